/* SPDX-License-Identifier: MIT */
/* Frames of 16 bits a pixel: against those of a palette, and against each rule channel by channel.
 */
#include "unit.h"

enum {
    WIDTH = 50,
    HEIGHT = 34,
    BACKGROUND = 3,
    GUARD = 0xA5A5
};

/* Three walls one behind the other, each of a model of its own: 0 has the texture, 1 its own
 * colour, 2 one behind both. */
static const fxl_point vertices[] = {
    {Q16(-4), Q16(3), Q16(6)},  {Q16(4), Q16(3), Q16(6)},   {Q16(4), Q16(-3), Q16(6)},
    {Q16(-4), Q16(-3), Q16(6)}, {Q16(-2), Q16(4), Q16(5)},  {Q16(1), Q16(2), Q16(5)},
    {Q16(1), Q16(-2), Q16(5)},  {Q16(-2), Q16(-3), Q16(5)}, {Q16(-9), Q16(1), Q16(12)},
    {Q16(9), Q16(1), Q16(12)},  {Q16(9), Q16(-1), Q16(12)}, {Q16(-9), Q16(-1), Q16(12)}};
static const uint16_t indices[] = {0, 1, 2, 3};
static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 0, 4, 20, 0},
                                 {{0, 0, -FXL_Q2_30_ONE}, 0, 4, 21, 0},
                                 {{0, 0, -FXL_Q2_30_ONE}, 0, 4, 22, 0}};
static const fxl_model models[] = {{.first_vertex = 0,
                                    .vertex_count = 4,
                                    .first_face = 0,
                                    .face_count = 1,
                                    .kind = FXL_MODEL_CONVEX,
                                    .radius = Q16(8)},
                                   {.first_vertex = 4,
                                    .vertex_count = 4,
                                    .first_face = 1,
                                    .face_count = 1,
                                    .kind = FXL_MODEL_CONVEX,
                                    .radius = Q16(7)},
                                   {.first_vertex = 8,
                                    .vertex_count = 4,
                                    .first_face = 2,
                                    .face_count = 1,
                                    .kind = FXL_MODEL_CONVEX,
                                    .radius = Q16(16)}};
static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 0}, {{0, 0, 0}, 2, 0, 0}};
static const fxl_direction normals[] = {{0, 0, -FXL_Q2_30_ONE}, {0, 0, FXL_Q2_30_ONE}};
static const fxl_pose eye = {{Q16(0.3), Q16(0.2), 0}, 1 << 26, 0, 1 << 27};

static uint8_t texels[16 * 16 + 8 * 8];
static uint16_t texels_565[16 * 16 + 8 * 8], palette[256];
static fxl_texture texture;
static fxl_surface surface[2];
static fxl_mapped_face mapped[2];
static uint16_t face_map[3];
static fxl_surface_set set;
static fxl_scene scene;
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_rgb565_frame frame;
static FXL_ALIGN_8 uint8_t memory[3000];
static uint8_t indexed[HEIGHT * WIDTH];
static uint16_t pixels[HEIGHT * WIDTH], again[HEIGHT * WIDTH];

static void make_texture(uint8_t format)
{
    texture = (fxl_texture){
        .texels = texels, .log_width = 4, .log_height = 4, .format = format, .levels = 2};
    if (format == FXL_TEXTURE_565) {
        texture.texels = (const uint8_t *)(const void *)texels_565;
    }
}

