/* SPDX-License-Identifier: MIT */
#include "segments.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M

/* The weight and the attributes at a column, of light the upper word. */
typedef struct {
    int64_t weight, u, v;
    int32_t light;
} segment_values;

/* What a segment has at one end. */
typedef struct {
    int32_t u, v, light;
} segment_end;

/* Segments may end beyond what the gradients are bounded for: then their sums wrap. */
static inline int64_t sum(int64_t value, int64_t step, uint32_t times)
{
    return (int64_t)((uint64_t)value + (uint64_t)fxl_multiply_s64(step, times));
}

static inline void begin(const fxl_segment_face *face, const fxl_paint_row *row, uint32_t segment,
                         segment_values *at)
{
    const int64_t *attributes = row->attributes;
    at->weight = sum(row->weight, face->weight_step, segment);
    at->u = sum(attributes[FXL_ATTRIBUTE_U], face->u_step, segment);
    at->v = sum(attributes[FXL_ATTRIBUTE_V], face->v_step, segment);
    at->light = 0;
    if (face->ramp != NULL) {
        at->light = (int32_t)((uint32_t)(attributes[FXL_SEGMENT_LIGHT] >> 32) +
                              segment * (uint32_t)face->light_step);
    }
}

static inline void advance(const fxl_segment_face *face, segment_values *at)
{
    at->weight = (int64_t)((uint64_t)at->weight + (uint64_t)face->weight_step);
    at->u = (int64_t)((uint64_t)at->u + (uint64_t)face->u_step);
    at->v = (int64_t)((uint64_t)at->v + (uint64_t)face->v_step);
    at->light = (int32_t)((uint32_t)at->light + (uint32_t)face->light_step);
}

/* A product, shifted. The weight is large enough that it is not shifted to the left. */
static inline int32_t divided(int32_t value, const fxl_reciprocal *reciprocal, int32_t drop)
{
    const int64_t product = fxl_multiply_s32(value, reciprocal->value);
    const int32_t left = 32 + drop - (int32_t)reciprocal->zeros;
    return (int32_t)(uint32_t)(product >> (left < 0 ? 0 : left > 63 ? 63 : left));
}

static inline int32_t limited(int32_t light, int32_t most)
{
    return light < 0 ? 0 : light > most ? most : light;
}

static inline void find_end(const fxl_segment_face *face, const segment_values *at,
                            const fxl_reciprocal *reciprocal, segment_end *end)
{
    end->u = divided((int32_t)(at->u >> 32), reciprocal, face->u_drop);
    end->v = divided((int32_t)(at->v >> 32), reciprocal, face->v_drop);
    end->light = 0;
    if (face->ramp != NULL) {
        end->light = limited(divided(at->light, reciprocal, face->light_drop), face->light_max);
    }
}

static inline int32_t difference(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

/* A 256th of a difference, rounded to nearest. */
static inline int32_t step_of(int32_t from, int32_t to)
{
    return (int32_t)((uint32_t)difference(to, from) + 128u) >> 8;
}

static inline void find_texels(const segment_end *from, const segment_end *to, fxl_texel_run *run)
{
    run->position = (uint32_t)(from->u >> 4) << 16 | ((uint32_t)from->v >> 4 & 0xFFFFu);
    run->step = ((uint32_t)step_of(from->u, to->u) << 16) +
                (uint32_t)(int32_t)(int16_t)(uint16_t)step_of(from->v, to->v);
    run->light = (uint32_t)from->light;
    run->light_step = (uint32_t)((to->light >> 4) - (from->light >> 4));
}

void fxl_paint_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                        int32_t x1)
{
    segment_values at;
    segment_end ends[2];
    fxl_texel_run run;
    begin(face, row, (uint32_t)x0 >> 4, &at);
    fxl_reciprocal reciprocal = fxl_reciprocal_of((uint32_t)(at.weight >> 32));
    find_end(face, &at, &reciprocal, &ends[0]);
    while (x0 < x1) {
        const uint32_t skip = (uint32_t)x0 & 15u, left = (uint32_t)(x1 - x0);
        const uint32_t count = left < 16u - skip ? left : 16u - skip;
        advance(face, &at);
        if (!face->is_constant) {
            reciprocal = fxl_reciprocal_of((uint32_t)(at.weight >> 32));
        }
        find_end(face, &at, &reciprocal, &ends[1]);
        find_texels(&ends[0], &ends[1], &run);
        run.position += run.step * skip;
        run.light += run.light_step * skip;
        fxl_paint_texels(face, &run, row->pixels + x0, count);
        x0 += (int32_t)count;
        ends[0] = ends[1];
    }
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
            *pixels++ = texel(face, position);
        }
        return;
    }
    for (; pixels != end; position += run->step, light += run->light_step) {
        *pixels++ = face->ramp[(light & ~255u) + texel(face, position)];
    }
}

#endif
