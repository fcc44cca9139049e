/* SPDX-License-Identifier: MIT */
/* Outlines over surfaces and billboards, in a palette and in RGB565: against the frames without
 * outlines, and those of outlines alone. */
#include <string.h>

#include "depth_scene.h"
#include "unit.h"
#include "unity.h"

enum {
    WIDTH = DEPTH_SCENE_WIDTH,
    HEIGHT = DEPTH_SCENE_HEIGHT,
    PIXELS = WIDTH * HEIGHT,
    LINE = 77,
    SURFACES = 1,
    BILLBOARDS = 2,
    OUTLINES = 4
};

static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 98304}, 1, 0, 0}, {{-16384, 29491, 81920}, 2, 0, 0}};
static const uint8_t sprite_pixels[] = {41, 42, 43, 44};
static const fxl_sprite sprite = {
    .pixels = sprite_pixels, .width = 2, .height = 2, .bits = 8, .key = FXL_SPRITE_OPAQUE};
static const fxl_billboard board = {&sprite, 32768, 32768, 16384, 16384};
static const uint16_t model_map[DEPTH_SCENE_QUADS] = {0, 0, 1};
static const fxl_billboard_set board_set = {&board, 1, model_map};
static const fxl_outline_style style = {.line = LINE, .keeps_colours = true};

static depth_scene *made;
static uint16_t colours[256], pixels[PIXELS];
static uint8_t all[PIXELS], without[PIXELS], lines[PIXELS];
static fxl_billboards billboards;
static fxl_outlines outlines;

void setUp(void)
{
    made = depth_scene_make();
    made->scene.instances = instances;
    made->face_map[1] = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    for (uint32_t i = 0; i < 256; i++) {
        colours[i] = (uint16_t)(i * 257 + 1);
    }
}

void tearDown(void)
{
}

static void start(bool is_rgb565, uint32_t set)
{
    fxl_renderer *renderer = &made->renderer;
    fxl_config config = made->config;
    config.target = is_rgb565 ? &fxl_rgb565 : &fxl_palette;
    config.palette = is_rgb565 ? colours : NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(renderer, &made->scene, &config, made->memory,
                                                sizeof made->memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(renderer, &outlines,
                                                  set & OUTLINES ? &style : NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_surfaces(renderer, &made->surfaces,
                                          set & SURFACES ? &made->set : NULL,
                                          is_rgb565 ? FXL_SURFACES_OF(fxl_rgb565)
                                                    : FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(renderer, &billboards,
                                                    set & BILLBOARDS ? &board_set : NULL,
                                                    is_rgb565 ? FXL_SPRITES_OF(fxl_rgb565)
                                                              : FXL_SPRITES_OF(fxl_palette)));
}

static void draw(uint32_t set, uint8_t *to)
{
    start(false, set);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, to, WIDTH));
}

static uint32_t count_of(const uint8_t *frame, uint8_t from, uint8_t to)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        count += frame[i] >= from && frame[i] <= to;
    }
    return count;
}

/* Where there is no line, the picture is the one without outlines. Lines are where they are without
 * surfaces. */
/* wire 3.1 */
void test_surfaces_have_the_lines_of_flat_faces(void)
{
    draw(OUTLINES | SURFACES, all);
    draw(SURFACES, without);
    draw(OUTLINES, lines);
    TEST_ASSERT_TRUE(count_of(all, LINE, LINE) * 20 > PIXELS);
    TEST_ASSERT_TRUE(count_of(all, 98, 99) * 20 > PIXELS);
    for (uint32_t i = 0; i < PIXELS; i++) {
        TEST_ASSERT_EQUAL_UINT8(lines[i] == LINE ? LINE : without[i], all[i]);
    }
}

/* A billboard hides the lines behind it, and has none. */
void test_a_billboard_is_drawn_in_its_turn(void)
{
    uint32_t hidden = 0;
    draw(OUTLINES | SURFACES | BILLBOARDS, all);
    draw(SURFACES | BILLBOARDS, without);
    made->scene.instance_count = DEPTH_SCENE_QUADS - 1; /* less the billboard's */
    draw(OUTLINES | SURFACES, lines);
    TEST_ASSERT_TRUE(count_of(all, 41, 44) * 20 > PIXELS);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const bool is_sprite = without[i] >= 41 && without[i] <= 44;
        hidden += is_sprite && lines[i] == LINE && all[i] != LINE;
        TEST_ASSERT_TRUE(all[i] == without[i] || (all[i] == LINE && lines[i] == LINE));
    }
    TEST_ASSERT_TRUE(hidden > 0);
}

/* A line has the colour of the style through the palette, and is where it is in bytes. */
/* wire 3.4 */
void test_lines_in_rgb565(void)
{
    for (uint32_t set = 0; set < OUTLINES; set++) {
        draw(set | OUTLINES, all);
        start(true, set | OUTLINES);
        memset(pixels, 0, sizeof pixels);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, pixels, WIDTH));
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL_HEX16(colours[all[i]], pixels[i]);
        }
    }
}

/* Bands and display lists of any size, and another core's workspace. */
/* wire 3.3 */
void test_deliveries(void)
{
    static uint64_t memory[64];
    fxl_workspace workspace;
    for (uint32_t words = 0; words <= 128; words += 32) {
        start(false, OUTLINES | SURFACES | BILLBOARDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&made->renderer, &depth_scene_eye, made->frame,
                                             WIDTH));
        depth_scene_draw_in_bands(made, 4, words);
        depth_scene_draw_in_bands(made, HEIGHT, words);
        const fxl_band band = {.pixels = all, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&workspace, &made->renderer, memory,
                                                     sizeof memory));
        fxl_fill_band(&band, DEPTH_SCENE_BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&made->renderer, &workspace, &band));
        TEST_ASSERT_EQUAL_MEMORY(made->frame, all, sizeof all);
    }
}
