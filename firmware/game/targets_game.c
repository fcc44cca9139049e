/* SPDX-License-Identifier: MIT */
/* The targets of the game: those of the walk. Beside the game and a driver of a display some boards have no flash for all of them:
 * they set GAME_WITHOUT_RGB565_DEPTH. */
#if defined GAME_WITHOUT_RGB565_DEPTH
#define WALK_WITHOUT_RGB565_DEPTH
#endif
#include "targets.c"
