/* SPDX-License-Identifier: MIT */
/* The targets of the game: its words are drawn by the overlay, which knows palette indices alone. */
#ifndef WALK_WITHOUT_RGB565
#define WALK_WITHOUT_RGB565
#endif
#include "targets.c"
