/* SPDX-License-Identifier: MIT */
/* The numbers of turned instances, against their definitions in whole numbers of 128 bits. */
#include "scene/placement_code.h"
#include "unit.h"
#include "wide.h"

static const fxl_placement none = FXL_PLACEMENT_NONE;

/* The largest radius of a model that a placement may have about the origin. */
static fxl_q16_16 radius_of(const fxl_placement *placement)
{
    const int64_t limit =
        ((int64_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK) << 16) / placement->scale;
    return limit < FXL_RADIUS_MAX ? (fxl_q16_16)limit : FXL_RADIUS_MAX;
}

/* A vertex within a radius. */
static fxl_point vertex_in(fxl_q16_16 radius)
{
    return unit_point((fxl_q16_16)((int64_t)radius * 577 / 1000)); /* less than 1 / sqrt(3) */
}

static int64_t sum_of(const int32_t *a, const int32_t *b, int step)
{
    return (int64_t)a[0] * b[0] + (int64_t)a[1] * b[step] + (int64_t)a[2] * b[2 * step];
}

/* Whether result = floor(product / divisor + 1/2), for product = a b. */
static void expect_rounded(int64_t result, int64_t a, int64_t b, int64_t half)
{
    const wide product = wide_product(a, b);
    TEST_ASSERT_TRUE(wide_compare(wide_product(2 * result - 1, half), product) <= 0);
    TEST_ASSERT_TRUE(wide_compare(wide_product(2 * result + 1, half), product) > 0);
}

/* --- the check ------------------------------------------------------------------------------ */

static fxl_status check(const fxl_placement *placement)
{
    const fxl_point centre = {0, 0, 0};
    return fxl_placement_check(placement, &centre, Q16(1));
}

/* SPEC 8.1h */
void test_rotations_are_accepted(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, check(&none));
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const fxl_placement placement = unit_placement();
        TEST_ASSERT_EQUAL(FXL_OK, check(&placement));
    }
}

/* x is too long by 1.5 2^-29, its square by 1.5 2^-28; all else is within its tolerance. */
void test_a_row_just_too_long_is_refused(void)
{
    fxl_placement placement = none;
    const fxl_orientation rows = {
        {FXL_Q2_30_ONE + 3, -1, 0}, {0, FXL_Q2_30_ONE - 1, 0}, {0, 0, FXL_Q2_30_ONE + 2}};
    placement.orientation = rows;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, check(&placement));
    placement.orientation.x.x--;
    placement.orientation.z.z--;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, check(&placement));
    placement.orientation.x.x--;
    placement.orientation.z.z--;
    TEST_ASSERT_EQUAL(FXL_OK, check(&placement));
}

/* All six products of two rows, to within 2^-28: then the rows are accepted. A row that is moved
 * by more than 2^-26 is not. */
/* SPEC 8.1g */
void test_rows_near_and_far_from_a_rotation(void)
{
    const int64_t one = (int64_t)1 << 60, tolerance = (int64_t)1 << 32;
    int near = 0;
    for (int round = 0; round < UNIT_REPEAT; round++) {
        fxl_placement placement = unit_placement();
        int32_t *entries = &placement.orientation.x.x;
        const int32_t most = 1 << unit_between(0, 6);
        int64_t largest = 0;
        for (int i = 0; i < 9; i++) {
            entries[i] += unit_between(-most, most);
        }
        for (int i = 0; i < 3; i++) {
            for (int k = i; k < 3; k++) {
                int64_t off = sum_of(entries + 3 * i, entries + 3 * k, 1) - (i == k ? one : 0);
                off = off < 0 ? -off : off;
                largest = off > largest ? off : largest;
            }
        }
        if (largest < tolerance) {
            near++;
            TEST_ASSERT_EQUAL(FXL_OK, check(&placement));
        } else if (largest > 16 * tolerance) {
            TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, check(&placement));
        }
    }
    TEST_ASSERT_TRUE(near > UNIT_REPEAT / 20);
}

