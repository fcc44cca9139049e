/* SPDX-License-Identifier: MIT */
/* The dividend of an edge's first row. Internal. */
#ifndef FXL_EDGE_DIVIDEND_H
#define FXL_EDGE_DIVIDEND_H

#include "../math/pixel_centre.h"

/* The dividend on the first row, whose centre is at or below the top. part and t are below 2^16, so
 * products of 16 bits suffice: with height = 2^16 h + h' and dx = 2^16 d + d' the sum of
 * fxl_edge_dividend is 2^16 (part h + t d) + part h' + t d'. Requires height <= FXL_EDGE_HEIGHT_MAX
 * and |dx| of at most 1025 pixels, so the bracket is below 2^28 in magnitude. */
static inline int32_t fxl_edge_first_dividend(int32_t start, int32_t dx, int32_t height,
                                              int32_t top_y)
{
    const uint32_t part = (uint32_t)start & 65535u, t = (uint32_t)(FXL_HALF_PIXEL - top_y) & 65535u;
    const uint32_t a = part * ((uint32_t)height & 65535u), b = t * ((uint32_t)dx & 65535u);
    const int32_t low = (int32_t)((a & 65535u) + (b & 65535u)) - 1;
    const int32_t high = (int32_t)(part * ((uint32_t)height >> 16)) + (int32_t)t * (dx >> 16);
    return high + (int32_t)(a >> 16) + (int32_t)(b >> 16) + (low >> 16);
}

#endif
