/* SPDX-License-Identifier: MIT */
/* What a first program calls: constants, a configuration, one block of memory, whole frames; and
 * what it draws with a small display over it. */
#include <string.h>

#include "fixel.h"
#include "tiny.h"
#include "unity.h"
#include "hud.h"

/* What a first program calls: constants, a configuration, one block of memory, whole frames. */

enum {
    WIDTH = 48,
    HEIGHT = 32,
    LARGE = 4096
};

static uint64_t block[LARGE / 8];
static uint8_t pixels[HEIGHT][WIDTH], other[HEIGHT][WIDTH];
static fxl_renderer renderer;
static fxl_scene scene;

/* Constant expressions, in C and C++. */
FXL_STATIC_ASSERT(FXL_UNITS(1) == 65536 && FXL_UNITS(-8) == -524288, "units");
FXL_STATIC_ASSERT(FXL_RATIO(1, 4) == 16384 && FXL_RATIO(-1, 3) == -21845, "ratios");
FXL_STATIC_ASSERT(FXL_DEGREES(90) == FXL_ANGLE_QUARTER, "degrees");

void setUp(void)
{
    tiny_scene *made = tiny_make();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    scene = made->scene;
    memset(&renderer, 0, sizeof renderer);
    memset(pixels, 0xEE, sizeof pixels);
}

void test_ratios_are_rounded_to_the_nearest_halves_upward(void)
{
    TEST_ASSERT_EQUAL_INT32(43691, FXL_RATIO(2, 3));
    TEST_ASSERT_EQUAL_INT32(-43691, FXL_RATIO(-2, 3));
    TEST_ASSERT_EQUAL_INT32(1, FXL_RATIO(1, 131072));
    TEST_ASSERT_EQUAL_INT32(0, FXL_RATIO(-1, 131072));
    TEST_ASSERT_EQUAL_INT32(32767 * 65536, FXL_RATIO(32767, 1));
}

void test_degrees_are_rounded_and_wrap(void)
{
    TEST_ASSERT_EQUAL_HEX32(11930465, FXL_DEGREES(1));
    TEST_ASSERT_EQUAL_HEX32(0u - 11930465u, FXL_DEGREES(-1));
    TEST_ASSERT_EQUAL_HEX32(0, FXL_DEGREES(360));
    TEST_ASSERT_EQUAL_HEX32(FXL_DEGREES(330), FXL_DEGREES(-30));
    /* 12 / 360 of 2^32 is 143165576.53: either sign to the nearest. */
    TEST_ASSERT_EQUAL_HEX32(143165577, FXL_DEGREES(12));
    TEST_ASSERT_EQUAL_HEX32(0u - 143165577u, FXL_DEGREES(-12));
}

void test_the_default_configuration_is_in_range(void)
{
    fxl_config config = fxl_config_default(320, 240);
    TEST_ASSERT_EQUAL_UINT16(320, config.width);
    TEST_ASSERT_EQUAL_UINT16(240, config.height);
    /* 60 degrees are a sixth of 2^32. The rest is what render.h promises. */
    TEST_ASSERT_EQUAL_HEX32(715827883, config.fov);
    TEST_ASSERT_EQUAL_INT32(65536 / 4, config.near_z);
    TEST_ASSERT_EQUAL_INT32(65536 * 256, config.far_z);
    TEST_ASSERT_EQUAL_INT32(0, config.inset);
    TEST_ASSERT_EQUAL_UINT8(0, config.background);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, LARGE));
}

/* What begins elsewhere than at a multiple of eight, is too small, or out of range. */
void test_what_cannot_be_is_refused_and_changes_nothing(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    const fxl_renderer before = renderer;
    fxl_scene unchecked = scene;
    unchecked.draw_list_needed = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(NULL, &scene, &config, block, LARGE));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(&renderer, NULL, &config, block, LARGE));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(&renderer, &scene, NULL, block, LARGE));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init(&renderer, &scene, &config, NULL, LARGE));
    for (uint32_t off = 1; off < 8; off++) {
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_renderer_init(&renderer, &scene, &config,
                                                             (uint8_t *)block + off, LARGE - 8));
    }
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_init(&renderer, &unchecked, &config, block, LARGE));
    config.near_z = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_renderer_init(&renderer, &scene, &config, block, LARGE));
    TEST_ASSERT_EQUAL_MEMORY(&before, &renderer, sizeof renderer);
}