/* SPEC 8.1i */
void test_what_is_no_rotation(void)
{
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        fxl_placement placement = unit_placement();
        int32_t *entries = &placement.orientation.x.x;
        const int row = unit_between(0, 2);
        switch (round % 5) {
        case 0: /* a mirror image */
            for (int i = 0; i < 3; i++) {
                entries[3 * row + i] = -entries[3 * row + i];
            }
            break;
        case 1: /* two rows change places */
            for (int i = 0; i < 3; i++) {
                const int32_t other = entries[3 * row + i];
                entries[3 * row + i] = entries[3 * ((row + 1) % 3) + i];
                entries[3 * ((row + 1) % 3) + i] = other;
            }
            break;
        case 2: /* no direction */
            memset(entries + 3 * row, 0, 3 * sizeof *entries);
            break;
        case 3: /* any numbers */
            for (int i = 0; i < 9; i++) {
                entries[i] = unit_between(INT32_MIN, INT32_MAX);
            }
            break;
        default: /* the same direction twice */
            memcpy(entries + 3 * row, entries + 3 * ((row + 1) % 3), 3 * sizeof *entries);
        }
        TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, check(&placement));
    }
}

/* A number of any size below 2^bits, sometimes a power of two. */
static int32_t any_size(int bits)
{
    const int32_t power = 1 << unit_between(0, bits - 1);
    return unit_between(0, 3) == 0 ? power : unit_between(0, power);
}

/* What a frame asks of all instances is what the check of one asks. */
void test_the_places_of_a_scene(void)
{
    static fxl_instance instances[2];
    static fxl_model model;
    fxl_placement placement = none;
    const fxl_scene scene = {.models = &model,
                             .instances = instances,
                             .model_count = 1,
                             .instance_count = 2,
                             .placements = &placement,
                             .first_turned = 1};
    int32_t *centre = &instances[1].centre.x;
    uint32_t in_range = 0;
    instances[0].centre.x = INT32_MAX;
    for (int round = 0; round < UNIT_REPEAT; round++) {
        placement.scale = any_size(26) - (round % 64 == 0 ? 300 : 0);
        model.radius = any_size(31);
        for (int i = 0; i < 3; i++) {
            centre[i] = any_size(31) * (unit_between(0, 1) ? 1 : -1) - unit_between(0, 1);
        }
        const bool is_ok =
            fxl_placement_check(&placement, &instances[1].centre, model.radius) == FXL_OK;
        TEST_ASSERT_EQUAL(is_ok, fxl_placement_places_are_in_range(&scene));
        in_range += is_ok;
    }
    TEST_ASSERT_TRUE(in_range > UNIT_REPEAT / 10 && in_range < UNIT_REPEAT);
}

/* SPEC 3.1n, 8.1e-f */
void test_ranges_of_a_placement(void)
{
    fxl_point centre = {0, 0, 0};
    fxl_placement placement = none;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_placement_check(NULL, &centre, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_placement_check(&placement, NULL, 0));
    static const struct {
        int32_t scale, radius;
        fxl_status status;
    } cases[] = {{FXL_SCALE_MIN, 1, FXL_OK},
                 {FXL_SCALE_MIN - 1, 1, FXL_E_RANGE},
                 {0, 1, FXL_E_RANGE},
                 {-65536, 1, FXL_E_RANGE},
                 {INT32_MIN, 1, FXL_E_RANGE},
                 {INT32_MAX, 1, FXL_E_RANGE},
                 {FXL_SCALE_MAX, 1, FXL_OK},
                 {FXL_SCALE_MAX + 1, 1, FXL_E_RANGE},
                 {FXL_SCALE_MIN, -1, FXL_E_RANGE},
                 {FXL_SCALE_MIN, FXL_RADIUS_MAX, FXL_OK},
                 {FXL_SCALE_MIN, FXL_RADIUS_MAX + 1, FXL_E_RANGE},
                 {FXL_SCALE_MAX, FXL_RADIUS_MAX, FXL_E_RANGE},
                 {FXL_SCALE_MAX, Q16(8190.0 / 256), FXL_OK},
                 {FXL_SCALE_MAX, Q16(8191.0 / 256), FXL_E_RANGE}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        placement.scale = cases[i].scale;
        TEST_ASSERT_EQUAL(cases[i].status,
                          fxl_placement_check(&placement, &centre, cases[i].radius));
    }
    /* A sphere larger than the world fits nowhere. */
    placement.scale = FXL_SCALE_MAX;
    centre = (fxl_point){Q16(100), Q16(100), Q16(100)};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_placement_check(&placement, &centre, Q16(8200.0 / 256)));
}

