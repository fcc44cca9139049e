/* SPDX-License-Identifier: MIT */
/* A sky and a ground in the place of the background (docs/extras/horizon.md), in double. */
#ifndef REF_HORIZON_H
#define REF_HORIZON_H

#include "reference/render.h"

/* How far apart the sides of the comparison of clause 1.3 may be where the other level may be shown,
 * as a part of the length of the ray. */
#define REF_HORIZON_BOUND 0x1p-20

/* Reads the horizon of an image. Returns true also where there is none. */
bool ref_horizon_read(const uint8_t *bytes, ref_horizon *horizon);

/* The level of the ray through the centre of a pixel; low and high: the least and the greatest that
 * a frame may show. Requires a horizon. */
int ref_horizon_level(const ref_renderer *renderer, int x, int y, int *low, int *high);

/* Clears a band to the horizon of the frame, or without one to the background. */
void ref_frame_fill(const ref_renderer *renderer, const ref_band *band, uint8_t background);

#endif
