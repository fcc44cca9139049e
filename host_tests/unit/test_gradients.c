/* SPDX-License-Identifier: MIT */
/* How attributes vary over the screen, against the definition in double: rays through points of the
 * screen, and the conditions that give the least weight. */
#include <math.h>

#include "clip_unit.h"
#include "paint/gradients.h"

static int width, height;
static fxl_view view;
static fxl_gradient_corners face;
static fxl_gradients found;

static double corner[3][3];

static double word(int64_t value)
{
    return (double)value / 4294967296.0;
}

static double at(const fxl_gradient *gradient, double column, double row)
{
    return word(gradient->at) + column * word(gradient->along) + row * word(gradient->down);
}

/* Corners on the screen, whose depths differ by at most so much, with attributes of so many bits.
 */
static void make_face(unsigned bits, fxl_q16_16 depths)
{
    const double one = 70368744177664.0; /* 2^46 */
    const double focal = view.lens.focal / 65536.0;
    const fxl_q16_16 nearest = unit_between(Q16(0.5), Q16(90));
    for (int i = 0; i < 3; i++) {
        const double depth = unit_between(nearest, nearest + depths) / 65536.0;
        corner[i][0] = unit_between(-width * 32768, width * 32768) / 65536.0 * depth / focal;
        corner[i][1] = unit_between(-height * 32768, height * 32768) / 65536.0 * depth / focal;
        corner[i][2] = depth;
        face.corners[i] =
            (fxl_view_point){(fxl_q18_46)(corner[i][0] * one), (fxl_q18_46)(corner[i][1] * one),
                             (fxl_q18_46)(corner[i][2] * one)};
    }
    face.count = FXL_ATTRIBUTES;
    for (int i = 0; i < FXL_ATTRIBUTES * 3; i++) {
        face.values[i / 3][i % 3] = unit_between(-(1 << bits) + 1, (1 << bits) - 1);
    }
}

