/* SPDX-License-Identifier: MIT */
/* The planes of small faces, against planes through the same corners in double, and the rule that
 * says which faces are small. */
#include "corner_unit.h"
#include "paint/corner_colours.h"
#include "paint/light_row.h"

/* Of the units of a gradient's upper word, what is cut off the steps is at most this part. */
#define PART_OF_UNIT (1.0 / 16)

/* The share of its bound that the worst face has at least. */
#ifdef UNIT_ON_TARGET
#define WORST_SHARE 0.2
#else
#define WORST_SHARE 0.7
#endif

void setUp(void)
{
    corner_begin();
}

static double word(int64_t value)
{
    return (double)value / 4294967296.0;
}

static double value_at(const fxl_gradient *gradient, double x, double y)
{
    return word(gradient->at) + (x / 65536 - 0.5) * word(gradient->along) +
           (y / 65536 - 0.5) * word(gradient->down);
}

static void check_bounds(const fxl_gradient *gradient)
{
    const double columns = (triangle.view.lens.width + 15) / 16 * 16,
                 rows = triangle.view.lens.height;
    for (int i = 0; i < 4; i++) {
        const double value = word(gradient->at) + (i & 1 ? columns : 0) * word(gradient->along) +
                             (i & 2 ? rows : 0) * word(gradient->down);
        TEST_ASSERT_TRUE(fabs(value) <= 1073741824.0);
    }
}

/* SPEC 9.1.1a-e */
void test_small_is_what_its_conditions_say(void)
{
    uint32_t small = 0, thin = 0, apart = 0, steep = 0, texels = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        corner_make(unit_random() % 4 == 0 ? 5.0 : 0.2);
        const double w = triangle.corners.width, h = triangle.corners.height;
        const bool has_size = fmin(w, h) >= 16384 && fmax(w, h) <= FXL_WORDS_SIDE_MAX;
        const bool is_thin = corner_twice_area() * 8 < w * h,
                   is_line = corner_twice_area() * 512 < w * h;
        const double z =
            fmax((double)triangle.corners.depths[0],
                 fmax((double)triangle.corners.depths[1], (double)triangle.corners.depths[2]));
        const double power = exp2(floor(log2(z)) - 1);
        bool is_apart = false;
        for (int k = 0; k < 3; k++) {
            is_apart = is_apart || (double)triangle.corners.depths[k] < power;
        }
        const double near =
            fmin((double)triangle.corners.depths[0],
                 fmin((double)triangle.corners.depths[1], (double)triangle.corners.depths[2]));
        const double side = fmin(w, h) / 65536 / FXL_SMALL_SLOPES;
        if (fabs(1 - near / z - side) < 1e-6) {
            continue; /* a tie, to within rounding */
        }
        const bool is_steep = 1 - near / z > side;
        const bool expected = has_size && !is_line && !is_apart;
        TEST_ASSERT_EQUAL(expected, fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens,
                                                            FXL_WORDS_SIDE_MAX, &triangle.planes));
        const bool is_for_words = is_thin || is_steep || fmax(w, h) > 64 * 65536;
        TEST_ASSERT_TRUE(!expected || triangle.planes.may_be_steep == (is_thin || is_steep));
        TEST_ASSERT_TRUE(!expected || triangle.planes.is_for_words == is_for_words);
        TEST_ASSERT_EQUAL(expected && !is_for_words,
                          fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens,
                                                  FXL_SMALL_SIDE_MAX, &triangle.planes));
        /* Whichever corner is the first. */
        const fxl_screen_corners turned = {
            {triangle.corners.points[1], triangle.corners.points[2], triangle.corners.points[0]},
            {triangle.corners.depths[1], triangle.corners.depths[2], triangle.corners.depths[0]},
            triangle.corners.width,
            triangle.corners.height,
            true};
        TEST_ASSERT_EQUAL(expected, fxl_corner_planes_begin(&turned, &triangle.view.lens,
                                                            FXL_WORDS_SIDE_MAX, &triangle.planes));
        const bool may_be_texels = fmin(w, h) >= 16384 && fmax(w, h) <= FXL_TEXELS_SIDE_MAX &&
                                   corner_twice_area() * 16 >= w * h && !is_apart;
        TEST_ASSERT_EQUAL(may_be_texels,
                          fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens,
                                                  FXL_TEXELS_SIDE_MAX, &triangle.planes));
        TEST_ASSERT_TRUE(!may_be_texels || triangle.planes.is_for_words == is_for_words);
        texels += may_be_texels && is_for_words;
        small += expected && !is_for_words;
        thin += has_size && is_thin;
        apart += has_size && is_apart;
        steep += has_size && is_steep;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 75, small);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, thin);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, apart);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, steep);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, texels);
}

