/* SPDX-License-Identifier: MIT */
/* Orientations from quaternions and back, against Hamilton's product in long double. */
#include <stdlib.h>

#include "exact_placement.h"
#include "unit.h"

#define LIMIT FXL_Q2_30_ONE

/* A long double of 64 bits on a board takes 2^-22 of a unit of its own. */
static const long double slack = sizeof(long double) == 8 ? 1e-5L : 1e-8L;

static fxl_orientation by_quaternion(fxl_quaternion q)
{
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_quaternion(&q, &o));
    return o;
}

static fxl_orientation by_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    fxl_orientation o;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(yaw, pitch, roll, &o));
    return o;
}

static exact_quaternion exactly(const fxl_quaternion *q)
{
    return (exact_quaternion){{q->w, q->x, q->y, q->z}};
}

/* Numbers of any size, of both signs, 0 and the ends among them. */
static int32_t any_number(void)
{
    const uint32_t choice = unit_random() % 8;
    const int32_t most = choice == 0 ? LIMIT : LIMIT >> unit_random() % 30;
    return choice < 2    ? (unit_random() % 2 ? most : -most)
           : choice == 2 ? 0
                         : unit_between(-most, most);
}

static fxl_quaternion any_quaternion(void)
{
    fxl_quaternion q;
    do {
        q = (fxl_quaternion){any_number(), any_number(), any_number(), any_number()};
    } while ((q.w | q.x | q.y | q.z) == 0);
    return q;
}

/* orientation 1.5a, 1.5c */
void test_a_quaternion_is_rounded_once(void)
{
    for (int i = 0; i < UNIT_REPEAT / 3; i++) {
        const fxl_quaternion q = any_quaternion();
        const exact_quaternion exact = exactly(&q);
        const exact_placement wanted = exact_turn_of(&exact);
        const fxl_orientation o = by_quaternion(q);
        const fxl_placement placement = {o, FXL_Q16_16_ONE};
        TEST_ASSERT_NEAR(exact_distance(&wanted, &o), 0, 0.5L + slack);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_check(&placement, &(fxl_point){0, 0, 0}, 0));
    }
}

/* Of 1 + 2i the norm is 5: -3/5 and 4/5 of 2^30 are 644245094.4 and 858993459.2. */
/* orientation 1.5c */
void test_a_fifth_is_rounded_to_the_nearest(void)
{
    const fxl_orientation o = by_quaternion((fxl_quaternion){1, 2, 0, 0});
    const fxl_orientation wanted = {
        {LIMIT, 0, 0}, {0, -644245094, -858993459}, {0, 858993459, -644245094}};
    TEST_ASSERT_EQUAL_MEMORY(&wanted, &o, sizeof o);
}

/* 2.30, an IMU's 1/16384, and any other unit; and the other sign of all four. */
/* orientation 1.5b, 1.5d */
void test_neither_the_norm_nor_the_sign_counts(void)
{
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_quaternion q = {unit_between(-16384, 16384), unit_between(-16384, 16384),
                                  unit_between(-16384, 16384), unit_between(1, 16384)};
        const fxl_orientation o = by_quaternion(q);
        const int32_t times = 1 << unit_random() % 17;
        const fxl_orientation same =
            by_quaternion((fxl_quaternion){q.w * times, q.x * times, q.y * times, q.z * times});
        const fxl_orientation minus = by_quaternion((fxl_quaternion){-q.w, -q.x, -q.y, -q.z});
        TEST_ASSERT_EQUAL_MEMORY(&o, &same, sizeof o);
        TEST_ASSERT_EQUAL_MEMORY(&o, &minus, sizeof o);
    }
}

/* orientation 1.5e */
void test_what_is_no_quaternion_is_refused(void)
{
    const fxl_orientation before = by_angles(1, 2, 3);
    fxl_orientation o = before;
    fxl_quaternion q = {0, 0, 0, 0};
    int32_t *const numbers[4] = {&q.w, &q.x, &q.y, &q.z};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_from_quaternion(&q, &o));
    for (int i = 0; i < 4; i++) {
        static const int32_t beyond[] = {LIMIT + 1, -LIMIT - 1, INT32_MAX, INT32_MIN};
        for (int k = 0; k < 4; k++) {
            q = (fxl_quaternion){1, 1, 1, 1};
            *numbers[i] = beyond[k];
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_orientation_from_quaternion(&q, &o));
        }
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_from_quaternion(NULL, &o));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_from_quaternion(&q, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&before, &o, sizeof o);
    for (int i = 0; i < 4; i++) { /* turns nothing, and half turns about the axes */
        q = (fxl_quaternion){0, 0, 0, 0};
        *numbers[i] = i % 2 ? LIMIT : -1;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_quaternion(&q, &o));
        TEST_ASSERT_EQUAL_INT32(i < 2 ? LIMIT : -LIMIT, o.x.x);
        TEST_ASSERT_EQUAL_INT32(i % 2 ? -LIMIT : LIMIT, o.y.y);
    }
}

/* --- a sensor's axes ------------------------------------------------------------------------- */

/* The half of a right angle's turn, and of 30 degrees, in 2.30. */
#define SIN_45 759250125
#define SIN_15 277904834
#define COS_15 1037154959

/* orientation 1.7: x forward, y right, z down, as in an aircraft. */
static fxl_quaternion of_aircraft(fxl_quaternion s)
{
    return (fxl_quaternion){s.w, -s.y, s.z, -s.x};
}

/* x east or right, y north or forward, z up. */
static fxl_quaternion of_ground(fxl_quaternion s)
{
    return (fxl_quaternion){s.w, -s.x, -s.z, -s.y};
}

