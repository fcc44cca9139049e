/* SPDX-License-Identifier: MIT */
/* The planes of small faces, against planes through the same corners in double, and the rule that
 * says which faces are small. */
#include <math.h>

#include "clip_views.h"
#include "paint/corner_planes.h"
#include "paint/light_row.h"

static fxl_view view;
static fxl_screen_corners corners;
static fxl_corner_planes planes;

static double word(int64_t value)
{
    return (double)value / 4294967296.0;
}

/* Of a plane that has values at the corners: at a point of the screen. */
static double plane_at(const double values[3], double x, double y)
{
    const fxl_screen_point *p = corners.points;
    const double x1 = p[1].x - (double)p[0].x, y1 = p[1].y - (double)p[0].y;
    const double x2 = p[2].x - (double)p[0].x, y2 = p[2].y - (double)p[0].y;
    const double area = x1 * y2 - x2 * y1, dx = x - p[0].x, dy = y - p[0].y;
    return values[0] + (values[1] - values[0]) * (dx * y2 - dy * x2) / area +
           (values[2] - values[0]) * (dy * x1 - dx * y1) / area;
}

static double at(const fxl_gradient *gradient, double x, double y)
{
    return word(gradient->at) + (x / 65536 - 0.5) * word(gradient->along) +
           (y / 65536 - 0.5) * word(gradient->down);
}

static double largest(const double values[3])
{
    return fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
}

static double range(const double values[3])
{
    return fmax(values[0], fmax(values[1], values[2])) -
           fmin(values[0], fmin(values[1], values[2]));
}

static double twice_area(void)
{
    const fxl_screen_point *p = corners.points;
    return fabs((p[1].x - (double)p[0].x) * (p[2].y - (double)p[0].y) -
                (p[2].x - (double)p[0].x) * (p[1].y - (double)p[0].y));
}

/* Of the units of a gradient's upper word, what is cut off the steps is at most this part. */
#define PART_OF_UNIT (1.0 / 16)

/* What rounding costs a plane through values at the corners, beside that: accuracy 5.1.1. With W
 * and H the sides of the box and L the longer one, the triangle fills 1/n of the box, so twice its
 * area is 2 W H / n. A side is scaled to 2^30 or more and the reciprocal of the area is 2^30 or
 * more, so the largest possible coefficient, L over twice the area, is at least 2^28 units. Each of
 * the two coefficients of a step loses less than a unit, times a difference of at most the range:
 * together 2 range units a pixel, over W + H pixels. The reciprocal is within 2^-29, which changes
 * all coefficients alike. */
static double plane_rounding(const double values[3])
{
    const double w = corners.width, h = corners.height, n = 2 * w * h / twice_area();
    return range(values) * (ldexp(1, -29) + ldexp(n, -28) * (1 + fmax(w, h) / fmin(w, h)));
}

/* The same of depth, whose values at the corners are rounded too: each by less than 2^-25 of the
 * largest. */
static double depth_rounding(const double values[3])
{
    return plane_rounding(values) + ldexp(largest(values), -25);
}

/* Sets the box of the corners, which it keeps on the screen. */
static void find_box(void)
{
    const int32_t width = view.lens.width * 65536, height = view.lens.height * 65536;
    int32_t x[2] = {width, 0}, y[2] = {height, 0};
    for (int i = 0; i < 3; i++) {
        fxl_screen_point *p = &corners.points[i];
        p->x = p->x < 0 ? 0 : p->x < width ? p->x : width;
        p->y = p->y < 0 ? 0 : p->y < height ? p->y : height;
        x[0] = p->x < x[0] ? p->x : x[0];
        x[1] = p->x > x[1] ? p->x : x[1];
        y[0] = p->y < y[0] ? p->y : y[0];
        y[1] = p->y > y[1] ? p->y : y[1];
    }
    corners.width = x[1] - x[0];
    corners.height = y[1] - y[0];
    corners.is_triangle = true;
}

/* Three corners in a box of some size on the screen, at depths that differ by less than `spread`.
 */