/* The reach: |centre| + scale * radius, rounded upward, and the slack. */
/* SPEC 8.1f, 8.1j */
void test_the_reach_of_a_placement(void)
{
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const fxl_placement placement = unit_placement();
        const fxl_q16_16 radius = unit_between(0, radius_of(&placement));
        const int64_t product = (int64_t)radius * placement.scale;
        const fxl_q16_16 reach = fxl_placement_radius(&placement, radius);
        TEST_ASSERT_TRUE(((int64_t)(reach - FXL_PLACEMENT_SLACK) << 16) >= product);
        TEST_ASSERT_TRUE(((int64_t)(reach - FXL_PLACEMENT_SLACK - 1) << 16) < product);
        fxl_point centre = {0, 0, 0};
        int32_t *const coordinate = &(&centre.x)[unit_between(0, 2)];
        const int sign = unit_between(0, 1) ? 1 : -1;
        *coordinate = sign * (FXL_COORDINATE_MAX - reach);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_placement_check(&placement, &centre, radius));
        *coordinate += sign;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_placement_check(&placement, &centre, radius));
        *coordinate = sign < 0 ? INT32_MIN : INT32_MAX;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_placement_check(&placement, &centre, radius));
    }
}

/* --- matrix, points, eye --------------------------------------------------------------------- */

/* SPEC 8.2d-f, accuracy 1.1e */
void test_each_entry_of_the_matrix_is_rounded_once(void)
{
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const fxl_placement placement = unit_placement();
        const fxl_pose pose = unit_pose();
        fxl_camera camera;
        fxl_axes matrix;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        const unsigned shift = fxl_placement_matrix(&placement, &camera.axes, &matrix);
        TEST_ASSERT_TRUE((int64_t)FXL_Q16_16_ONE << shift >= placement.scale);
        TEST_ASSERT_TRUE(shift == 0 ||
                         (int64_t)FXL_Q16_16_ONE << shift < 2 * (int64_t)placement.scale);
        for (int i = 0; i < 9; i++) {
            const int64_t sum =
                sum_of(&camera.axes.right.x + i / 3 * 3, &placement.orientation.x.x + i % 3, 3);
            expect_rounded((&matrix.right.x)[i], sum, placement.scale, (int64_t)1 << (45 + shift));
        }
    }
}

void test_no_placement_leaves_the_view(void)
{
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = unit_pose();
        fxl_camera camera;
        fxl_axes matrix;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        TEST_ASSERT_EQUAL(0, fxl_placement_matrix(&none, &camera.axes, &matrix));
        TEST_ASSERT_EQUAL_MEMORY(&camera.axes, &matrix, sizeof matrix);
        const fxl_point vertex = unit_point(Q16(2000)), centre = unit_point(Q16(2000));
        fxl_point point;
        fxl_placement_point(&none, &centre, &vertex, &point);
        TEST_ASSERT_EQUAL(centre.x + vertex.x, point.x);
        TEST_ASSERT_EQUAL(centre.y + vertex.y, point.y);
        TEST_ASSERT_EQUAL(centre.z + vertex.z, point.z);
        const fxl_direction direction = unit_direction();
        fxl_direction turned;
        fxl_placement_direction(&none, &direction, &turned);
        TEST_ASSERT_EQUAL_MEMORY(&direction, &turned, sizeof turned);
    }
}

