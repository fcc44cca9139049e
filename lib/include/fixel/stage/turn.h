/* SPDX-License-Identifier: MIT */
/* Instances that turn and scale: the check of a turn, and what a frame works out from it. SPEC.md,
 * section 8, defines each result. A turn is in RAM of the caller, who may change it between the
 * last band of a frame, or fxl_frame_release_scene, and the next fxl_frame_begin. */
#ifndef FXL_TURN_H
#define FXL_TURN_H

#include "fixel/scene.h"
#include "fixel/stage/camera.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Added to scale * radius, in units of 1/65536: more than tolerated rows and all rounding move a
 * point of an instance away from its centre. */
#define FXL_TURN_SLACK 32

/* Whether an instance at a centre, whose model has a radius, may be turned so. Its time does not
 * depend on the model.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a scale outside FXL_SCALE_MIN..FXL_SCALE_MAX; a radius outside 0..FXL_RADIUS_MAX;
 * or a coordinate of the centre beyond FXL_COORDINATE_MAX less fxl_turn_radius.
 * FXL_E_TURN: rows that are no rotation.
 * All six products of two rows may differ from those of a rotation by less than 2^-28; SPEC.md,
 * section 8.1, has the exact test. A mirror image is no rotation. */
fxl_status fxl_turn_check(const fxl_turn *turn, const fxl_point *centre, fxl_q16_16 radius);

/* The radius of a turned instance: scale * radius, rounded upward, and FXL_TURN_SLACK. No point of
 * the instance is farther from its centre. Requires a scale within its range and
 * scale * radius <= 2 * FXL_COORDINATE_MAX. */
fxl_q16_16 fxl_turn_radius(const fxl_turn *turn, fxl_q16_16 radius);

/* The model matrix times the view matrix, M = scale * view * orientation: *matrix is M / 2^shift,
 * each entry rounded once to 2.30. Returns the shift, the least for which 2^shift >= scale.
 * Requires a checked turn. Error: half a unit an entry, 2^(shift - 31) of M. If the turn is
 * FXL_TURN_NONE, *matrix is *view and the shift is 0. */
unsigned fxl_turn_matrix(const fxl_turn *turn, const fxl_axes *view, fxl_axes *matrix);

/* A point of the model in the world: centre + scale * orientation . vertex, rounded once. point may
 * be centre. Requires a checked turn and a vertex of which each coordinate is within the model's
 * radius. A vertex within the radius comes within FXL_COORDINATE_MAX, any other within three times
 * that. Error: half a unit a coordinate. */
void fxl_turn_point(const fxl_turn *turn, const fxl_point *centre, const fxl_point *vertex,
                    fxl_point *point);

/* The eye in the space of the model, from_eye being the centre less the eye:
 * *eye is -(orientation^T . from_eye) / scale in units of 2^shift / 65536, rounded once. Returns
 * the shift: the least for which each |coordinate| + (radius >> shift) < 2^30.
 * Requires a checked turn; centre and eye within FXL_COORDINATE_MAX. */
unsigned fxl_turn_eye(const fxl_turn *turn, const fxl_point *from_eye, fxl_q16_16 radius,
                      fxl_point *eye);

/* A direction of the model in the world: orientation . direction, each component rounded once. */
void fxl_turn_direction(const fxl_turn *turn, const fxl_direction *direction,
                        fxl_direction *turned);

/* Whether the plane normal . v = height of the model shows its front to the eye:
 * normal . (orientation^T . (eye - centre)) > scale * height, exactly. height has units of 2^-46.
 * Requires a checked turn, from_eye as above, a unit vector, and |scale * height| < 2^14 units. */
bool fxl_turn_is_front(const fxl_turn *turn, const fxl_point *from_eye, const fxl_direction *normal,
                       fxl_q18_46 height);

#ifdef __cplusplus
}
#endif

#endif
