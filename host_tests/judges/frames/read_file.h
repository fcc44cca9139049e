/* SPDX-License-Identifier: MIT */
/* A whole file in memory, for the programs of the host that draw and judge. */
#ifndef FRAMES_READ_FILE_H
#define FRAMES_READ_FILE_H

#include <stddef.h>
#include <stdint.h>

/* The file's bytes, aligned for a scene image; the caller frees them. Null if the file cannot
 * be read; then *size is not written. An empty file gives a pointer and a size of 0. */
uint8_t *read_file(const char *path, size_t *size);

#endif