/* SPEC 8.5a, 8.5g, accuracy 1.1g */
void test_points_and_directions_are_rounded_once(void)
{
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const fxl_placement placement = unit_placement();
        const fxl_point vertex = vertex_in(radius_of(&placement)), centre = {0, 0, 0};
        const fxl_direction direction = unit_direction();
        fxl_point point;
        fxl_direction turned;
        fxl_placement_point(&placement, &centre, &vertex, &point);
        fxl_placement_direction(&placement, &direction, &turned);
        for (int i = 0; i < 3; i++) {
            const int32_t *row = &placement.orientation.x.x + 3 * i;
            expect_rounded((&point.x)[i], sum_of(row, &vertex.x, 1), placement.scale,
                           (int64_t)1 << 45);
            expect_rounded((&turned.x)[i], sum_of(row, &direction.x, 1), 1, (int64_t)1 << 29);
        }
    }
}

/* How a random instance lies to a random eye. */
typedef struct {
    fxl_placement placement;
    fxl_point from_eye;
    fxl_q16_16 radius;
    int64_t exact[3]; /* the eye along the model's axes, times the scale, in units of 2^-46 */
} sight;

static sight any_sight(void)
{
    sight of = {.placement = unit_placement()};
    const fxl_point eye = unit_point(FXL_COORDINATE_MAX);
    const fxl_q16_16 most = radius_of(&of.placement);
    of.radius = unit_between(0, most < Q16(100) ? most : Q16(100));
    if (unit_between(0, 3) == 0) {
        of.radius = most;
    }
    const fxl_q16_16 reach = fxl_placement_radius(&of.placement, of.radius);
    const fxl_point centre =
        unit_point(reach < FXL_COORDINATE_MAX ? FXL_COORDINATE_MAX - reach : 0);
    const int32_t to_eye[3] = {eye.x - centre.x, eye.y - centre.y, eye.z - centre.z};
    of.from_eye = (fxl_point){-to_eye[0], -to_eye[1], -to_eye[2]};
    for (int i = 0; i < 3; i++) {
        of.exact[i] = sum_of(to_eye, &of.placement.orientation.x.x + i, 3);
    }
    return of;
}

static bool fits(const sight *of, const fxl_point *eye, unsigned shift)
{
    const int64_t limit = ((int64_t)1 << 30) - 1 - (of->radius >> shift);
    for (int i = 0; i < 3; i++) {
        const int64_t at = (&eye->x)[i];
        if (at > limit || at < -limit) {
            return false;
        }
    }
    return true;
}

/* SPEC 8.4b, accuracy 1.1f */
void test_the_eye_in_the_space_of_the_model(void)
{
    uint32_t shifted = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const sight of = any_sight();
        fxl_point eye;
        const unsigned shift = fxl_placement_eye(&of.placement, &of.from_eye, of.radius, &eye);
        TEST_ASSERT_TRUE(fits(&of, &eye, shift));
        for (int i = 0; i < 3; i++) {
            expect_rounded((&eye.x)[i], of.exact[i], 1,
                           (int64_t)of.placement.scale << (13 + shift));
        }
        if (shift >
            0) { /* the shift before would not do: an exact coordinate is beyond the limit */
            const int64_t limit = ((int64_t)1 << 30) - 1 - (of.radius >> (shift - 1));
            bool beyond = false;
            for (int i = 0; i < 3; i++) {
                const int64_t size = of.exact[i] < 0 ? -of.exact[i] : of.exact[i];
                beyond = beyond || wide_compare(wide_product(size, 1),
                                                wide_product(2 * limit, (int64_t)of.placement.scale
                                                                            << (12 + shift))) > 0;
            }
            TEST_ASSERT_TRUE(beyond);
            shifted++;
        }
    }
    TEST_ASSERT_TRUE(shifted > UNIT_REPEAT / 100);
}