static void make_corners(double spread)
{
    const int32_t width = view.lens.width * 65536, height = view.lens.height * 65536;
    const int32_t wide = unit_between(1, unit_random() % 2 ? 70 << 16 : 3 << 16);
    const int32_t high = unit_between(1, unit_random() % 2 ? 70 << 16 : 3 << 16);
    const int32_t left = unit_between(0, width), top = unit_between(0, height);
    const double depth = ldexp(1 + unit_between(0, 65535) / 65536.0, unit_between(40, 58));
    for (int i = 0; i < 3; i++) {
        corners.points[i].x = left + unit_between(0, wide);
        corners.points[i].y = top + unit_between(0, high);
        corners.depths[i] = (fxl_q18_46)(depth * (1 + spread * unit_between(0, 65535) / 65536));
    }
    find_box();
}

/* Puts the corners where rounding costs most: corners 0 and 1 at opposite ends of the box, and the
 * other one so near their line that the triangle fills about `part` of the box, or less at a border
 * of the screen. */
static void make_thin(double part)
{
    const double along = unit_between(10, 90) / 100.0;
    const double beside = 2 * part * unit_between(960, 1080) / 1000.0;
    fxl_screen_point *p = corners.points;
    const double wide = unit_random() % 2 ? 63.99 * 65536 : corners.width;
    const double high = unit_random() % 2 ? 63.99 * 65536 : corners.height;
    p[1].x = p[0].x + (int32_t)wide;
    p[1].y = p[0].y + (int32_t)high;
    p[2].x = p[0].x + (int32_t)(wide * (along + beside / 2));
    p[2].y = p[0].y + (int32_t)(high * (along - beside / 2));
    find_box();
}

/* A point of the triangle. */
static void choose_point(double *x, double *y)
{
    double share[3] = {unit_between(0, 1000), unit_between(0, 1000), unit_between(1, 1000)};
    const double sum = share[0] + share[1] + share[2];
    *x = *y = 0;
    for (int i = 0; i < 3; i++) {
        *x += corners.points[i].x * share[i] / sum;
        *y += corners.points[i].y * share[i] / sum;
    }
}

/* A corner or another point of the triangle: what is linear differs most at a corner. */
static void choose_place(double *x, double *y)
{
    const int corner = unit_between(0, 5);
    choose_point(x, y);
    if (corner < 3) {
        *x = corners.points[corner].x;
        *y = corners.points[corner].y;
    }
}

static void check_bounds(const fxl_gradient *gradient)
{
    const double columns = (view.lens.width + 15) / 16 * 16, rows = view.lens.height;
    for (int i = 0; i < 4; i++) {
        const double value = word(gradient->at) + (i & 1 ? columns : 0) * word(gradient->along) +
                             (i & 2 ? rows : 0) * word(gradient->down);
        TEST_ASSERT_TRUE(fabs(value) <= 1073741824.0);
    }
}

/* Seeds of the checks of bounds that few faces come near, and the share of the bound that the worst
 * of these faces has at least. */
#ifdef UNIT_ON_TARGET
#define SEEDS       2
#define WORST_SHARE 0.2
#else
#define SEEDS       20
#define WORST_SHARE 0.7
#endif

void setUp(void)
{
    const int width = 2 * unit_between(1, 512), height = 2 * unit_between(1, 300);
    view = clip_random_view((uint16_t)width, (uint16_t)height);
}

void tearDown(void)
{
}

/* The numbers of a seed, and a lens of them. */
static void begin_seed(uint32_t seed)
{
    unit_seed(seed);
    setUp();
}

