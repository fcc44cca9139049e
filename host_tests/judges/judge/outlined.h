/* SPDX-License-Identifier: MIT */
/* Frames with outlines. */
#ifndef JUDGE_OUTLINED_H
#define JUDGE_OUTLINED_H

#include "reference/render.h"

/* Whether a line along an edge of a polygon that was drawn may cover a pixel, if it is moved by at
 * most a pixel: as far as outlines move a vertex, and as far as rounding does. */
bool judge_is_on_outline(const ref_renderer *renderer, int x, int y);

#endif
