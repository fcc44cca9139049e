/* SPDX-License-Identifier: MIT */
#include "math/plane.c"
#include "math/pixel_centre.h"
#include "math/memory.h"
#include "math/product.h"
#include "proof.h"

void prove_plane_from_point(void)
{
    fxl_point *point;
    fxl_direction *normal;
    (void)fxl_plane_from_point(point, normal, nondet_s32());
    PROOF_ENDS();
}

void prove_plane_distance(void)
{
    fxl_plane *plane;
    fxl_point *point;
    (void)fxl_plane_distance(plane, point);
    PROOF_ENDS();
}

void prove_is_unit(void)
{
    fxl_direction *normal;
    (void)fxl_is_unit(normal);
    PROOF_ENDS();
}

void prove_square_root(void)
{
    (void)fxl_square_root(nondet_u64());
    PROOF_ENDS();
}

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

void prove_plane_from_points(void)
{
    fxl_point *a = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *a, 0);
    fxl_point *b = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *b, 0);
    fxl_point *c = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *c, 0);
    fxl_plane *plane = nondet_bool() ? NULL : __CPROVER_allocate(sizeof *plane, 0);
    (void)fxl_plane_from_points(a, b, c, plane);
    PROOF_ENDS();
}

void prove_shifted(void)
{
    (void)shifted(nondet_s64(), (int)nondet_s32());
    PROOF_ENDS();
}

void prove_normalise(void)
{
    wide_vector *v;
    fxl_direction *unit;
    (void)normalise(v, unit);
    PROOF_ENDS();
}

void prove_unit_cross(void)
{
    fxl_point *a, *b;
    fxl_direction *unit;
    (void)fxl_unit_cross(a, b, unit);
    PROOF_ENDS();
}

/* --- what is inline beside it ---------------------------------------------------------------- */

void prove_first_centre_from(void)
{
    const int32_t coordinate = nondet_s32(), row = nondet_s32();
    ASSUME(WITHIN(coordinate, 1 << 30) && WITHIN(row, 1 << 14));
    ASSERT("the rule of the header", (fxl_first_centre_from(coordinate) <= row) == (coordinate <= fxl_centre_of(row)));
    PROOF_ENDS();
}

void prove_is_aligned(void)
{
    (void)fxl_is_aligned((const void *)nondet_size(), (size_t)1 << (nondet_u8() & 3));
    PROOF_ENDS();
}

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