/* SPEC 9.1.1 */
void test_small_is_what_its_conditions_say(void)
{
    uint32_t small = 0, thin = 0, apart = 0, steep = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        make_corners(unit_random() % 4 == 0 ? 5.0 : 0.2);
        const double w = corners.width, h = corners.height;
        const bool has_size = fmin(w, h) >= 16384 && fmax(w, h) <= FXL_WORDS_SIDE_MAX;
        const bool is_thin = twice_area() * 8 < w * h, is_line = twice_area() * 512 < w * h;
        const double z = fmax((double)corners.depths[0],
                              fmax((double)corners.depths[1], (double)corners.depths[2]));
        const double power = exp2(floor(log2(z)) - 1);
        bool is_apart = false;
        for (int k = 0; k < 3; k++) {
            is_apart = is_apart || (double)corners.depths[k] < power;
        }
        const double near = fmin((double)corners.depths[0],
                                 fmin((double)corners.depths[1], (double)corners.depths[2]));
        const double side = fmin(w, h) / 65536 / FXL_SMALL_SLOPES;
        if (fabs(1 - near / z - side) < 1e-6) {
            continue; /* a tie, to within rounding */
        }
        const bool is_steep = 1 - near / z > side;
        const bool expected = has_size && !is_line && !is_apart;
        TEST_ASSERT_EQUAL(expected, fxl_corner_planes_begin(&corners, &view.lens, true, &planes));
        const bool is_for_words = is_thin || is_steep || fmax(w, h) > 64 * 65536;
        TEST_ASSERT_TRUE(!expected || planes.may_be_steep == (is_thin || is_steep));
        TEST_ASSERT_TRUE(!expected || planes.is_for_words == is_for_words);
        TEST_ASSERT_EQUAL(expected && !is_for_words,
                          fxl_corner_planes_begin(&corners, &view.lens, false, &planes));
        /* Whichever corner is the first. */
        const fxl_screen_corners turned = {
            {corners.points[1], corners.points[2], corners.points[0]},
            {corners.depths[1], corners.depths[2], corners.depths[0]},
            corners.width,
            corners.height,
            true};
        TEST_ASSERT_EQUAL(expected, fxl_corner_planes_begin(&turned, &view.lens, true, &planes));
        small += expected && !is_for_words;
        thin += has_size && is_thin;
        apart += has_size && is_apart;
        steep += has_size && is_steep;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 50, small);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, thin);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, apart);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, steep);
}

/* SPEC 9.1.1 */
void test_the_box_counts_that_of_all_vertices(void)
{
    const fxl_screen_corners small = {{{0, 0}, {65536, 0}, {0, 65536}},
                                      {(int64_t)1 << 46, (int64_t)1 << 46, (int64_t)1 << 46},
                                      65536,
                                      65536,
                                      true};
    fxl_screen_corners large = small;
    TEST_ASSERT_TRUE(fxl_corner_planes_begin(&small, &view.lens, true, &planes));
    TEST_ASSERT_FALSE(planes.is_for_words);
    large.width = (64 << 16) + 1;
    TEST_ASSERT_TRUE(!fxl_corner_planes_begin(&large, &view.lens, true, &planes) ||
                     planes.is_for_words);
    large.width = FXL_WORDS_SIDE_MAX + 1;
    TEST_ASSERT_FALSE(fxl_corner_planes_begin(&large, &view.lens, true, &planes));
}

/* Whether the face is small. */
static bool begins(void)
{
    return fxl_corner_planes_begin(&corners, &view.lens, false, &planes);
}

/* accuracy 5.1.1 */
void test_depth_is_that_of_the_plane_through_the_corners(void)
{
    uint32_t checked = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            fxl_depth_plane plane;
            double values[3], x, y;
            make_corners(i % 4 == 0 ? 2.8 : 0.5);
            if (i % 2 == 0) {
                make_thin(1.0 / 16);
            }
            if (!begins()) {
                continue;
            }
            fxl_corner_planes_depth(&planes, &plane);
            check_bounds(&plane.gradient);
            for (int k = 0; k < 3; k++) {
                values[k] = view.lens.near_z * 1073741824.0 / (double)corners.depths[k];
            }
            choose_place(&x, &y);
            const double found = ldexp(at(&plane.gradient, x, y), 32 - plane.one);
            TEST_ASSERT_NEAR(plane_at(values, x, y), found,
                             depth_rounding(values) + PART_OF_UNIT * ldexp(1, 32 - plane.one));
            checked++;
        }
    }
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 200), checked);
}

/* A word that is linear on the screen, where its true value is near `expected`, in units of the
 * word.
 */
