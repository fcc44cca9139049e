/* SPDX-License-Identifier: MIT */
#include "../../extra/surfaces/segments.h"

#include "../../extra/surfaces/attribute.h"
#include "../family.h"
#include "../paint_texels.h"

#if !FXL_KERNELS_ARMV7M

/* What a segment has at one end. */
typedef struct {
    int32_t u, v, light;
} segment_end;

/* A product, shifted. The weight is large enough that it is not shifted to the left. */
static inline int32_t divided(int64_t value, const fxl_reciprocal *reciprocal, int32_t drop)
{
    const int64_t product = fxl_multiply_s32((int32_t)(value >> 32), reciprocal->value);
    const int32_t left = 32 + drop - (int32_t)reciprocal->zeros;
    return (int32_t)(uint32_t)(product >> (left < 0 ? 0 : left > 63 ? 63 : left));
}

static inline int32_t limited(int32_t light, int32_t most)
{
    return light < 0 ? 0 : light > most ? most : light;
}

static inline void find_end(const fxl_segment_face *face, const fxl_segment_start *at,
                            const fxl_reciprocal *reciprocal, segment_end *end)
{
    end->u = divided(at->u, reciprocal, face->u_drop);
    end->v = divided(at->v, reciprocal, face->v_drop);
    end->light = 0;
    if (face->ramp != NULL) {
        const int64_t light = (int64_t)((uint64_t)(uint32_t)at->light << 32);
        end->light = limited(divided(light, reciprocal, face->light_drop), face->light_max);
    }
}

/* Segments may end beyond what the gradients are bounded for: then their sums wrap. */
static inline int64_t sum(int64_t value, int64_t step)
{
    return (int64_t)((uint64_t)value + (uint64_t)step);
}

static inline void advance(const fxl_segment_face *face, fxl_segment_start *at)
{
    at->weight = sum(at->weight, face->weight_step);
    at->u = sum(at->u, face->u_step);
    at->v = sum(at->v, face->v_step);
    at->light = (int32_t)((uint32_t)at->light + (uint32_t)face->light_step);
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
    const int32_t light = to->light - from->light;
    run->position = (uint32_t)(from->u >> 4) << 16 | ((uint32_t)from->v >> 4 & 0xFFFFu);
    run->step = ((uint32_t)step_of(from->u, to->u) << 16) +
                (uint32_t)(int32_t)(int16_t)(uint16_t)step_of(from->v, to->v);
    run->light = (uint32_t)from->light;
    run->light_step = (uint32_t)((light + (light >> 31 & 15)) >> 4);
}

void fxl_paint_segments(const fxl_segment_face *face, const fxl_segment_start *start)
{
    fxl_segment_start at = *start;
    segment_end ends[2];
    fxl_texel_run run;
    fxl_reciprocal reciprocal = fxl_reciprocal_of((uint32_t)(at.weight >> 32));
    find_end(face, &at, &reciprocal, &ends[0]);
    for (uint32_t first = 0; first < at.end; first += 16) {
        const uint32_t left = at.end - first;
        advance(face, &at);
        if (!face->is_constant) {
            reciprocal = fxl_reciprocal_of((uint32_t)(at.weight >> 32));
        }
        find_end(face, &at, &reciprocal, &ends[1]);
        find_texels(&ends[0], &ends[1], &run);
        run.position += run.step * at.skip;
        run.light += run.light_step * at.skip;
        fxl_paint_texels(face, &run, at.pixels + first + at.skip,
                         (left < 16 ? left : 16) - at.skip);
        at.skip = 0;
        ends[0] = ends[1];
    }
}

#endif
