/* SPDX-License-Identifier: MIT */
/* What a face's key is made of, for those who check keys and those who have none.
 * Internal. */
#ifndef FXL_FACE_BOUNDS_H
#define FXL_FACE_BOUNDS_H

#include "../math/arith.h"
#include "fixel/scene.h"

/* Lets [*low, *high] hold the value. */
static inline void fxl_widen(int32_t value, int32_t *low, int32_t *high)
{
    if (value < *low) {
        *low = value;
    }
    if (value > *high) {
        *high = value;
    }
}

/* Minimum + maximum of each coordinate. A model's vertices are below 2^30, so the
 * sums are below 2^31. */
static inline fxl_point fxl_face_box(const fxl_point *vertices, const uint16_t *corners,
                                     uint32_t count)
{
    const uint16_t *end = corners + count;
    fxl_point low = vertices[*corners];
    fxl_point high = low;
    while (++corners < end) {
        const fxl_point *vertex = &vertices[*corners];
        fxl_widen(vertex->x, &low.x, &high.x);
        fxl_widen(vertex->y, &low.y, &high.y);
        fxl_widen(vertex->z, &low.z, &high.z);
    }
    fxl_point box = {low.x + high.x, low.y + high.y, low.z + high.z};
    return box;
}

/* How high the plane of a face lies over its model's origin. Each coordinate is
 * below 2^30: see fxl_dot. */
static inline fxl_q18_46 fxl_face_height(const fxl_point *vertices, const uint16_t *corners,
                                         const fxl_face *face)
{
    const fxl_point *first = &vertices[*corners];
    return fxl_dot(&face->normal, first->x, first->y, first->z);
}

static inline fxl_q18_46 fxl_face_bounds_height(const fxl_face_bounds *key)
{
    return (int64_t)((uint64_t)key->height_high << 32 | key->height_low);
}

#endif
