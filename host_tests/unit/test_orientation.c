/* SPDX-License-Identifier: MIT */
/* Orientations against long double, and instances that are attached to others. */
#include <math.h>
#include <stdlib.h>

#include "exact_placement.h"
#include "unit.h"

static const fxl_point origin = {0, 0, 0};
static const fxl_orientation identity = FXL_ORIENTATION_NONE;

static void expect_near(const exact_placement *wanted, const fxl_orientation *actual,
                        long double bound)
{
    TEST_ASSERT_NEAR(exact_distance(wanted, actual), 0, bound);
}

/* The rows are 1.8 units from unit length and right angles, which is less than the range's 4. */
static void expect_rows(const fxl_orientation *o)
{
    fxl_q2_30 rows[3][3];
    exact_entries(o, rows);
    const fxl_placement placement = {*o, FXL_Q16_16_ONE};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_check(&placement, &origin, 0));
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j <= i; j++) {
            int64_t sum = i == j ? -((int64_t)1 << 60) : 0;
            for (int k = 0; k < 3; k++) {
                sum += (int64_t)rows[i][k] * rows[j][k];
            }
            TEST_ASSERT_TRUE(llabs(sum) <= (int64_t)(1.8 * (i == j ? 2 : 1) * FXL_Q2_30_ONE));
        }
    }
}

static fxl_orientation by_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(yaw, pitch, roll, &o));
    return o;
}

static fxl_orientation by_axis(fxl_point axis, fxl_angle angle)
{
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_axis(&axis, angle, &o));
    return o;
}

static fxl_orientation times(const fxl_orientation *a, const fxl_orientation *b)
{
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(a, b, &o));
    return o;
}

static fxl_orientation any_orientation(void)
{
    return by_angles(unit_random(), unit_random(), unit_random());
}

void test_turned_by_nothing_it_is_the_identity(void)
{
    const fxl_orientation o = by_angles(0, 0, 0);
    TEST_ASSERT_EQUAL_MEMORY(&identity, &o, sizeof o);
}

/* An object that is turned so looks where the camera looks: its columns are the camera's rows. */
/* orientation 1.1 */
void test_angles_are_those_of_the_camera(void)
{
    const fxl_pose pose = {{0, 0, 0}, DEGREES(30), DEGREES(-50), DEGREES(110)};
    const fxl_orientation o = by_angles(pose.yaw, pose.pitch, pose.roll);
    fxl_camera camera;
    fxl_camera_from_pose(&pose, &camera);
    TEST_ASSERT_NEAR(camera.axes.forward.x, o.x.z, 4);
    TEST_ASSERT_NEAR(camera.axes.forward.y, o.y.z, 4);
    TEST_ASSERT_NEAR(camera.axes.right.y, o.y.x, 4);
    TEST_ASSERT_NEAR(camera.axes.up.z, o.z.y, 4);
}

void test_quarter_turns_are_exact(void)
{
    for (uint32_t i = 0; i < 64; i++) {
        const fxl_angle yaw = (i & 3) << 30, pitch = (i >> 2 & 3) << 30, roll = (i >> 4) << 30;
        const exact_placement wanted = exact_angles(yaw, pitch, roll);
        const fxl_orientation o = by_angles(yaw, pitch, roll);
        expect_near(&wanted, &o, 1e-6L);
        TEST_ASSERT_EQUAL_INT32(0, (o.x.x | o.x.y | o.x.z | o.y.x) & 0x3FFFFFFF);
    }
}

/* orientation 1.1, accuracy 1.2i */
void test_angles_are_within_four_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 3; i++) {
        const fxl_angle yaw = unit_random(), pitch = unit_random(), roll = unit_random();
        const exact_placement wanted = exact_angles(yaw, pitch, roll);
        const fxl_orientation o = by_angles(yaw, pitch, roll);
        expect_near(&wanted, &o, 4);
        expect_rows(&o);
    }
}

/* Yaw is a turn about y, pitch one about -x, roll one about z. */
/* orientation 1.2a-b */
void test_an_axis_turns_as_the_angles_do(void)
{
    const fxl_angle angle = DEGREES(37);
    const exact_placement yaw = exact_angles(angle, 0, 0), pitch = exact_angles(0, angle, 0),
                          roll = exact_angles(0, 0, angle);
    fxl_orientation o = by_axis((fxl_point){0, 7, 0}, angle);
    expect_near(&yaw, &o, 4);
    o = by_axis((fxl_point){-1, 0, 0}, angle);
    expect_near(&pitch, &o, 4);
    o = by_axis((fxl_point){0, 0, FXL_COORDINATE_MAX}, angle);
    expect_near(&roll, &o, 4);
}