/* SPEC 9.1.1b */
void test_the_box_counts_that_of_all_vertices(void)
{
    const fxl_screen_corners small = {{{0, 0}, {65536, 0}, {0, 65536}},
                                      {(int64_t)1 << 46, (int64_t)1 << 46, (int64_t)1 << 46},
                                      65536,
                                      65536,
                                      true};
    fxl_screen_corners large = small;
    TEST_ASSERT_TRUE(
        fxl_corner_planes_begin(&small, &triangle.view.lens, FXL_WORDS_SIDE_MAX, &triangle.planes));
    TEST_ASSERT_FALSE(triangle.planes.is_for_words);
    large.width = (64 << 16) + 1;
    TEST_ASSERT_TRUE(!fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_WORDS_SIDE_MAX,
                                              &triangle.planes) ||
                     triangle.planes.is_for_words);
    TEST_ASSERT_FALSE(
        fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_SMALL_SIDE_MAX, &triangle.planes));
    large.width = FXL_WORDS_SIDE_MAX + 1;
    TEST_ASSERT_FALSE(
        fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_WORDS_SIDE_MAX, &triangle.planes));
}

/* Whether the face is small. */
static bool begins(void)
{
    return fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens, FXL_SMALL_SIDE_MAX,
                                   &triangle.planes);
}

/* accuracy 5.1.1g, 5.1.1w, SPEC 10.2e */
void test_depth_is_that_of_the_plane_through_the_corners(void)
{
    uint32_t checked = 0;
    for (uint32_t seed = 1; seed <= CORNER_SEEDS; seed++) {
        corner_begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            fxl_depth_plane plane;
            double values[3], x, y;
            corner_make(i % 4 == 0 ? 2.8 : 0.5);
            if (i % 2 == 0) {
                corner_make_thin(1.0 / 16);
            }
            if (!begins()) {
                continue;
            }
            fxl_corner_planes_depth(&triangle.planes, &plane);
            check_bounds(&plane.gradient);
            for (int k = 0; k < 3; k++) {
                values[k] =
                    triangle.view.lens.near_z * 1073741824.0 / (double)triangle.corners.depths[k];
            }
            corner_choose_place(&x, &y);
            const double found = ldexp(value_at(&plane.gradient, x, y), 32 - plane.one);
            TEST_ASSERT_NEAR(corner_plane_at(values, x, y), found,
                             corner_depth_rounding(values) +
                                 PART_OF_UNIT * ldexp(1, 32 - plane.one));
            checked++;
        }
    }
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 200), checked);
}

/* What attributes are off by, at most, as a part of what they may be. */
typedef struct {
    uint32_t constant; /* faces of a constant weight */
    double worst;
} attribute_counts;

/* Attributes of a face: u and v, or light alone, or all three. */
static void check_attributes(int first, uint32_t count, bool is_affine, attribute_counts *counts)
{
    int32_t given[FXL_ATTRIBUTES][3];
    double values[FXL_ATTRIBUTES][3], x, y;
    fxl_gradients found;
    const bool is_far_apart = unit_random() % 2;
    for (int i = 0; i < FXL_ATTRIBUTES * 3; i++) {
        const bool is_light = first + i / 3 == 2;
        const int32_t low = is_light ? 32768 : -(1 << 24), high = is_light ? 31 << 16 : 1 << 24;
        given[i / 3][i % 3] = is_far_apart ? (i % 3 == 0 ? low : high) : unit_between(low, high);
        values[i / 3][i % 3] = given[i / 3][i % 3];
    }
    fxl_corner_planes_find(&triangle.planes, given, count, is_affine, &found);
    TEST_ASSERT_EQUAL(count, found.count);
    check_bounds(&found.weight);
    corner_choose_place(&x, &y);
    const bool is_constant = fxl_weight_is_constant(&found);
    counts->constant += is_constant;
    for (uint32_t i = 0; i < count; i++) {
        const bool is_light = first + (int)i == 2;
        const double weight = value_at(&found.weight, x, y), unit = ldexp(1, found.shifts[i]);
        const double value = value_at(&found.attributes[i], x, y) / weight * unit;
        const double exact =
            is_affine ? corner_plane_at(values[i], x, y) : corner_attribute_at(values[i], x, y);
        double bound = is_constant ? corner_plane_rounding(values[i]) + PART_OF_UNIT * unit / weight
                                   : corner_divided_rounding(values[i], x, y) +
                                         PART_OF_UNIT * (unit + fabs(exact)) / weight;
        if (is_constant && !is_affine) {
            bound += (is_light ? FXL_AFFINE_ERROR_LIGHT : FXL_AFFINE_ERROR_TEXEL) /
                     (triangle.planes.is_triangle ? 1 : 8);
        }
        check_bounds(&found.attributes[i]);
        TEST_ASSERT_NEAR(exact, value, bound);
        counts->worst = fmax(counts->worst, fabs(exact - value) / bound);
    }
}

