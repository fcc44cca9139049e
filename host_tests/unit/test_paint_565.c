/* SPDX-License-Identifier: MIT */
/* Rows of RGB565 that frames seldom have: light that leaves its ramp, and textures in light that is
 * the same everywhere. */
#include <math.h>
#include <string.h>

#include "paint/rgb565_colour.h"
#include "paint/segments.h"
#include "paint/smooth_outline.h"
#include "paint/texture_level.h"
#include "unit.h"
#include "unity.h"

enum {
    COLUMNS = 64,
    LEVELS = 9,
    DARK = 0x0841,
    BRIGHT = 0xF7BE
};

static uint16_t texels[32 * 32], palette[256], pixels[COLUMNS], others[COLUMNS];
static fxl_gradients gradients;
static fxl_paint paint;
static fxl_paint_row row;

/* place light: definition: left_of, the part in RGB565; rows of it */
void setUp(void)
{
    memset(&gradients, 0, sizeof gradients);
    memset(&paint, 0, sizeof paint);
    memset(&row, 0, sizeof row);
    for (uint32_t i = 0; i < 32 * 32; i++) {
        texels[i] = (uint16_t)(i * 40503u | 1u);
    }
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = BRIGHT;
    }
    paint.gradients = &gradients;
    paint.levels_less_1 = LEVELS - 1;
    paint.opacity = 16;
    paint.of_565.palette = palette;
    paint.of_565.dark = DARK;
    paint.of_565.part_of_level = 65536 / (LEVELS - 1);
}

static void paint_row(uint16_t *to)
{
    memset(to, 0, sizeof pixels);
    row.pixels = (uint8_t *)to;
    fxl_paint_pixels_565(&paint, &row, 0, COLUMNS);
}

/* place sampling: definition: texels of lit surfaces, segments, divided pixels, RGB565 */
/* A texture of 32 x 32, whose coordinates go along both sides. */
static void choose_texture(uint8_t flags)
{
    paint.level.texels = (const uint8_t *)texels;
    paint.level.log_width = 5;
    paint.level.columns_less_1 = paint.level.rows_less_1 = 31;
    paint.level.flags = (uint8_t)(FXL_LEVEL_565 | flags);
    gradients.count = 2;
    gradients.weight_min[0] = gradients.weight_min[1] = 1;
    gradients.weight.at = row.weight = (int64_t)1 << 61;
    for (uint32_t i = 0; i < 2; i++) {
        gradients.shifts[i] = 24;
        gradients.attributes[i].along = (int64_t)(3 + i) << 53;
    }
}

/* Opaque texels, which are painted in a loop of their own, and the same with a key that no texel
 * has. */
/* SPEC 9.7 */
void test_even_light_of_a_texture_without_segments(void)
{
    uint32_t differing = 0;
    paint.is_evenly_lit = true;
    paint.light = 3 * 256 + 77;
    choose_texture(0);
    paint_row(pixels);
    choose_texture(FXL_TEXTURE_KEYED);
    paint.of_565.key = 0;
    paint_row(others);
    TEST_ASSERT_EQUAL_MEMORY(pixels, others, sizeof pixels);
    paint.is_evenly_lit = false;
    paint.of_565.part_of_level = 0; /* unlit */
    paint_row(others);
    for (uint32_t x = 0; x < COLUMNS; x++) {
        differing += pixels[x] != others[x];
    }
    TEST_ASSERT_GREATER_THAN(COLUMNS / 2, differing);
}

/* Segments leave holes out only where nothing mixes their pixels afterwards. */
void test_segments_of_even_light(void)
{
    fxl_segment_face face;
    choose_texture(FXL_TEXTURE_KEYED);
    TEST_ASSERT_TRUE(fxl_segments_find_565(&paint, &face));
    paint.is_evenly_lit = true;
    TEST_ASSERT_FALSE(fxl_segments_find_565(&paint, &face));
    choose_texture(FXL_TEXTURE_CLAMP);
    TEST_ASSERT_TRUE(fxl_segments_find_565(&paint, &face));
    choose_texture(0);
    TEST_ASSERT_TRUE(fxl_segments_find_565(&paint, &face));
}

/* From three levels below the ramp to three above it: the dark colour, what is between, and the
 * bright one. */
