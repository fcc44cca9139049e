/* SPDX-License-Identifier: MIT */
#include "plain_run.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M

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

#if !FXL_KERNELS_ARMV7M && !FXL_KERNELS_ARMV6M

static inline uint8_t texel(const fxl_segment_face *face, uint32_t position)
{
    const uint32_t column = position >> (32u - face->log_width);
    return face->texels[(position >> face->row_drop & face->rows_mask) + column];
}

void fxl_paint_texels(const fxl_segment_face *face, const fxl_texel_run *run, uint8_t *pixels,
                      uint32_t count)
{
    const uint8_t *end = pixels + count;
    uint32_t position = run->position, light = run->light;
    if (face->ramp == NULL) {
        for (; pixels != end; position += run->step) {
            const uint8_t colour = texel(face, position);
            *pixels++ = face->table != NULL ? face->table[colour] : colour;
        }
        return;
    }
    for (; pixels != end; position += run->step, light += run->light_step) {
        *pixels++ = face->ramp[(light & ~255u) + texel(face, position)];
    }
}

#endif