/* SPEC 9.1.1f-h, accuracy 5.1.1b-f, 5.1.1h-i, 5.1.1m */
void test_attributes_are_those_of_the_corners(void)
{
    uint32_t checked = 0;
    attribute_counts divided = {0, 0}, affine = {0, 0};
    for (uint32_t seed = 1; seed <= CORNER_SEEDS; seed++) {
        corner_begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            corner_make(unit_random() % 2 ? 0.5 : 1.0 / 1024);
            if (i % 2 == 0) {
                corner_make_thin(1.0 / 16);
            }
            if (!begins()) {
                continue;
            }
            check_attributes(0, 2, false, &divided);
            check_attributes(0, 3, false, &divided);
            check_attributes(2, 1, false, &divided);
            check_attributes(0, 3, true, &affine);
            checked++;
        }
    }
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 200), checked);
    TEST_ASSERT_GREATER_THAN(checked / 8, divided.constant);
    TEST_ASSERT_LESS_THAN(2 * checked, divided.constant);
    TEST_ASSERT_EQUAL(checked, affine.constant);
    TEST_ASSERT_TRUE(affine.worst > WORST_SHARE);
}

/* SPEC 9.1.1i */
void test_attributes_of_a_face_of_more_vertices(void)
{
    uint32_t checked = 0;
    attribute_counts whole = {0, 0}, light = {0, 0};
    corner_begin_seed(1);
    for (int i = 0; i < UNIT_REPEAT / 2; i++) {
        corner_make(i % 2 ? 1.0 / 4096 : 1.0 / 64);
        triangle.corners.is_triangle = false;
        if (begins()) {
            check_attributes(0, 3, false, &whole);
            check_attributes(2, 1, false, &light);
            checked++;
        }
    }
    TEST_ASSERT_GREATER_THAN(checked / 100, whole.constant);
    TEST_ASSERT_GREATER_THAN(checked / 10, light.constant);
    TEST_ASSERT_LESS_THAN(checked * 9 / 10, light.constant);
}

/* Rows of the box, and 16 columns about it: where the weights suffice, an attribute on the line
 * between both ends of a segment is within a third of its unit of the divided one. */
/* SPEC 9.1.1f */
void test_segments_are_within_a_third_where_the_least_weight_suffices(void)
{
    uint32_t wide = 0, narrow = 0, refused = 0;
    corner_begin_seed(1); /* whichever test was before: the lens decides how many are wide */
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        int32_t given[2][3];
        fxl_gradients found;
        corner_make(0.5);
        if (!begins()) {
            continue;
        }
        const int bits = unit_between(13, 24);
        for (int k = 0; k < 6; k++) {
            given[k / 3][k % 3] = unit_between(-(1 << bits), 1 << bits);
        }
        fxl_corner_planes_find(&triangle.planes, given, 2, false, &found);
        if (fxl_weight_is_constant(&found)) {
            continue;
        }
        double x, y;
        corner_choose_point(&x, &y);
        const int columns = unit_random() % 2 ? 16 : 4;
        const double least = found.weight_min[columns == 16 ? 0 : 1];
        const double first = floor(x / 65536 / columns) * columns * 65536;
        const double ends[2] = {value_at(&found.weight, first, y),
                                value_at(&found.weight, first + columns * 65536.0, y)};
        if (ends[0] < least || ends[1] < least) {
            refused++;
            continue;
        }
        wide += columns == 16;
        narrow += columns == 4;
        for (int k = 0; k < 2; k++) {
            const fxl_gradient *u = &found.attributes[k];
            const double unit = ldexp(1, found.shifts[k]);
            const double u0 = value_at(u, first, y) / ends[0] * unit;
            const double u1 = value_at(u, first + columns * 65536.0, y) / ends[1] * unit;
            TEST_ASSERT_TRUE(fabs(u1 - u0) <= 536870912.0);
            for (int step = 0; step <= columns; step++) {
                const double exact = value_at(u, first + step * 65536.0, y) /
                                     value_at(&found.weight, first + step * 65536.0, y) * unit;
                TEST_ASSERT_NEAR(exact, u0 + (u1 - u0) * step / columns, 21846);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, wide);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 500, narrow);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 500, refused);
}

