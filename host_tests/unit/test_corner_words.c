/* SPDX-License-Identifier: MIT */
/* The depth and the light of small triangles in words, against planes in double. */
#include "corner_unit.h"
#include "paint/light_row.h"
#include "paint/smooth_outline.h"

void setUp(void)
{
    corner_begin();
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
    corner_make(spread);
    if (unit_random() % 4 == 0) {
        corner_make_thin(ldexp(1, -unit_between(4, 10)));
    }
    if (!fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens, FXL_WORDS_SIDE_MAX, &triangle.planes)) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        light[k] = is_even ? 65536 + k : unit_between(32768, 31 << 16);
        lights[k] = light[k];
        values[k] = triangle.view.lens.near_z * 1073741824.0 / (double)triangle.corners.depths[k];
    }
    int o = 1000, last = 0; /* octaves of the corners */
    for (int k = 0; k < 3; k++) {
        const int octave = -1 - ilogb(values[k]);
        o = octave < o ? octave : o;
        last = octave > last ? octave : last;
    }
    const fxl_depth_scale scale = fxl_depth_scale_of(&triangle.view.lens);
    if (!fxl_corner_planes_linear(&triangle.planes, light, &gradients, &plane)) {
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
    corner_choose_place(&x, &y);
    const double code = code_of(corner_plane_at(values, x, y), o, scale) * 65536;
    TEST_ASSERT_NEAR(code, word_at(&plane.gradient, x, y, code),
                     ldexp(corner_depth_rounding(values), o + 1 + scale.mantissa + 16) + 2048);
    const fxl_light_plane words = fxl_light_plane_of(&gradients);
    TEST_ASSERT_EQUAL((uint32_t)gradients.attributes[0].at, words.at);
    const double level = corner_plane_at(lights, x, y) * 256, error = affine_error(lights, values);
    const double found = word_at(&gradients.attributes[0], x, y, level);
    const double cut = corner_plane_rounding(lights) * 256 + 2048;
    TEST_ASSERT_TRUE(error < FXL_WORDS_ERROR_LIGHT * 1.001);
    if (error < FXL_AFFINE_ERROR_LIGHT * 0.999) {
        TEST_ASSERT_NEAR(level, found, cut);
    }
    /* From an eighth of a level on the mean of the error is taken off. */
    const double most =
        error < FXL_AFFINE_ERROR_LIGHT * 1.001 ? FXL_AFFINE_ERROR_LIGHT : error * 3 / 4;
    TEST_ASSERT_NEAR(corner_attribute_at(lights, x, y) * 256, found, most * 256 + cut);
    counts->balanced += error > FXL_AFFINE_ERROR_LIGHT * 1.001;
    counts->checked++;
    counts->thin += triangle.planes.may_be_steep;
    counts->bent += last != o;
}

/* SPEC 9.1.1s-t, accuracy 5.1.1k, 5.1.1n */
void test_words_are_codes_and_light(void)
{
    word_counts counts = {0, 0, 0, 0, 0, 0};
    for (uint32_t seed = 1; seed <= CORNER_SEEDS; seed++) {
        corner_begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            check_words(unit_random() % 2 ? 0.5 : 1.0 / 64, false, &counts);
        }
    }
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 400), counts.checked);
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 1000), counts.refused);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.bent);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.thin);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.balanced);
}

typedef struct {
    uint32_t checked, bent, far_apart, steep, thin, unlit;
} texel_counts;

/* Of v: a texture of 32 columns. */
#define V_DROP 3u

/* fxl_find_texel_planes of corners with such values, and light or none. */
static int32_t planes_of(int32_t (*values)[3], const int32_t *light, fxl_texel_planes *planes,
                         bool is_affine)
{
    const fxl_words_lens lens = fxl_words_lens_of(&triangle.view.lens);
    fxl_corner corners[3];
    for (uint32_t i = 0; i < 3; i++) {
        corners[i].texel.u = values[FXL_ATTRIBUTE_U][i];
        corners[i].texel.v = values[FXL_ATTRIBUTE_V][i];
    }
    const fxl_corner *const of[3] = {&corners[0], &corners[1], &corners[2]};
    return fxl_find_texel_planes(&triangle.corners, &lens, of, planes, light, is_affine, V_DROP);
}