/* SPEC 9.7, 9.6g */
void test_light_that_leaves_the_ramp_is_held(void)
{
    uint32_t dark = 0, between = 0, bright = 0;
    paint.is_light_linear = paint.has_light_rows = true;
    gradients.count = 1;
    gradients.shifts[0] = 53; /* by the lower words */
    gradients.attributes[0].at = -(3 << 24);
    gradients.attributes[0].along = ((LEVELS + 6) << 24) / COLUMNS;
    paint_row(pixels);
    for (uint32_t x = 0; x < COLUMNS; x++) {
        const uint32_t red = pixels[x] >> 11;
        TEST_ASSERT_TRUE(x == 0 || red >= (uint32_t)pixels[x - 1] >> 11);
        dark += pixels[x] == DARK;
        bright += pixels[x] == BRIGHT;
        between += pixels[x] != DARK && pixels[x] != BRIGHT;
    }
    TEST_ASSERT_TRUE(dark > COLUMNS / 8 && between > COLUMNS / 3 && bright > COLUMNS / 8);
    TEST_ASSERT_EQUAL_HEX16(DARK, pixels[0]);
    TEST_ASSERT_EQUAL_HEX16(BRIGHT, pixels[COLUMNS - 1]);
}

/* --- texels in words ------------------------------------------------------------------------- */

enum { WORDS_WIDTH = 40, WORDS_HEIGHT = 30, WORDS_PIXELS = WORDS_WIDTH * WORDS_HEIGHT };

static struct {
    fxl_depth_head head;
    uint16_t cells[WORDS_PIXELS];
} depths, expected_depths;
static uint16_t frame[WORDS_PIXELS], expected[WORDS_PIXELS];
static fxl_depth_plane plane;

static uint32_t random_word(void)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 32);
}

static uint32_t word_at(const fxl_gradient *gradient, uint32_t x, uint32_t y)
{
    return (uint32_t)gradient->at + x * (uint32_t)gradient->along + y * (uint32_t)gradient->down;
}

/* The texel of `count` that a coordinate in 8.24 of level 0 is in, where the level has a texel for 2^drop of
 * these. Rounded down, the word of a level and its steps are less by less than 2^(drop - 24) a step. */
static uint32_t texel_of(const fxl_gradient *gradient, uint32_t x, uint32_t y, uint32_t drop,
                         uint32_t bits, uint32_t count)
{
    const int32_t at = (int32_t)gradient->at >> (drop + bits);
    const int32_t along = (int32_t)gradient->along >> (drop + bits);
    const int32_t down = (int32_t)gradient->down >> (drop + bits);
    const double texel = ((double)at + (double)x * along + (double)y * down) / ldexp(1, 24 - (int)bits);
    return (uint32_t)((int64_t)floor(texel) & (int64_t)(count - 1u));
}

/* place sampling: definition: texels in words */
/* A pixel of the face, by what its words mean. */
static void expect_pixel(uint32_t x, uint32_t y)
{
    const uint32_t place = y * WORDS_WIDTH + x, columns = paint.level.columns_less_1 + 1u;
    const uint32_t u_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - gradients.shifts[0]);
    const uint32_t v_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - gradients.shifts[1]);
    const uint32_t i = texel_of(&gradients.attributes[0], x, y, u_drop, 0, columns);
    const uint32_t j = texel_of(&gradients.attributes[1], x, y, v_drop, 8u - paint.level.log_width,
                                paint.level.rows_less_1 + 1u);
    const uint32_t border = fxl_depth_border(expected_depths.head.scale, &plane);
    uint32_t code = word_at(&plane.gradient, x, y), colour;
    code = code < border ? border - 2u * (border - code) : code;
    if (code >> 16 < expected_depths.cells[place] ||
        (code >> 16 == expected_depths.cells[place] && !depths.head.or_equal)) {
        return;
    }
    expected_depths.cells[place] = (uint16_t)(code >> 16);
    colour = paint.level.flags & FXL_LEVEL_565
                 ? texels[j * columns + i]
                 : palette[((const uint8_t *)texels)[j * columns + i]];
    if (paint.of_565.part_of_level != 0) {
        const uint32_t light = gradients.count == 3 ? word_at(&gradients.attributes[2], x, y)
                                                    : (uint32_t)paint.light << 16;
        const uint64_t level = light - (1u << 23) + fxl_half_part_565(LEVELS - 1);
        colour = fxl_mix_565(colour, DARK, (uint32_t)(level * paint.of_565.part_of_level >> 32));
    }
    expected[place] = (uint16_t)colour;
}

