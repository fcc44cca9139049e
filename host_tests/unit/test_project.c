/* SPDX-License-Identifier: MIT */
#include "unit.h"
#include "wide.h"

/* World units of the view, exactly. */
#define V(units) ((fxl_q18_46)(units) * ((int64_t)1 << 46))

static fxl_screen_point project(const fxl_lens *lens, int64_t x, int64_t y, int64_t z)
{
    fxl_view_point view = {x, y, z};
    fxl_screen_point screen;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(lens, &view, &screen));
    return screen;
}

void test_straight_ahead_is_the_middle(void)
{
    fxl_lens lens = unit_lens(320, 240);
    fxl_screen_point screen = project(&lens, 0, 0, V(1));
    TEST_ASSERT_EQUAL_INT32(Q16(160), screen.x);
    TEST_ASSERT_EQUAL_INT32(Q16(120), screen.y);
    lens = unit_lens(63, 1);
    screen = project(&lens, 0, 0, FXL_PROJECT_DEPTH_MIN);
    TEST_ASSERT_EQUAL_INT32(Q16(31.5), screen.x);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), screen.y);
    screen = project(&lens, 0, 0, ((int64_t)1 << 61) - 1);
    TEST_ASSERT_EQUAL_INT32(Q16(31.5), screen.x);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), screen.y);
}

/* SPEC 1.1b, 4.8a */
void test_right_is_right_and_up_is_up(void)
{
    fxl_lens lens = unit_lens(320, 240);
    lens.focal = Q16(160);
    TEST_ASSERT_EQUAL_INT32(Q16(240), project(&lens, V(1), 0, V(2)).x);
    TEST_ASSERT_EQUAL_INT32(Q16(40), project(&lens, 0, V(1), V(2)).y);
    TEST_ASSERT_EQUAL_INT32(Q16(80), project(&lens, -V(7000), 0, V(14000)).x);
    TEST_ASSERT_EQUAL_INT32(Q16(200), project(&lens, 0, -V(7000), V(14000)).y);
    /* far beside the screen */
    TEST_ASSERT_EQUAL_INT32(Q16(960), project(&lens, V(10), 0, V(2)).x);
    TEST_ASSERT_EQUAL_INT32(Q16(-680), project(&lens, 0, V(10), V(2)).y);
}

/* |offset - focal side / depth| <= 1/2 + 2^-31 |offset| + 2^-30, times 2^32
 * depth. The first difference is about depth, the products below 2^92. */
static void expect_nearest(int64_t focal, int64_t side, int64_t depth, int64_t offset)
{
    int64_t error;
    wide difference = wide_difference(wide_product(offset, depth), wide_product(focal, side));
    TEST_ASSERT_TRUE_MESSAGE(wide_narrow(difference, &error), "far off");
    error = error < 0 ? -error : error;
    int64_t size = offset < 0 ? -offset : offset;
    int64_t bound = ((int64_t)1 << 31) + 2 * (size + 1) + 4;
    TEST_ASSERT_TRUE_MESSAGE(
        wide_compare(wide_product(error, (int64_t)1 << 32), wide_product(depth, bound)) <= 0,
        "beyond the bound");
}

/* Whether focal side / depth is not clearly within low + 1 .. high - 1. */
static bool at_an_end(int64_t focal, int64_t side, int64_t depth, int64_t low, int64_t high)
{
    wide product = wide_product(focal, side);
    return wide_compare(product, wide_product(low + 1, depth)) < 0 ||
           wide_compare(product, wide_product(high - 1, depth)) > 0;
}

static void expect_rightly_refused(const fxl_lens *lens, const fxl_view_point *view)
{
    const int64_t limit = FXL_SCREEN_COORDINATE_MAX;
    int64_t x = lens->width * 32768, y = lens->height * 32768;
    TEST_ASSERT_TRUE(view->z < FXL_PROJECT_DEPTH_MIN ||
                     at_an_end(lens->focal, view->x, view->z, -limit - x, limit - x) ||
                     at_an_end(lens->focal, view->y, view->z, y - limit, y + limit));
}

/* A side of a point at a depth of so many bits, mostly on the screen. */
static int64_t random_side(int bits)
{
    int side = bits + unit_between(-12, 5);
    return unit_wide((unsigned)(side < 1 ? 1 : side > 61 ? 61 : side));
}