static double word_at(const fxl_gradient *gradient, double x, double y, double expected)
{
    const double off =
        (x / 65536 - 0.5) * (double)gradient->along + (y / 65536 - 0.5) * (double)gradient->down;
    return remainder((double)gradient->at + off - expected, 4294967296.0) + expected;
}

/* The code of a depth, whose octave is o: what depth_code.h states. */
static double code_of(double depth, int o, fxl_depth_scale scale)
{
    return (ldexp(depth, o + 1) - 1 + scale.octaves - 1 - o) * (1 << scale.mantissa) + 1;
}

/* An attribute with the weight, where it is divided. */
typedef struct {
    double products[3], weights[3];
} divided_planes;

static divided_planes divided_of(const double values[3])
{
    divided_planes of;
    for (int k = 0; k < 3; k++) {
        of.weights[k] = 1 / (double)corners.depths[k];
        of.products[k] = values[k] * of.weights[k];
    }
    return of;
}

static double attribute_at(const double values[3], double x, double y)
{
    const divided_planes of = divided_of(values);
    return plane_at(of.products, x, y) / plane_at(of.weights, x, y);
}

/* What rounding costs it: that of both planes, a part of the weight there; weights at the corners,
 * which differ by less than 2^-24 of their exact ratios, and so move it by less than a quarter of
 * that of the range; and products at the corners, rounded downward, by less than 2^-25 of the
 * largest value times the largest weight. */
static double divided_rounding(const double values[3], double x, double y)
{
    const divided_planes of = divided_of(values);
    const double weight = plane_at(of.weights, x, y);
    const double planes_cost =
        plane_rounding(of.products) + fabs(attribute_at(values, x, y)) * plane_rounding(of.weights);
    const double products_cost = ldexp(largest(values) * largest(of.weights), -25);
    return (planes_cost + products_cost) / weight + ldexp(range(values), -26);
}

/* How much a constant weight may change light by, of fxl_corner_planes_linear. */
static double affine_error(const double lights[3], const double weights[3])
{
    const double least = fmin(weights[0], fmin(weights[1], weights[2]));
    const double most = fmax(weights[0], fmax(weights[1], weights[2]));
    const double range =
        fmax(lights[0], fmax(lights[1], lights[2])) - fmin(lights[0], fmin(lights[1], lights[2]));
    return range * (most - least) / (4 * least);
}

typedef struct {
    uint32_t checked, refused, thin, bent, balanced, far_apart;
} word_counts;

/* The words of a face whose depths differ by less than `spread`, in light that is nearly the same
 * everywhere or in any. */
