/* SPDX-License-Identifier: MIT */
/* What the library asks of a beam of light. Internal. */
#ifndef FXL_SCENE_BEAM_H
#define FXL_SCENE_BEAM_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

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
