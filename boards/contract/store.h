/* SPDX-License-Identifier: MIT */
/* Board contract: the place of the scene image. */
#ifndef BOARD_STORE_H
#define BOARD_STORE_H

#include <stddef.h>

/* Returns the first byte of the scene partition, aligned to four bytes, and its size in bytes,
 * which may exceed that of the image. Does not read the contents: an erased partition counts as
 * one.
 * Requires size not null. The memory stays readable and unchanged until the program ends.
 * Returns null, with *size 0, where the board has no partition. */
const void *store_scene(size_t *size);

#endif