static void check_words(double spread, bool is_even, word_counts *counts)
{
    fxl_gradients gradients;
    fxl_depth_plane plane;
    double values[3], lights[3], x, y;
    int32_t light[3];
    make_corners(spread);
    if (unit_random() % 4 == 0) {
        make_thin(ldexp(1, -unit_between(4, 10)));
    }
    if (!fxl_corner_planes_begin(&corners, &view.lens, true, &planes)) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        light[k] = is_even ? 65536 + k : unit_between(32768, 31 << 16);
        lights[k] = light[k];
        values[k] = view.lens.near_z * 1073741824.0 / (double)corners.depths[k];
    }
    int o = 1000, last = 0; /* octaves of the corners */
    for (int k = 0; k < 3; k++) {
        const int octave = -1 - ilogb(values[k]);
        o = octave < o ? octave : o;
        last = octave > last ? octave : last;
    }
    const fxl_depth_scale scale = fxl_depth_scale_of(&view.lens);
    if (!fxl_corner_planes_linear(&planes, light, &gradients, &plane)) {
        counts->refused++;
        counts->far_apart += last > o + 1;
        return;
    }
    TEST_ASSERT_TRUE(o >= 0 && last < scale.octaves && last <= o + 1);
    TEST_ASSERT_EQUAL(last == o ? FXL_DEPTH_IS_LINEAR : FXL_DEPTH_IS_BENT + o, plane.one);
    TEST_ASSERT_TRUE(fxl_depth_is_in_words(&plane));
    TEST_ASSERT_EQUAL(last == o ? 0 : (uint32_t)(code_of(ldexp(1, -o - 1), o, scale) * 65536),
                      fxl_depth_border(scale, &plane));
    TEST_ASSERT_TRUE(fxl_weight_is_constant(&gradients));
    choose_place(&x, &y);
    const double code = code_of(plane_at(values, x, y), o, scale) * 65536;
    TEST_ASSERT_NEAR(code, word_at(&plane.gradient, x, y, code),
                     ldexp(depth_rounding(values), o + 1 + scale.mantissa + 16) + 2048);
    const fxl_light_plane words = fxl_light_plane_of(&gradients);
    TEST_ASSERT_EQUAL((uint32_t)gradients.attributes[0].at, words.at);
    const double level = plane_at(lights, x, y) * 256, error = affine_error(lights, values);
    const double found = word_at(&gradients.attributes[0], x, y, level);
    const double cut = plane_rounding(lights) * 256 + 2048;
    TEST_ASSERT_TRUE(error < FXL_WORDS_ERROR_LIGHT * 1.001);
    if (error < FXL_AFFINE_ERROR_LIGHT * 0.999) {
        TEST_ASSERT_NEAR(level, found, cut);
    }
    /* From an eighth of a level on the mean of the error is taken off. */
    const double most =
        error < FXL_AFFINE_ERROR_LIGHT * 1.001 ? FXL_AFFINE_ERROR_LIGHT : error * 3 / 4;
    TEST_ASSERT_NEAR(attribute_at(lights, x, y) * 256, found, most * 256 + cut);
    counts->balanced += error > FXL_AFFINE_ERROR_LIGHT * 1.001;
    counts->checked++;
    counts->thin += planes.may_be_steep;
    counts->bent += last != o;
}

/* SPEC 9.1.1 */
void test_words_are_codes_and_light(void)
{
    word_counts counts = {0, 0, 0, 0, 0, 0};
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            check_words(unit_random() % 2 ? 0.5 : 1.0 / 64, false, &counts);
        }
    }
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 400), counts.checked);
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 1000), counts.refused);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.bent);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.thin);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.balanced);
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
    fxl_corner_planes_find(&planes, given, count, is_affine, &found);
    TEST_ASSERT_EQUAL(count, found.count);
    check_bounds(&found.weight);
    choose_place(&x, &y);
    const bool is_constant = fxl_weight_is_constant(&found);
    counts->constant += is_constant;
    for (uint32_t i = 0; i < count; i++) {
        const bool is_light = first + (int)i == 2;
        const double weight = at(&found.weight, x, y), unit = ldexp(1, found.shifts[i]);
        const double value = at(&found.attributes[i], x, y) / weight * unit;
        const double exact = is_affine ? plane_at(values[i], x, y) : attribute_at(values[i], x, y);
        double bound = is_constant ? plane_rounding(values[i]) + PART_OF_UNIT * unit / weight
                                   : divided_rounding(values[i], x, y) +
                                         PART_OF_UNIT * (unit + fabs(exact)) / weight;
        if (is_constant && !is_affine) {
            bound += is_light ? FXL_AFFINE_ERROR_LIGHT : FXL_AFFINE_ERROR_TEXEL;
        }
        check_bounds(&found.attributes[i]);
        TEST_ASSERT_NEAR(exact, value, bound);
        counts->worst = fmax(counts->worst, fabs(exact - value) / bound);
    }
}

/* SPEC 9.1.1, accuracy 5.1.1 */
void test_attributes_are_those_of_the_corners(void)
{
    uint32_t checked = 0;
    attribute_counts divided = {0, 0}, affine = {0, 0};
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            make_corners(unit_random() % 2 ? 0.5 : 1.0 / 1024);
            if (i % 2 == 0) {
                make_thin(1.0 / 16);
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
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 200), checked);
    TEST_ASSERT_GREATER_THAN(checked / 8, divided.constant);
    TEST_ASSERT_LESS_THAN(2 * checked, divided.constant);
    TEST_ASSERT_EQUAL(checked, affine.constant);
    TEST_ASSERT_TRUE(affine.worst > WORST_SHARE);
}