/* The same planes from the corners, in one call. */
static void expect_planes(int32_t (*values)[3], const int32_t *light, bool is_found,
                          const fxl_gradients *gradients, const fxl_depth_plane *plane)
{
    fxl_texel_planes expected, found;
    const int32_t one = planes_of(values, light, &found, false);
    TEST_ASSERT_EQUAL_INT32(is_found ? plane->one : 0, one);
    if (is_found) {
        fxl_texel_words_of(gradients, plane, &expected);
        fxl_texel_planes_scale(&expected, 0, V_DROP);
        if (light == NULL) { /* undefined */
            found.at.light = found.down.light = found.along.light = 0;
        }
        TEST_ASSERT_EQUAL_MEMORY(&expected, &found, sizeof expected);
    }
}

/* u and v without light are what they are with it. Returns whether they are words only so: light may
 * differ too much. */
static bool is_found_unlit(int32_t (*values)[3], bool is_found, const fxl_gradients *lit)
{
    fxl_gradients unlit;
    fxl_depth_plane plane;
    const bool is_unlit =
        fxl_find_texels(&triangle.planes, values, FXL_SEGMENT_LIGHT, false, &unlit, &plane);
    TEST_ASSERT_TRUE(is_unlit || !is_found);
    expect_planes(values, NULL, is_unlit, &unlit, &plane);
    if (is_found) {
        TEST_ASSERT_EQUAL(FXL_SEGMENT_LIGHT, unlit.count);
        TEST_ASSERT_EQUAL_MEMORY(lit->attributes, unlit.attributes,
                                 FXL_SEGMENT_LIGHT * sizeof *lit->attributes);
    }
    return is_unlit && !is_found;
}

static void check_texel_planes(int32_t (*values)[3], bool is_found, const fxl_gradients *gradients,
                               const fxl_depth_plane *plane)
{
    const int32_t *light = values[FXL_SEGMENT_LIGHT];
    fxl_texel_planes found;
    expect_planes(values, light, is_found, gradients, plane);
    if (is_found) {
        values[FXL_ATTRIBUTE_V][2] += 192 << 16;
        TEST_ASSERT_EQUAL_INT32(0, planes_of(values, light, &found, true));
        values[FXL_ATTRIBUTE_V][2] -= 192 << 16;
        triangle.corners.width += FXL_SMALL_SIDE_MAX;
        TEST_ASSERT_EQUAL_INT32(0, planes_of(values, light, &found, false));
        triangle.corners.width -= FXL_SMALL_SIDE_MAX;
    }
}