/* SPEC 9.8, 9.1.1j, accuracy 5.1.1l */
void test_colours_take_longer_sides_and_thin_triangles(void)
{
    const fxl_q18_46 depth = (fxl_q18_46)1 << 46;
    fxl_screen_corners large = {
        {{0, 0}, {FXL_COLOURS_SIDE_MAX, 0}, {0, 1 << 26}}, {depth, depth, depth}, 0, 0, true};
    large.points[2].y = FXL_COLOURS_SIDE_MAX;
    large.width = large.height = FXL_COLOURS_SIDE_MAX;
    TEST_ASSERT_TRUE(fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_COLOURS_SIDE_MAX,
                                             &triangle.planes));
    TEST_ASSERT_TRUE(triangle.planes.is_for_words && triangle.planes.exponent <= 40);
    for (int k = 0; k < 2; k++) { /* the larger coefficient is one over a side */
        const double most =
            fmax(fabs((double)triangle.planes.along[k]), fabs((double)triangle.planes.down[k]));
        TEST_ASSERT_TRUE(fabs(ldexp(most, 16 - triangle.planes.exponent) * 1023 - 65536) < 0.01);
    }
    TEST_ASSERT_FALSE(
        fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_WORDS_SIDE_MAX, &triangle.planes));
    large.width++;
    TEST_ASSERT_FALSE(fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_COLOURS_SIDE_MAX,
                                              &triangle.planes));
    large.width--;
    for (int k = 0; k < 2; k++) { /* 1/16 of the box, and 1/128 */
        large.points[2].y = FXL_COLOURS_SIDE_MAX / (k == 0 ? 8 : 64);
        TEST_ASSERT_TRUE(fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_COLOURS_SIDE_MAX,
                                                 &triangle.planes));
        TEST_ASSERT_EQUAL(k != 0, triangle.planes.may_be_steep);
    }
    large.points[2].y--;
    TEST_ASSERT_FALSE(fxl_corner_planes_begin(&large, &triangle.view.lens, FXL_COLOURS_SIDE_MAX,
                                              &triangle.planes));
}

/* --- colours that are functions of the screen ---------------------------------------------- */

static double channel_at(uint64_t words, int upper)
{
    return (int32_t)(uint32_t)(words >> (upper ? 32 : 0)) / 4194304.0;
}

/* What a function adds to red (0) or blue (2) at corner 0, in levels. */
static double added_to(const fxl_gradients *found, int k, double value)
{
    const fxl_gradient *a = found->attributes;
    const fxl_screen_point *p = &triangle.corners.points[0];
    const double column = (int32_t)(uint32_t)((uint64_t)a[0].at >> 32);
    const double at = k == 0 ? channel_at((uint64_t)a[0].at, 0) : channel_at((uint64_t)a[1].at, 1);
    const double along = channel_at((uint64_t)a[1].along, k != 0);
    const double down = channel_at((uint64_t)a[k / 2].down, 0);
    const double off = at - 1024 / 4194304.0 + along * (p->x / 65536.0 - 0.5 - column) +
                       down * (p->y / 65536.0 - 0.5) - value;
    return off - 1024 * floor(off / 1024 + 0.5); /* words are modulo 1024 levels */
}

/* How far a channel is above its function, in levels: from low to high, and in the mean. */
typedef struct {
    double low, high, mean;
} bend;

static bend bend_of(const int32_t values[3])
{
    bend found = {0, 0, 0};
    double near[3], least = INFINITY;
    for (int i = 0; i < 3; i++) {
        near[i] = 1 / (double)triangle.corners.depths[i];
        least = fmin(least, near[i]);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double product = (values[i] - values[j]) / 65536.0 * (near[i] - near[j]) / least;
        found.low = fmin(found.low, product / 4);
        found.high = fmax(found.high, product / 4);
        found.mean += product / 12;
    }
    return found;
}

