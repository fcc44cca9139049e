/* SPDX-License-Identifier: MIT */
#include "../scene/placement_code.h"
#include "exact.h"

/* A difference of two products of components: each is at most 2^60. */
static int64_t minor(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return fxl_multiply_s32(a, b) - fxl_multiply_s32(c, d);
}

/* *high and *low gain factor * value, |factor| <= 2^61, |value| <= 2^30 + 2^7, as 2^32 high + low.
 * Each call adds less than 2^59 + 2^37 to *high and less than 2^32 to *low. */
/* collide 2.1 */
static void add_product(int64_t factor, int32_t value, int64_t *high, uint64_t *low)
{
    const int64_t lower = fxl_multiply_su32(value, (uint32_t)factor);
    *high += fxl_multiply_s32((int32_t)(factor >> 32), value) + (lower >> 32);
    *low += (uint32_t)lower;
}

/* collide 2.1 */
int fxl_determinant_sign(const fxl_point *a, const fxl_point *b, const fxl_point *c)
{
    int64_t high = 0;
    uint64_t low = 0;
    add_product(minor(b->y, c->z, b->z, c->y), a->x, &high, &low);
    add_product(minor(b->z, c->x, b->x, c->z), a->y, &high, &low);
    add_product(minor(b->x, c->y, b->y, c->x), a->z, &high, &low);
    high += (int64_t)(low >> 32);
    return high < 0 ? -1 : high > 0 || (uint32_t)low != 0;
}

/* The vertices go clockwise as seen from the front, in left-handed axes: a line from front to back
 * has every edge on the side where the determinant is not above 0. */
/* collide 2.1 */
bool fxl_line_is_within(const fxl_face_place *face, const fxl_point *from,
                        const fxl_point *direction)
{
    fxl_point before = fxl_corner_from(face, face->count - 1, from);
    for (uint32_t k = 0; k < face->count; k++) {
        const fxl_point corner = fxl_corner_from(face, k, from);
        if (fxl_determinant_sign(direction, &before, &corner) > 0) {
            return false;
        }
        before = corner;
    }
    return true;
}

/* With q = centre - start and d = end - start, the foot of the centre on the line is at the part
 * (q . d) / (d . d) of the segment. Beyond an end, that end is the nearest point. Otherwise the
 * squared distance is q . q - (q . d)^2 / (d . d). It is compared with the squared radius by the
 * two halves of products of 128 bits. Squares are below 2^62. */
bool fxl_sphere_meets_segment(const fxl_sphere *sphere, const fxl_point *start,
                              const fxl_point *end)
{
    fxl_point q, d, beyond;
    fxl_subtract(&sphere->centre, start, &q);
    fxl_subtract(end, start, &d);
    const int64_t along = fxl_dot_vectors(&q, &d);
    const uint64_t whole = fxl_square_of(&d), square = fxl_square_of(&q);
    const uint64_t reach = (uint64_t)fxl_multiply_s32(sphere->radius, sphere->radius);
    if (square <= reach) {
        return true;
    }
    if (along <= 0) {
        return false;
    }
    if ((uint64_t)along >= whole) {
        fxl_subtract(&sphere->centre, end, &beyond);
        return fxl_square_of(&beyond) <= reach;
    }
    const uint64_t most = (uint64_t)along, over = square - reach;
    const uint64_t left = fxl_multiply_high(over, whole), right = fxl_multiply_high(most, most);
    return left != right ? left < right : over * whole <= most * most;
}

bool fxl_segment_nears_instance(const fxl_scene *scene, const fxl_instance *instance,
                                const fxl_point *from, const fxl_point *to, fxl_q16_16 margin)
{
    /* The radius is at most 28375 units, the margin 512: the sum is below 2^31. */
    const fxl_sphere sphere = {instance->centre, fxl_instance_radius(scene, instance) + margin};
    return fxl_sphere_meets_segment(&sphere, from, to);
}
