/* SPDX-License-Identifier: MIT */
/* What a frame works out of an instance's placement. SPEC.md, section 8, defines each result.
 * Internal.
 */
#ifndef FXL_PLACEMENT_H
#define FXL_PLACEMENT_H

#include "../math/arith.h"
#include "fixel/camera.h"
#include "model_view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The model matrix times the view matrix, M = scale * view * orientation: *matrix is M / 2^shift,
 * each entry rounded once to 2.30. Returns the shift, the least for which 2^shift >= scale.
 * Requires a checked placement. Error: half a unit an entry, 2^(shift - 31) of M. If the placement
 * is FXL_PLACEMENT_NONE, *matrix is *view and the shift is 0. */
unsigned fxl_placement_matrix(const fxl_placement *placement, const fxl_axes *view,
                              fxl_axes *matrix);

/* A point of the model in the world: centre + scale * orientation . vertex, rounded once. point may
 * be centre. Requires a checked placement and a vertex of which each coordinate is within the
 * model's radius. A vertex within the radius comes within FXL_COORDINATE_MAX, any other within
 * three times that. Error: half a unit a coordinate. */
void fxl_placement_point(const fxl_placement *placement, const fxl_point *centre,
                         const fxl_point *vertex, fxl_point *point);

/* The eye in the space of the model, from_eye being the centre less the eye:
 * *eye is -(orientation^T . from_eye) / scale in units of 2^shift / 65536, rounded once. Returns
 * the shift: the least for which each |coordinate| + (radius >> shift) < 2^30.
 * Requires a checked placement; centre and eye within FXL_COORDINATE_MAX. */
unsigned fxl_placement_eye(const fxl_placement *placement, const fxl_point *from_eye,
                           fxl_q16_16 radius, fxl_point *eye);

/* A direction of the model in the world: orientation . direction, each component rounded once. */
void fxl_placement_direction(const fxl_placement *placement, const fxl_direction *direction,
                             fxl_direction *turned);

/* Whether the plane normal . v = height of the model shows its front to the eye:
 * normal . (orientation^T . (eye - centre)) > scale * height, exactly. height has units of 2^-46.
 * Requires a checked placement, from_eye as above, a unit vector, and |scale * height| < 2^14
 * units. */
bool fxl_placement_is_front(const fxl_placement *placement, const fxl_point *from_eye,
                            const fxl_direction *normal, fxl_q18_46 height);

/* fxl_placement_eye from the exact eye, orientation^T . (eye - centre) in units of 2^-46. */
unsigned fxl_placement_divide_eye(const fxl_q18_46 exact[3], fxl_q16_16 scale, fxl_q16_16 radius,
                                  fxl_point *eye);

/* Whether no coordinate exceeds the limit, which is at least 0. */
static inline bool fxl_eye_is_within(const fxl_point *point, int32_t limit)
{
    const uint32_t most = (uint32_t)limit;
    return (uint32_t)point->x + most <= 2 * most && (uint32_t)point->y + most <= 2 * most &&
           (uint32_t)point->z + most <= 2 * most;
}

/* *matrix = view * of, each entry rounded once to 2.30. Requires rows of the view and columns of
 * the orientation that are at most 1 + 2^-24 long: then an entry fits, and a sum of three products
 * is below 2^60 (1 + 2^-23), as is each of its parts. Error: half a unit an entry. */
void fxl_placement_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix);

/* A turned view. The caller owns it. */
typedef struct fxl_turned_view {
    /* Its axes are matrix. Its offset is less the eye in the space of the model, in units of
     * 2^eye_shift / 65536. It is the first member: scale_vertex and lights are given its address.
     */
    fxl_model_view model_view;
    fxl_axes matrix;
    const fxl_placement *placement;
    fxl_point from_eye; /* the instance's centre - the eye, along the world's axes */
    unsigned eye_shift;
} fxl_turned_view;

/* Sets up the turned view of an instance that is turned, as fxl_model_view_of_instance does, and
 * answers the instance's model. Its planes are those given; the caller gives those that
 * fxl_sphere_planes finds for fxl_placement_radius. Requires a checked scene and a checked
 * placement. */
const fxl_model *fxl_turned_view_of_instance(fxl_turned_view *turned, const fxl_scene *scene,
                                             uint32_t number, const fxl_view *view,
                                             fxl_vertex_cache *cache, uint32_t planes);

/* Fills entries with those of count faces of the instance's model, from first on, that face the
 * eye, as fxl_list_front_faces does. */
uint32_t fxl_list_turned_faces(const fxl_turned_view *turned, const fxl_scene *scene,
                               const fxl_model *model, uint32_t first, uint32_t count,
                               fxl_draw_entry *entries);

/* The planes that a cluster of the instance may cross, of the model view's, and
 * FXL_MODEL_VIEW_SCALED as the model view has it; or 0; or FXL_SPHERE_OUTSIDE. */
uint32_t fxl_turned_cluster_planes(const fxl_turned_view *turned, const fxl_cluster *cluster);

/* fxl_placement_is_front, from all bits. */
bool fxl_turned_view_is_front(const fxl_turned_view *turned, const fxl_face *face);

/* Whether a face is turned away from the eye: -1 no, 1 yes, 0 the estimate does not decide.
 * distance is normal . (first vertex - eye) in the space of the model, in units of
 * 2^(eye_shift - 46), from the rounded eye. Each coordinate of that is off by at most 1/2, the
 * normal's components sum up to less than 1.74 2^30, and the floor of a height adds 1: so the exact
 * distance differs by less than 2^30. It decides from 2^32 on, which the upper word tells. */
/* SPEC 8.3 */
static inline int fxl_estimated_side(fxl_q18_46 distance)
{
    const int32_t upper = (int32_t)(distance >> 32);
    if (upper < -1) {
        return -1;
    }
    return upper > 0;
}

/* Whether a face is turned towards the eye. Exact. is_near: eye_shift is 0. */
/* SPEC 8.3 */
static inline bool fxl_turned_view_face_is_front(const fxl_turned_view *turned,
                                                 const fxl_face *face, bool is_near)
{
    const fxl_model_view *model_view = &turned->model_view;
    if (is_near) {
        /* Below 2^30: fxl_placement_eye says so. */
        const fxl_point first = fxl_model_view_vertex(model_view, face->indices[0]);
        const int side = fxl_estimated_side(fxl_dot(&face->normal, first.x, first.y, first.z));
        if (side != 0) {
            return side < 0;
        }
    }
    return fxl_turned_view_is_front(turned, face);
}

#ifdef __cplusplus
}
#endif

#endif