void test_a_block_that_is_too_small_says_by_how_much(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    const uint32_t least =
        (scene.draw_list_needed * (uint32_t)sizeof(fxl_draw_entry) + 7u) / 8u * 8u;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                      fxl_renderer_init(&renderer, &scene, &config, block, least - 3));
    TEST_ASSERT_EQUAL_UINT32(3, renderer.memory_missing);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_init(&renderer, &scene, &config, block, 0));
    TEST_ASSERT_EQUAL_UINT32(least, renderer.memory_missing);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, least));
}

/* The order of one instance of a convex model has one entry. */
void test_the_smallest_scene(void)
{
    const fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    scene.instance_count = 1;
    scene.draw_list_needed = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, LARGE));
    TEST_ASSERT_EQUAL_UINT32(1, renderer.instance_capacity);
}

/* No table reaches into another or beyond the block, whatever its size. */
void test_the_block_is_divided_without_overlap(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    for (uint32_t size = 16; size <= LARGE; size += 4) {
        if (fxl_renderer_init(&renderer, &scene, &config, block, size) != FXL_OK) {
            continue;
        }
        const uint8_t *end = (const uint8_t *)block + size;
        const uint8_t *cache = (const uint8_t *)renderer.workspace.cache.entries;
        const uint8_t *list = (const uint8_t *)renderer.frame.display_list.words;
        const uint8_t *order_end =
            (const uint8_t *)(renderer.frame.draw_list + scene.draw_list_needed);
        TEST_ASSERT_TRUE((const uint8_t *)renderer.frame.draw_list == (const uint8_t *)block);
        TEST_ASSERT_TRUE(list >= order_end &&
                         list + 4 * (size_t)renderer.frame.display_list.capacity <= end);
        if (renderer.workspace.cache.entries != NULL) {
            TEST_ASSERT_TRUE(cache >= order_end &&
                             (const uint8_t *)(renderer.workspace.cache.entries +
                                               renderer.workspace.cache.mask + 1) <= list);
        }
    }
}

/* The cache has a power of two of entries that is enough for the largest model's 8 vertices, or
 * as many as fit a quarter of the memory beside the order. All else is the display list. */
void test_how_the_block_is_divided(void)
{
    const fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    const size_t order = (scene.draw_list_needed * sizeof(fxl_draw_entry) + 7) / 8 * 8;
    for (uint32_t entries = 0; entries <= 16; entries = entries == 0 ? 1 : 2 * entries) {
        const size_t size = order + 4 * entries * sizeof(fxl_cached_vertex);
        const uint32_t kept = entries < 8 ? entries : 8;
        TEST_ASSERT_TRUE(size + 64 <= LARGE);
        for (size_t more = 0; more <= 8; more += 8) {
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_renderer_init(&renderer, &scene, &config, block, size + more));
            TEST_ASSERT_EQUAL_UINT32(kept == 0 ? 0 : kept - 1, renderer.workspace.cache.mask);
            TEST_ASSERT_EQUAL_UINT32((size + more - order - kept * sizeof(fxl_cached_vertex)) / 4,
                                     renderer.frame.display_list.capacity);
        }
        if (entries > 0 && entries <= 8) { /* a byte less is half as many */
            TEST_ASSERT_EQUAL(FXL_OK,
                              fxl_renderer_init(&renderer, &scene, &config, block, size - 1));
            TEST_ASSERT_EQUAL_UINT32(entries < 4 ? 0 : entries / 2 - 1,
                                     renderer.workspace.cache.mask);
        }
    }
}

