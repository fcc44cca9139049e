/* SPDX-License-Identifier: MIT */
/* Where a texel is, and which pixels an opacity draws. Internal. */
#ifndef FXL_TEXEL_PLACE_H
#define FXL_TEXEL_PLACE_H

#include "paint.h"

/* place stipple: the numbers of the pattern, and the comment that says how it looks */
/* Whether an opacity draws a pixel: of a square of 4 x 4 those whose number is below it. Neighbours
 * in number are far apart, so the pattern is even at every opacity. */
/* SPEC 9.6, surfaces 4.2 */
static inline bool fxl_is_stippled_away(uint32_t opacity, int32_t x, int32_t y)
{
    static const uint8_t stipple[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    return opacity < 16 && stipple[4 * (y & 3) + (x & 3)] >= opacity;
}

/* Whether pixels of RGB565 are blended with what is beneath, or added to it. */
static inline bool fxl_is_mixed_565(const fxl_paint *paint)
{
    return paint->of_565.sixteenths != 0 || paint->of_565.adds;
}

/* SPEC 9.5, surfaces 1.1 */
static inline uint32_t fxl_limited(int32_t coordinate, uint32_t last)
{
    return coordinate < 0 ? 0 : (uint32_t)coordinate > last ? last : (uint32_t)coordinate;
}

/* place sampling: the texel of a column and a row, for any texture */
/* The number of the texel in column i and row j, repeated or clamped. */
/* SPEC 9.5 */
static inline uint32_t fxl_texel_place(const fxl_texture_level *level, int32_t i, int32_t j)
{
    uint32_t column = (uint32_t)i & level->columns_less_1, row = (uint32_t)j & level->rows_less_1;
    if (level->flags & FXL_TEXTURE_CLAMP) {
        column = fxl_limited(i, level->columns_less_1);
        row = fxl_limited(j, level->rows_less_1);
    }
    return (row << level->log_width) + column;
}

/* A texel of 8 or 4 bits: its palette index. */
/* surfaces 1.3 */
static inline uint8_t fxl_texel_index(const fxl_texture_level *level, uint32_t place)
{
    if (level->colours != NULL) {
        const uint32_t two = level->texels[place >> 1];
        return level->colours[two >> (4u * (place & 1u)) & 15u];
    }
    return level->texels[place];
}

#endif
