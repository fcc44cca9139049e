/* SPDX-License-Identifier: MIT */
#include "scene/beam.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_beam_plane_at"
 * property = "the halves of its distance, exactly, and nothing out of bounds"
 * checks = 29
 */
void prove_beam_plane_at(void)
{
    fxl_beam beam;
    const uint32_t number = nondet_u32();
    ASSUME(beam.plane_count <= FXL_BEAM_PLANES_MAX && number < beam.plane_count);
    const fxl_plane plane = fxl_beam_plane_at(&beam, number);
    ASSERT("its two halves", fxl_low_32(fxl_bits_64(plane.distance)) == beam.planes[number].distance_low &&
                                 (uint32_t)(fxl_bits_64(plane.distance) >> 32) == beam.planes[number].distance_high);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_beam_shines_on"
 * property = "any checked beam, point in range and normal: nothing overflows"
 * checks = 134
 * uses = ["fxl_dot"]
 */
void prove_beam_shines_on(void)
{
    fxl_beam beam;
    fxl_point vertex;
    fxl_direction normal;
    ASSUME(WITHIN(normal.x, FXL_Q2_30_ONE + 4) && WITHIN(normal.y, FXL_Q2_30_ONE + 4) && WITHIN(normal.z, FXL_Q2_30_ONE + 4));
    const fxl_point from = {beam.from[0], beam.from[1], beam.from[2]};
    ASSUME(fxl_point_in_range(&vertex) && (beam.kind == FXL_BEAM_DIRECTION || fxl_point_in_range(&from)));
    /* as a unit vector of a checked beam is, but for a few units that no sum of two terms needs */
    ASSUME(beam.kind != FXL_BEAM_DIRECTION || (WITHIN(from.x, 1 << 30) && WITHIN(from.y, 1 << 30) && WITHIN(from.z, 1 << 30)));
    (void)fxl_beam_shines_on(&beam, &vertex, &normal);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_beam_reaches"
 * property = "any checked beam and sphere in range: nothing overflows or is out of bounds"
 * checks = 165
 * unwind = 9
 * uses = ["fxl_plane_distance"]
 */
void prove_beam_reaches(void)
{
    fxl_beam beam;
    fxl_point centre;
    const fxl_q16_16 radius = nondet_s32();
    ASSUME(beam.plane_count <= FXL_BEAM_PLANES_MAX && radius >= 0 && radius <= FXL_RADIUS_MAX && fxl_point_in_range(&centre));
    for (uint32_t i = 0; i < FXL_BEAM_PLANES_MAX; i++) {
        const fxl_direction *normal = &beam.planes[i].normal;
        ASSUME(WITHIN(normal->x, FXL_Q2_30_ONE + 4) && WITHIN(normal->y, FXL_Q2_30_ONE + 4) && WITHIN(normal->z, FXL_Q2_30_ONE + 4));
        const int64_t distance = fxl_signed_64((uint64_t)beam.planes[i].distance_high << 32 | beam.planes[i].distance_low);
        ASSUME(WITHIN(distance, ((int64_t)1 << 61) - 1));
    }
    (void)fxl_beam_reaches(&beam, &centre, radius);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_beams_fit"
 * property = "up to 4 beams of any planes: nothing is out of bounds, and no face of too many vertices fits"
 * checks = 15
 */
void prove_beams_fit(void)
{
    fxl_beam beams[FXL_BEAMS_MAX];
    const uint32_t count = nondet_u32(), vertices = nondet_u32();
    ASSUME(count <= FXL_BEAMS_MAX && vertices <= 255);
    const bool fits = fxl_beams_fit(beams, count, vertices);
    ASSERT("at most so many vertices", !fits || vertices <= FXL_FACE_VERTICES_MAX);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_beam_check"
 * property = "any beam, or null: nothing overflows or is out of bounds, and a checked one has 1 to 8 planes"
 * checks = 204
 * unwind = 9
 * uses = ["fxl_is_unit"]
 */
void prove_beam_check(void)
{
    fxl_beam beam;
    const fxl_status status = fxl_beam_check(nondet_bool() ? NULL : &beam);
    ASSERT("checked, its planes are in range", status != FXL_OK || (beam.plane_count >= 1 && beam.plane_count <= FXL_BEAM_PLANES_MAX &&
                                                                   beam.kind <= FXL_BEAM_DIRECTION));
    PROOF_ENDS();
}

fxl_status fxl_plane_from_points(const fxl_point *a, const fxl_point *b, const fxl_point *c, fxl_plane *plane)
{
    const bool good = nondet_bool();
    ASSERT("points in range", fxl_point_in_range(a) && fxl_point_in_range(b) && fxl_point_in_range(c));
    ANY_CONTENT(plane);
    ASSUME(!good || (FXL_DIRECTION(&plane->normal) && WITHIN(plane->distance, (int64_t)1 << 61)));
    return good ? FXL_OK : FXL_E_DEGENERATE;
}

/* [[row]]
 * function = "fxl_beam_from_point"
 * property = "any light and window of up to 4 corners, and null pointers: nothing overflows or is out of bounds, and there is a plane for each side and one more"
 * checks = 594
 * unwind = 5
 * uses = ["fxl_unit_cross", "fxl_plane_from_point", "fxl_plane_distance"]
 * stubs = { fxl_plane_from_points = "any plane in range, or a status" }
 */
void prove_beam_from_point(void)
{
    fxl_point light, window[FXL_BEAM_PLANES_MAX - 1];
    fxl_beam beam;
    const uint32_t count = nondet_u32();
    ASSUME(count <= 4); /* a window of as many sides as most have */
    const fxl_status status = fxl_beam_from_point(nondet_bool() ? NULL : &light, nondet_bool() ? NULL : window, count, nondet_bool() ? NULL : &beam);
    ASSERT("a plane for each side, and the window's", status != FXL_OK || beam.plane_count == count + 1u);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_beam_from_direction"
 * property = "any direction and window of up to 4 corners, and null pointers: nothing overflows or is out of bounds, and there is a plane for each side and one more"
 * checks = 656
 * unwind = 5
 * uses = ["fxl_unit_cross", "fxl_plane_from_point", "fxl_plane_distance", "fxl_is_unit", "fxl_dot"]
 * stubs = { fxl_plane_from_points = "any plane in range, or a status" }
 */
void prove_beam_from_direction(void)
{
    fxl_direction travel;
    fxl_point window[FXL_BEAM_PLANES_MAX - 1];
    fxl_beam beam;
    const uint32_t count = nondet_u32();
    ASSUME(count <= 4);
    /* as in fxl_beam_shines_on */
    ASSUME(WITHIN(travel.x, 1 << 30) && WITHIN(travel.y, 1 << 30) && WITHIN(travel.z, 1 << 30));
    const fxl_status status = fxl_beam_from_direction(nondet_bool() ? NULL : &travel, nondet_bool() ? NULL : window, count, nondet_bool() ? NULL : &beam);
    ASSERT("a plane for each side, and the window's", status != FXL_OK || beam.plane_count == count + 1u);
    PROOF_ENDS();
}
