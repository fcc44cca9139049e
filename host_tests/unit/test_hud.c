/* SPDX-License-Identifier: MIT */
/* What the first program draws, a cube in front of a background, with a small display over it: the
 * same pixels on every board, whole and in bands. */
#include "hud.h"
#include "tiny.h"

enum {
    WIDTH = 80,
    HEIGHT = 48,
    BAND = 5
};

#define PICTURE 0x008942FEu /* CRC-32 */

static const hud_colours colours = {250, 251, 252, 253, 254};
static uint8_t pixels[HEIGHT][WIDTH];
static uint64_t memory[40];
static fxl_renderer renderer;

static void start(fxl_pose *eye)
{
    const fxl_config config = fxl_config_default(WIDTH, HEIGHT);
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

/* overlay 1.4 */
void test_the_picture_is_that_of_every_board(void)
{
    const fxl_band whole = {.pixels = pixels[0], .width = WIDTH, .stride = WIDTH, .first_row = 0,
                            .rows = HEIGHT};
    fxl_pose eye;
    start(&eye);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, pixels[0], WIDTH));
    TEST_ASSERT_TRUE(hud_draw(&whole, WIDTH, HEIGHT, "01230", &colours));
    TEST_ASSERT_EQUAL_HEX32(PICTURE, unit_crc32(pixels[0], sizeof pixels));
}

/* overlay 1.1 */
void test_bands_have_the_pixels_of_the_whole(void)
{
    fxl_pose eye;
    start(&eye);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    for (uint16_t row = 0; row < HEIGHT; row += BAND) {
        const uint16_t rows = row + BAND <= HEIGHT ? BAND : HEIGHT - row;
        const fxl_band band = {.pixels = pixels[row], .width = WIDTH, .stride = WIDTH,
                               .first_row = row, .rows = rows};
        fxl_fill_band(&band, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_TRUE(hud_draw(&band, WIDTH, HEIGHT, "01230", &colours));
    }
    TEST_ASSERT_EQUAL_HEX32(PICTURE, unit_crc32(pixels[0], sizeof pixels));
}