void setUp(void)
{
    scene = (fxl_scene){.vertices = vertices,
                        .indices = indices,
                        .faces = faces,
                        .models = models,
                        .instances = instances,
                        .vertex_count = 12,
                        .index_count = 4,
                        .face_count = 3,
                        .model_count = 3,
                        .instance_count = 3};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 40503u + 11);
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(i * 7 + (i >> 4) * 3);
        texels_565[i] = palette[texels[i]];
    }
    make_texture(FXL_TEXTURE_565);
    surface[0] = (fxl_surface){.texture = 1, .opacity = 16};
    surface[1] = (fxl_surface){.opacity = 16};
    for (uint16_t i = 0; i < 2; i++) {
        mapped[i] = (fxl_mapped_face){.surface = i,
                                      .corners = {0, 1, 2},
                                      .texels = {{0, 0}, {Q16(40), 0}, {Q16(40), Q16(24)}}};
    }
    face_map[0] = 1;
    face_map[1] = face_map[2] = 0;
    set = (fxl_surface_set){.textures = &texture,
                            .surfaces = surface,
                            .faces = mapped,
                            .face_map = face_map,
                            .normals = normals,
                            .texture_count = 1,
                            .surface_count = 2,
                            .face_count = 2,
                            .normal_count = 2};
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    config.background = BACKGROUND;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
}

void tearDown(void)
{
}

static void begin(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_rgb565(&renderer, &frame, palette, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_surfaces_rgb565(&renderer, &surfaces, &set));
}

static void draw(uint16_t *to)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render_rgb565(&renderer, &eye, to, WIDTH));
}

/* The frame of the palette is drawn; that of 16 bits shows its colours. */
static void check_against_palette(void)
{
    uint32_t textured = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_surfaces(&renderer, &surfaces, &set));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, indexed, WIDTH));
    const uint8_t flags = texture.flags;
    make_texture(FXL_TEXTURE_565);
    texture.flags = flags;
    begin();
    draw(pixels);
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            TEST_ASSERT_EQUAL_HEX16(palette[indexed[y * WIDTH + x]], pixels[y * WIDTH + x]);
            textured += indexed[y * WIDTH + x] != BACKGROUND && indexed[y * WIDTH + x] != 21 &&
                        indexed[y * WIDTH + x] != 22;
        }
    }
    TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 6, textured);
}

/* --- texels ------------------------------------------------------------------------------ */

void test_texels_are_those_of_a_palette(void)
{
    for (uint8_t division = FXL_DIVIDE_16; division <= FXL_AFFINE; division++) {
        for (uint8_t flags = 0; flags < 2; flags++) {
            make_texture(FXL_TEXTURE_8);
            texture.flags = flags;
            surface[0].division = division;
            /* the kernel, which paints opaque faces of a palette, rounds in another unit */
            surface[0].opacity = (uint8_t)(division == FXL_DIVIDE_1 ? 16 : 15 - 5 * flags);
            check_against_palette();
        }
    }
}

void test_the_second_level_is_found(void)
{
    make_texture(FXL_TEXTURE_8);
    mapped[0].texels[1].u = mapped[0].texels[2].u = Q16(200);
    mapped[0].texels[2].v = Q16(120);
    memset(texels, 9, 256);
    check_against_palette();
}

void test_a_texel_of_the_key_is_not_drawn(void)
{
    begin();
    texture.flags = FXL_TEXTURE_KEYED;
    texture.key_565 = texels_565[33];
    draw(pixels);
    texture.flags = 0;
    draw(again);
    uint32_t holes = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint16_t with = pixels[i], without = again[i];
        holes += with != without;
        TEST_ASSERT_TRUE(without == texture.key_565 ? with != without || with == palette[21]
                                                    : with == without);
    }
    TEST_ASSERT_GREATER_THAN(2, holes);
}

void test_indices_take_their_colour_of_the_palette(void)
{
    static const uint8_t colours[16] = {30,  41,  52, 63, 74, 85, 96, 107,
                                        118, 129, 3,  5,  7,  9,  11, 13};
    make_texture(FXL_TEXTURE_8);
    begin();
    draw(pixels);
    make_texture(FXL_TEXTURE_565);
    draw(again);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(pixels, again, WIDTH * HEIGHT);
    make_texture(FXL_TEXTURE_4);
    texture.colours = colours;
    draw(pixels);
    for (uint32_t i = 0; i < 16 * 16; i++) {
        texels_565[i] = palette[colours[texels[i / 2] >> 4 * (i & 1) & 15]];
    }
    for (uint32_t i = 0; i < 8 * 8; i++) {
        texels_565[256 + i] = palette[colours[texels[128 + i / 2] >> 4 * (i & 1) & 15]];
    }
    make_texture(FXL_TEXTURE_565);
    draw(again);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(pixels, again, WIDTH * HEIGHT);
}

