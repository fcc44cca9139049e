/* SPDX-License-Identifier: MIT */
/* What the functions of overlay share: checks of a band, clipping, and sprites. Internal. */
#ifndef FXL_OVERLAY_BAND_H
#define FXL_OVERLAY_BAND_H

#include "fixel/overlay.h"

/* FXL_OK, FXL_E_ARGUMENT or FXL_E_RANGE, as overlay.h says of all functions. */
fxl_status fxl_overlay_check(const fxl_band *band);

/* The pixels first <= pixel < end of a row or column of pixels. */
typedef struct {
    int32_t first, end;
} fxl_stretch;

/* The part of `count` pixels from `at` on that lies within low <= pixel < high. Empty, first ==
 * end, if there is none. Takes any int32_t at and count, and more; sums stay below 2^63. */
/* overlay 1.1 */
static inline fxl_stretch fxl_clip_stretch(int64_t at, int64_t count, int32_t low, int32_t high)
{
    const int64_t end = at + count;
    fxl_stretch part = {low, low};
    if (end > low && at < high && count > 0) {
        part.first = at > low ? (int32_t)at : low;
        part.end = end < high ? (int32_t)end : high;
    }
    return part;
}

/* fxl_draw_sprite without checks, at any place whose sums with a sprite's size fit 64 bits. */
void fxl_overlay_sprite(const fxl_band *band, int64_t x, int64_t y, const fxl_sprite *sprite);

#endif