/* SPEC 4.8a, accuracy 1.1r */
void test_rounding_is_to_nearest(void)
{
    int projected = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_lens lens = unit_any_lens();
        int bits = unit_between(37, 61);
        int64_t z = unit_wide((unsigned)bits);
        fxl_view_point view = {random_side(bits), random_side(bits), z < 0 ? -z : z};
        fxl_screen_point screen = {0, 0};
        fxl_status status = fxl_project_point(&lens, &view, &screen);
        if (status != FXL_OK) {
            TEST_ASSERT_EQUAL(FXL_E_RANGE, status);
            expect_rightly_refused(&lens, &view);
            continue;
        }
        projected++;
        TEST_ASSERT_TRUE(view.z >= FXL_PROJECT_DEPTH_MIN);
        TEST_ASSERT_INT32_WITHIN(FXL_SCREEN_COORDINATE_MAX, 0, screen.x);
        TEST_ASSERT_INT32_WITHIN(FXL_SCREEN_COORDINATE_MAX, 0, screen.y);
        expect_nearest(lens.focal, view.x, view.z, screen.x - lens.width * 32768);
        expect_nearest(lens.focal, view.y, view.z, lens.height * 32768 - screen.y);
    }
    TEST_ASSERT_TRUE_MESSAGE(projected > UNIT_REPEAT / 4, "too few were on the screen");
}

/* Offsets of 1/2 and -1/2 unit, from the middle: halves go upward. At every
 * depth of one bit that the eye can see. */