/* Any words; light that is of the ramp all over the frame. */
static void choose_words(void)
{
    const uint32_t kind = random_word();
    const uint32_t log_width = random_word() % 6u, log_height = random_word() % 6u;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_gradient *attribute = &gradients.attributes[i];
        attribute->at = (int32_t)random_word();
        attribute->along = (int32_t)random_word() >> 4;
        attribute->down = (int32_t)random_word() >> 4;
    }
    gradients.attributes[2].at = (1 << 23) + (LEVELS - 1) * (1 << 23);
    gradients.attributes[2].along = (int32_t)random_word() >> 8;
    gradients.attributes[2].down = (int32_t)random_word() >> 8;
    gradients.shifts[0] = (int8_t)(FXL_SHIFT_OF_TEXELS - random_word() % 4u);
    gradients.shifts[1] = (int8_t)(FXL_SHIFT_OF_TEXELS - random_word() % 4u);
    gradients.count = kind & 1u ? 3 : 2;
    paint.is_evenly_lit = gradients.count == 2;
    paint.light = (uint16_t)(128u + random_word() % ((LEVELS - 1) * 256u));
    paint.of_565.part_of_level = kind & 2u ? 65536u / (LEVELS - 1) : 0;
    paint.level.texels = (const uint8_t *)texels;
    paint.level.flags = kind & 4u ? FXL_LEVEL_565 : 0;
    paint.level.log_width = (uint8_t)log_width;
    paint.level.columns_less_1 = (1u << log_width) - 1u;
    paint.level.rows_less_1 = (1u << log_height) - 1u;
    depths.head.scale = expected_depths.head.scale = (fxl_depth_scale){12, 12};
    depths.head.or_equal = (kind & 24u) == 0;
    plane.one = (kind & 96u) == 0 ? FXL_DEPTH_IS_BENT + 5 : FXL_DEPTH_IS_LINEAR;
    plane.gradient.at = (int32_t)(7u << 28);
    plane.gradient.along = (int32_t)random_word() >> 7;
    plane.gradient.down = (int32_t)random_word() >> 7;
}

/* A triangle anywhere in a band, over cells that hide some of it. Returns how many of its pixels
 * are hidden. */
static uint32_t draw_words(void)
{
    static fxl_scan scan;
    fxl_band band = {.pixels = (uint8_t *)frame,
                     .width = WORDS_WIDTH,
                     .stride = WORDS_WIDTH,
                     .rows = WORDS_HEIGHT};
    fxl_screen_point points[3];
    fxl_span span;
    uint32_t hidden = 0;
    choose_words();
    for (uint32_t i = 0; i < 3; i++) {
        points[i].x = (int32_t)(random_word() % (WORDS_WIDTH << 16));
        points[i].y = (int32_t)(random_word() % (WORDS_HEIGHT << 16));
    }
    for (uint32_t i = 0; i < WORDS_PIXELS; i++) {
        const uint32_t code = word_at(&plane.gradient, i % WORDS_WIDTH, i / WORDS_WIDTH);
        const uint32_t cell = random_word() % 4 ? 0 : (code >> 16) + random_word() % 3 - 1u;
        depths.cells[i] = expected_depths.cells[i] = (uint16_t)cell;
        frame[i] = expected[i] = 0;
    }
    fxl_scan_outline(points, 3, &band, &scan);
    const bool reaches = fxl_scan_reaches(&scan, &band);
    while (fxl_scan_next(&scan, &span)) {
        for (int32_t x = span.x0; x < span.x1; x++) {
            const uint32_t place = (uint32_t)span.y * WORDS_WIDTH + (uint32_t)x;
            const uint16_t before = expected_depths.cells[place];
            expect_pixel((uint32_t)x, (uint32_t)span.y);
            hidden += before == expected_depths.cells[place];
        }
    }
    TEST_ASSERT_EQUAL(reaches, fxl_draw_texels(&paint, &plane, &depths, points, 3, &band, &scan));
    TEST_ASSERT_EQUAL_MEMORY(expected_depths.cells, depths.cells, sizeof depths.cells);
    TEST_ASSERT_EQUAL_MEMORY(expected, frame, sizeof frame);
    return hidden;
}

/* Texels of 8 and of 16 bits, unlit, lit, and lit evenly, of one octave and of two, near to far and
 * far to near. */
/* SPEC 9.5, 10.3d, rgb565 2.1 */
void test_texels_in_words(void)
{
    uint32_t hidden = 0;
    for (uint32_t i = 0; i < UNIT_REPEAT / 40; i++) {
        hidden += draw_words();
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 40, hidden);
}
