/* SPDX-License-Identifier: MIT */
/* The kernel of pixels that are each divided: against the exact coordinates in double, and the
 * segments that it takes. */
#include "paint/paint_divided.h"
/* place sampling: definition: texels of lit surfaces, segments, divided pixels, RGB565 */
#include "paint/texel_place.h"
#include "segment_unit.h"

enum {
    TEXELS = 65536
};

static uint8_t texels[TEXELS];
static fxl_divided_face face;

void setUp(void)
{
    segment_begin();
    segment.paint.level.texels = texels;
    segment.paint.division = FXL_DIVIDE_1;
}

static double exact(const fxl_gradient *gradient, int64_t at, int column)
{
    return ldexp((double)(at + gradient->along * column), -32);
}

/* An attribute at a column, in texels. */
static double coordinate(uint32_t i, int column)
{
    return ldexp(exact(&segment.gradients.attributes[i], segment.row.attributes[i], column) /
                     exact(&segment.gradients.weight, segment.row.weight, column),
                 segment.gradients.shifts[i] - 16);
}

/* A face with weights of so many bits at most, and coordinates within so many texels. */
static void choose_face(int bits, int range)
{
    const double first = ldexp(0.4 + (segment_any() & 1023u) / 1023.0 * 0.6, bits);
    const double ends[2] = {first, first * (0.5 + (segment_any() & 1023u) / 1023.0 * 0.5)};
    segment_choose_gradient(&segment.gradients.weight, &segment.row.weight, ends[0], ends[1]);
    for (uint32_t i = 0; i < 2; i++) {
        const double from =
            (int)(segment_any() % (2u * (uint32_t)range)) - range + (segment_any() & 255u) / 256.0;
        const double to = (int)(segment_any() % (2u * (uint32_t)range)) - range;
        segment.gradients.shifts[i] = 20;
        segment_choose_gradient(&segment.gradients.attributes[i], &segment.row.attributes[i],
                                from * ends[0] / 16, to * ends[1] / 16);
    }
}

static int32_t paint_row(uint8_t *pixels, int32_t x0, int32_t x1)
{
    memset(pixels, SEGMENT_UNTOUCHED, SEGMENT_COLUMNS);
    segment.row.pixels = pixels;
    TEST_ASSERT_TRUE(fxl_divided_find(&segment.paint, &face));
    return fxl_paint_divided(&face, &segment.row, x0, x1);
}

/* The texels' columns are their bytes, or their rows. */
static void check_coordinate(uint32_t i, uint32_t log_width, uint32_t log_height)
{
    for (uint32_t n = 0; n < 1u << (log_width + log_height); n++) {
        texels[n] = (uint8_t)(i == 0 ? n & ((1u << log_width) - 1u) : n >> log_width);
    }
    TEST_ASSERT_EQUAL(SEGMENT_COLUMNS, paint_row(segment.pixels, 0, SEGMENT_COLUMNS));
    for (int x = 0; x < SEGMENT_COLUMNS; x++) {
        const double at = coordinate(i, x);
        const double bound =
            ldexp(fabs(at), -25) + ldexp(1, i == 0           ? -16
                                            : log_width == 8 ? -13
                                                             : -9 - (int)log_width);
        TEST_ASSERT_TRUE(segment_distance(at, segment.pixels[x], i == 0 ? log_width : log_height) <=
                         bound);
    }
}

void test_texels_are_those_of_the_exact_coordinates(void)
{
    for (uint32_t log_width = FXL_DIVIDED_LOG_MIN; log_width <= 8; log_width++) {
        for (uint32_t n = 0; n < 200; n++) {
            const uint32_t log_height = segment_any() % 9u;
            segment_choose_size(log_width, log_height);
            choose_face(6 + (int)(segment_any() % 24u), 40);
            check_coordinate(0, log_width, log_height);
            check_coordinate(1, log_width, log_height);
        }
    }
}

