/* SPDX-License-Identifier: MIT */
#include "plain_run.h"
#include "special_texels.h"

#include "../math/family.h"

#if !FXL_TEXELS_IN_ASSEMBLY && !FXL_IS_SMALL

/* place sampling: positions in a segment, and their texels: keys, patterns, 4 bits too */
/* Texels that are not plain. */
/* rgb565 1.4 */
FXL_APART void paint_special(const fxl_segment_face *face, const fxl_paint_row *row,
                             const fxl_texel_run *run, uint32_t x, uint32_t count)
{
    uint16_t *pixels = (uint16_t *)(void *)row->pixels;
    uint32_t position = run->position, texel;
    for (const uint32_t end = x + count; x != end; x++, position += run->step) {
        const uint32_t place = fxl_segment_place(face, position);
        if (fxl_special_texel(face, row, x, place, fxl_texels_are_colours(face), &texel)) {
            pixels[x] = (uint16_t)(fxl_texels_are_colours(face) ? texel : face->palette[texel]);
        }
    }
}

static inline void paint_texels(const fxl_segment_face *face, const fxl_paint_row *row,
                                const fxl_texel_run *run, int32_t x, uint32_t count)
{
    if (FXL_TEXELS_ARE_SPECIAL(face->kind)) {
        paint_special(face, row, run, (uint32_t)x, count);
        return;
    }
    uint16_t *pixels = (uint16_t *)(void *)row->pixels + x;
    const uint16_t *end = pixels + count;
    const uint8_t *texels = face->texels, *in_beam = face->in_beam;
    const uint16_t *palette = face->palette, *colours = (const uint16_t *)(const void *)texels;
    const uint32_t step = run->step, mask = face->rows_mask, row_drop = face->row_drop;
    const uint32_t column_drop = 32u - face->log_width;
    uint32_t position = run->position;
    if (fxl_texels_are_colours(face)) {
        for (; pixels != end; position += step) {
            *pixels++ = colours[(position >> row_drop & mask) + (position >> column_drop)];
        }
        return;
    }
    if (!FXL_IS_COMPACT && in_beam == NULL) {
        for (; pixels != end; position += step) {
            *pixels++ = palette[texels[(position >> row_drop & mask) + (position >> column_drop)]];
        }
        return;
    }
    for (; pixels != end; position += step) {
        const uint32_t place = (position >> row_drop & mask) + (position >> column_drop);
        const uint32_t texel = texels[place];
        *pixels++ = palette[FXL_IS_COMPACT && in_beam == NULL ? texel : in_beam[texel]];
    }
}

#define TEXEL_CODE (&fxl_texel_code_565)

static inline bool has_kernel(const fxl_segment_face *face)
{
    return face->kind == FXL_TEXELS_PLAIN;
}

#define HAS_RAMPS 0
#include "segment_runs.h"

void fxl_paint_segments_565(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                            int32_t x1)
{
    paint_row_segments(face, row, x0, x1);
}

bool fxl_paint_rows_565(fxl_plain_rows *rows)
{
    if (FXL_KERNELS_ARMV6M && has_kernel(rows->row.segments) && !rows->row.segments->is_constant) {
        return fxl_paint_plain_rows(rows, TEXEL_CODE);
    }
    return fxl_paint_rows_by(rows, fxl_paint_segments_565);
}

#endif
