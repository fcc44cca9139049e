/* SPDX-License-Identifier: MIT */
/* Light in textured segments, the kinds of their texels, and pixels that no kernel paints. */
#include <stdlib.h>

/* place sampling: definition: texels of lit surfaces, segments, divided pixels, RGB565 */
#include "paint/texel_place.h"
#include "paint/texture_level.h"
#include "segment_unit.h"

void setUp(void)
{
    segment_begin();
}

/* Light is partly below the ramp's first level, and partly above its last one. */
static void choose_lit_face(void)
{
    segment_choose_face();
    segment.gradients.shifts[2] = 20;
    segment_choose_gradient(&segment.gradients.attributes[2], &segment.row.attributes[2],
                            segment_exact(&segment.gradients.weight, 0) *
                                ((int)(segment_any() % 1200u) - 100) / 5000,
                            segment_exact(&segment.gradients.weight, SEGMENT_COLUMNS) *
                                ((int)(segment_any() % 1200u) - 100) / 5000);
}

/* A step of light is off by less than a unit of 1/256 level. Beyond the levels it is limited. */
static void check_light(int columns)
{
    for (int x = 0; x < SEGMENT_COLUMNS; x++) {
        const double light = segment_on_line(2, x, columns);
        TEST_ASSERT_TRUE(segment.pixels[x] < SEGMENT_LEVELS);
        TEST_ASSERT_TRUE(light - segment.pixels[x] > -1.0 / 15 || segment.pixels[x] == 0);
        TEST_ASSERT_TRUE(light - segment.pixels[x] < 1 + 1.0 / 15 ||
                         segment.pixels[x] == SEGMENT_LEVELS - 1);
    }
}

void test_light_is_on_the_line_between_both_ends(void)
{
    segment_choose_size(4, 4);
    memset(segment.texels, 7, sizeof segment.texels);
    for (uint32_t i = 0; i < sizeof segment.ramp; i++) {
        segment.ramp[i] = (uint8_t)((i & 255u) == 7 ? i >> 8 : SEGMENT_UNTOUCHED);
    }
    segment.paint.ramp = segment.ramp;
    segment.paint.levels_less_1 = SEGMENT_LEVELS - 1;
    segment.gradients.count = 3;
    for (uint32_t n = 0; n < 100; n++) {
        choose_lit_face();
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        for (uint32_t log = 2; log <= 4; log++) {
            segment_choose_log(log);
            segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
            check_light(1 << log);
        }
    }
}

