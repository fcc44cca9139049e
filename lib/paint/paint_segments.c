/* SPDX-License-Identifier: MIT */
#include "plain_run.h"

#include "../math/family.h"

#if !FXL_TEXELS_IN_ASSEMBLY

static inline void paint_texels(const fxl_segment_face *face, const fxl_paint_row *row,
                                const fxl_texel_run *run, int32_t x, uint32_t count)
{
    fxl_paint_texels(face, run, row->pixels + x, count);
}

#define TEXEL_CODE (&fxl_texel_code_8)

static inline bool has_kernel(const fxl_segment_face *face)
{
    return face->ramp == NULL;
}

#include "segment_runs.h"

/* The kernels of Armv6-M paint texels. */
static inline void put_through(const uint8_t *table, uint8_t *pixel, const uint8_t *end)
{
    for (; pixel != end; pixel++) {
        *pixel = table[*pixel];
    }
}

void fxl_paint_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                        int32_t x1)
{
    paint_row_segments(face, row, x0, x1);
    if (FXL_KERNELS_ARMV6M && has_kernel(face) && face->table != NULL) {
        put_through(face->table, row->pixels + x0, row->pixels + x1);
    }
}

bool fxl_paint_rows(fxl_plain_rows *rows)
{
    if (FXL_KERNELS_ARMV6M && has_kernel(rows->row.segments) && rows->row.segments->table == NULL &&
        !rows->row.segments->is_constant) {
        return fxl_paint_plain_rows(rows, TEXEL_CODE);
    }
    return fxl_paint_rows_by(rows, fxl_paint_segments);
}

#endif

#if !FXL_TEXELS_IN_ASSEMBLY && !FXL_KERNELS_ARMV6M

void fxl_paint_texels(const fxl_segment_face *face, const fxl_texel_run *run, uint8_t *pixels,
                      uint32_t count)
{
    const uint8_t *end = pixels + count, *texels = face->texels;
    const uint8_t *table = face->ramp != NULL ? face->ramp : face->table; /* lit: one for a level */
    const uint32_t mask = face->rows_mask, row_drop = face->row_drop, step = run->step;
    const uint32_t column_drop = 32u - face->log_width;
    const uint32_t light_step = face->ramp != NULL ? run->light_step : 0;
    uint32_t position = run->position, light = face->ramp != NULL ? run->light : 0;
    for (; pixels != end; position += step, light += light_step) {
        uint32_t colour = texels[(position >> row_drop & mask) + (position >> column_drop)];
        if (table != NULL) {
            colour = table[(light & ~255u) + colour];
        }
        *pixels++ = (uint8_t)colour;
    }
}

#endif
