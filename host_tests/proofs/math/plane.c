/* SPDX-License-Identifier: MIT */
#include "math/plane.c"
#include "math/pixel_centre.h"
#include "math/memory.h"
#include "math/product.h"
#include "proof.h"

/* [[row]]
 * function = "fxl_plane_from_point"
 * property = "the distance is below 2^61 and fits"
 * checks = 198
 * contract = true
 * uses = ["fxl_dot", "fxl_point_in_range"]
 */
void prove_plane_from_point(void)
{
    fxl_point *point;
    fxl_direction *normal;
    (void)fxl_plane_from_point(point, normal, nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_plane_distance"
 * property = "nothing overflows for any plane and point in range"
 * checks = 182
 * contract = true
 * uses = ["fxl_dot", "fxl_point_in_range"]
 */
void prove_plane_distance(void)
{
    fxl_plane *plane;
    fxl_point *point;
    (void)fxl_plane_distance(plane, point);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/plane.h:fxl_is_unit"
 * property = "nothing overflows for any direction"
 * checks = 102
 * contract = true
 */
void prove_is_unit(void)
{
    fxl_direction *normal;
    (void)fxl_is_unit(normal);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/plane.h:fxl_square_root"
 * property = "it ends after 32 rounds"
 * checks = 8
 * contract = true
 * unwind = 33
 */
void prove_square_root(void)
{
    (void)fxl_square_root(nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * id = "fxl_square_root, its range"
 * function = "lib/math/plane.h:fxl_square_root"
 * property = "of a number below 3 2^60 at most 7 2^28"
 * checks = 2
 * unwind = 33
 */
void prove_square_root_range(void)
{
    const uint64_t value = nondet_u64();
    const uint32_t root = fxl_square_root(value);
    ASSERT("at most 7 2^28", value >> 60 >= 3 || root <= 0x70000000u);
    PROOF_ENDS();
}

/* [[row]]
 * function = "cross"
 * property = "each component is at most 2^61"
 * checks = 77
 */
void prove_cross(void)
{
    fxl_point a, b;
    ASSUME(WITHIN(a.x, 1 << 30) && WITHIN(a.y, 1 << 30) && WITHIN(a.z, 1 << 30));
    ASSUME(WITHIN(b.x, 1 << 30) && WITHIN(b.y, 1 << 30) && WITHIN(b.z, 1 << 30));
    const wide_vector c = cross(&a, &b);
    ASSERT("at most 2^61", WITHIN(c.x, (int64_t)1 << 61) && WITHIN(c.y, (int64_t)1 << 61) &&
                               WITHIN(c.z, (int64_t)1 << 61));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_plane_from_points"
 * property = "nothing overflows for any points and null pointers; a plane has a unit normal and a distance of at most 2^61"
 * checks = 344
 * uses = ["fxl_unit_cross", "fxl_point_in_range", "fxl_plane_from_point", "fxl_subtract"]
 */
void prove_plane_from_points(void)
{
    fxl_point *a = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *a, 0);
    fxl_point *b = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *b, 0);
    fxl_point *c = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *c, 0);
    fxl_plane *plane = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *plane, 0);
    const fxl_status status = fxl_plane_from_points(a, b, c, plane);
    ASSERT("a unit normal, and a distance", status != FXL_OK || (FXL_DIRECTION(&plane->normal) && WITHIN(plane->distance, (int64_t)1 << 61)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "shifted"
 * property = "at most 2^30, and not 0 for the longest component"
 * checks = 25
 * contract = true
 */
void prove_shifted(void)
{
    (void)shifted(nondet_s64(), (int)nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "normalise"
 * property = "nothing overflows, and each quotient fits"
 * checks = 176
 * contract = true
 * equations = true
 * uses = ["fxl_square_root", "fxl_divide_round", "shifted"]
 */
void prove_normalise(void)
{
    wide_vector *v;
    fxl_direction *unit;
    (void)normalise(v, unit);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_unit_cross"
 * property = "nothing overflows, and each component of the result is at most 1"
 * checks = 304
 * contract = true
 * uses = ["normalise"]
 */
void prove_unit_cross(void)
{
    fxl_point *a, *b;
    fxl_direction *unit;
    (void)fxl_unit_cross(a, b, unit);
    PROOF_ENDS();
}

/* --- what is inline beside it ---------------------------------------------------------------- */

/* [[row]]
 * function = "lib/math/pixel_centre.h:fxl_first_centre_from"
 * property = "it is at most a row if and only if the coordinate is at most that row's centre"
 * checks = 5
 */
void prove_first_centre_from(void)
{
    const int32_t coordinate = nondet_s32(), row = nondet_s32();
    ASSUME(WITHIN(coordinate, 1 << 30) && WITHIN(row, 1 << 14));
    ASSERT("the rule of the header", (fxl_first_centre_from(coordinate) <= row) == (coordinate <= fxl_centre_of(row)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/memory.h:fxl_is_aligned"
 * property = "nothing is undefined"
 * checks = 2
 */
void prove_is_aligned(void)
{
    (void)fxl_is_aligned((const void *)nondet_size(), (size_t)1 << (nondet_u8() & 3));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/math/product.h:fxl_upper_product"
 * property = "none of these products overflows or shifts wrongly"
 * checks = 5
 */
void prove_upper_product(void)
{
    (void)fxl_upper_product(nondet_s32(), nondet_s32());
    (void)fxl_multiply_s31(nondet_s32(), nondet_s32());
    (void)fxl_upper_product_unsigned(nondet_u32(), nondet_u32());
    (void)fxl_product_wide(nondet_s64(), nondet_s32());
    (void)fxl_multiply_su32(nondet_s32(), nondet_u32());
    (void)fxl_multiply_s64_u16(nondet_s64(), nondet_u16());
    PROOF_ENDS();
}