/* SPEC 4.1b */
void test_a_frame_is_the_same_whatever_the_block(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    config.background = 9;
    fxl_pose eye = {.position = {0, FXL_UNITS(1), FXL_UNITS(-6)}, .pitch = FXL_DEGREES(-8)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, LARGE));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels[0], WIDTH));
    TEST_ASSERT_TRUE(renderer.workspace.counters.drawn > 0);
    /* One band is drawn without the list; its room is there for the next frame. */
    TEST_ASSERT_EQUAL_UINT32(0, renderer.frame.display_list.used);
    TEST_ASSERT_TRUE(renderer.frame.display_list.capacity > 0);
    memcpy(other, pixels, sizeof pixels);
    const fxl_band whole = UNIT_BAND(pixels[0], WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    TEST_ASSERT_TRUE(renderer.frame.display_list.used > 0);
    fxl_fill_band(&whole, 9);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &whole));
    TEST_ASSERT_EQUAL_MEMORY(other, pixels, sizeof pixels);
    for (uint32_t size = 64; size < LARGE; size = size * 2 + 12) {
        if (fxl_renderer_init(&renderer, &scene, &config, block, size) == FXL_OK) {
            memset(pixels, 0xEE, sizeof pixels);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels[0], WIDTH));
            TEST_ASSERT_EQUAL_MEMORY(other, pixels, sizeof pixels);
        }
    }
    TEST_ASSERT_EQUAL_UINT8(9, other[0][0]);
}

void test_a_frame_that_cannot_be_leaves_the_pixels(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    fxl_pose eye = {.position = {0, 0, FXL_UNITS(-6)}};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_render(NULL, &eye, pixels[0], WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, block, LARGE));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_render(&renderer, NULL, pixels[0], WIDTH));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_render(&renderer, &eye, NULL, WIDTH));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_render(&renderer, &eye, pixels[0], WIDTH - 1));
    eye.position.x = FXL_COORDINATE_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_render(&renderer, &eye, pixels[0], WIDTH));
    TEST_ASSERT_EQUAL_UINT32(4, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EACH_EQUAL_UINT8(0xEE, pixels, sizeof pixels);
}

/* What the first program draws, a cube in front of a background, with a small display over it: the
 * same hud_pixels on every board, whole and in bands. */

enum {
    HUD_WIDTH = 80,
    HUD_HEIGHT = 48,
    BAND = 5
};

#define PICTURE 0x008942FEu /* CRC-32 */

static const hud_colours colours = {250, 251, 252, 253, 254};
static uint8_t hud_pixels[HUD_HEIGHT][HUD_WIDTH];
static uint64_t memory[40];

static void start(fxl_pose *eye)
{
    const fxl_config config = fxl_config_default(HUD_WIDTH, HUD_HEIGHT);
    tiny_scene *tiny = tiny_make();
    tiny->scene.instance_count = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &tiny->scene, &config, memory, sizeof memory));
    memset(eye, 0, sizeof *eye);
    eye->position.y = FXL_UNITS(1);
    eye->position.z = FXL_UNITS(-4);
    eye->pitch = FXL_DEGREES(-12);
}

/* overlay 1.4a */
void test_the_picture_is_that_of_every_board(void)
{
    const fxl_band whole = UNIT_BAND(hud_pixels[0], HUD_WIDTH, 0, HUD_HEIGHT);
    fxl_pose eye;
    start(&eye);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, hud_pixels[0], HUD_WIDTH));
    TEST_ASSERT_TRUE(hud_draw(&whole, HUD_WIDTH, HUD_HEIGHT, "01230", &colours));
    TEST_ASSERT_EQUAL_HEX32(PICTURE, unit_crc32(hud_pixels[0], sizeof hud_pixels));
}

/* overlay 1.1c */
void test_bands_have_the_pixels_of_the_whole(void)
{
    fxl_pose eye;
    start(&eye);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint16_t row = 0; row < HUD_HEIGHT; row += BAND) {
        const uint16_t rows = row + BAND <= HUD_HEIGHT ? BAND : HUD_HEIGHT - row;
        const fxl_band band = UNIT_BAND(hud_pixels[row], HUD_WIDTH, row, rows);
        fxl_fill_band(&band, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_TRUE(hud_draw(&band, HUD_WIDTH, HUD_HEIGHT, "01230", &colours));
    }
    TEST_ASSERT_EQUAL_HEX32(PICTURE, unit_crc32(hud_pixels[0], sizeof hud_pixels));
}