/* --- bands ------------------------------------------------------------------------------- */

void test_bands_and_lists_change_no_pixel(void)
{
    static fxl_workspace other;
    static FXL_ALIGN_8 uint8_t other_memory[3000];
    surface[1].flags = FXL_SURFACE_ADD;
    face_map[1] = 2;
    begin();
    draw(pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &renderer, other_memory, 3000));
    for (uint32_t words = 0; words < 3; words++) {
        renderer.frame.display_list.capacity = words * 40;
        memset(again, 0, sizeof again);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
        for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + 2)) {
            const fxl_band_565 band = {again + row * WIDTH, WIDTH, WIDTH, row, 2};
            fxl_fill_rgb565(&band, palette[BACKGROUND]);
            TEST_ASSERT_EQUAL(FXL_OK, row % 4
                                          ? fxl_frame_draw_rgb565(&renderer, &band)
                                          : fxl_frame_draw_rgb565_with(&renderer, &other, &band));
        }
        TEST_ASSERT_EQUAL_HEX16_ARRAY(pixels, again, WIDTH * HEIGHT);
    }
}

void test_no_other_byte_is_written(void)
{
    static uint16_t wide[HEIGHT * (WIDTH + 3)];
    begin();
    draw(pixels);
    for (uint32_t i = 0; i < HEIGHT * (WIDTH + 3); i++) {
        wide[i] = GUARD;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render_rgb565(&renderer, &eye, wide + 1, WIDTH + 3));
    for (uint32_t y = 0; y < HEIGHT; y++) {
        const uint16_t *row = wide + y * (WIDTH + 3);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[0]);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[WIDTH + 1]);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[WIDTH + 2]);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(pixels + y * WIDTH, row + 1, WIDTH);
    }
}

void test_bytes_are_swapped_for_a_display(void)
{
    uint16_t two[2][3] = {{0x1234, 0xF00D, 0x5555}, {0xABCD, 1, 0x7777}};
    const uint16_t swapped[2][3] = {{0x3412, 0x0DF0, 0x5555}, {0xCDAB, 0x0100, 0x7777}};
    const fxl_band_565 band = {two[0], 2, 3, 0, 2};
    fxl_swap_rgb565(&band);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(swapped[0], two[0], 6);
    TEST_ASSERT_EQUAL_HEX16(31 << 11 | 50 << 5 | 1, FXL_RGB565(255, 200, 15));
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
    face_map[0] = 0;
    face_map[1] = 2;
    surface[1].flags = flags;
    begin();
    for (uint32_t round = 0; round < 300; round++) {
        const uint16_t above = (uint16_t)unit_random(), beneath = (uint16_t)(unit_random() >> 16);
        palette[20] = palette[22] = palette[BACKGROUND] = beneath;
        palette[21] = above;
        uint32_t blended = 0;
        uint16_t expected = 0;
        const channels a = split(above), b = split(beneath);
        for (int i = 0; i < 3; i++) {
            expected = (uint16_t)(expected << (i == 1 ? 6 : 5) |
                                  rule(a.channel[i], b.channel[i], most[i]));
        }
        draw(pixels);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            blended += pixels[i] != beneath;
            TEST_ASSERT_TRUE(pixels[i] == beneath || pixels[i] == expected);
        }
        TEST_ASSERT_TRUE(expected == beneath || blended > WIDTH * HEIGHT / 9);
    }
}

static int half(int above, int beneath, int largest)
{
    (void)largest;
    return (above + beneath) / 2;
}

static int sum(int above, int beneath, int largest)
{
    return above + beneath > largest ? largest : above + beneath;
}