static void expect_attitude(fxl_quaternion q, fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    const fxl_orientation o = by_quaternion(q);
    const exact_placement wanted = exact_angles(yaw, pitch, roll);
    TEST_ASSERT_NEAR(exact_distance(&wanted, &o), 0, 3); /* the numbers are rounded, too */
}

/* Nose up by 30 degrees, the right wing down by 30, the compass east: by each kind of sensor. */
/* orientation 1.7c-e */
void test_three_attitudes(void)
{
    expect_attitude(of_aircraft((fxl_quaternion){COS_15, 0, SIN_15, 0}), 0, DEGREES(30), 0);
    expect_attitude(of_ground((fxl_quaternion){COS_15, SIN_15, 0, 0}), 0, DEGREES(30), 0);
    expect_attitude(of_aircraft((fxl_quaternion){COS_15, SIN_15, 0, 0}), 0, 0, DEGREES(-30));
    expect_attitude(of_ground((fxl_quaternion){COS_15, 0, SIN_15, 0}), 0, 0, DEGREES(-30));
    expect_attitude(of_aircraft((fxl_quaternion){SIN_45, 0, 0, SIN_45}), DEGREES(90), 0, 0);
    expect_attitude(of_ground((fxl_quaternion){SIN_45, 0, 0, -SIN_45}), DEGREES(90), 0, 0);
}

/* --- and back -------------------------------------------------------------------------------- */

/* Against the rotation that is nearest to the rows. Within 2 units, and of unit length but for
 * them; w is not below 0. */
static void expect_quaternion(const fxl_orientation *o)
{
    const fxl_orientation identity = FXL_ORIENTATION_NONE;
    const exact_placement nearest = exact_nearest_to_product(&identity, o);
    fxl_quaternion q;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_to_quaternion(o, &q));
    const exact_quaternion got = exactly(&q), wanted = exact_quaternion_of(&nearest, &got);
    const exact_placement turn = exact_turn_of(&wanted);
    TEST_ASSERT_TRUE(q.w >= 0);
    for (int i = 0; i < 9; i++) {
        TEST_ASSERT_NEAR(nearest.at[i / 3][i % 3] * EXACT_ONE, turn.at[i / 3][i % 3] * EXACT_ONE,
                         0.001L);
    }
    for (int i = 0; i < 4; i++) {
        TEST_ASSERT_NEAR(wanted.at[i] * EXACT_ONE, got.at[i], 2);
    }
}

/* Also half turns, near which w is near 0, and rows that are not the best ones. */
/* orientation 1.6a, 1.6c */
void test_back_is_within_two_units(void)
{
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        fxl_orientation o = by_quaternion(any_quaternion());
        expect_quaternion(&o);
        const fxl_point axis = {unit_between(-50, 50), unit_between(-50, 50), unit_between(1, 50)};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_axis(
                                      &axis, 0x80000000u + (fxl_angle)unit_between(-9, 9), &o));
        expect_quaternion(&o);
        o = by_angles(unit_random(), unit_random(), unit_random());
        o.x.y += unit_between(-1, 1);
        o.z.x += unit_between(-1, 1);
        expect_quaternion(&o);
    }
}

/* orientation 1.6b */
void test_the_sign_of_a_half_turn(void)
{
    static const fxl_quaternion made[] = {
        {0, 0, 0, -7}, {0, -1, 1, 0}, {0, -3, 4, 0}, {-5, 0, 0, 0}, {-3, 4, 0, 0}};
    static const fxl_quaternion wanted[] = {{0, 0, 0, LIMIT},
                                            {0, SIN_45, -SIN_45, 0},
                                            {0, -644245094, 858993459, 0},
                                            {LIMIT, 0, 0, 0},
                                            {644245094, -858993459, 0, 0}};
    for (uint32_t i = 0; i < sizeof made / sizeof made[0]; i++) {
        const fxl_orientation o = by_quaternion(made[i]);
        fxl_quaternion q;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_to_quaternion(&o, &q));
        TEST_ASSERT_NEAR(wanted[i].w, q.w, 1);
        TEST_ASSERT_NEAR(wanted[i].x, q.x, 1);
        TEST_ASSERT_NEAR(wanted[i].y, q.y, 1);
        TEST_ASSERT_NEAR(wanted[i].z, q.z, 1);
    }
}

/* orientation 1.6d */
void test_rows_that_are_no_rotation_have_no_quaternion(void)
{
    fxl_orientation o = FXL_ORIENTATION_NONE;
    const fxl_quaternion before = {1, 2, 3, 4};
    fxl_quaternion q = before;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_to_quaternion(NULL, &q));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_orientation_to_quaternion(&o, NULL));
    o.x.x -= 5;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_orientation_to_quaternion(&o, &q));
    TEST_ASSERT_EQUAL_MEMORY(&before, &q, sizeof q);
}

/* The same bits on every board: a hash of many results. */
void test_every_board_gives_the_same_quaternions(void)
{
    uint32_t crc = 0, number = 1;
    for (int i = 0; i < 200; i++) {
        int32_t n[4];
        for (int k = 0; k < 4; k++) {
            number = number * 1664525u + 1013904223u;
            n[k] = (int32_t)(number >> 2) - (1 << 29);
        }
        const fxl_orientation o = by_quaternion((fxl_quaternion){n[0], n[1], n[2], n[3]});
        fxl_quaternion q;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_to_quaternion(&o, &q));
        crc ^=
            unit_crc32((const uint8_t *)&o, sizeof o) ^ unit_crc32((const uint8_t *)&q, sizeof q);
    }
    TEST_ASSERT_EQUAL_HEX32(0x3FCE5C60u, crc);
}
