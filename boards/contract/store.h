/* SPDX-License-Identifier: MIT */
/* Board contract: where the scene image is kept. */
#ifndef BOARD_STORE_H
#define BOARD_STORE_H

#include <stddef.h>

/* The scene partition: its first byte, aligned to four bytes, and its size in
 * bytes, which may exceed what is in it. What it holds is not looked at: an
 * erased partition is a partition.
 * Requires size not null. The memory stays readable and unchanged until the
 * program ends. Null, with *size 0, where the board has none. */
const void *store_scene(size_t *size);

#endif
