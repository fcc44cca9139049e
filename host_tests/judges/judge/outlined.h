/* SPDX-License-Identifier: MIT */
/* Frames with outlines. */
#ifndef JUDGE_OUTLINED_H
#define JUDGE_OUTLINED_H

#include "reference/render.h"

/* How far from a polygon's box, in pixels, its outline may be. */
#define JUDGE_OUTLINE_REACH 2.0

/* Whether a line along an edge of a polygon may cover a pixel, if it is moved by at most a pixel:
 * as far as outlines move a vertex, and as far as rounding does. */
bool judge_is_on_outline(const ref_screen_polygon *polygon, int x, int y);

#endif