static void cross(const double *a, const double *b, double *result)
{
    for (int i = 0; i < 3; i++) {
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Six times the volume between the eye and the corners; its sign is that of the corners' turn. */
static double volume_of_face(void)
{
    double normal[3];
    cross(corner[1], corner[2], normal);
    return dot(normal, corner[0]);
}

static double length(const double *a)
{
    return sqrt(dot(a, a));
}

/* An attribute where the ray through a pixel's centre meets the plane: a mean of the corners'
 * values whose weights are volumes of which the ray is one edge. *bound: what rounding may cost, of
 * docs/accuracy.md, section 5.1, with the edges' lengths where it has components. */
static double exact_attribute(int number, double column, double row, double *bound)
{
    const double focal = view.lens.focal / 65536.0;
    const double ray[3] = {(column + 0.5 - width / 2) / focal, (height / 2 - row - 0.5) / focal, 1};
    const int32_t *given = face.values[number];
    double sum = 0, values = 0, edges[2][3];
    for (int i = 0; i < 3; i++) {
        double normal[3];
        cross(corner[(i + 1) % 3], corner[(i + 2) % 3], normal);
        const double weight = dot(normal, ray);
        sum += weight;
        values += weight * given[i];
        edges[0][i] = corner[1][i] - corner[0][i];
        edges[1][i] = corner[2][i] - corner[0][i];
    }
    const double first = length(edges[0]), second = length(edges[1]), far = length(corner[0]);
    const double k = (fabs((double)given[0]) + fabs(values / sum)) * first * second +
                     fabs((double)given[1] - given[0]) * second * far +
                     fabs((double)given[2] - given[0]) * first * far;
    *bound = ldexp(k, -27) * (fabs(ray[0]) + fabs(ray[1]) + 1) / fabs(sum);
    return values / sum;
}

static bool is_thin(void)
{
    return fabs(volume_of_face()) < 1;
}

void setUp(void)
{
    width = 2 * unit_between(1, 160); /* often a multiple of 16 */
    width = unit_random() % 2 ? width : (width + 15) / 16 * 16;
    height = 2 * unit_between(1, 120);
    view = clip_random_view((uint16_t)width, (uint16_t)height);
}

/* SPEC 9.1b, 9.1d, accuracy 5.1a, 5.1d-e */
void test_attributes_are_those_of_the_point_that_is_seen(void)
{
    uint32_t checked = 0, tight = 0;
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        make_face(28, Q16(9));
        if (is_thin()) {
            continue;
        }
        fxl_gradients_find(&face, &view, &found);
        TEST_ASSERT_EQUAL(FXL_ATTRIBUTES, found.count);
        for (int number = 0; number < FXL_ATTRIBUTES; number++) {
            /* Each corner's pixel, where the weight is above 0. */
            const int near = unit_between(0, 2);
            const double focal = view.lens.focal / 65536.0;
            const double column = floor(width / 2 + corner[near][0] / corner[near][2] * focal);
            const double row = floor(height / 2 - corner[near][1] / corner[near][2] * focal);
            const double weight = at(&found.weight, column, row);
            if (column < 0 || column >= width || row < 0 || row >= height || weight < 65536) {
                continue;
            }
            const double value = at(&found.attributes[number], column, row) / weight *
                                 ldexp(1, found.shifts[number]);
            double bound;
            const double exact = exact_attribute(number, column, row, &bound);
            TEST_ASSERT_NEAR(exact, value, bound);
            tight += fabs(exact - value) * 64 > bound;
            checked++;
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 60, checked);
    TEST_ASSERT_GREATER_THAN(checked / 9, tight); /* the bound says something */
}

/* accuracy 5.1c */
void test_the_volume_is_exact_but_for_rounding(void)
{
    const double one = 70368744177664.0;
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        make_face(20, Q16(9));
        if (is_thin()) {
            continue;
        }
        fxl_gradients_find(&face, &view, &found);
        const double exact = fabs(volume_of_face());
        const double actual =
            ldexp((double)found.volume.number, found.volume.exponent) / one / one / one;
        TEST_ASSERT_NEAR(exact, actual, 2e-3 + exact * 1e-5);
    }
}

/* Scaled so that the largest value on the screen has 62 bits; all else is exact. */
/* SPEC 9.1d */
void test_the_gradient_of_a_plane(void)
{
    for (int i = 0; i < UNIT_REPEAT / 30; i++) {
        const int32_t limit = 1 << unit_between(0, 30);
        const fxl_block_vector vector = {unit_between(-limit, limit), unit_between(-limit, limit),
                                         unit_between(-limit, limit), unit_between(-9, 9)};
        fxl_gradient gradient;
        const int exponent = fxl_gradient_of_plane(vector, &view, &gradient);
        double largest = 0;
        for (int k = 0; k < 4; k++) {
            const double column = k % 2 ? (width + 15) / 16 * 16 : 0, row = k / 2 ? height : 0;
            const double exact =
                (vector.x * (column + 0.5 - width / 2) * 65536 +
                 vector.y * (height / 2 - row - 0.5) * 65536 + (double)vector.z * view.lens.focal) *
                ldexp(1, vector.exponent);
            const double value = at(&gradient, column, row) * 4294967296.0;
            TEST_ASSERT_NEAR(exact, value * ldexp(1, exponent),
                             fabs(exact) * 1e-12 + ldexp(1, exponent));
            largest = fmax(largest, fabs(value));
        }
        if ((vector.x | vector.y | vector.z) == 0) {
            TEST_ASSERT_EQUAL(0, exponent);
            TEST_ASSERT_TRUE(largest == 0);
        } else {
            TEST_ASSERT_TRUE(largest >= ldexp(1, 61) * 0.999 && largest <= ldexp(1, 62));
        }
    }
}

void test_a_plane_through_the_eye_is_zero(void)
{
    const fxl_block_vector none = {0, 0, 0, 7};
    fxl_gradient gradient = {1, 2, 3};
    TEST_ASSERT_EQUAL(0, fxl_gradient_of_plane(none, &view, &gradient));
    TEST_ASSERT_TRUE(gradient.at == 0 && gradient.along == 0 && gradient.down == 0);
}

/* |u' w - w' u| of a row, in units of words; *slack: what the slopes, cut to 31 bits, may add. */
static double twist_of(int number, double row, double *slack)
{
    const fxl_gradient *u = &found.attributes[number], *w = &found.weight;
    const double shift = ldexp(1, found.shifts[number]);
    const double steeper = fmax(fabs((double)u->along), fabs((double)w->along));
    int bits;
    (void)frexp(steeper, &bits);
    *slack = ldexp(4, bits > 31 ? bits - 31 : 0) * shift;
    return fabs(word(u->along) * at(w, 0, row) - word(w->along) * at(u, 0, row)) * shift;
}

/* The weight of 8 pixels suffices, and is at most that of 16; FXL_DIVIDE_8 takes half the columns.
 */
static void check_least_weight_of_8(double exact)
{
    uint32_t of_16[3], of_8[3];
    fxl_find_least_weights(&found, FXL_DIVIDE_16, of_16);
    fxl_find_least_weights(&found, FXL_DIVIDE_8, of_8);
    TEST_ASSERT_TRUE(of_16[1] >= fmin(exact * 0.9999, 2147483648.0));
    TEST_ASSERT_TRUE(of_16[0] >> 31 != 0 || of_16[0] + 2 >= of_16[1]);
    TEST_ASSERT_TRUE(of_16[1] >= of_16[2]);
    TEST_ASSERT_TRUE(of_8[0] == UINT32_MAX && of_8[1] == of_16[0] && of_8[2] == of_16[1]);
}

/* Over a segment of 16 pixels a line through its ends is off by at most 0.3 of a unit, and
 * its ends are below 2^29 (gradients.c). The bound is at most a step of its own above that. */
/* accuracy 5.2b */
void test_the_least_weight_is_what_its_two_conditions_ask_for(void)
{
    uint32_t by_bend = 0, by_far = 0, least = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        make_face((unsigned)unit_between(0, 29), (1 << unit_between(0, 20)) - 1);
        if (is_thin()) {
            continue;
        }
        fxl_gradients_find(&face, &view, &found);
        double twist = 0, above = 0;
        for (int k = 0; k < 2 * FXL_ATTRIBUTES; k++) {
            double slack;
            const double own = twist_of(k / 2, k % 2 ? height : 0, &slack);
            twist = fmax(twist, own);
            above = fmax(above, own + slack);
        }
        const double slope = fabs(word(found.weight.along));
        const double bend = cbrt(twist * slope * 27 / 8192), far = sqrt(twist / (1 << 25));
        const double bend_above = cbrt(above * (slope + 1e-9) * 27 / 8192),
                     far_above = sqrt(above / (1 << 25));
        const double most = fmax(bend_above * 1.004 + 1, far_above * 2.001 + 1);
        TEST_ASSERT_TRUE(found.weight_min[0] >= fmin(fmax(bend, far) * 0.9999, 2147483648.0));
        TEST_ASSERT_TRUE(found.weight_min[0] <= most);
        const double bend_of_4 = bend * cbrt(1.0 / 16), far_of_4 = far / 2;
        TEST_ASSERT_TRUE(found.weight_min[1] >=
                         fmin(fmax(bend_of_4, far_of_4) * 0.9999, 2147483648.0));
        TEST_ASSERT_TRUE(found.weight_min[1] <=
                         fmax(bend_above * cbrt(1.0 / 16) * 1.005 + 2, far_above * 1.001 + 1));
        check_least_weight_of_8(fmax(bend * cbrt(1.0 / 4), far * sqrt(0.5)));
        by_bend += bend > far * 2.01 && bend > 2;
        by_far += far > bend && far > 2;
        least += found.weight_min[0] == 1;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 100, by_bend);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 100, by_far);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, least);
}