/* accuracy 1.2i, orientation 1.2a, 1.2c */
void test_an_axis_is_within_four_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 3; i++) {
        const fxl_q16_16 limit = 1 + (fxl_q16_16)(unit_random() >> (2 + unit_random() % 29));
        fxl_point axis = unit_point(limit < FXL_COORDINATE_MAX ? limit : FXL_COORDINATE_MAX);
        axis.x += (axis.x | axis.y | axis.z) == 0;
        const fxl_angle angle = unit_random() >> unit_random() % 31;
        const exact_placement wanted = exact_axis(axis, angle);
        const fxl_orientation o = by_axis(axis, angle);
        expect_near(&wanted, &o, 4);
        expect_rows(&o);
    }
}

/* orientation 1.2a */
void test_a_half_turn_about_an_axis(void)
{
    fxl_orientation o = by_axis((fxl_point){0, 0, 5}, 0x80000000u);
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, o.x.x);
    TEST_ASSERT_EQUAL_INT32(-FXL_Q2_30_ONE, o.y.y);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, o.z.z);
    o = by_axis((fxl_point){3, 4, 5}, 0);
    TEST_ASSERT_EQUAL_MEMORY(&identity, &o, sizeof o);
}

void test_looking_along_z_turns_nothing(void)
{
    const fxl_point ahead = {0, 0, 12345}, up = {0, 77, 0};
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_look_at(&ahead, &up, &o));
    TEST_ASSERT_EQUAL_MEMORY(&identity, &o, sizeof o);
}

/* Also where direction and up are nearly parallel. */
/* accuracy 1.2i, orientation 1.3a */
void test_look_at_is_within_four_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 3; i++) {
        const fxl_point direction = unit_point(unit_between(1, 0x3FFFFFFF));
        fxl_point up = unit_point(unit_between(1, 0x3FFFFFFF));
        if (i % 4 == 0) {
            up = (fxl_point){direction.x / 2 + unit_between(-3, 3), direction.y / 2,
                             direction.z / 2 + unit_between(-3, 3)};
        }
        fxl_orientation o;
        const fxl_status status = fxl_orientation_look_at(&direction, &up, &o);
        if (status == FXL_OK) {
            const exact_placement wanted = exact_look(direction, up);
            expect_near(&wanted, &o, i % 4 == 0 && sizeof wanted.at[0][0] == 8 ? 1e9L : 4);
            expect_rows(&o);
        } else {
            TEST_ASSERT_EQUAL(FXL_E_RANGE, status);
        }
    }
}

/* orientation 1.3b */
void test_directions_without_a_turn_are_refused(void)
{
    const fxl_point zero = {0, 0, 0}, up = {0, 3, 0}, down = {0, -5, 0}, far = {1 << 30, 0, 0};
    const fxl_orientation before = by_angles(1, 2, 3);
    fxl_orientation o = before;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_look_at(&zero, &up, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_look_at(&up, &zero, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_look_at(&down, &up, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_look_at(&far, &up, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_look_at(&up, &far, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_from_axis(&zero, 5, &o));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_from_axis(&far, 5, &o));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_look_at(NULL, &up, &o));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_look_at(&up, NULL, &o));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_look_at(&up, &up, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_from_axis(NULL, 5, &o));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_from_axis(&up, 5, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_from_angles(1, 2, 3, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
}

/* accuracy 1.2i, orientation 1.4b */
void test_a_product_is_the_nearest_rotation(void)
{
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        fxl_orientation a = any_orientation(), b = any_orientation();
        a.x.y += unit_between(-1, 1); /* also where the rows are not the best ones */
        b.z.x += unit_between(-1, 1);
        const exact_placement wanted = exact_nearest_to_product(&a, &b);
        const fxl_orientation o = times(&a, &b);
        expect_near(&wanted, &o, 0.501L);
        expect_rows(&o);
    }
}

/* b is the first turn: a yawed model that was rolled before. */
/* orientation 1.4a */
void test_the_second_factor_turns_first(void)
{
    const fxl_orientation yaw = by_angles(DEGREES(40), 0, 0), roll = by_angles(0, 0, DEGREES(70));
    const exact_placement wanted = exact_angles(DEGREES(40), 0, DEGREES(70));
    const fxl_orientation o = times(&yaw, &roll);
    expect_near(&wanted, &o, 8);
}

/* Each product is made orthonormal again, so no chain leaves the range. The drift from the exact
 * turn is below 1.5 units a product. */
/* orientation 1.4c */
void test_a_million_products_stay_in_range(void)
{
    const int count = UNIT_REPEAT * 10;
    const fxl_angle step = 0x01234567u;
    const fxl_orientation small = by_axis((fxl_point){2, 3, 6}, step);
    fxl_orientation o = identity;
    for (int i = 0; i < count; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(&o, &small, &o));
    }
    expect_rows(&o);
    const exact_placement wanted =
        exact_axis((fxl_point){2, 3, 6}, (fxl_angle)((uint32_t)count * step));
    expect_near(&wanted, &o, 6.0L * count);
}

void test_rows_that_are_no_rotation_are_refused(void)
{
    const fxl_orientation good = any_orientation();
    fxl_orientation out = good;
    fxl_orientation bad[6] = {good, good, good, identity, identity, identity};
    memset(&bad[0].y, 0, sizeof bad[0].y); /* a row of length 0 */
    bad[1].z = bad[1].x;                   /* two equal rows */
    bad[2].x.x = INT32_MIN;                /* out of every range */
    bad[3].z.z = -FXL_Q2_30_ONE;           /* a mirror */
    bad[4].x.x += 5;                       /* 5 units too long */
    bad[5].x.y = 5;                        /* 5 units off a right angle */
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_orientation_multiply(&bad[i], &good, &out));
        TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_orientation_multiply(&good, &bad[i], &out));
    }
    bad[4].x.x -= 4; /* within 2^-28: a squared length, and a right angle */
    bad[5].x.y = 3;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_multiply(NULL, &good, &out));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_multiply(&good, NULL, &out));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_multiply(&good, &good, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&good, &out, sizeof out);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(&bad[4], &bad[5], &out));
    expect_rows(&out);
}