void test_half_of_each_channel(void)
{
    check_blend(FXL_SURFACE_BLEND, half);
}

void test_channels_are_added_up_to_the_largest(void)
{
    check_blend(FXL_SURFACE_ADD, sum);
}

void test_light_takes_a_part_of_each_channel(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(64)];
    static fxl_light light;
    const uint16_t dark = 0x8A35;
    face_map[0] = 0;
    face_map[1] = 2;
    surface[1].flags = FXL_SURFACE_LIT;
    begin();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_rgb565(&renderer, &frame, palette, dark));
    for (uint32_t round = 0; round < 300; round++) {
        /* brightness = sixteenths / 16: the light of a corner is exact then, but for half a unit */
        const int sixteenths = unit_between(0, 16), levels = unit_between(2, 64);
        const fxl_light_settings settings = {
            .ambient = FXL_Q2_30_ONE / 16 * sixteenths, .ramp = ramp, .levels = (uint8_t)levels};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_light(&renderer, &light, &settings));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_light_surfaces(&renderer, &light));
        palette[0] = palette[BACKGROUND]; /* what flat faces are by this ramp */
        palette[21] = (uint16_t)unit_random();
        const channels a = split(palette[21]), d = split(dark);
        uint32_t lit = 0;
        draw(pixels);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const channels seen = split(pixels[i]);
            if (pixels[i] == palette[BACKGROUND]) {
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

/* Light between the corners is not of the ramp's few levels alone. */
void test_light_is_smooth_between_two_levels(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    static fxl_light light;
    const fxl_light_settings settings = {
        .point_count = 1,
        .ramp = ramp,
        .levels = 2,
        .points = {{{Q16(-2), Q16(4), Q16(4.5)}, Q16(8), FXL_Q2_30_ONE}}};
    bool seen[64] = {false};
    int shades = 0;
    face_map[0] = 0;
    face_map[1] = 2;
    surface[1].flags = FXL_SURFACE_LIT;
    palette[21] = FXL_RGB565(255, 255, 255);
    begin();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_light(&renderer, &light, &settings));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_light_surfaces(&renderer, &light));
    draw(pixels);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const channels colour = split(pixels[i]);
        if (pixels[i] != palette[0] && pixels[i] != palette[BACKGROUND]) {
            /* white stays grey: half a step of each channel */
            TEST_ASSERT_INT_WITHIN((63 + 31) / 2, colour.channel[1] * 31, colour.channel[0] * 63);
            shades += !seen[colour.channel[1]];
            seen[colour.channel[1]] = true;
        }
    }
    TEST_ASSERT_GREATER_THAN(8, shades);
}

/* At the corner that the map has not, light would be twice that of full light. */
void test_light_beyond_the_corners_is_held(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)];
    static fxl_light light;
    const fxl_light_settings settings = {
        .direction = {0, 0, FXL_Q2_30_ONE}, .strength = FXL_Q2_30_ONE, .ramp = ramp, .levels = 2};
    uint32_t full = 0;
    face_map[0] = 0;
    face_map[1] = 2;
    surface[1].flags = FXL_SURFACE_LIT;
    mapped[1].normals[1] = 1;
    palette[21] = FXL_RGB565(255, 255, 255);
    begin();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_light(&renderer, &light, &settings));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_light_surfaces(&renderer, &light));
    draw(pixels);
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const channels colour = split(pixels[i]);
        if (pixels[i] != palette[0] && pixels[i] != palette[BACKGROUND]) {
            TEST_ASSERT_INT_WITHIN((63 + 31) / 2, colour.channel[1] * 31, colour.channel[0] * 63);
            full += pixels[i] == palette[21];
        }
    }
    TEST_ASSERT_GREATER_THAN(40, full);
}

/* --- what is refused ----------------------------------------------------------------------- */