/* What fxl_paint_pixels paints of a lit row are the kernel's pixels, wherever light is. */
void test_lit_rows_are_those_of_the_kernel(void)
{
    segment_choose_size(4, 4);
    for (uint32_t i = 0; i < sizeof segment.ramp; i++) {
        segment.ramp[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    segment.paint.ramp = segment.ramp;
    segment.paint.levels_less_1 = SEGMENT_LEVELS - 1;
    segment.gradients.count = 3;
    for (uint32_t n = 0; n < 400; n++) {
        choose_lit_face();
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        segment_choose_log(2 + n % 3);
        segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
        segment.row.segments = &segment.face;
        segment.row.pixels = segment.part;
        fxl_paint_pixels(&segment.paint, &segment.row, 0, SEGMENT_COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(segment.pixels, segment.part, SEGMENT_COLUMNS);
    }
}

/* Light far beyond the levels, whatever its numbers: no entry beyond the ramp is read, as the
 * sanitizers see, and every pixel is painted. */
void test_light_beyond_the_levels_is_limited(void)
{
    segment_choose_size(4, 0);
    memset(segment.texels, 0, sizeof segment.texels);
    memset(segment.ramp, 1, sizeof segment.ramp);
    segment.paint.ramp = segment.ramp;
    segment.gradients.count = 3;
    for (uint32_t n = 0; n < 500; n++) {
        segment_choose_face();
        segment.paint.levels_less_1 = (uint8_t)(n % SEGMENT_LEVELS);
        segment.gradients.shifts[2] = (int8_t)(n % 64);
        segment_choose_gradient(&segment.gradients.attributes[2], &segment.row.attributes[2],
                                (int32_t)segment_any() / 4 >> n % 28,
                                (int32_t)segment_any() / 4 >> n % 29);
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        if (fxl_segments_suffice(&segment.face, &segment.row, 0, SEGMENT_COLUMNS)) {
            segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
            for (int x = 0; x < SEGMENT_COLUMNS; x++) {
                TEST_ASSERT_EQUAL(1, segment.pixels[x]);
            }
        }
    }
}

/* The pixels of a kind of texels, where `plain` has those of the same texels of 8 bits, in light
 * that is the same everywhere or in none. */
static void check_kind_in_light(const uint8_t *plain, int32_t x0, const uint8_t *colours)
{
    TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
    TEST_ASSERT_NOT_EQUAL(FXL_TEXELS_PLAIN, segment.face.kind);
    segment_paint_row(segment.pixels, x0, SEGMENT_COLUMNS);
    for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
        const bool is_drawn =
            x >= x0 &&
            (segment.face.kind != FXL_TEXELS_KEYED || plain[x] != segment.paint.level.key) &&
            (segment.face.kind != FXL_TEXELS_STIPPLED ||
             !fxl_is_stippled_away(segment.paint.opacity, x, segment.row.y));
        const uint8_t colour = colours != NULL && is_drawn ? colours[plain[x]] : plain[x];
        TEST_ASSERT_EQUAL(!is_drawn                     ? SEGMENT_UNTOUCHED
                          : segment.paint.table != NULL ? segment.paint.table[colour]
                                                        : colour,
                          segment.pixels[x]);
    }
}

static void check_kind(const uint8_t *plain, int32_t x0, const uint8_t *colours)
{
    static uint8_t table[256];
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    check_kind_in_light(plain, x0, colours);
    segment.paint.table = table;
    check_kind_in_light(plain, x0, colours);
    segment.paint.table = NULL;
}

/* Texels that are keyed, stippled or of 4 bits are those that are plain, at every pixel. */
/* SPEC 9.5, 9.6d-e, surfaces 1.1a, 1.3a */
void test_other_kinds_of_texels_are_at_the_places_of_plain_ones(void)
{
    static uint8_t packed[SEGMENT_TEXELS / 2];
    uint8_t plain[SEGMENT_COLUMNS], colours[16];
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % 16u);
        packed[i / 2] = (uint8_t)(packed[i / 2] >> 4 | segment.texels[i] << 4);
    }
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 100; n++) {
        const int32_t x0 = (int32_t)(segment_any() % 20u);
        segment_choose_face();
        segment_choose_size(4 + n % 2, 5);
        segment.row.y = (int32_t)(n % 7);
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        TEST_ASSERT_EQUAL(FXL_TEXELS_PLAIN, segment.face.kind);
        segment_paint_row(plain, x0, SEGMENT_COLUMNS);
        segment.paint.level.flags = FXL_TEXTURE_KEYED;
        segment.paint.level.key = (uint8_t)(segment_any() % 16u);
        check_kind(plain, x0, NULL);
        segment.paint.level.flags = 0;
        segment.paint.opacity = (uint8_t)(1u + n % 15u);
        check_kind(plain, x0, NULL);
        segment.paint.opacity = 16;
        segment.paint.level.texels = packed;
        segment.paint.level.colours = colours;
        check_kind(plain, x0, colours);
        segment.paint.level.texels = segment.texels;
        segment.paint.level.colours = NULL;
    }
}

/* Texels that do not repeat are those that fxl_paint_pixels shows without a kernel, to within what
 * both round: a texel beside it at most, and few of them. */
