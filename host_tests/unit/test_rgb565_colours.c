/* SPDX-License-Identifier: MIT */
/* The colours of frames of 16 bits a pixel: light and blending, channel by channel. */
#include "rgb565_scene.h"

void setUp(void)
{
    walls_make();
}

/* --- colours ------------------------------------------------------------------------------ */

typedef struct {
    int channel[3];
} channels;

static channels split(uint16_t colour)
{
    return (channels){{colour >> 11, colour >> 5 & 63, colour & 31}};
}

static const int most[3] = {31, 63, 31};

/* A face of a colour of its own over a background, for many of both. */
static void check_blend(uint8_t flags, int (*rule)(int above, int beneath, int largest))
{
    walls.face_map[0] = 0;
    walls.face_map[1] = 2;
    walls.surface[1].flags = flags;
    walls_begin();
    for (uint32_t round = 0; round < UNIT_REPEAT / 200; round++) {
        const uint16_t above = (uint16_t)unit_random(), beneath = (uint16_t)(unit_random() >> 16);
        walls.palette[20] = walls.palette[22] = walls.palette[BACKGROUND] = beneath;
        walls.palette[21] = above;
        uint32_t blended = 0;
        uint16_t expected = 0;
        const channels a = split(above), b = split(beneath);
        for (int i = 0; i < 3; i++) {
            expected = (uint16_t)(expected << (i == 1 ? 6 : 5) |
                                  rule(a.channel[i], b.channel[i], most[i]));
        }
        walls_draw(walls.pixels);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            blended += walls.pixels[i] != beneath;
            TEST_ASSERT_TRUE(walls.pixels[i] == beneath || walls.pixels[i] == expected);
        }
        TEST_ASSERT_TRUE(expected == beneath || blended > WIDTH * HEIGHT / 9);
    }
}

static int own_sixteenths;

static int share(int above, int beneath, int largest)
{
    (void)largest;
    return (own_sixteenths * above + (16 - own_sixteenths) * beneath) / 16;
}

static int sum(int above, int beneath, int largest)
{
    return above + beneath > largest ? largest : above + beneath;
}

/* Without a number it is half. */
/* rgb565 2.2a */
void test_sixteenths_of_each_channel(void)
{
    for (uint8_t sixteenths = 0; sixteenths <= 16; sixteenths++) {
        own_sixteenths = sixteenths == 0 ? 8 : sixteenths;
        walls.surface[1].sixteenths = sixteenths;
        check_blend(FXL_SURFACE_BLEND, share);
    }
}

/* rgb565 2.3a */
void test_channels_are_added_up_to_the_largest(void)
{
    check_blend(FXL_SURFACE_ADD, sum);
}

/* rgb565 2.1a-b, 2.1g, SPEC 9.6j */
void test_light_takes_a_part_of_each_channel(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(64)];
    const uint16_t dark = 0x8A35;
    walls_hide_others(walls.palette[BACKGROUND]);
    walls.face_map[1] = 2;
    walls.surface[1].flags = FXL_SURFACE_LIT;
    walls_begin();
    for (uint32_t round = 0; round < 300; round++) {
        /* brightness = sixteenths / 16: the light of a corner is exact then, but for half a unit */
        const int sixteenths = unit_between(0, 16), levels = unit_between(2, 64);
        const fxl_light_settings settings = {
            .ambient = FXL_Q2_30_ONE / 16 * sixteenths, .ramp = ramp, .levels = (uint8_t)levels, .dark = dark};
        walls_light(&settings);
        walls.palette[21] = (uint16_t)unit_random();
        const channels a = split(walls.palette[21]), d = split(dark);
        uint32_t lit = 0;
        walls_draw(walls.pixels);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const channels seen = split(walls.pixels[i]);
            if (walls.pixels[i] == walls.palette[BACKGROUND]) {
                continue;
            }
            lit++;
            for (int k = 0; k < 3; k++) {
                /* half for the channel's rounding, and 1.63 / 256 at most for the part's */
                const double exact =
                    d.channel[k] + (a.channel[k] - d.channel[k]) * sixteenths / 16.0;
                TEST_ASSERT_NEAR(exact, seen.channel[k], 0.5 + 63 * 1.63 / 256);
                TEST_ASSERT_TRUE(sixteenths % 16 != 0 || seen.channel[k] == exact);
            }
        }
        TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 9, lit);
    }
}

/* place light: definition: left_of, the part in RGB565; rows of it */
/* What is left of a colour in a light without direction. */
static uint16_t left_of(uint16_t colour, uint16_t dark, double brightness)
{
    const channels c = split(colour), d = split(dark);
    const double part = (int)(brightness * 256 + 0.5) / 256.0;
    uint16_t left = 0;
    for (int i = 0; i < 3; i++) {
        const double exact = d.channel[i] + (c.channel[i] - d.channel[i]) * part;
        left = (uint16_t)(left << (i == 1 ? 6 : 5) | (int)(exact + 0.5));
    }
    return left;
}

/* The frame that was begun, in bands of five rows and in two workspaces. */
static void draw_bands(uint16_t *to)
{
    static fxl_workspace other;
    static FXL_ALIGN_8 uint8_t other_memory[3000];
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &walls.renderer, other_memory,
                                                 sizeof other_memory));
    for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + 5)) {
        const fxl_band band = {.pixels = (uint8_t *)(to + row * WIDTH),
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = row,
                               .rows = (uint16_t)(HEIGHT - row < 5 ? HEIGHT - row : 5),
                               .palette = walls.palette};
        fxl_workspace *workspace = row % 10 == 0 ? &walls.renderer.workspace : &other;
        fxl_frame_fill(&walls.renderer, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_with(&walls.renderer, workspace, &band));
    }
}

