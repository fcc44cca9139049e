/* SPDX-License-Identifier: MIT */
/* The kernel of pixels that are each divided: against the exact coordinates in double, and the
 * segments that it takes. */
#include <math.h>
#include <string.h>

#include "paint/paint_divided.h"
#include "paint/segments.h"
#include "paint/texel_place.h"
#include "unity.h"

enum {
    COLUMNS = 128,
    TEXELS = 65536,
    UNTOUCHED = 255
};

static uint8_t texels[TEXELS], row_pixels[COLUMNS], part[COLUMNS];
static fxl_gradients gradients;
static fxl_paint paint;
static fxl_paint_row row;
static fxl_divided_face face;
static uint32_t state;

void setUp(void)
{
    state = 2463534242u;
    memset(&gradients, 0, sizeof gradients);
    memset(&paint, 0, sizeof paint);
    memset(&row, 0, sizeof row);
    gradients.count = 2;
    paint.gradients = &gradients;
    paint.level.texels = texels;
    paint.division = FXL_DIVIDE_1;
    paint.opacity = 16;
}

void tearDown(void)
{
}

static uint32_t any(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static void choose_size(uint32_t log_width, uint32_t log_height)
{
    paint.level.log_width = (uint8_t)log_width;
    paint.level.columns_less_1 = (1u << log_width) - 1u;
    paint.level.rows_less_1 = (1u << log_height) - 1u;
}

/* A gradient from one value to another over the columns; the row's value is the first. */
static void choose_gradient(fxl_gradient *gradient, int64_t *at, double from, double to)
{
    *at = (int64_t)ldexp(from, 32);
    gradient->along = (int64_t)(ldexp(to - from, 32) / COLUMNS);
}

static double exact(const fxl_gradient *gradient, int64_t at, int column)
{
    return ldexp((double)(at + gradient->along * column), -32);
}

/* An attribute at a column, in texels. */
static double coordinate(uint32_t i, int column)
{
    return ldexp(exact(&gradients.attributes[i], row.attributes[i], column) /
                     exact(&gradients.weight, row.weight, column),
                 gradients.shifts[i] - 16);
}

/* A face with weights of so many bits at most, and coordinates within so many texels. */
static void choose_face(int bits, int range)
{
    const double first = ldexp(0.4 + (any() & 1023u) / 1023.0 * 0.6, bits);
    const double ends[2] = {first, first * (0.5 + (any() & 1023u) / 1023.0 * 0.5)};
    choose_gradient(&gradients.weight, &row.weight, ends[0], ends[1]);
    for (uint32_t i = 0; i < 2; i++) {
        const double from = (int)(any() % (2u * (uint32_t)range)) - range + (any() & 255u) / 256.0;
        const double to = (int)(any() % (2u * (uint32_t)range)) - range;
        gradients.shifts[i] = 20;
        choose_gradient(&gradients.attributes[i], &row.attributes[i], from * ends[0] / 16,
                        to * ends[1] / 16);
    }
}

static int32_t paint_row(uint8_t *pixels, int32_t x0, int32_t x1)
{
    memset(pixels, UNTOUCHED, COLUMNS);
    row.pixels = pixels;
    TEST_ASSERT_TRUE(fxl_divided_find(&paint, &face));
    return fxl_paint_divided(&face, &row, x0, x1);
}

/* How far a coordinate is outside of texel n of 2^log, which repeats; below 0: it is inside. */
static double distance(double at, uint32_t n, uint32_t log)
{
    const double size = ldexp(1, (int)log), from_middle = at - n - 0.5;
    return fabs(from_middle - size * floor(from_middle / size + 0.5)) - 0.5;
}

/* The texels' columns are their bytes, or their rows. */
static void check_coordinate(uint32_t i, uint32_t log_width, uint32_t log_height)
{
    for (uint32_t n = 0; n < 1u << (log_width + log_height); n++) {
        texels[n] = (uint8_t)(i == 0 ? n & ((1u << log_width) - 1u) : n >> log_width);
    }
    TEST_ASSERT_EQUAL(COLUMNS, paint_row(row_pixels, 0, COLUMNS));
    for (int x = 0; x < COLUMNS; x++) {
        const double at = coordinate(i, x);
        const double bound = ldexp(fabs(at), -25) + ldexp(1, i == 0           ? -16
                                                              : log_width == 8 ? -13
                                                                               : -9 - (int)log_width);
        TEST_ASSERT_TRUE(distance(at, row_pixels[x], i == 0 ? log_width : log_height) <= bound);
    }
}

void test_texels_are_those_of_the_exact_coordinates(void)
{
    for (uint32_t log_width = FXL_DIVIDED_LOG_MIN; log_width <= 8; log_width++) {
        for (uint32_t n = 0; n < 200; n++) {
            const uint32_t log_height = any() % 9u;
            choose_size(log_width, log_height);
            choose_face(6 + (int)(any() % 24u), 40);
            check_coordinate(0, log_width, log_height);
            check_coordinate(1, log_width, log_height);
        }
    }
}

/* The pixels of a kind of texels, where `plain` has those of the same texels of 8 bits. */
static void check_kind(const uint8_t *plain, const uint8_t *colours)
{
    TEST_ASSERT_EQUAL(COLUMNS, paint_row(row_pixels, 3, COLUMNS));
    for (int32_t x = 0; x < COLUMNS; x++) {
        const bool is_drawn = x >= 3 && (paint.level.flags == 0 || plain[x] != paint.level.key) &&
                              !fxl_is_stippled_away(paint.opacity, x, row.y);
        TEST_ASSERT_EQUAL(!is_drawn         ? UNTOUCHED
                          : colours != NULL ? colours[plain[x]]
                                            : plain[x],
                          row_pixels[x]);
    }
}

void test_other_kinds_of_texels_are_at_the_places_of_plain_ones(void)
{
    static uint8_t packed[TEXELS / 2], colours[16];
    uint8_t plain[COLUMNS];
    for (uint32_t n = 0; n < TEXELS; n++) {
        texels[n] = (uint8_t)(any() % 16u);
        packed[n / 2] = (uint8_t)(packed[n / 2] >> 4 | texels[n] << 4);
    }
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 500; n++) {
        choose_size(4 + n % 4, any() % 9u);
        choose_face(29, 40);
        row.y = (int32_t)(n % 7);
        TEST_ASSERT_EQUAL(COLUMNS, paint_row(plain, 0, COLUMNS));
        paint.level.flags = FXL_TEXTURE_KEYED;
        paint.level.key = (uint8_t)(any() % 16u);
        check_kind(plain, NULL);
        paint.level.flags = 0;
        paint.opacity = (uint8_t)(1u + n % 15u);
        check_kind(plain, NULL);
        paint.opacity = 16;
        paint.level.texels = packed;
        paint.level.colours = colours;
        check_kind(plain, colours);
        paint.level.texels = texels;
        paint.level.colours = NULL;
    }
}