/* Counts: taken at once, with a mean, and near what no pixel shows without one, or with what is nearest to it. */
static void check_channel(const fxl_gradients *found, int k, const int32_t values[3],
                          bool is_coarse, uint32_t counts[4])
{
    const bend of = bend_of(values);
    const double added = k == 1 ? 0 : added_to(found, k, values[0] / 65536.0);
    const double mean = fmin(fmax(of.mean, of.high - 0.3), of.low + 0.3);
    double lower = INFINITY, upper = INFINITY; /* room below and above the channels of the corners */
    for (int i = 0; i < 3; i++) {
        lower = fmin(lower, values[i] / 65536.0 - 1.0 / 16);
        upper = fmin(upper, (k == 1 ? 64 : 32) - values[i] / 65536.0 - 1.0 / 16);
    }
    const double inside = fmin(lower + mean, upper - mean);
    TEST_ASSERT_TRUE(k == 1 || (of.high - added <= 0.301 && added - of.low <= 0.301));
    if (!is_coarse) {
        TEST_ASSERT_TRUE(of.high <= 0.126 && of.low >= -0.126);
    }
    TEST_ASSERT_TRUE(of.high - of.low <= 0.601);
    if (k == 1 || fabs(inside) < 0.02) {
        return; /* a word of green has too few bits of its step; a tie */
    }
    if (!is_coarse || fmax(of.high, -of.low) < 0.056) {
        TEST_ASSERT_NEAR(0, added, 0.005);
        counts[0]++;
    } else if (fmax(of.high, -of.low) > 0.0626 && inside > 0) {
        TEST_ASSERT_NEAR(mean, added, 0.02);
        counts[1]++;
    } else if (inside < 0 && fmax(of.high, -of.low) < 0.29) {
        TEST_ASSERT_NEAR(0, added, 0.005);
        counts[2]++;
    } else if (inside < 0 && fmax(of.high, -of.low) > 0.31) {
        TEST_ASSERT_NEAR(fmin(fmax(mean, -lower), upper), added, 0.02);
        counts[3]++;
    }
}

/* Where a channel is above its function by up to 0.6 of a level, that has its mean, or what is nearest to that
 * and not near what no pixel shows. */
/* SPEC 9.1.1k, 9.1.1m-p */
void test_colours_are_functions_of_the_screen_where_they_bend_little(void)
{
    uint32_t counts[2][4] = {{0}};
    corner_begin_seed(1);
    for (int n = 0; n < UNIT_REPEAT; n++) {
        const bool is_coarse = n % 2 != 0;
        int32_t values[3][3];
        fxl_gradients found;
        corner_make(n % 3 == 0 ? 0.05 : 0.5);
        const int32_t range = unit_between(2 << 16, 16 << 16);
        for (int i = 0; i < 9; i++) {
            const int32_t most = i / 3 == 1 ? 64 << 16 : 32 << 16;
            values[i / 3][i % 3] = unit_between(-most / 4, most + most / 4);
            values[i / 3][i % 3] = unit_between(
                most / 512, values[i / 3][i % 3] < most / 512 ? most / 512 : most - most / 512);
        }
        if (n % 4 == 3) { /* one channel near an end, and the others constant */
            const int k = n % 5 == 0 ? 0 : 2;
            for (int i = 0; i < 9; i++) {
                const int32_t more = unit_between(1 << 12, i % 3 == n / 4 % 4 ? 5 << 12 : range);
                values[i / 3][i % 3] = i / 3 != k ? 1 << 20 : n % 3 == 1 ? more : (32 << 16) - more;
            }
        }
        if (fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens, FXL_COLOURS_SIDE_MAX,
                                    &triangle.planes) &&
            triangle.planes.weight_range >> 6 > triangle.planes.weight_most >> 13 &&
            fxl_corner_colours_linear(&triangle.planes, values, false, is_coarse, &found)) {
            for (int k = 0; k < 3; k++) {
                check_channel(&found, k, values[k], is_coarse, counts[is_coarse]);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, counts[0][0]);
    for (int i = 0; i < 4; i++) {
        TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, counts[1][i]);
    }
}