/* Corners whose attributes become linear on the screen: all on it, or none of them changes. */

enum {
    WIDTH = 40,
    HEIGHT = 30
};

/* A corner at a point of the screen, in pixels, so far away. */
static fxl_view_point corner_at(double x, double y, double depth)
{
    const double focal = view.lens.focal / 65536.0, one = 70368744177664.0; /* 2^46 */
    return (fxl_view_point){(fxl_q18_46)((x - WIDTH / 2) * depth / focal * one),
                            (fxl_q18_46)((HEIGHT / 2 - y) * depth / focal * one),
                            (fxl_q18_46)(depth * one)};
}

static fxl_gradient_corners corners_with(double x, double y)
{
    fxl_gradient_corners affine;
    memset(&affine, 0, sizeof affine);
    affine.corners[0] = corner_at(10, 8, 3);
    affine.corners[1] = corner_at(25, 12, 5);
    affine.corners[2] = corner_at(x, y, 7);
    return affine;
}

static bool becomes_affine(fxl_gradient_corners affine)
{
    const fxl_gradient_corners before = affine;
    fxl_corners_make_affine(&affine, &view);
    const bool is_changed = memcmp(&before, &affine, sizeof affine) != 0;
    for (int i = 0; is_changed && i < 3; i++) {
        fxl_screen_point point;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_project_visible(&view.projection, &before.corners[i], &point));
        TEST_ASSERT_TRUE(affine.corners[i].x == point.x - WIDTH * 32768);
        TEST_ASSERT_TRUE(affine.corners[i].y == HEIGHT * 32768 - point.y);
        TEST_ASSERT_TRUE(affine.corners[i].z == view.lens.focal);
    }
    return is_changed;
}

