/* SPDX-License-Identifier: MIT */
/* With the normal n of a face in the view, its corner P, and the direction D of a pixel, the face
 * is seen at distance z = (n . P) focal / (n . D). So the depth near_z / z is the gradient of n .
 * D, times near_z / ((n . P) focal). */
#include "depth_plane.h"

#include "../../src/math/arith.h"

/* A number mantissa * 2^exponent. */
typedef struct {
    uint32_t mantissa; /* 2^31 to 2^32 */
    int exponent;
} normalised;

/* Requires number > 0. Rounded down, by less than 2^-31 of it. */
static normalised normalise(uint64_t number)
{
    const int drop = (int)fxl_bit_length(number) - 32;
    const normalised result = {(uint32_t)(drop > 0 ? number >> drop : number << -drop), drop};
    return result;
}

/* Products of rows and normals, of unit length or shorter: a sum is below 2^61. */
static int64_t row_times(const fxl_direction *row, const fxl_direction *normal)
{
    return fxl_multiply_s32(row->x, normal->x) + fxl_multiply_s32(row->y, normal->y) +
           fxl_multiply_s32(row->z, normal->z);
}

/* n . P / 2^31, rounded down. Components of n are at most 2^30. Upper parts of P are at most 2^30
 * and lower parts are below 2^31: their sums of three products are below 2^62 and 2^63. */
static int64_t height_of(const fxl_block_vector *n, const fxl_view_point *p)
{
    const int64_t lower = fxl_multiply_s32(n->x, (int32_t)(p->x & INT32_MAX)) +
                          fxl_multiply_s32(n->y, (int32_t)(p->y & INT32_MAX)) +
                          fxl_multiply_s32(n->z, (int32_t)(p->z & INT32_MAX));
    return fxl_multiply_s32(n->x, (int32_t)(p->x >> 31)) +
           fxl_multiply_s32(n->y, (int32_t)(p->y >> 31)) +
           fxl_multiply_s32(n->z, (int32_t)(p->z >> 31)) + (lower >> 31);
}

/* value * factor / 2^32, rounded down; factor is from 2^30 to 2^32. */
static int64_t times(int64_t value, uint32_t factor)
{
    return fxl_multiply_su32((int32_t)(value >> 32), factor) +
           (int64_t)(fxl_multiply_u32((uint32_t)value, factor) >> 32);
}

void fxl_depth_plane_find(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *on, fxl_depth_plane *plane)
{
    const fxl_axes *axes = model_view->axes;
    const fxl_view *view = model_view->view;
    fxl_gradient *gradient = &plane->gradient;
    fxl_view_point first;
    fxl_find_corner(model_view, model_view->indices[face->first_index], on, &first);
    /* It points away from the eye, so that n . P > 0. */
    const fxl_block_vector n =
        fxl_block(-row_times(&axes->right, &face->normal), -row_times(&axes->up, &face->normal),
                  -row_times(&axes->forward, &face->normal), 0);
    const int64_t height = height_of(&n, &first);
    if (height <= 0) {
        gradient->at = gradient->along = gradient->down = 0;
        plane->one = 0;
        return;
    }
    /* height is in units of 2^-15 of n's, near_z in units of 2^-16. */
    const int exponent = fxl_gradient_of_plane(n, view, gradient) - n.exponent;
    const normalised near_z = normalise((uint32_t)view->lens.near_z);
    const normalised at_height = normalise((uint64_t)height);
    const normalised divisor =
        normalise(fxl_multiply_u32(at_height.mantissa, (uint32_t)view->lens.focal));
    uint32_t rest;
    /* From 2^30 to 2^32. */
    const uint32_t factor =
        fxl_divide_u64((uint64_t)(near_z.mantissa >> 1) << 32, divisor.mantissa, &rest);
    gradient->at = times(gradient->at, factor);
    gradient->along = times(gradient->along, factor);
    gradient->down = times(gradient->down, factor);
    plane->one = at_height.exponent + divisor.exponent - near_z.exponent - exponent;
}
