/* SPDX-License-Identifier: MIT */
#include "plain_run.h"
#include "segment_lengths.h"
#include "special_texels.h"

#include "../math/family.h"

#if FXL_TEXELS_IN_ASSEMBLY

void fxl_paint_lit_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                            int32_t x1)
{
    uint64_t weight = (uint64_t)sum(row->weight, face->weight_step, (uint32_t)x0 >> 4);
    while (x0 < x1) {
        uint32_t log;
        const int32_t end = next_length(face, x0, x1, &weight, &log);
        fxl_paint_lit_run(face, row, x0, end, log);
        x0 = end;
    }
}

#else

/* place sampling: positions in a segment, and their texels: keys, patterns, 4 bits too */
/* Texels that are not plain. */
FXL_APART void paint_special(const fxl_segment_face *face, const fxl_paint_row *row,
                             const fxl_texel_run *run, uint32_t x, uint32_t count)
{
    uint32_t position = run->position, texel;
    for (const uint32_t end = x + count; x != end; x++, position += run->step) {
        if (fxl_special_texel(face, row, x, fxl_segment_place(face, position), false, &texel)) {
            row->pixels[x] = (uint8_t)(face->table != NULL ? face->table[texel] : texel);
        }
    }
}

static inline uint32_t limited(uint32_t light, int32_t most)
{
    return (int32_t)light < 0 ? 0 : (int32_t)light > most ? (uint32_t)most : light;
}

/* All pixels' light is a level if that of the first and of the last is: a step of a segment of n
 * columns is at most 2^32 / n, so its sums do not come round. */
static inline void paint_texels(const fxl_segment_face *face, const fxl_paint_row *row,
                                const fxl_texel_run *run, int32_t x, uint32_t count)
{
    const uint32_t most = (uint32_t)face->light_max;
    if (FXL_TEXELS_ARE_SPECIAL(face->kind)) {
        paint_special(face, row, run, (uint32_t)x, count);
        return;
    }
    if (face->ramp == NULL ||
        (run->light <= most && run->light + (count - 1u) * run->light_step <= most)) {
        fxl_paint_texels(face, run, row->pixels + x, count);
        return;
    }
    fxl_texel_run pixel = *run;
    for (uint32_t light = run->light; count > 0; count--, x++) {
        pixel.light = limited(light, face->light_max);
        fxl_paint_texels(face, &pixel, row->pixels + x, 1);
        pixel.position += run->step;
        light += run->light_step;
    }
}

#define TEXEL_CODE (&fxl_texel_code_8)

static inline bool has_kernel(const fxl_segment_face *face)
{
    return face->ramp == NULL && face->kind == FXL_TEXELS_PLAIN;
}

#define HAS_RAMPS 1
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
    uint32_t position = run->position;
    if (!FXL_IS_COMPACT && table == NULL) {
        for (; pixels != end; position += step) {
            *pixels++ = texels[(position >> row_drop & mask) + (position >> column_drop)];
        }
        return;
    }
    const uint32_t light_step = face->ramp != NULL ? run->light_step : 0;
    uint32_t light = face->ramp != NULL ? run->light : 0;
    for (; pixels != end; position += step, light += light_step) {
        uint32_t colour = texels[(position >> row_drop & mask) + (position >> column_drop)];
        if (!FXL_IS_COMPACT || table != NULL) {
            colour = table[(light & ~255u) + colour];
        }
        *pixels++ = (uint8_t)colour;
    }
}

#endif
