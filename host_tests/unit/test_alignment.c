/* SPDX-License-Identifier: MIT */
/* What docs/safety/constraints.md M2 says of palettes, pixels and tables: at each place where they may
 * not begin they are refused, and at the others they are taken. */
#include "fixel/line.h"
#include "tiny.h"

enum {
    WIDTH = 16,
    HEIGHT = 8
};

/* What is moved by some bytes. */
enum {
    PIXELS,
    PALETTE,
    OUT,
    BEAMS,
    MEMORY
};

static fxl_renderer renderer;
static FXL_ALIGN_8 uint8_t memory[4096], room[8192], pixels[2 * WIDTH * HEIGHT + 8];
static FXL_ALIGN_8 uint8_t colours[2 * 256 + 8], beams[2 * sizeof(fxl_beam)];
static uint8_t lit[256];
static fxl_beam beam;

static void *moved(uint8_t *memory_of, int what, int moves, size_t by)
{
    return memory_of + (what == moves ? by : 0);
}

static fxl_band band_of(int what, size_t by)
{
    const fxl_band band = {.pixels = (uint8_t *)moved(pixels, what, PIXELS, by),
                           .width = WIDTH,
                           .stride = WIDTH,
                           .rows = HEIGHT,
                           .palette = (const uint16_t *)moved(colours, what, PALETTE, by)};
    return band;
}

static void start(void)
{
    static tiny_scene *tiny;
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_rgb565);
    tiny = tiny_make();
    config.palette = (const uint16_t *)(const void *)colours;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &tiny->scene, &config, memory,
                                                sizeof memory));
}

static fxl_status draw(int what, size_t by)
{
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    const fxl_band band = band_of(what, by);
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    fxl_frame_fill(&renderer, &band, 1);
    const fxl_status status = fxl_frame_draw(&renderer, &band);
    const char *sentence = fxl_frame_explain(&renderer, &band);
    TEST_ASSERT_EQUAL(status == FXL_OK, sentence == NULL);
    return status;
}

static fxl_status draw_wire(int what, size_t by)
{
    static fxl_wire wire;
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, Q16(-6)}, 0, 0, 0};
    const fxl_band band = band_of(what, by);
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, renderer.scene, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    return fxl_wire_draw(&wire, &band);
}

static fxl_status draw_rectangle(int what, size_t by)
{
    const fxl_band band = band_of(what, by);
    return fxl_draw_rectangle(&band, 0, 0, 5, 5, 3);
}

static fxl_status find_crc(int what, size_t by)
{
    uint32_t crc = FXL_CRC_START;
    const fxl_band band = band_of(what, by);
    return fxl_band_crc(&crc, &band);
}

static fxl_status convert(int what, size_t by)
{
    static const uint8_t palette[3 * 256];
    static fxl_pixels format;
    const fxl_band band = band_of(what, by);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pixels_init(&format, &fxl_pixels_rgb565, palette));
    return fxl_pixels_convert(&format, &band, moved(room, what, OUT, by), sizeof room - 8);
}

static bool start_to_send(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes,
                          size_t size)
{
    (void)user;
    (void)first_row;
    return bytes != NULL && size > 0 && rows > 0;
}

static bool wait_for_it(void *user)
{
    (void)user;
    return true;
}

static fxl_status set_up_pump(int what, size_t by)
{
    static fxl_pump pump;
    const fxl_pump_config config = {.width = WIDTH,
                                    .height = HEIGHT,
                                    .rows = 4,
                                    .palette = (const uint16_t *)moved(colours, what, PALETTE, by)};
    const fxl_pump_sink sink = {.start = start_to_send, .wait = wait_for_it};
    return fxl_pump_init(&pump, &config, &sink, moved(room, what, MEMORY, by), sizeof room - 8);
}

static fxl_status attach(int what, size_t by)
{
    const fxl_beam_set set = {(const fxl_beam *)memcpy(moved(beams, what, BEAMS, by), &beam,
                                                       sizeof beam),
                              1, lit};
    start();
    return fxl_attach_beams(&renderer, &set, moved(room, what, MEMORY, by), sizeof room - 8);
}

void test_each_place_is_taken_or_refused(void)
{
    const fxl_point from = {0, Q16(8), Q16(3)};
    const fxl_point window[] = {{Q16(-2), 0, Q16(1)},
                                {Q16(-2), 0, Q16(6)},
                                {Q16(2), 0, Q16(6)},
                                {Q16(2), 0, Q16(1)}};
    const struct {
        fxl_status (*call)(int what, size_t by);
        int what;
        size_t aligned;
    } cases[] = {{draw, PIXELS, 2},           {draw, PALETTE, 2},        {draw_wire, PIXELS, 2},
                 {draw_wire, PALETTE, 2},     {draw_rectangle, PIXELS, 2}, {draw_rectangle, PALETTE, 2},
                 {find_crc, PIXELS, 2},       {find_crc, PALETTE, 2},    {convert, PIXELS, 2},
                 {convert, PALETTE, 2},       {convert, OUT, 4},         {set_up_pump, PALETTE, 2},
                 {set_up_pump, MEMORY, 8},    {attach, BEAMS, 4},        {attach, MEMORY, 8}};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (size_t by = 0; by < 8; by++) {
            memset(pixels, 0x5A, sizeof pixels);
            TEST_ASSERT_EQUAL_MESSAGE(by % cases[i].aligned == 0 ? FXL_OK : FXL_E_ALIGNMENT,
                                      cases[i].call(cases[i].what, by), "an address");
            if (by % cases[i].aligned != 0) {
                TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, pixels, sizeof pixels);
            }
        }
    }
}