/* SPEC 9.5, surfaces 1.1c */
void test_clamped_texels_are_held_within_the_texture(void)
{
    uint32_t unlike = 0, beyond = 0;
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(i % 32u / 4u * 16u + i / 32u / 4u);
    }
    for (uint32_t n = 0; n < 300; n++) {
        const int32_t x0 = (int32_t)(segment_any() % 20u);
        segment_choose_face();
        segment.paint.level.flags = FXL_TEXTURE_CLAMP;
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        TEST_ASSERT_EQUAL(FXL_TEXELS_CLAMPED, segment.face.kind);
        segment_paint_row(segment.pixels, x0, SEGMENT_COLUMNS);
        segment.row.segments = NULL;
        segment.row.pixels = segment.part;
        memset(segment.part, SEGMENT_UNTOUCHED, sizeof segment.part);
        fxl_paint_pixels(&segment.paint, &segment.row, x0, SEGMENT_COLUMNS);
        TEST_ASSERT_EQUAL(0, memcmp(segment.pixels, segment.part, (size_t)x0));
        for (int32_t x = x0; x < SEGMENT_COLUMNS; x++) {
            const int columns = abs((segment.pixels[x] >> 4) - (segment.part[x] >> 4));
            const int rows = abs((segment.pixels[x] & 15) - (segment.part[x] & 15));
            TEST_ASSERT_TRUE(columns <= 1 && rows <= 1);
            unlike += columns + rows > 0;
            beyond += segment.part[x] == 0 || segment.part[x] == 0x77;
        }
    }
    TEST_ASSERT_LESS_THAN(400, unlike);
    TEST_ASSERT_GREATER_THAN(5000, beyond);
}