/* The pixels of a kind of texels, where `plain` has those of the same texels of 8 bits. */
static void check_kind(const uint8_t *plain, const uint8_t *colours)
{
    TEST_ASSERT_EQUAL(SEGMENT_COLUMNS, paint_row(segment.pixels, 3, SEGMENT_COLUMNS));
    for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
        const bool is_drawn =
            x >= 3 && (segment.paint.level.flags == 0 || plain[x] != segment.paint.level.key) &&
            !fxl_is_stippled_away(segment.paint.opacity, x, segment.row.y);
        TEST_ASSERT_EQUAL(!is_drawn         ? SEGMENT_UNTOUCHED
                          : colours != NULL ? colours[plain[x]]
                                            : plain[x],
                          segment.pixels[x]);
    }
}

void test_other_kinds_of_texels_are_at_the_places_of_plain_ones(void)
{
    static uint8_t packed[TEXELS / 2], colours[16];
    uint8_t plain[SEGMENT_COLUMNS];
    for (uint32_t n = 0; n < TEXELS; n++) {
        texels[n] = (uint8_t)(segment_any() % 16u);
        packed[n / 2] = (uint8_t)(packed[n / 2] >> 4 | texels[n] << 4);
    }
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 500; n++) {
        segment_choose_size(4 + n % 4, segment_any() % 9u);
        choose_face(29, 40);
        segment.row.y = (int32_t)(n % 7);
        TEST_ASSERT_EQUAL(SEGMENT_COLUMNS, paint_row(plain, 0, SEGMENT_COLUMNS));
        segment.paint.level.flags = FXL_TEXTURE_KEYED;
        segment.paint.level.key = (uint8_t)(segment_any() % 16u);
        check_kind(plain, NULL);
        segment.paint.level.flags = 0;
        segment.paint.opacity = (uint8_t)(1u + n % 15u);
        check_kind(plain, NULL);
        segment.paint.opacity = 16;
        segment.paint.level.texels = packed;
        segment.paint.level.colours = colours;
        check_kind(plain, colours);
        segment.paint.level.texels = texels;
        segment.paint.level.colours = NULL;
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
        const uint32_t logs[2] = {FXL_DIVIDED_LOG_MIN + segment_any() % 5u, segment_any() % 9u};
        segment_choose_size(logs[0], logs[1]);
        choose_face(27, 40);
        segment.paint.level.flags = FXL_TEXTURE_CLAMP;
        for (uint32_t i = 0; i < 2; i++) {
            for (uint32_t at = 0; at < 1u << (logs[0] + logs[1]); at++) {
                texels[at] = (uint8_t)(i == 0 ? at & ((1u << logs[0]) - 1u) : at >> logs[0]);
            }
            const int32_t end = paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
            for (int x = 0; x < end; x++) {
                const double at = coordinate(i, x);
                TEST_ASSERT_TRUE(held_distance(at, segment.pixels[x], logs[i]) <=
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
        texels[n] = (uint8_t)(segment_any() % 255u);
    }
    for (uint32_t n = 0; n < 2000; n++) {
        segment_choose_size(6, 6);
        choose_face(29, 60);
        TEST_ASSERT_EQUAL(SEGMENT_COLUMNS, paint_row(segment.pixels, 0, SEGMENT_COLUMNS));
        const int32_t x0 = (int32_t)(segment_any() % SEGMENT_COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(segment_any() % (uint32_t)(SEGMENT_COLUMNS - x0));
        TEST_ASSERT_EQUAL(x1, paint_row(segment.part, x0, x1));
        for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
            TEST_ASSERT_EQUAL(x < x0 || x >= x1 ? SEGMENT_UNTOUCHED : segment.pixels[x],
                              segment.part[x]);
        }
    }
}

void test_a_segment_ends_what_is_painted_where_its_weights_are_far_apart(void)
{
    segment_choose_size(6, 6);
    choose_face(29, 40);
    /* From 2^29 in column 0 to 2^29 / 128 in column 127: the segment from 112 on has a ratio of 16.
     */
    segment_choose_gradient(&segment.gradients.weight, &segment.row.weight, ldexp(1, 29), 0);
    segment.gradients.attributes[0].along = segment.gradients.attributes[1].along = 0;
    segment.row.attributes[0] = segment.row.attributes[1] = 0;
    TEST_ASSERT_EQUAL(96, paint_row(segment.pixels, 5, SEGMENT_COLUMNS));
    TEST_ASSERT_EQUAL(SEGMENT_UNTOUCHED, segment.pixels[96]);
    TEST_ASSERT_EQUAL(120, paint_row(segment.pixels, 120, SEGMENT_COLUMNS));
}

void test_a_weight_of_0_and_large_coordinates_are_not_painted(void)
{
    segment_choose_size(6, 6);
    choose_face(29, 40);
    segment.row.weight = segment.gradients.weight.along = 0;
    TEST_ASSERT_EQUAL(0, paint_row(segment.pixels, 0, SEGMENT_COLUMNS));
    segment.row.weight = (int64_t)1 << 40;
    segment.row.attributes[0] = (int64_t)1 << 61;
    TEST_ASSERT_EQUAL(0, paint_row(segment.pixels, 0, SEGMENT_COLUMNS));
}

void test_other_faces_are_not_for_it(void)
{
    segment_choose_size(6, 6);
    TEST_ASSERT_TRUE(fxl_divided_find(&segment.paint, &face));
    segment_choose_size(3, 6);
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
    segment_choose_size(6, 6);
    segment.paint.division = FXL_DIVIDE_16;
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
    segment.paint.division = FXL_DIVIDE_1;
    segment.paint.opacity = 15;
    TEST_ASSERT_TRUE(fxl_divided_find(&segment.paint, &face));
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
    segment.paint.opacity = 16;
    TEST_ASSERT_TRUE(fxl_divided_find(&segment.paint, &face));
    segment.paint.has_beams = true;
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
    segment.paint.has_beams = false;
    segment.paint.level.flags = FXL_TEXTURE_KEYED | FXL_TEXTURE_CLAMP;
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
    segment.paint.level.flags = 0;
    segment.paint.ramp = texels;
    TEST_ASSERT_FALSE(fxl_divided_find(&segment.paint, &face));
}

/* Coordinates so small that their upper words are 0, or that no bit of them is left: the first
 * texel. The kernel, and each pixel alone. */
void test_coordinates_without_upper_bits(void)
{
    for (uint32_t n = 0; n < TEXELS; n++) {
        texels[n] = (uint8_t)(n % 200u);
    }
    segment_choose_size(5, 5);
    for (int shift = -60; shift <= 40; shift += 20) {
        choose_face(30, 40);
        for (uint32_t i = 0; i < 2; i++) {
            segment.gradients.shifts[i] = (int8_t)shift;
            segment.gradients.attributes[i].along =
                shift < 20 ? segment.gradients.attributes[i].along : 0;
            segment.row.attributes[i] = shift < 20 ? (int64_t)1 << 40 : 77;
        }
        if (shift < 20) { /* above 0 */
            segment.gradients.attributes[0].along = segment.gradients.attributes[1].along = 1 << 20;
        }
        TEST_ASSERT_EQUAL(SEGMENT_COLUMNS, paint_row(segment.pixels, 0, SEGMENT_COLUMNS));
        TEST_ASSERT_EACH_EQUAL_UINT8(texels[0], segment.pixels, SEGMENT_COLUMNS);
        memset(segment.part, SEGMENT_UNTOUCHED, sizeof segment.part);
        segment.row.pixels = segment.part;
        segment.paint.is_replaced = true; /* not for the kernel */
        fxl_paint_pixels(&segment.paint, &segment.row, 0, SEGMENT_COLUMNS);
        segment.paint.is_replaced = false;
        TEST_ASSERT_EQUAL_MEMORY(segment.pixels, segment.part, SEGMENT_COLUMNS);
    }
}
