/* SPDX-License-Identifier: MIT */
/* Instances that are attached to others, against long double. */
#include <math.h>

#include "exact_placement.h"
#include "unit.h"

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

/* orientation 3.1 */
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
/* orientation 3.1 */
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
/* orientation 3.2 */
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