/* How far a coordinate that is held within 2^log texels is outside of texel n; below 0: it is
 * inside. */
static double held_distance(double at, uint32_t n, uint32_t log)
{
    const double last = ldexp(1, (int)log) - 0.5;
    return fabs((at < 0.5 ? 0.5 : at > last ? last : at) - n - 0.5) - 0.5;
}

void test_clamped_texels_are_held_within_the_texture(void)
{
    uint32_t beyond = 0;
    for (uint32_t n = 0; n < 1000; n++) {
        const uint32_t logs[2] = {FXL_DIVIDED_LOG_MIN + any() % 5u, any() % 9u};
        choose_size(logs[0], logs[1]);
        choose_face(27, 40);
        paint.level.flags = FXL_TEXTURE_CLAMP;
        for (uint32_t i = 0; i < 2; i++) {
            for (uint32_t at = 0; at < 1u << (logs[0] + logs[1]); at++) {
                texels[at] = (uint8_t)(i == 0 ? at & ((1u << logs[0]) - 1u) : at >> logs[0]);
            }
            const int32_t end = paint_row(row_pixels, 0, COLUMNS);
            for (int x = 0; x < end; x++) {
                const double at = coordinate(i, x);
                TEST_ASSERT_TRUE(held_distance(at, row_pixels[x], logs[i]) <=
                                 ldexp(fabs(at), -25) + ldexp(1, (int)logs[i] - 20));
                beyond += at < 0 || at > ldexp(1, (int)logs[i]);
            }
        }
    }
    TEST_ASSERT_TRUE(beyond > 10000);
}

