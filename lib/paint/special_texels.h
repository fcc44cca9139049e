/* SPDX-License-Identifier: MIT */
/* Texels that are keyed, stippled or of 4 bits, in the portable C of the kernels of segments: one
 * pixel of either size. Internal. */
#ifndef FXL_SPECIAL_TEXELS_H
#define FXL_SPECIAL_TEXELS_H

#include "segments.h"

/* place sampling: positions in a segment, and their texels: keys, patterns, 4 bits too */
/* The texel at a place: a colour of the palette, or of RGB565 where the face has wide texels.
 * Returns whether the pixel is drawn. */
/* rgb565 1.4, surfaces 4.1 */
static inline bool fxl_special_texel(const fxl_segment_face *face, const fxl_paint_row *row,
                                     uint32_t x, uint32_t place, bool is_wide, uint32_t *texel)
{
    if (face->kind == FXL_TEXELS_4) {
        const uint32_t two = face->texels[place >> 1];
        *texel = face->colours[two >> (4u * (place & 1u)) & 15u];
        return true;
    }
    *texel = is_wide ? ((const uint16_t *)(const void *)face->texels)[place] : face->texels[place];
    return face->kind == FXL_TEXELS_KEYED
               ? *texel != face->key
               : (face->stipple >> (4u * ((uint32_t)row->y & 3u) + (x & 3u)) & 1u) != 0;
}

/* The place of the texel at a position. */
static inline uint32_t fxl_segment_place(const fxl_segment_face *face, uint32_t position)
{
    return (position >> face->row_drop & face->rows_mask) + (position >> (32u - face->log_width));
}

#endif
