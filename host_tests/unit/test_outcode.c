/* SPDX-License-Identifier: MIT */
/* Outcodes against the distances that they stand for. */
#include "unit.h"

#define LIMIT ((int64_t)1 << 61)

static fxl_planes planes_outside(const fxl_view_frustum *frustum, const fxl_view_point *point)
{
    unsigned outside = 0;
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        outside |= (unsigned)(fxl_view_distance(frustum, plane, point) < 0) << plane;
    }
    return (fxl_planes)outside;
}

static fxl_planes expect_outcode(const fxl_view_frustum *frustum, const fxl_view_point *point)
{
    fxl_planes outside = planes_outside(frustum, point);
    fxl_planes some = (fxl_planes)(unit_random() & FXL_PLANES_ALL);
    TEST_ASSERT_EQUAL_HEX8(outside, fxl_outcode(frustum, FXL_PLANES_ALL, point));
    TEST_ASSERT_EQUAL_HEX8(outside & some, fxl_outcode(frustum, some, point));
    return outside;
}

static fxl_view_frustum random_frustum(void)
{
    fxl_view_frustum frustum;
    fxl_lens lens = unit_any_lens();
    fxl_view_frustum_from_lens(&lens, &frustum);
    return frustum;
}

void test_each_plane_has_its_bit(void)
{
    fxl_view_frustum frustum;
    fxl_lens lens = unit_lens(64, 64); /* 90 degrees, near 1/16, far 1000 */
    fxl_view_frustum_from_lens(&lens, &frustum);
    static const struct {
        int x, y, z;
        unsigned outside;
    } points[] = {
        {0, 0, 10, 0},
        {-20, 0, 10, 1u << FXL_PLANE_LEFT},
        {20, 0, 10, 1u << FXL_PLANE_RIGHT},
        {0, -20, 10, 1u << FXL_PLANE_BOTTOM},
        {0, 20, 10, 1u << FXL_PLANE_TOP},
        {0, 0, 1001, 1u << FXL_PLANE_FAR},
        {20, -20, 10, 1u << FXL_PLANE_RIGHT | 1u << FXL_PLANE_BOTTOM},
        /* behind the eye, so beyond both of a pair */
        {0, 0, -10,
         1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT |
             1u << FXL_PLANE_BOTTOM | 1u << FXL_PLANE_TOP},
    };
    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++) {
        const int64_t unit = (int64_t)1 << 46;
        fxl_view_point point = {points[i].x * unit, points[i].y * unit, points[i].z * unit};
        TEST_ASSERT_EQUAL_HEX8(points[i].outside, fxl_outcode(&frustum, FXL_PLANES_ALL, &point));
        expect_outcode(&frustum, &point);
    }
}

/* SPEC 4.7 */
void test_any_point(void)
{
    unsigned seen = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view_frustum frustum = random_frustum();
        unsigned bits = (unsigned)unit_between(36, 61);
        for (int k = 0; k < 4; k++) {
            fxl_view_point point = {unit_wide(bits), unit_wide(bits), unit_wide(bits)};
            seen |= expect_outcode(&frustum, &point);
        }
    }
    TEST_ASSERT_EQUAL_HEX8(FXL_PLANES_ALL, seen);
}

/* Where a plane of this pair is, for a depth, to within 2^-20 of a unit or so. */
static int64_t side_at(fxl_q2_30 side, fxl_q2_30 depth, int64_t z, int64_t inset)
{
    double across =
        ((double)inset - (double)depth * (double)z / 1073741824.0) * 1073741824.0 / side;
    return across > -0x1p60 && across < 0x1p60 ? (int64_t)across : 0;
}

/* About the planes, by steps from one unit to beyond what the upper words tell. */
void test_points_beside_a_plane(void)
{
    int inside = 0, outside = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view_frustum frustum = random_frustum();
        int64_t z = unit_wide((unsigned)unit_between(38, 59));
        int64_t x = side_at(frustum.x_side, frustum.x_depth, z, frustum.inset);
        int64_t y = side_at(frustum.y_side, frustum.y_depth, z, frustum.inset);
        fxl_view_point points[] = {{x, 0, z},  {-x, 0, z}, {0, y, z},
                                   {0, -y, z}, {x, y, z},  {x, y, frustum.near_z}};
        for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
            fxl_view_point *point = &points[k];
            int64_t *moved = unit_random() % 3 == 0 ? &point->z : k < 2 ? &point->x : &point->y;
            *moved += unit_wide((unsigned)unit_between(1, 40));
            if (*moved<LIMIT && * moved> - LIMIT) {
                fxl_planes code = expect_outcode(&frustum, point);
                inside += code == 0;
                outside += code != 0;
            }
        }
        fxl_view_point ends[] = {{0, 0, frustum.near_z}, {0, 0, frustum.far_z}};
        for (int k = 0; k < 2; k++) {
            ends[k].z += unit_between(-1, 1);
            expect_outcode(&frustum, &ends[k]);
        }
    }
    TEST_ASSERT_TRUE(inside > UNIT_REPEAT / 4 && outside > UNIT_REPEAT / 4);
}
