/* SPDX-License-Identifier: MIT */
/* The faces that face the eye: the test of one, and of all of a model by the scene's face bounds;
 * and a face as a polygon of the world. Internal. */
#ifndef FXL_CULL_H
#define FXL_CULL_H

#include "../math/family.h"
#include "outcode.h"
#include "../math/arith.h"
#include "fixel/records.h"
#include "model_view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- estimates ----------------------------------------------------------------------------- */

/* Estimates of sums of products, inline: they decide a comparison before the exact sum is computed,
 * where a family's exact products are slow. The others compute the exact sum. */

/* Whether direction . (x, y, z) is negative, from all bits, for an inline kernel: a call keeps its
 * caller's frame on the stack small. Requires what fxl_dot requires. */
bool fxl_exact_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y, int32_t z);

#if !FXL_ESTIMATES

/* Whether direction . (x, y, z) is negative. Requires what fxl_dot requires. Exact. */
static inline bool fxl_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y,
                                       int32_t z)
{
    return fxl_dot(direction, x, y, z) < 0;
}

/* Of fxl_sphere_planes, where an estimate does not decide the result. */
#define FXL_SPHERE_UNDECIDED UINT32_MAX

/* The result of fxl_sphere_planes, or FXL_SPHERE_UNDECIDED. from_eye is the centre less the eye,
 * each coordinate below 2^30; reach is the radius with its slack in units of 2^-12. */
static inline uint32_t fxl_estimated_sphere(const fxl_axes *axes, const fxl_view_frustum *frustum,
                                            const fxl_point *from_eye, int32_t reach)
{
    (void)axes, (void)frustum, (void)from_eye, (void)reach;
    return FXL_SPHERE_UNDECIDED;
}

#else

/* By products of 16 by 16 bits, for a core without long products.
 *
 * They serve points less than 256 units away: |e| <= 2^24. Let n be a component of a direction,
 *   n = 2^15 n' + f, 0 <= f < 2^15, and e = 2^9 e' + g, 0 <= g < 2^9. Then
 *   n e = 2^24 n' e' + 2^15 n' g + f e.
 * |n'| sums up to less than 1.74 2^15 over the components and |e'| is at most 2^15. So a sum of
 * products n' e' is below 2^31, its unit is 2^-22 world units, and what it lacks is below
 * (1.74 + 3) 2^15 of these, which is less than FXL_ESTIMATE_ERROR. */

#define FXL_ESTIMATE_ERROR (5 << 15)

/* Whether each of three coordinates is within -2^24..2^24 - 1. */
static inline bool fxl_can_estimate(int32_t x, int32_t y, int32_t z)
{
    const uint32_t half = 1u << 24;
    return (((uint32_t)x + half) | ((uint32_t)y + half) | ((uint32_t)z + half)) >> 25 == 0;
}

/* x, y and z are e'. */
static inline int32_t fxl_estimated_dot(const fxl_direction *direction, int32_t x, int32_t y,
                                        int32_t z)
{
    return (direction->x >> 15) * x + (direction->y >> 15) * y + (direction->z >> 15) * z;
}

static inline bool fxl_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y,
                                       int32_t z)
{
    if (fxl_can_estimate(x, y, z)) {
        int32_t sum = fxl_estimated_dot(direction, x >> 9, y >> 9, z >> 9);
        if (sum >= FXL_ESTIMATE_ERROR || sum <= -FXL_ESTIMATE_ERROR) {
            return sum < 0;
        }
    }
    return fxl_exact_dot_is_negative(direction, x, y, z);
}

#define FXL_SPHERE_UNDECIDED UINT32_MAX

/* Where a sphere lies whose centre has the given distance from a plane: FXL_SPHERE_OUTSIDE, 1 if it
 * crosses the plane, 0 if it is inside, or FXL_SPHERE_UNDECIDED. Requires an error of the distance
 * of less than `error`. All are in units of 2^-12. */
