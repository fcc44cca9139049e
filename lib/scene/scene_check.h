/* SPDX-License-Identifier: MIT */
/* What the checks of a scene share: of the whole scene, of its tree, its clusters and its motions.
 * What the library asks of a beam of light. Internal. */
#ifndef FXL_SCENE_CHECK_H
#define FXL_SCENE_CHECK_H

#include "../math/arith.h"
#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef fxl_status fxl_scene_checker(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the tables that every scene has, then calls more; sets scene->draw_list_needed if no check
 * failed. */
fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more);

/* Checks the tree; FXL_OK if there is none. Requires that all other tables were checked. *fault
 * (may be null) is written only on an error. Takes time linear in the tree and in its model. */
fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the clusters; FXL_OK if there are none. Requires that the tables that every scene has were
 * checked. *fault (may be null) is written only on an error. Takes time linear in the faces. */
fxl_status fxl_cluster_check(const fxl_scene *scene, fxl_scene_fault *fault);

static inline bool fxl_motion_limits_in_range(const fxl_motion_limits *limits)
{
    return limits->acceleration >= 0 && limits->acceleration <= FXL_MOTION_MAX &&
           limits->friction >= 0 && limits->friction <= FXL_MOTION_MAX && limits->speed_max >= 0 &&
           limits->speed_max <= FXL_MOTION_MAX && limits->turn <= FXL_ANGLE_QUARTER;
}

/* place field: the check of its values, in the file of its table */
/* The status, and where it is not FXL_OK what of the scene is at fault; fault may be null. */
FXL_IN_PLACE_LARGE fxl_status fxl_fault_at(fxl_scene_fault *fault, const char *what, uint32_t index,
                                           fxl_status status)
#if FXL_IS_COMPACT && !defined(FXL_HERE)
    ;
#else
{
    if (fault != NULL) {
        fault->what = what;
        fault->index = index;
    }
    return status;
}
#endif

/* --- beams of light ------------------------------------------------------------------------ */

/* Tells whether every part of a face with so many vertices fits a polygon that a clipper may
 * cut. It does if the face's vertices, the planes of the first beam, and twice the planes of
 * each further beam add up to no more than FXL_FACE_VERTICES_MAX. Requires checked beams. */
bool fxl_beams_fit(const fxl_beam *beams, uint32_t beam_count, uint32_t face_vertices);

/* Returns a plane of a beam. Requires number < beam->plane_count. */
fxl_plane fxl_beam_plane_at(const fxl_beam *beam, uint32_t number);

/* Tells whether a face with this vertex and this normal is turned to the light. Exact.
 * Requires a point in range and a checked beam. */
bool fxl_beam_shines_on(const fxl_beam *beam, const fxl_point *vertex, const fxl_direction *normal);

/* Tells whether anything within a sphere may lie in the beam. The test is conservative: false
 * means that the sphere is behind one plane by 2^-14 unit or more.
 * Requires a centre in range, 0 <= radius <= FXL_RADIUS_MAX, a checked beam. */
bool fxl_beam_reaches(const fxl_beam *beam, const fxl_point *centre, fxl_q16_16 radius);

#ifdef __cplusplus
}
#endif

#endif
