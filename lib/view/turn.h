/* SPDX-License-Identifier: MIT */
/* What a frame works out of an instance's turn. SPEC.md, section 8, defines each result. Internal.
 * */
#ifndef FXL_TURN_H
#define FXL_TURN_H

#include "../math/arith.h"
#include "fixel/camera.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/* fxl_turn_eye from the exact eye, orientation^T . (eye - centre) in units of 2^-46. */
unsigned fxl_turn_divide_eye(const fxl_q18_46 exact[3], fxl_q16_16 scale, fxl_q16_16 radius,
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
void fxl_turn_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix);

#ifdef __cplusplus
}
#endif

#endif
