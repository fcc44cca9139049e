/* SPDX-License-Identifier: MIT */
/* Rows of RGB565 that frames seldom have: light that leaves its ramp, and textures in light that is
 * the same everywhere. */
#include <string.h>

#include "paint/segments.h"
#include "paint/texture_level.h"
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
/* SPEC 9.7 */
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
