/* SPDX-License-Identifier: MIT */
/* A triangle whose light and depth are in words, as cores without a kernel draw it, against the definition of a pixel. */
#include "unit.h"
#include "draw/surface_polygon.h"
#include "paint/depth_code.h"
#include "paint/depth_outline.h"
#include "paint/smooth_outline.h"
#include "raster/scan.h"

#if !FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT

enum {
    SIDE = 14
};

static fxl_depth_head *smooth_head; /* cells follow */
static uint16_t smooth_cells[SIDE * SIDE];

/* The definition of a pixel: a bent code, and light that is held within the ramp. */
static void define_smooth(const fxl_paint *paint, const fxl_depth_plane *depth, uint32_t x,
                          uint32_t y, bool is_wide, uint16_t *pixel)
{
    const fxl_gradient *light = paint->gradients->attributes, *of = &depth->gradient;
    const uint32_t border = fxl_depth_border(smooth_head->scale, depth);
    const int64_t word = of->at + x * of->along + y * of->down;
    const int64_t code = word < border ? 2 * word - border : word;
    const int64_t half = is_wide ? ((int64_t)paint->levels_less_1 << 15) - (1 << 23) : 0;
    const int64_t most = ((int64_t)paint->levels_less_1 << 24) + (is_wide ? half + (1 << 23) : 0);
    int64_t level = light->at + x * light->along + y * light->down + half;
    level = level < 0 ? 0 : level > most ? most : level;
    if (code >> 16 > smooth_cells[y * SIDE + x]) {
        smooth_cells[y * SIDE + x] = (uint16_t)(code >> 16);
        *pixel = is_wide ? fxl_mix_565(paint->of_565.palette[paint->colour], paint->of_565.dark,
                                       (uint32_t)(level * paint->of_565.part_of_level >> 32))
                         : paint->ramp[(level >> 24) * 256 + paint->colour];
    }
}

#endif

/* On cores without a kernel: a lit triangle has the code and the light of each of its pixels, also where a row
 * crosses the end of an octave or of the ramp. */
/* SPEC 9.6, 10.3, 10.4b */
void test_a_smooth_triangle_has_the_light_and_codes_of_its_pixels(void)
{
#if !FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT
    static uint64_t memory[1 + SIDE * SIDE / 4];
    static uint8_t ramp[64 * 256];
    static uint16_t palette[256], pixels[SIDE * SIDE], expected[SIDE * SIDE];
    static fxl_scan scan;
    uint32_t bent = 0, held = 0;
    smooth_head = (fxl_depth_head *)(void *)memory;
    smooth_head->scale = (fxl_depth_scale){9, 12};
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        const bool is_wide = i % 2;
        const int32_t levels = unit_between(2, 64), octave = unit_between(0, 7);
        uint8_t *bytes = (uint8_t *)pixels;
        fxl_gradients gradients = {.count = 1};
        fxl_depth_plane depth = {.one = unit_between(0, 1) ? FXL_DEPTH_IS_BENT + octave
                                                           : FXL_DEPTH_IS_LINEAR};
        const uint32_t border = fxl_depth_border(smooth_head->scale, &depth);
        fxl_paint paint = {.gradients = &gradients,
                           .ramp = ramp,
                           .levels_less_1 = (uint8_t)(levels - 1),
                           .colour = (uint8_t)unit_random(),
                           .of_565 = {.palette = palette,
                                      .part_of_level = (uint32_t)(65536 + (levels - 1) / 2) /
                                                       (uint32_t)(levels - 1),
                                      .dark = (uint16_t)unit_random()}};
        const fxl_band band = {
            .pixels = bytes, .width = SIDE, .stride = SIDE, .first_row = 0, .rows = SIDE};
        fxl_screen_point points[3];
        for (uint32_t k = 0; k < 3; k++) {
            points[k].x = unit_between(0, SIDE << 16);
            points[k].y = unit_between(0, SIDE << 16);
        }
        /* from -1/4 of the ramp on to 5/4 of it */
        gradients.attributes[0].at = unit_between(-levels, 5 * levels) * (1 << 22);
        gradients.attributes[0].along = unit_between(-levels, levels) * (1 << 22) / SIDE;
        gradients.attributes[0].down = unit_between(-levels, levels) * (1 << 22) / SIDE;
        depth.gradient.at = (int64_t)(border != 0 ? border : 1u << 31) + unit_between(-(1 << 24), 1 << 24);
        depth.gradient.along = unit_between(-(1 << 21), 1 << 21);
        depth.gradient.down = unit_between(-(1 << 21), 1 << 21);
        for (uint32_t k = 0; k < 64 * 256; k++) {
            ramp[k] = (uint8_t)(k * 7u + (k >> 8));
        }
        palette[paint.colour] = (uint16_t)unit_random();
        memset(pixels, 0xA5, sizeof pixels);
        memset(expected, 0, sizeof expected);
        uint16_t *found = (uint16_t *)(void *)(memory + 1);
        for (uint32_t k = 0; k < SIDE * SIDE; k++) {
            const int64_t near = depth.gradient.at + unit_between(-(1 << 22), 1 << 22);
            found[k] = smooth_cells[k] = (uint16_t)(unit_between(0, 1) ? 0 : near >> 16);
            expected[k] = is_wide ? pixels[k] : bytes[k];
        }
        fxl_scan_outline(points, 3, &band, &scan);
        for (fxl_span span; fxl_scan_next(&scan, &span);) {
            for (int32_t x = span.x0; x < span.x1; x++) {
                define_smooth(&paint, &depth, (uint32_t)x, (uint32_t)span.y, is_wide,
                              &expected[span.y * SIDE + x]);
                held += gradients.attributes[0].at < 0;
                bent += border != 0;
            }
        }
        fxl_scan_outline(points, 3, &band, &scan);
        fxl_draw_smooth_words(&paint, &depth, memory, is_wide ? 2 : 1, &band, &scan);
        for (uint32_t k = 0; k < SIDE * SIDE; k++) {
            TEST_ASSERT_EQUAL_HEX16(smooth_cells[k], found[k]);
            TEST_ASSERT_EQUAL_HEX16(expected[k], is_wide ? pixels[k] : bytes[k]);
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, bent);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 4, held);
#endif
}