/* The last place where an eye keeps its unit, along each axis, and the first where it does not. */
/* SPEC 8.4b */
void test_the_limit_of_an_eye(void)
{
    for (int i = 0; i < 6; i++) {
        for (int half = 0; half < 2; half++) {
            const fxl_q16_16 radius = 2 * unit_between(0, Q16(50)) + 1;
            const int32_t limit = (1 << 30) - 1 - radius; /* even, as half a scale wants */
            const fxl_placement placement = {none.orientation, FXL_Q16_16_ONE >> half};
            const int32_t to_eye = i < 3 ? limit >> half : -limit >> half;
            fxl_point from_eye = {0, 0, 0}, eye;
            (&from_eye.x)[i % 3] = -to_eye;
            TEST_ASSERT_EQUAL(0, fxl_placement_eye(&placement, &from_eye, radius, &eye));
            TEST_ASSERT_EQUAL(i < 3 ? limit : -limit, (&eye.x)[i % 3]);
            (&from_eye.x)[i % 3] = i < 3 ? -to_eye - 1 : -to_eye + 1;
            TEST_ASSERT_EQUAL(1, fxl_placement_eye(&placement, &from_eye, radius, &eye));
        }
    }
}

void test_the_eye_of_an_instance_that_is_not_turned(void)
{
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_point from_eye = unit_point(2 * FXL_COORDINATE_MAX);
        fxl_point eye;
        TEST_ASSERT_EQUAL(0, fxl_placement_eye(&none, &from_eye, 0, &eye));
        TEST_ASSERT_EQUAL(-from_eye.x, eye.x);
        TEST_ASSERT_EQUAL(-from_eye.y, eye.y);
        TEST_ASSERT_EQUAL(-from_eye.z, eye.z);
    }
}

/* --- facing ---------------------------------------------------------------------------------- */

/* normal . exact - scale * height 2^14, below 0, 0 or above 0. */
static int side_of(const sight *of, const fxl_direction *normal, fxl_q18_46 height)
{
    wide left = wide_product(normal->x, of->exact[0]);
    left = wide_sum(left, wide_product(normal->y, of->exact[1]));
    left = wide_sum(left, wide_product(normal->z, of->exact[2]));
    return wide_compare(left, wide_product(height, (int64_t)of->placement.scale << 14));
}

/* The height at which the eye lies on the plane, as near as a height can be. Within scale * height
 * below 2^14 units, or 0. */
static fxl_q18_46 height_at_eye(const sight *of, const fxl_direction *normal)
{
    fxl_q18_46 height = 0;
    const int64_t most = (int64_t)1 << 61;
    /* 2^14 units / scale, in units of 2^-46. */
    const int64_t limit = of->placement.scale <= 32768 ? most : most / of->placement.scale * 32768;
    for (int bit = 60; bit >= 0; bit--) {
        const fxl_q18_46 more = height + ((int64_t)1 << bit);
        if (more < limit && side_of(of, normal, more) >= 0) {
            height = more;
        }
    }
    return height;
}

/* SPEC 8.3b */
void test_facing_is_exact(void)
{
    int exactly = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        sight of = any_sight();
        fxl_direction normal = unit_direction();
        if (round % 4 == 0) { /* an eye on the plane, to the last bit */
            normal = (fxl_direction){0, 0, 0};
            (&normal.x)[round / 4 % 3] = FXL_Q2_30_ONE;
        }
        fxl_q18_46 height = height_at_eye(&of, &normal);
        for (int step = -2; step <= 2; step++) {
            const int side = side_of(&of, &normal, height + step);
            exactly += side == 0;
            TEST_ASSERT_EQUAL(side > 0, fxl_placement_is_front(&of.placement, &of.from_eye, &normal,
                                                               height + step));
        }
        height = (int64_t)normal.x * unit_between(-of.radius, of.radius);
        TEST_ASSERT_EQUAL(side_of(&of, &normal, height) > 0,
                          fxl_placement_is_front(&of.placement, &of.from_eye, &normal, height));
    }
    TEST_ASSERT_TRUE(exactly > 0);
}