static inline uint32_t fxl_estimated_place(int32_t distance, int32_t reach, int32_t error)
{
    if (distance >= reach + error) {
        return 0;
    }
    if (distance < -reach - error) {
        return FXL_SPHERE_OUTSIDE;
    }
    return distance >= error - reach && distance < reach - error ? 1u : FXL_SPHERE_UNDECIDED;
}

/* Adds the place at a plane to planes, or returns it if it is the result. */
#define FXL_ESTIMATE_PLANE(plane, distance, error) \
    do { \
        uint32_t place = fxl_estimated_place(distance, reach, error); \
        if (place >= FXL_SPHERE_OUTSIDE) { \
            return place; \
        } \
        planes |= place << (plane); \
    } while (0)

/* The same sums as in cull.c, from estimates. A coordinate in the view, floored to units of
 * 2^-12, has an error below 5 2^15 2^-10 + 1 = 161; so have the distances from near and far, and
 * the floors of those planes add 1.
 *
 * For a side plane the coordinate is floored to units of 2^-6, which adds 64; it is then below
 * 2^15. The component of the normal is floored to units of 2^-15, which moves the product by less
 * than 2^15 2^-15 of these units, 64 of 2^-12. So each product has an error below 290, floors
 * included. Two of them, the inset, and the 3 by which cull.c differs from the exact sum are
 * below 600. */
static inline uint32_t fxl_estimated_sphere(const fxl_axes *axes, const fxl_view_frustum *frustum,
                                            const fxl_point *from_eye, int32_t reach)
{
    int32_t x = from_eye->x, y = from_eye->y, z = from_eye->z;
    if (!fxl_can_estimate(x, y, z)) {
        return FXL_SPHERE_UNDECIDED;
    }
    x >>= 9;
    y >>= 9;
    z >>= 9;
    uint32_t planes = 0;
    int32_t along = fxl_estimated_dot(&axes->forward, x, y, z);
    FXL_ESTIMATE_PLANE(FXL_PLANE_NEAR, (along >> 10) - (int32_t)(frustum->near_z >> 34), 170);
    FXL_ESTIMATE_PLANE(FXL_PLANE_FAR, (int32_t)(frustum->far_z >> 34) - (along >> 10), 170);
    along >>= 16;
    int32_t inset = (int32_t)(frustum->inset >> 34);
    int32_t apart = (frustum->x_side >> 15) * (fxl_estimated_dot(&axes->right, x, y, z) >> 16) >> 9;
    int32_t ahead = ((frustum->x_depth >> 15) * along >> 9) - inset;
    FXL_ESTIMATE_PLANE(FXL_PLANE_LEFT, ahead + apart, 600);
    FXL_ESTIMATE_PLANE(FXL_PLANE_RIGHT, ahead - apart, 600);
    apart = (frustum->y_side >> 15) * (fxl_estimated_dot(&axes->up, x, y, z) >> 16) >> 9;
    ahead = ((frustum->y_depth >> 15) * along >> 9) - inset;
    FXL_ESTIMATE_PLANE(FXL_PLANE_BOTTOM, ahead + apart, 600);
    FXL_ESTIMATE_PLANE(FXL_PLANE_TOP, ahead - apart, 600);
    return planes;
}

#endif

/* Whether a face of an instance is turned towards the eye:
 *   normal . (eye - first vertex) > 0.
 * Requires a checked scene, and an eye within FXL_COORDINATE_MAX.
 * Exact, given the stated normal: the sum is below 2^61.
 * Source: A6 (Listing 65.3, PolyFacesViewer). */
bool fxl_face_is_front(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       const fxl_point *eye);

/* Makes a face of an instance a polygon of the world, without texture.
 * Requires face->count <= FXL_FACE_VERTICES_MAX. Exact. */
void fxl_face_to_polygon(const fxl_model_view *model_view, const fxl_face *face,
                         fxl_polygon *polygon);

/* The same as fxl_face_is_front, with the first vertex relative to the eye: normal . (eye - vertex)
 * > 0. Exact. */
static inline bool fxl_model_view_face_is_front(const fxl_model_view *model_view,
                                                const fxl_face *face)
{
    fxl_point first = fxl_model_view_vertex(model_view, face->indices[0]);
    return fxl_dot_is_negative(&face->normal, first.x, first.y, first.z);
}