static void look(void)
{
    view = clip_random_view(WIDTH, HEIGHT);
}

/* SPEC 9.3a */
void test_a_corner_beyond_any_side_leaves_all_as_they_are(void)
{
    for (int i = 0; i < 50; i++) {
        look();
        TEST_ASSERT_TRUE(becomes_affine(corners_with(5, 25)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(0, 15))); /* on the border */
        TEST_ASSERT_TRUE(becomes_affine(corners_with(WIDTH, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, 0)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, HEIGHT)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(0.01, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(WIDTH - 0.01, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, 0.01)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, HEIGHT - 0.01)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(-0.01, 15)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(WIDTH + 0.01, 15)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(20, -0.01)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(20, HEIGHT + 0.01)));
    }
}

/* SPEC 9.3a */
void test_a_corner_that_has_no_place_on_the_screen_leaves_all_as_they_are(void)
{
    look();
    fxl_gradient_corners affine = corners_with(5, 25);
    affine.corners[1].z = -affine.corners[1].z;
    TEST_ASSERT_FALSE(becomes_affine(affine));
    affine.corners[1].z = 0;
    TEST_ASSERT_FALSE(becomes_affine(affine));
}

/* SPEC 9.3b */
void test_corners_on_one_line_stay(void)
{
    look();
    fxl_gradient_corners affine = corners_with(5, 25);
    affine.corners[2] = affine.corners[0];
    TEST_ASSERT_FALSE(becomes_affine(affine));
}

/* Right angles, with a side along either axis, at any corner: not on one line. */
/* SPEC 9.3b */
void test_corners_with_sides_along_the_axes(void)
{
    static const uint8_t at[4][2] = {{10, 8}, {25, 8}, {25, 20}, {10, 20}};
    look();
    for (int first = 0; first < 4; first++) {
        for (int step = 1; step < 4; step += 2) {
            fxl_gradient_corners affine = corners_with(5, 25);
            for (int i = 0; i < 3; i++) {
                const uint8_t *of = at[(first + i * step) % 4];
                affine.corners[i] = corner_at(of[0], of[1], 3 + i);
            }
            TEST_ASSERT_TRUE(becomes_affine(affine));
        }
    }
}
