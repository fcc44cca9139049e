/* SPDX-License-Identifier: MIT */
/* What the stages of an orthographic lens share: the view of an instance, and the functions of its
 * clipper and its order (docs/extras/orthographic.md). Only what makes such a lens links them. Internal. */
#ifndef FXL_ORTHOGRAPHIC_H
#define FXL_ORTHOGRAPHIC_H

#include "../math/arith.h"
#include "../scene/lens.h"
#include "../view/placement.h"
#include "submit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The model view of an instance, turned or not, and forward in its model. */
typedef struct {
    fxl_turned_view turned; /* of one that is not turned its model_view, and a null placement */
    fxl_direction forward;
    const fxl_scene *scene;
    bool is_deep; /* there is a depth buffer */
    /* Where surfaces are attached: what scales a vertex; null: nothing. */
    uint32_t (*scale_vertex)(const fxl_model_view *model_view, fxl_cached_vertex *entry);
} fxl_orthographic_view;

static inline const fxl_orthographic_view *
fxl_orthographic_view_of(const fxl_model_view *model_view)
{
    return (const fxl_orthographic_view *)(const void *)model_view;
}

/* The sum of three products, below 2^62: a box is below 2^31.8 long, and forward at most
 * 1 + 2^-25. */
static inline int64_t fxl_along(const fxl_direction *forward, int32_t x, int32_t y, int32_t z)
{
    return fxl_multiply_s32(forward->x, x) + fxl_multiply_s32(forward->y, y) +
           fxl_multiply_s32(forward->z, z);
}

/* The planes of a view's frustum in the world whose distances say how far an off-centre lens moves the
 * eye (lib/draw/orthographic.c). */
enum {
    FXL_ALONG_RIGHT,
    FXL_ALONG_UP
};

/* scale * across, rounded. Across is below 2^62 and the scale at most 2^28, so what is summed is below
 * 2^59, in units of 2^-30 pixel. The 32 bits that the sum leaves out are below the half that rounding adds: a floor of
 * a floor. */
static inline int64_t fxl_pixels_of(uint32_t scale, fxl_q18_46 across)
{
    const uint64_t low = fxl_multiply_u32(scale, fxl_low_32(fxl_bits_64(across)));
    const int64_t high =
        fxl_multiply_s32((int32_t)scale, (int32_t)(across >> 32)) + (int64_t)(low >> 32);
    return fxl_round_shift(high, 14);
}

/* Where a point of the view is on the screen: a centre is below 2^28. */
/* orthographic 2.6 */
static inline int64_t fxl_orthographic_x(const fxl_view *view, const fxl_view_point *point)
{
    return view->lens.centre_x +
           fxl_pixels_of((uint32_t)view->lens.focal,
                         point->x + view->frustum.planes[FXL_ALONG_RIGHT].distance);
}

/* orthographic 2.6 */
static inline int64_t fxl_orthographic_y(const fxl_view *view, const fxl_view_point *point)
{
    return view->lens.centre_y -
           fxl_pixels_of((uint32_t)view->lens.focal,
                         point->y + view->frustum.planes[FXL_ALONG_UP].distance);
}

/* Surfaces find attributes by the corners' view points and the focal length. With an orthographic
 * lens these are those of corners in the plane z = C, seen with the focal length scale C: C is a power
 * of two, from which the screen is at most 2 C wide and high, and at least 1. So where surfaces are
 * attached, a vertex has this depth in the cache, once its clip flags were found. */
fxl_q18_46 fxl_flat_depth(const fxl_lens *lens);

/* fxl_model_view.scale_vertex: gives a vertex that depth. */
uint32_t fxl_flatten_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry);

/* fxl_clipper_view by parallel planes; the second for surfaces in a target with a depth buffer. */
extern const fxl_clipper fxl_orthographic_clipper, fxl_orthographic_deep_clipper;

/* fxl_by_distance by depths along forward. */
extern const fxl_order fxl_by_depth;

/* The members begin, face_is_front, submit, find_depth and distance_of of fxl_orthographic_code. */
void fxl_orthographic_begin(const fxl_traversal *traversal);
bool fxl_orthographic_face_is_front(const fxl_view *view, const fxl_scene *scene, uint32_t number,
                                    const fxl_face *face);
bool fxl_submit_orthographic(const fxl_traversal *traversal, const fxl_draw_entry *entry);
void fxl_find_orthographic_depth(const fxl_model_view *model_view, const fxl_face *face,
                                 struct fxl_depth_plane *plane);
fxl_q18_46 fxl_distance_of_orthographic(const fxl_view *view, fxl_q18_46 depth);

#ifdef __cplusplus
}
#endif

#endif