/* Rows of the box, and 16 columns about it: where the weights suffice, an attribute on the line
 * between both ends of a segment is within a third of its unit of the divided one. */
/* SPEC 9.1.1 */
void test_segments_are_within_a_third_where_the_least_weight_suffices(void)
{
    uint32_t wide = 0, narrow = 0, refused = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        int32_t given[2][3];
        fxl_gradients found;
        make_corners(0.5);
        if (!begins()) {
            continue;
        }
        const int bits = unit_between(13, 24);
        for (int k = 0; k < 6; k++) {
            given[k / 3][k % 3] = unit_between(-(1 << bits), 1 << bits);
        }
        fxl_corner_planes_find(&planes, given, 2, false, &found);
        if (fxl_weight_is_constant(&found)) {
            continue;
        }
        double x, y;
        choose_point(&x, &y);
        const int columns = unit_random() % 2 ? 16 : 4;
        const double least = found.weight_min[columns == 16 ? 0 : 1];
        const double first = floor(x / 65536 / columns) * columns * 65536;
        const double ends[2] = {at(&found.weight, first, y),
                                at(&found.weight, first + columns * 65536.0, y)};
        if (ends[0] < least || ends[1] < least) {
            refused++;
            continue;
        }
        wide += columns == 16;
        narrow += columns == 4;
        for (int k = 0; k < 2; k++) {
            const fxl_gradient *u = &found.attributes[k];
            const double unit = ldexp(1, found.shifts[k]);
            const double u0 = at(u, first, y) / ends[0] * unit;
            const double u1 = at(u, first + columns * 65536.0, y) / ends[1] * unit;
            TEST_ASSERT_TRUE(fabs(u1 - u0) <= 536870912.0);
            for (int step = 0; step <= columns; step++) {
                const double exact = at(u, first + step * 65536.0, y) /
                                     at(&found.weight, first + step * 65536.0, y) * unit;
                TEST_ASSERT_NEAR(exact, u0 + (u1 - u0) * step / columns, 21846);
            }
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 1000, wide);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 500, narrow);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 500, refused);
}

/* A face that has words; then its like that has none: with more corners, in a lens of one octave,
 * nearer than any near plane. */
void test_what_has_no_words(void)
{
    const int32_t light[3] = {Q16(8), Q16(8), Q16(8)};
    fxl_gradients gradients;
    fxl_depth_plane plane;
    bool is_found = false;
    for (int i = 0; i < 10000 && !is_found; i++) {
        make_corners(1.0 / 1024);
        is_found = fxl_find_smooth_planes(&corners, &view.lens, light, &gradients, &plane);
    }
    TEST_ASSERT_TRUE(is_found);
    corners.is_triangle = false;
    TEST_ASSERT_FALSE(fxl_find_smooth_planes(&corners, &view.lens, light, &gradients, &plane));
    corners.is_triangle = true;
    fxl_lens lens = view.lens;
    lens.near_z = Q16(10);
    lens.far_z = Q16(15);
    TEST_ASSERT_FALSE(fxl_find_smooth_planes(&corners, &lens, light, &gradients, &plane));
    corners.depths[0] = corners.depths[1] = corners.depths[2] = UINT32_MAX;
    TEST_ASSERT_FALSE(fxl_find_smooth_planes(&corners, &view.lens, light, &gradients, &plane));
}

/* Near at any depth, so that an octave ends at any, and far away, so that codes have few bits. */
/* SPEC 9.1.1 */
void test_words_of_other_lenses(void)
{
    word_counts counts = {0, 0, 0, 0, 0, 0};
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            view.lens.near_z = unit_between(4096, 8191);
            view.lens.far_z = i % 2 ? FXL_FAR_MAX : Q16(1000);
            check_words(i % 4 ? 0.5 : 2.8, i % 4 == 0, &counts);
        }
    }
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 400), counts.checked);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.bent);
    TEST_ASSERT_GREATER_THAN(SEEDS * (UNIT_REPEAT / 4000), counts.far_apart);
}