/* The same bits on every board: a hash of many results. */
void test_every_board_gives_the_same_orientations(void)
{
    fxl_orientation chain = identity;
    uint32_t crc = 0, number = 1;
    for (int i = 0; i < 200; i++) {
        fxl_orientation o;
        number = number * 1664525u + 1013904223u;
        const fxl_point to = {(int32_t)(number >> 3), (int32_t)(number % 1000003u) - 500000, i + 1};
        const fxl_point up = {3 - i, 65536, (int32_t)(number >> 17)};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(number, number * 3, number * 7, &o));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(&chain, &o, &chain));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_axis(&to, number, &o));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(&chain, &o, &chain));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_look_at(&to, &up, &o));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_multiply(&o, &chain, &chain));
        crc ^= unit_crc32((const uint8_t *)&chain, sizeof chain);
    }
    TEST_ASSERT_EQUAL_HEX32(0x83E79135u, crc);
}

/* Instances that are attached to others, against long double. */

#define DEPTH 8

static const fxl_placement still = FXL_PLACEMENT_NONE;

static fxl_placement any_placement(fxl_q16_16 low, fxl_q16_16 high)
{
    fxl_placement placement;
    placement.scale = unit_between(low, high);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(unit_random(), unit_random(),
                                                          unit_random(), &placement.orientation));
    return placement;
}

static void expect_centre(const exact_place *wanted, const fxl_point *actual, long double bound)
{
    TEST_ASSERT_NEAR(wanted->centre[0], actual->x, bound);
    TEST_ASSERT_NEAR(wanted->centre[1], actual->y, bound);
    TEST_ASSERT_NEAR(wanted->centre[2], actual->z, bound);
}

/* orientation 3.1a-b */
void test_a_wheel_goes_with_its_car(void)
{
    const fxl_point car = {Q16(10), 0, Q16(-3)}, wheel = {Q16(1), Q16(0.5), Q16(2)};
    fxl_placement turned = still, placement;
    fxl_point centre;
    turned.scale = Q16(2);
    fxl_orientation_from_angles(FXL_ANGLE_QUARTER, 0, 0, &turned.orientation);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_placement_attach(&car, &turned, &wheel, &still, &centre, &placement));
    /* The car looks along +x: its right side is -z, what is before it is +x. */
    TEST_ASSERT_EQUAL_INT32(Q16(10 + 4), centre.x);
    TEST_ASSERT_EQUAL_INT32(Q16(1), centre.y);
    TEST_ASSERT_EQUAL_INT32(Q16(-3 - 2), centre.z);
    TEST_ASSERT_EQUAL_MEMORY(&turned, &placement, sizeof placement);
}