void test_a_part_of_a_row_is_as_in_the_row(void)
{
    for (uint32_t n = 0; n < TEXELS; n++) {
        texels[n] = (uint8_t)(any() % 255u);
    }
    for (uint32_t n = 0; n < 2000; n++) {
        choose_size(6, 6);
        choose_face(29, 60);
        TEST_ASSERT_EQUAL(COLUMNS, paint_row(row_pixels, 0, COLUMNS));
        const int32_t x0 = (int32_t)(any() % COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(any() % (uint32_t)(COLUMNS - x0));
        TEST_ASSERT_EQUAL(x1, paint_row(part, x0, x1));
        for (int32_t x = 0; x < COLUMNS; x++) {
            TEST_ASSERT_EQUAL(x < x0 || x >= x1 ? UNTOUCHED : row_pixels[x], part[x]);
        }
    }
}

void test_a_segment_ends_what_is_painted_where_its_weights_are_far_apart(void)
{
    choose_size(6, 6);
    choose_face(29, 40);
    /* From 2^29 in column 0 to 2^29 / 128 in column 127: the segment from 112 on has a ratio of 16.
     */
    choose_gradient(&gradients.weight, &row.weight, ldexp(1, 29), 0);
    gradients.attributes[0].along = gradients.attributes[1].along = 0;
    row.attributes[0] = row.attributes[1] = 0;
    TEST_ASSERT_EQUAL(96, paint_row(row_pixels, 5, COLUMNS));
    TEST_ASSERT_EQUAL(UNTOUCHED, row_pixels[96]);
    TEST_ASSERT_EQUAL(120, paint_row(row_pixels, 120, COLUMNS));
}

void test_a_weight_of_0_and_large_coordinates_are_not_painted(void)
{
    choose_size(6, 6);
    choose_face(29, 40);
    row.weight = gradients.weight.along = 0;
    TEST_ASSERT_EQUAL(0, paint_row(row_pixels, 0, COLUMNS));
    row.weight = (int64_t)1 << 40;
    row.attributes[0] = (int64_t)1 << 61;
    TEST_ASSERT_EQUAL(0, paint_row(row_pixels, 0, COLUMNS));
}

void test_other_faces_are_not_for_it(void)
{
    choose_size(6, 6);
    TEST_ASSERT_TRUE(fxl_divided_find(&paint, &face));
    choose_size(3, 6);
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
    choose_size(6, 6);
    paint.division = FXL_DIVIDE_16;
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
    paint.division = FXL_DIVIDE_1;
    paint.opacity = 15;
    TEST_ASSERT_TRUE(fxl_divided_find(&paint, &face));
    paint.level.flags = FXL_TEXTURE_KEYED;
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
    paint.opacity = 16;
    TEST_ASSERT_TRUE(fxl_divided_find(&paint, &face));
    paint.has_beams = true;
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
    paint.has_beams = false;
    paint.level.flags = FXL_TEXTURE_KEYED | FXL_TEXTURE_CLAMP;
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
    paint.level.flags = 0;
    paint.ramp = texels;
    TEST_ASSERT_FALSE(fxl_divided_find(&paint, &face));
}

/* Coordinates so small that their upper words are 0, or that no bit of them is left: the first texel. The kernel, and
 * each pixel alone. */
void test_coordinates_without_upper_bits(void)
{
    for (uint32_t n = 0; n < TEXELS; n++) {
        texels[n] = (uint8_t)(n % 200u);
    }
    choose_size(5, 5);
    for (int shift = -60; shift <= 40; shift += 20) {
        choose_face(30, 40);
        for (uint32_t i = 0; i < 2; i++) {
            gradients.shifts[i] = (int8_t)shift;
            gradients.attributes[i].along = shift < 20 ? gradients.attributes[i].along : 0;
            row.attributes[i] = shift < 20 ? (int64_t)1 << 40 : 77;
        }
        if (shift < 20) { /* above 0 */
            gradients.attributes[0].along = gradients.attributes[1].along = 1 << 20;
        }
        TEST_ASSERT_EQUAL(COLUMNS, paint_row(row_pixels, 0, COLUMNS));
        TEST_ASSERT_EACH_EQUAL_UINT8(texels[0], row_pixels, COLUMNS);
        memset(part, UNTOUCHED, sizeof part);
        row.pixels = part;
        paint.is_replaced = true; /* not for the kernel */
        fxl_paint_pixels(&paint, &row, 0, COLUMNS);
        paint.is_replaced = false;
        TEST_ASSERT_EQUAL_MEMORY(row_pixels, part, COLUMNS);
    }
}