/* The frame in bands, with a display list of three sizes. */
static void assert_bands_are_equal(void)
{
    for (uint32_t words = 0; words <= 120; words += 60) {
        walls.renderer.frame.display_list.capacity = words;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
        memset(walls.again, 0, sizeof walls.again);
        draw_bands(walls.again);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
    }
}

/* Each pixel is the background, or what is left of a wall's colour at a brightness. */
static void assert_walls(uint16_t dark, double brightness)
{
    uint32_t seen[3] = {0, 0, 0};
    uint16_t expected[3];
    for (uint32_t k = 0; k < 3; k++) {
        expected[k] = left_of(walls.palette[20 + k], dark, brightness);
    }
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint16_t pixel = walls.pixels[i];
        uint32_t k = 0;
        while (k < 3 && pixel != expected[k]) {
            k++;
        }
        if (pixel != walls.palette[BACKGROUND]) {
            TEST_ASSERT_LESS_THAN(3, k);
            seen[k]++;
        }
    }
    /* Light may make colours equal. */
    TEST_ASSERT_TRUE(brightness < 1 || (seen[0] > 300 && seen[1] > 300));
}

/* rgb565 2.1b, 2.1f, 3.4a-b */
void test_flat_faces_lose_a_part_of_each_channel(void)
{
    static const fxl_target *const targets[] = {&fxl_rgb565, &fxl_rgb565_depth_16,
                                                &fxl_rgb565_depth_32};
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    static fxl_light light;
    for (uint32_t round = 0; round < UNIT_REPEAT / 500; round++) {
        const fxl_q2_30 brightness = round < 2 ? (int32_t)round * FXL_Q2_30_ONE
                                               : unit_between(0, FXL_Q2_30_ONE);
        const uint16_t dark = (uint16_t)unit_random();
        const fxl_light_settings settings = {
            .ambient = brightness, .ramp = ramp, .levels = 2, .dark = dark};
        walls_start(targets[round % 3]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&walls.renderer, &light, &settings));
        walls_draw(walls.pixels);
        assert_walls(dark, brightness / 1073741824.0);
        assert_bands_are_equal();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&walls.renderer, NULL, NULL));
        walls_draw(walls.pixels);
        assert_walls(dark, 1);
        assert_bands_are_equal();
    }
}

static bool is_wall(uint16_t pixel)
{
    return pixel != walls.palette[0] && pixel != walls.palette[BACKGROUND];
}

/* The second wall, lit and white. White stays grey: half a step of each channel. */
static void draw_white_wall(const fxl_light_settings *settings)
{
    walls_hide_others(walls.palette[BACKGROUND]);
    walls.face_map[1] = 2;
    walls.surface[1].flags = FXL_SURFACE_LIT;
    walls.palette[21] = FXL_RGB565(255, 255, 255);
    walls_begin();
    walls_light(settings);
    walls_draw(walls.pixels);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const channels colour = split(walls.pixels[i]);
        if (is_wall(walls.pixels[i])) {
            TEST_ASSERT_INT_WITHIN((63 + 31) / 2, colour.channel[1] * 31, colour.channel[0] * 63);
        }
    }
}

/* Light between the corners is not of the ramp's few levels alone. */
/* rgb565 2.1g */
void test_light_is_smooth_between_two_levels(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    const fxl_light_settings settings = {
        .point_count = 1,
        .ramp = ramp,
        .levels = 2,
        .points = {{{Q16(-2), Q16(4), Q16(4.5)}, Q16(8), FXL_Q2_30_ONE}}};
    bool seen[64] = {false};
    int shades = 0;
    draw_white_wall(&settings);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        if (is_wall(walls.pixels[i])) {
            const channels colour = split(walls.pixels[i]);
            shades += !seen[colour.channel[1]];
            seen[colour.channel[1]] = true;
        }
    }
    TEST_ASSERT_GREATER_THAN(8, shades);
}

/* At the corner that the map has not, light would be twice that of full light. */
/* rgb565 2.1c */
void test_light_beyond_the_corners_is_held(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    const fxl_light_settings settings = {
        .direction = {0, 0, FXL_Q2_30_ONE}, .strength = FXL_Q2_30_ONE, .ramp = ramp, .levels = 2};
    uint32_t full = 0;
    walls.mapped_corners[1][1].normal = 1;
    draw_white_wall(&settings);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        full += is_wall(walls.pixels[i]) && walls.pixels[i] == walls.palette[21];
    }
    TEST_ASSERT_GREATER_THAN(40, full);
}

/* The same bits on the host and on every board. */
void test_a_frame_of_all_is_as_it_was(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(5)];
    const fxl_light_settings settings = {
        .ambient = Q30(0.125),
        .point_count = 1,
        .ramp = ramp,
        .levels = 5,
        .dark = 0x1234,
        .points = {{{Q16(-1), Q16(1), Q16(3)}, Q16(9), FXL_Q2_30_ONE}}};
    walls.surface[0].flags = FXL_SURFACE_LIT;
    walls.surface[1].flags = FXL_SURFACE_BLEND;
    walls.surface[1].opacity = 13;
    walls.face_map[1] = 2;
    walls_begin();
    walls_light(&settings);
    walls_draw(walls.pixels);
    TEST_ASSERT_EQUAL_HEX32(0xD13BAA3D,
                            unit_crc32((const uint8_t *)walls.pixels, sizeof walls.pixels));
}