/* A centre is exact but for one rounding, with any scale. */
/* orientation 3.1c */
void test_a_centre_is_within_half_a_unit(void)
{
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_placement parent =
            any_placement(FXL_SCALE_MIN, i % 2 ? FXL_SCALE_MAX : 2 * 65536);
        const fxl_point at = unit_point(FXL_COORDINATE_MAX / 2);
        const int64_t room = ((int64_t)FXL_COORDINATE_MAX / 4 << 16) / parent.scale;
        const fxl_point child = unit_point(room < 0x3FFFFFFF ? (fxl_q16_16)room : 0x3FFFFFFF);
        fxl_point centre;
        fxl_placement placement;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_placement_attach(&at, &parent, &child, &still, &centre, &placement));
        const exact_place p = exact_place_of(&at, &parent), c = exact_place_of(&child, &still);
        const exact_place wanted = exact_attached(&p, &c);
        expect_centre(&wanted, &centre, 0.5L + (sizeof p.scale == 8 ? 1e-6L : 1e-9L));
        TEST_ASSERT_EQUAL_INT32(parent.scale, placement.scale);
    }
}

/* docs/extras/orientation.md, section 3: the bound by depth. */
/* orientation 3.1b, 3.2b-c, 3.2e-f */
void test_a_chain_of_eight_is_within_its_bound(void)
{
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_point centre = unit_point(FXL_UNITS(1000)), local;
        fxl_placement placement = any_placement(Q16(0.5), Q16(2)), child;
        exact_place wanted = exact_place_of(&centre, &placement);
        exact_bounds bounds = {0, 0, 0};
        for (int depth = 1; depth <= DEPTH; depth++) {
            local = unit_point(FXL_UNITS(20));
            child = any_placement(Q16(0.7), Q16(1.4));
            const exact_place step = exact_place_of(&local, &child);
            bounds = exact_bounds_of_child(&bounds, &wanted, &step);
            wanted = exact_attached(&wanted, &step);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_attach(&centre, &placement, &local, &child,
                                                           &centre, &placement));
            expect_centre(&wanted, &centre, bounds.centre + 1e-6L);
            TEST_ASSERT_NEAR(wanted.scale * 65536, placement.scale, bounds.scale + 1e-6L);
            TEST_ASSERT_NEAR(exact_distance(&wanted.turn, &placement.orientation), 0,
                             bounds.turn + 1e-6L);
        }
    }
}

static fxl_status attach(const fxl_point *at, const fxl_placement *parent,
                         const fxl_point *child_at, const fxl_placement *child)
{
    const fxl_point before = {1, 2, 3};
    const fxl_placement placement_before = {FXL_ORIENTATION_NONE, 77};
    fxl_point centre = before;
    fxl_placement placement = placement_before;
    const fxl_status status =
        fxl_placement_attach(at, parent, child_at, child, &centre, &placement);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &centre, sizeof centre);
        TEST_ASSERT_EQUAL_MEMORY(&placement_before, &placement, sizeof placement);
    }
    return status;
}

void test_what_is_out_of_range_is_refused(void)
{
    const fxl_point zero = {0, 0, 0}, edge = {0, FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK, 0},
                    one = {0, 1, 0};
    const fxl_point outside = {FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK + 1, 0, 0},
                    far = {0, 0, 1 << 30};
    fxl_placement small = still, large = still, none = still, beyond = still, bad = still;
    small.scale = FXL_SCALE_MIN;
    large.scale = FXL_SCALE_MAX;
    none.scale = 0;
    beyond.scale = FXL_SCALE_MAX + 1;
    bad.orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_OK, attach(&edge, &still, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&edge, &still, &one, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&outside, &still, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &still, &far, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &small, &far, &still)); /* it would lie within */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &small, &(fxl_point){0, -(1 << 30), 0}, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &small, &(fxl_point){1 << 30, 0, 0}, &still));
    TEST_ASSERT_EQUAL(FXL_OK, attach(&zero, &small, &(fxl_point){(1 << 30) - 1, 0, 0}, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &none, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &still, &zero, &beyond));
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, attach(&zero, &bad, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, attach(&zero, &still, &zero, &bad));
    TEST_ASSERT_EQUAL(FXL_OK, attach(&zero, &small, &zero, &large));
    TEST_ASSERT_EQUAL(FXL_OK, attach(&zero, &large, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_OK, attach(&zero, &small, &zero, &still));
    small.scale = 65535;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, attach(&zero, &(fxl_placement){small.orientation, 256}, &zero,
                                          &(fxl_placement){small.orientation, 65000}));
    TEST_ASSERT_EQUAL(FXL_E_RANGE,
                      attach(&zero, &large, &zero, &(fxl_placement){small.orientation, 65537}));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, attach(NULL, &still, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, attach(&zero, NULL, &zero, &still));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, attach(&zero, &still, NULL, &still));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, attach(&zero, &still, &zero, NULL));
    fxl_placement placement;
    fxl_point centre;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_placement_attach(&zero, &still, &zero, &still, NULL, &placement));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_placement_attach(&zero, &still, &zero, &still, &centre, NULL));
}