/* u, v and light of a triangle that may have words, at a place in it. Returns whether they are words. */
static bool check_texels(texel_counts *counts)
{
    const int32_t most[3] = {1 << unit_between(16, 22), 1 << unit_between(16, 22), 31 << 16};
    fxl_gradients gradients;
    fxl_depth_plane plane;
    int32_t values[3][3];
    double exact[3][3], weights[3], x, y;
    bool is_far = false;
    corner_make(unit_random() % 2 ? 0.5 : 1.0 / 64);
    if (!fxl_corner_planes_begin(&triangle.corners, &triangle.view.lens, FXL_TEXELS_SIDE_MAX,
                                 &triangle.planes)) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        weights[k] = triangle.view.lens.near_z * 1073741824.0 / (double)triangle.corners.depths[k];
        for (int i = 0; i < 3; i++) {
            exact[i][k] = values[i][k] = (i == 2 ? 32768 : 0) + unit_between(0, most[i]);
        }
    }
    for (int i = 0; i < 3; i++) {
        const double error = affine_error(exact[i], weights);
        is_far |= error > (i == 2 ? FXL_WORDS_ERROR_LIGHT : FXL_WORDS_ERROR_TEXEL) * 1.001;
    }
    const bool is_found =
        fxl_find_texels(&triangle.planes, values, 3, false, &gradients, &plane);
    TEST_ASSERT_FALSE(is_far && is_found);
    check_texel_planes(values, is_found, &gradients, &plane);
    counts->unlit += is_found_unlit(values, is_found, &gradients);
    counts->far_apart += is_far;
    counts->steep += !is_far && !is_found;
    if (!is_found) {
        return false;
    }
    TEST_ASSERT_TRUE(fxl_has_texel_words(&gradients) && fxl_depth_is_in_words(&plane));
    TEST_ASSERT_TRUE(fxl_weight_is_constant(&gradients));
    corner_choose_place(&x, &y);
    for (int i = 0; i < 3; i++) {
        const double linear = corner_plane_at(exact[i], x, y) * 256;
        const double found = word_at(&gradients.attributes[i], x, y, linear);
        const double cut = corner_plane_rounding(exact[i]) * 256 + 2048;
        const double error = i == 2 ? FXL_WORDS_ERROR_LIGHT : FXL_WORDS_ERROR_TEXEL;
        TEST_ASSERT_NEAR(linear, found, cut);
        TEST_ASSERT_NEAR(corner_attribute_at(exact[i], x, y) * 256, found,
                         error * 1.001 * 256 + cut);
    }
    counts->bent += plane.one != FXL_DEPTH_IS_LINEAR;
    counts->thin += triangle.planes.is_for_words;
    return true;
}

/* SPEC 9.1.1u, accuracy 5.1.1k */
void test_words_are_texels(void)
{
    texel_counts counts = {0, 0, 0, 0, 0, 0};
    for (uint32_t seed = 1; seed <= CORNER_SEEDS; seed++) {
        corner_begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            counts.checked += check_texels(&counts);
        }
    }
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 400), counts.checked);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.bent);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.far_apart);
    TEST_ASSERT_GREATER_THAN(0, counts.steep);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.thin);
    TEST_ASSERT_GREATER_THAN(0, counts.unlit);
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
        corner_make(1.0 / 1024);
        is_found = fxl_find_smooth_planes(&triangle.corners, &triangle.view.lens, light, &gradients,
                                          &plane);
    }
    TEST_ASSERT_TRUE(is_found);
    triangle.corners.is_triangle = false;
    TEST_ASSERT_FALSE(
        fxl_find_smooth_planes(&triangle.corners, &triangle.view.lens, light, &gradients, &plane));
    triangle.corners.is_triangle = true;
    fxl_lens lens = triangle.view.lens;
    lens.near_z = Q16(10);
    lens.far_z = Q16(15);
    TEST_ASSERT_FALSE(fxl_find_smooth_planes(&triangle.corners, &lens, light, &gradients, &plane));
    triangle.corners.depths[0] = triangle.corners.depths[1] = triangle.corners.depths[2] =
        UINT32_MAX;
    TEST_ASSERT_FALSE(
        fxl_find_smooth_planes(&triangle.corners, &triangle.view.lens, light, &gradients, &plane));
}

/* Near at any depth, so that an octave ends at any, and far away, so that codes have few bits. */
/* SPEC 9.1.1s */
void test_words_of_other_lenses(void)
{
    word_counts counts = {0, 0, 0, 0, 0, 0};
    for (uint32_t seed = 1; seed <= CORNER_SEEDS; seed++) {
        corner_begin_seed(seed);
        for (int i = 0; i < UNIT_REPEAT / 20; i++) {
            triangle.view.lens.near_z = unit_between(4096, 8191);
            triangle.view.lens.far_z = i % 2 ? FXL_FAR_MAX : Q16(1000);
            check_words(i % 4 ? 0.5 : 2.8, i % 4 == 0, &counts);
        }
    }
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 400), counts.checked);
    TEST_ASSERT_GREATER_THAN(counts.checked / 100, counts.bent);
    TEST_ASSERT_GREATER_THAN(CORNER_SEEDS * (UNIT_REPEAT / 4000), counts.far_apart);
}