/* The faces of a model that are left to be submitted. */
typedef struct fxl_face_walk fxl_face_walk;

/* The next face that is turned to the eye and not dropped; null: none is left. It takes those that it
 * passes over off the walk, and the one that it returns. */
typedef const fxl_face *fxl_next_face(const fxl_model_view *model_view, fxl_face_walk *walk);

struct fxl_face_walk {
    const fxl_face *face; /* the next one, */
    int32_t step;         /* to the one after it: 1 or -1, */
    uint32_t left;        /* and how many are left */
    uint32_t outside;     /* faces that were dropped */
    uint32_t submitted;
    fxl_next_face *next;
    bool drops; /* faces whose vertices all lie outside one plane */
};

/* fxl_next_face of an instance that is not turned, a kernel of Armv7-M: fxl_next_face_by with
 * fxl_model_view_face_is_front. Requires what that requires, and face->count vertices of each face. */
fxl_next_face fxl_next_front_face;

/* Whether a face is turned towards the eye. */
typedef bool fxl_facing_test(const fxl_model_view *model_view, const fxl_face *face);

/* Whether the first vertex of a face is known to lie inside all planes. */
static inline bool fxl_starts_inside(const fxl_model_view *model_view, const fxl_face *face)
{
    const uint32_t number = face->indices[0];
    const fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    return face->count == 3 && entry->tag == model_view->tag + number &&
           (entry->clip_flags & FXL_PLANES_ALL) == 0;
}

/* fxl_next_face by a test of facing. */
static inline __attribute__((always_inline)) const fxl_face *
fxl_next_face_by(const fxl_model_view *model_view, fxl_face_walk *walk, fxl_facing_test *is_front)
{
    const fxl_face *next = walk->face;
    while (walk->left != 0) {
        const fxl_face *face = next;
        walk->left--;
        if (walk->left != 0) {
            next += walk->step;
        }
        if (!is_front(model_view, face)) {
            continue;
        }
        if (walk->drops && !fxl_starts_inside(model_view, face) &&
            fxl_face_is_outside(model_view, face)) {
            walk->outside++;
            continue;
        }
        walk->face = next;
        return face;
    }
    return NULL;
}

/* Below 2^62 for |value| < 2^31. */
static inline uint64_t fxl_square(int32_t value)
{
    return (uint64_t)fxl_multiply_s32(value, value);
}

/* The squared distance from the eye to the middle of a face's bounding box, with all coordinates
 * doubled, in units of 2^-34: the squared length of box - 2 eye. Requires
 * box and eye relative to the same point. The difference of two points of the world is below 2^30,
 * so each coordinate is below 2^31, and intermediate wraps cancel. */
static inline uint64_t fxl_box_distance(int32_t x, int32_t y, int32_t z, const fxl_point *eye)
{
    return fxl_square((int32_t)((uint32_t)x - 2 * (uint32_t)eye->x)) +
           fxl_square((int32_t)((uint32_t)y - 2 * (uint32_t)eye->y)) +
           fxl_square((int32_t)((uint32_t)z - 2 * (uint32_t)eye->z));
}

/* Whether a face faces the eye: normal . eye > height. Exact. For kernels whose estimate does not
 * decide. Requires what fxl_front_faces requires. */
bool fxl_bounded_face_is_front(const fxl_face *face, const fxl_face_bounds *bounds,
                               const fxl_point *eye);

/* Appends an entry, with squared distance and number, for each of count faces that faces the eye.
 * Their numbers are end - count to end - 1. A face does if normal . eye > height. Both sides are
 * below 2^61; fxl_face_is_front tests the sign of their difference. Returns the address behind the
 * last entry. The entries' `next` has no meaning. Requires count >= 1, and the eye relative to the
 * model's origin, each coordinate below 2^30. */
fxl_draw_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *bounds,
                                const fxl_point *eye, fxl_draw_entry *entry, uint32_t count,
                                uint32_t end);

#ifdef __cplusplus
}
#endif

#endif