void test_surfaces_of_the_wrong_kind_are_refused(void)
{
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_set_surfaces_rgb565(&renderer, &surfaces, &set));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_surfaces_rgb565(NULL, &surfaces, &set));
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_renderer_set_surfaces(&renderer, &surfaces, &set));
    make_texture(FXL_TEXTURE_8);
    surface[1].flags = FXL_SURFACE_ADD;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&set, &scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    surface[1].flags = FXL_SURFACE_ADD | FXL_SURFACE_BLEND;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    surface[1].flags = FXL_SURFACE_BLEND;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_check(&set, &scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    texture.key_565 = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    make_texture(FXL_TEXTURE_565);
    texture.key = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    texture.key = 0;
    texture.format = FXL_TEXTURE_565 + 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check_rgb565(&set, &scene, NULL));
    make_texture(FXL_TEXTURE_565);
    texture.texels++;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_surfaces_check_rgb565(&set, &scene, NULL));
}

void test_bands_of_the_wrong_kind_are_refused(void)
{
    fxl_band_565 band = {pixels, WIDTH, WIDTH, 0, HEIGHT};
    const fxl_band bytes = {indexed, WIDTH, WIDTH, 0, HEIGHT};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_rgb565(&renderer, &band));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_render_rgb565(&renderer, &eye, pixels, WIDTH));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_rgb565(&renderer, &frame, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_rgb565(&renderer, NULL, palette, 0));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_rgb565(NULL, &frame, palette, 0));
    begin();
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_rgb565(&renderer, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_rgb565(&renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_rgb565(NULL, &band));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_render_rgb565(NULL, &eye, pixels, WIDTH));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_render_rgb565(&renderer, NULL, pixels, WIDTH));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_render_rgb565(&renderer, &eye, pixels, WIDTH - 1));
    band.stride = 32768;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_rgb565(&renderer, &band));
    band.stride = WIDTH;
    band.first_row = 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_rgb565(&renderer, &band));
    band.first_row = 0;
    band.pixels = (uint16_t *)(uintptr_t)((uintptr_t)band.pixels + 1);
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_frame_draw_rgb565(&renderer, &band));
    /* a band of bytes stays as it is */
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    memset(indexed, 0x5A, sizeof indexed);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &bytes));
    TEST_ASSERT_EQUAL(refused + 1, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, indexed, sizeof indexed);
}

void test_another_method_draws_faces_in_their_own_colours(void)
{
    begin();
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_set_visibility(&renderer, &fxl_visibility_surfaces, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, indexed, WIDTH));
    for (uint32_t i = 0; i < sizeof indexed; i++) {
        TEST_ASSERT_TRUE(indexed[i] == BACKGROUND || (indexed[i] >= 20 && indexed[i] <= 22));
    }
}

void test_flat_frames_need_no_surfaces(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, indexed, WIDTH));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_rgb565(&renderer, &frame, palette, 0));
    draw(pixels);
    for (uint32_t i = 0; i < sizeof indexed; i++) {
        TEST_ASSERT_EQUAL_HEX16(palette[indexed[i]], pixels[i]);
    }
}

/* The same bits on the host and on every board. */
void test_a_frame_of_all_is_as_it_was(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(5)];
    static fxl_light light;
    const fxl_light_settings settings = {
        .ambient = Q30(0.125),
        .point_count = 1,
        .ramp = ramp,
        .levels = 5,
        .points = {{{Q16(-1), Q16(1), Q16(3)}, Q16(9), FXL_Q2_30_ONE}}};
    surface[0].flags = FXL_SURFACE_LIT;
    surface[1].flags = FXL_SURFACE_BLEND;
    surface[1].opacity = 13;
    face_map[1] = 2;
    begin();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_rgb565(&renderer, &frame, palette, 0x1234));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_light(&renderer, &light, &settings));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_light_surfaces(&renderer, &light));
    draw(pixels);
    TEST_ASSERT_EQUAL_HEX32(0x7A11BC5B, unit_crc32((const uint8_t *)pixels, sizeof pixels));
}