/* place stipple: definition: the numbers of the pattern */
/* Of 16 pixels an opacity draws so many, those whose number in the pattern is below it. */
/* SPEC 9.6b-c */
void test_which_pixels_an_opacity_draws(void)
{
    static const uint32_t numbers[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    for (uint32_t opacity = 0; opacity <= 17; opacity++) {
        for (int32_t at = 0; at < 256; at++) {
            const int32_t x = at % 16, y = at / 16;
            const bool is_drawn = opacity >= 16 || numbers[y % 4][x % 4] < opacity;
            TEST_ASSERT_EQUAL(!is_drawn, fxl_is_stippled_away(opacity, x, y));
        }
    }
}

/* Pixels x0 <= x < x1 that are not the kernel's. A beam that leaves colours as they are has each
 * painted as any pixel is. */
static void paint_any(uint8_t *pixels, const uint8_t *in_beam, int32_t x0, int32_t x1)
{
    memset(pixels, SEGMENT_UNTOUCHED, SEGMENT_COLUMNS);
    segment.paint.in_beam = in_beam;
    segment.paint.is_replaced = in_beam != NULL || segment.paint.blend != NULL;
    segment.row.segments = NULL;
    segment.row.pixels = pixels;
    fxl_paint_pixels(&segment.paint, &segment.row, x0, x1);
    segment.paint.in_beam = NULL;
}

/* Loops for what most faces have paint what the loop for any pixel paints, wherever they begin. */
/* surfaces 1.1b */
void test_simple_pixels_are_as_any_pixel(void)
{
    static uint8_t same[256], blend[6 * 256];
    uint32_t holes = 0, painted = 0;
    for (uint32_t i = 0; i < sizeof blend; i++) {
        same[i % 256] = (uint8_t)i;
        blend[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % 8u);
    }
    for (uint32_t i = 0; i < sizeof segment.ramp; i++) {
        segment.ramp[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 2000; n++) {
        const int32_t x0 = (int32_t)(segment_any() % SEGMENT_COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(segment_any() % (uint32_t)(SEGMENT_COLUMNS - x0));
        segment_begin();
        segment.state += n;
        segment_choose_face();
        segment_choose_size(segment_any() % 6u, segment_any() % 6u);
        segment.paint.level.flags = (uint8_t)(n % 3 == 0 ? FXL_TEXTURE_KEYED : 0);
        segment.paint.level.key = (uint8_t)(segment_any() % 8u);
        segment.paint.division = (uint8_t)(n % 5 == 0 ? FXL_DIVIDE_8 : FXL_DIVIDE_16);
        segment.paint.colour = 3;
        segment.paint.blend = n & 16u ? blend : NULL;
        segment.paint.blend_first = (uint8_t)(n % 4);
        segment.paint.blend_count = 3 + n % 3;
        if (n & 4u) {
            segment.paint.level.texels = n & 8u ? segment.texels : NULL;
            segment.paint.ramp = segment.ramp;
            segment.paint.levels_less_1 = SEGMENT_LEVELS - 1;
            segment.gradients.count = n & 8u ? 3 : 1;
            segment.gradients.shifts[segment.gradients.count - 1] = 20;
            segment_choose_gradient(&segment.gradients.attributes[segment.gradients.count - 1],
                                    &segment.row.attributes[segment.gradients.count - 1],
                                    segment_exact(&segment.gradients.weight, 0) *
                                        ((int)(segment_any() % 900u) - 100) / 4000,
                                    segment_exact(&segment.gradients.weight, SEGMENT_COLUMNS) *
                                        ((int)(segment_any() % 900u) - 100) / 4000);
        }
        paint_any(segment.pixels, NULL, x0, x1);
        paint_any(segment.part, same, x0, x1);
        TEST_ASSERT_EQUAL_MEMORY(segment.part, segment.pixels, SEGMENT_COLUMNS);
        paint_any(segment.pixels, NULL, 0, SEGMENT_COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(segment.part + x0, segment.pixels + x0, (size_t)(x1 - x0));
        for (int32_t x = x0; x < x1; x++) {
            holes += segment.part[x] == SEGMENT_UNTOUCHED;
            painted += segment.part[x] != SEGMENT_UNTOUCHED;
        }
    }
    TEST_ASSERT_TRUE(holes > 1000 && painted > 10000);
}

/* --- mixed pixels of RGB565 ------------------------------------------------------------------- */

static uint16_t mixed_texels[SEGMENT_TEXELS], mixed_palette[256];

/* Any face of one of the kinds that pixels of RGB565 have, and segments of any length. */
static void choose_mixed_face(uint32_t n)
{
    static uint8_t colours[16];
    segment_choose_face();
    segment_choose_size(1 + segment_any() % 5u, segment_any() % 6u);
    segment.row.y = (int32_t)(n % 5);
    segment.paint.opacity = (uint8_t)(n % 7 == 0 ? 1 + n % 15 : 16);
    segment.paint.division = (uint8_t)(n % 3);
    segment.gradients.weight_min[0] = segment_any() >> 1 >> segment_any() % 5u;
    segment.gradients.weight_min[1] = segment.gradients.weight_min[0] / 4;
    segment.paint.level.flags =
        (uint8_t)((n % 2 ? FXL_TEXTURE_KEYED : 0) | (n % 11 == 0 ? FXL_TEXTURE_CLAMP : 0) |
                  (n % 3 == 0 ? FXL_LEVEL_565 : 0));
    segment.paint.level.colours = n % 3 == 1 ? colours : NULL;
    segment.paint.level.texels = n % 3 == 0 ? (const uint8_t *)mixed_texels : segment.texels;
    segment.paint.level.key = (uint8_t)(n % 16);
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)i;
    }
    segment.paint.of_565.palette = mixed_palette;
    segment.paint.of_565.key = mixed_texels[n % 8];
    segment.paint.of_565.part_of_level = n % 13 == 0 ? 65536u / 2 : 0;
    segment.paint.is_evenly_lit = n % 13 == 0;
    segment.paint.levels_less_1 = 2;
    segment.paint.light = (uint16_t)(segment_any() % 512u + 128u);
}

static uint16_t mixed(uint32_t above, uint32_t beneath)
{
    static const uint32_t drops[3] = {11, 5, 0}, most[3] = {31, 63, 31};
    const fxl_paint_565 *of = &segment.paint.of_565;
    uint32_t all = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t a = above >> drops[i] & most[i], b = beneath >> drops[i] & most[i];
        const uint32_t sum =
            of->sixteenths == 0 ? a + b : (a * of->sixteenths + b * (16u - of->sixteenths)) / 16u;
        all |= (sum > most[i] ? most[i] : sum) << drops[i];
    }
    return (uint16_t)all;
}

static void paint_mixed(uint16_t *pixels, uint32_t sixteenths, bool adds, int32_t x0, int32_t x1)
{
    segment.paint.of_565.sixteenths = (uint8_t)sixteenths;
    segment.paint.of_565.adds = adds;
    segment.row.segments = NULL;
    segment.row.pixels = (uint8_t *)pixels;
    fxl_paint_pixels_565(&segment.paint, &segment.row, x0, x1);
}

/* Opaque pixels, one by one: in light that changes none of them, but is found for each. */
static void paint_one_by_one(uint16_t *pixels, int32_t x0, int32_t x1)
{
    const fxl_paint paint = segment.paint;
    segment.paint.of_565.part_of_level = 65536u / 2;
    segment.gradients.count = 3;
    segment.gradients.attributes[2] = segment.gradients.weight;
    segment.gradients.shifts[2] = 20;
    segment.row.attributes[2] = segment.row.weight;
    paint_mixed(pixels, 0, false, x0, x1);
    segment.paint = paint;
    segment.gradients.count = 2;
}

/* What is blended or added has the texels and the holes that it has without that, over whatever is
 * beneath: a pixel that is the same over two backgrounds is drawn. Those with holes are as they are
 * one by one. */
/* rgb565 2.2, 2.3, surfaces 2.2, 4.1 */
void test_mixed_texels_are_opaque_ones_that_are_mixed(void)
{
    static uint16_t dark[SEGMENT_COLUMNS], bright[SEGMENT_COLUMNS], beneath[SEGMENT_COLUMNS],
        seen[SEGMENT_COLUMNS], single[SEGMENT_COLUMNS];
    uint32_t holes = 0, drawn = 0;
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        mixed_texels[i] = (uint16_t)(segment_any() % 8u * 0x1F35u);
        segment.texels[i] = (uint8_t)segment_any();
        mixed_palette[i % 256] = (uint16_t)segment_any();
    }
    for (uint32_t n = 0; n < 1000; n++) {
        const int32_t x0 = (int32_t)(segment_any() % SEGMENT_COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(segment_any() % (uint32_t)(SEGMENT_COLUMNS - x0));
        choose_mixed_face(n);
        for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
            dark[x] = single[x] = 0;
            bright[x] = 0xFFFFu;
            seen[x] = beneath[x] = (uint16_t)segment_any();
        }
        paint_mixed(dark, 0, false, x0, x1);
        paint_mixed(bright, 0, false, x0, x1);
        paint_mixed(seen, n % 2 ? 1 + n % 16 : 0, n % 2 == 0, x0, x1);
        if (n % 13 != 0) {
            paint_one_by_one(single, x0, x1);
            TEST_ASSERT_EQUAL_MEMORY(single, dark, sizeof dark);
        }
        for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
            const bool is_drawn = dark[x] == bright[x];
            const uint16_t expected = is_drawn ? mixed(dark[x], beneath[x]) : beneath[x];
            TEST_ASSERT_EQUAL_HEX16(expected, seen[x]);
            holes += !is_drawn && x >= x0 && x < x1;
            drawn += is_drawn;
        }
    }
    TEST_ASSERT_TRUE(holes > 1000 && drawn > 10000);
}

/* Each texel of each side from 1 to 16, and as far beyond the border. */
/* SPEC 9.5a */
void test_a_texel_is_within_its_level_however_wide_and_high(void)
{
    for (int sides = 0; sides < 25; sides++) {
        const int width = 1 << sides % 5, height = 1 << sides / 5;
        fxl_texture_level level = {.columns_less_1 = (uint32_t)width - 1,
                                   .rows_less_1 = (uint32_t)height - 1,
                                   .log_width = (uint8_t)(sides % 5)};
        for (int i = -2 * width; i < 3 * width; i++) {
            for (int j = -2 * height; j < 3 * height; j++) {
                const int column = i < 0 ? 0 : i < width ? i : width - 1;
                const int row = j < 0 ? 0 : j < height ? j : height - 1;
                level.flags = FXL_TEXTURE_CLAMP;
                TEST_ASSERT_EQUAL(row * width + column, (int)fxl_texel_place(&level, i, j));
                level.flags = 0;
                TEST_ASSERT_EQUAL((j + 2 * height) % height * width + (i + 2 * width) % width,
                                  (int)fxl_texel_place(&level, i, j));
            }
        }
    }
}