/* SPEC 2.2 */
void test_halves_go_upward(void)
{
    fxl_lens lens = unit_lens(2, 2);
    lens.focal = Q16(1);
    for (int bit = 37; bit <= 60; bit++) {
        int64_t depth = (int64_t)1 << bit, half = depth >> 17;
        TEST_ASSERT_EQUAL_INT32(Q16(1) + 1, project(&lens, half, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(1), project(&lens, half - 1, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(1), project(&lens, -half, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(1) - 1, project(&lens, -half - 1, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(1) - 1, project(&lens, 0, half, depth).y);
        TEST_ASSERT_EQUAL_INT32(Q16(1), project(&lens, 0, -half, depth).y);
    }
}

/* The same three pixels further out, where no kernel takes its short way. */
/* SPEC 2.2 */
void test_halves_go_upward_beside_the_screen(void)
{
    fxl_lens lens = unit_lens(2, 2);
    lens.focal = Q16(1);
    for (int bit = 37; bit <= 59; bit++) {
        int64_t depth = (int64_t)1 << bit, half = 3 * depth + (depth >> 17);
        TEST_ASSERT_EQUAL_INT32(Q16(4) + 1, project(&lens, half, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(4), project(&lens, half - 1, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(-2), project(&lens, -half, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(-2) - 1, project(&lens, -half - 1, 0, depth).x);
        TEST_ASSERT_EQUAL_INT32(Q16(-2) - 1, project(&lens, 0, half, depth).y);
        TEST_ASSERT_EQUAL_INT32(Q16(4), project(&lens, 0, -half, depth).y);
    }
}

/* The whole side counts: its last bit moves the outcome. */
/* accuracy 1.1r */
void test_no_bit_of_the_side_is_lost(void)
{
    fxl_lens lens = unit_lens(2, 2);
    lens.focal = Q16(1);
    int64_t depth = (int64_t)1 << 60, side = (depth >> 16) * 60000 + (depth >> 17);
    TEST_ASSERT_EQUAL_INT32(Q16(1) + 60001, project(&lens, side, 0, depth).x);
    TEST_ASSERT_EQUAL_INT32(Q16(1) + 60000, project(&lens, side - 1, 0, depth).x);
}

/* Where nothing is rounded away, only the direction counts. */
void test_the_scale_cancels(void)
{
    fxl_lens lens = unit_lens(320, 240);
    fxl_screen_point first = project(&lens, 123456789, -98765432, 1234567890ll << 7);
    for (int shift = 0; shift < 23; shift++) {
        fxl_screen_point screen = project(&lens, 123456789ll << shift, -98765432ll * (1 << shift),
                                          1234567890ll << (7 + shift));
        TEST_ASSERT_EQUAL_MEMORY(&first, &screen, sizeof first);
    }
}

static void expect_refused(const fxl_lens *lens, int64_t x, int64_t y, int64_t z)
{
    fxl_view_point view = {x, y, z};
    fxl_screen_point screen = {12345, 54321};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_project_point(lens, &view, &screen));
    TEST_ASSERT_EQUAL_INT32(12345, screen.x);
    TEST_ASSERT_EQUAL_INT32(54321, screen.y);
}

void test_what_is_off_range_is_refused(void)
{
    const int64_t end = ((int64_t)1 << 61) - 1, nearest = FXL_PROJECT_DEPTH_MIN;
    fxl_lens lens = unit_lens(320, 240);
    lens.focal = Q16(160);
    expect_refused(&lens, 0, 0, 0);
    expect_refused(&lens, 5, 5, -1);
    expect_refused(&lens, 0, 0, -end);
    expect_refused(&lens, 0, 0, nearest - 1);
    for (int64_t depth = nearest; depth <= (int64_t)1 << 50; depth *= 2) {
        expect_refused(&lens, end, 0, depth);
        expect_refused(&lens, -end, 0, depth);
        expect_refused(&lens, 0, end, depth);
        expect_refused(&lens, 0, -end, depth);
        expect_refused(&lens, -end, end, depth);
    }
}

/* 160 + 3935 = 4095, and a bit more; 160 - 4255 = -4095, and a bit less. */
static void expect_ends_at_4095(const fxl_lens *lens, int64_t one)
{
    TEST_ASSERT_EQUAL_INT32(Q16(4095), project(lens, 3935 * one, 0, one).x);
    TEST_ASSERT_EQUAL_INT32(Q16(-4095), project(lens, -4255 * one, 0, one).x);
    TEST_ASSERT_EQUAL_INT32(Q16(4095), project(lens, 0, -3935 * one, one).y);
    TEST_ASSERT_EQUAL_INT32(Q16(-4095), project(lens, 0, 4255 * one, one).y);
    int64_t more = one >> 16; /* a unit of the screen */
    expect_refused(lens, 3935 * one + more, 0, one);
    expect_refused(lens, -4255 * one - more, 0, one);
    expect_refused(lens, 0, -3935 * one - more, one);
    expect_refused(lens, 0, 4255 * one + more, one);
}

/* SPEC 3.1s, 4.8b */
void test_the_range_ends_at_4095(void)
{
    fxl_lens lens = unit_lens(320, 320);
    lens.focal = Q16(1);
    expect_ends_at_4095(&lens, FXL_PROJECT_DEPTH_MIN);
    expect_ends_at_4095(&lens, V(1));
    expect_ends_at_4095(&lens, (int64_t)1 << 48);
}

/* The members are multiples of the focal length, modulo 2^32. The kernels' fast path is for focal
 * lengths below 1024 pixels and screens less than about four of them wide. */
void test_what_is_set_up_of_a_lens(void)
{
    static const struct {
        fxl_q16_16 focal;
        uint16_t width, height;
        bool fast;
    } lenses[] = {{Q16(160), 320, 240, true}, {Q16(1024) - 1, 64, 48, true},
                  {Q16(1024), 64, 48, false}, {Q16(64), 253, 10, true},
                  {Q16(64), 254, 10, false},  {Q16(64), 10, 253, true},
                  {Q16(64), 10, 254, false}};
    for (size_t i = 0; i < sizeof lenses / sizeof lenses[0]; i++) {
        fxl_lens lens = unit_lens(lenses[i].width, lenses[i].height);
        fxl_projection made;
        lens.focal = lenses[i].focal;
        const uint32_t focal = (uint32_t)lens.focal;
        fxl_projection_from_lens(&lens, &made);
        TEST_ASSERT_EQUAL_HEX32(4 * focal, made.factor);
        TEST_ASSERT_EQUAL_HEX32(4 * focal - 1, made.factor_less_1);
        TEST_ASSERT_EQUAL_HEX32(16 * focal, made.factor_2);
        TEST_ASSERT_EQUAL_HEX32(524288 * focal, made.factor_17);
        TEST_ASSERT_EQUAL_INT32(lens.width * 32768, made.centre_x);
        TEST_ASSERT_EQUAL_INT32(lens.height * 32768, made.centre_y);
        TEST_ASSERT_EQUAL_INT32(lenses[i].fast ? 32 : INT32_MAX, made.depth_min);
    }
}
