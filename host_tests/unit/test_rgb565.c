/* SPDX-License-Identifier: MIT */
/* Frames of 16 bits a pixel against those of a palette; bands, and what is refused. */
#include "fixel/lines.h"
#include "rgb565_scene.h"

enum {
    GUARD = 0xA5A5
};

void setUp(void)
{
    walls_make();
}

static fxl_band band_of(uint16_t *pixels, uint16_t first_row, uint16_t rows)
{
    const fxl_band band = {.pixels = (uint8_t *)(void *)pixels, .width = WIDTH, .stride = WIDTH,
                           .first_row = first_row, .rows = rows, .palette = walls.palette};
    return band;
}

/* place pixel-format: the new format has files like this one, test_rgb565_colours.c and test_rgb565_hashes.c */
/* The frame of the palette is drawn; that of 16 bits shows its colours. */
static void check_against_palette(void)
{
    uint32_t textured = 0;
    walls_start(&fxl_palette);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set,
                                                  FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, walls.indexed, WIDTH));
    const uint8_t flags = walls.texture.flags;
    walls_make_texture(FXL_TEXTURE_565);
    walls.texture.flags = flags;
    walls_begin();
    walls_draw(walls.pixels);
    for (uint32_t y = 0; y < HEIGHT; y++) {
        for (uint32_t x = 0; x < WIDTH; x++) {
            TEST_ASSERT_EQUAL_HEX16(walls.palette[walls.indexed[y * WIDTH + x]],
                                    walls.pixels[y * WIDTH + x]);
            textured += walls.indexed[y * WIDTH + x] != BACKGROUND &&
                        walls.indexed[y * WIDTH + x] != 21 && walls.indexed[y * WIDTH + x] != 22;
        }
    }
    TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 6, textured);
}

/* --- texels ------------------------------------------------------------------------------ */

/* rgb565 1.4a-b */
void test_texels_are_those_of_a_palette(void)
{
    for (uint8_t division = FXL_DIVIDE_16; division <= FXL_AFFINE; division++) {
        for (uint8_t flags = 0; flags < 2; flags++) {
            walls_make_texture(FXL_TEXTURE_8);
            walls.texture.flags = flags;
            walls.surface[0].division = division;
            /* the kernel, which paints opaque faces of a palette, rounds in another unit */
            walls.surface[0].opacity = (uint8_t)(division == FXL_DIVIDE_1 ? 16 : 15 - 5 * flags);
            check_against_palette();
        }
    }
}

/* Opaque faces have a kernel, and a loop of their own if they are lit. The kernel rounds in another
 * unit, but for pixels that are divided. */
void test_opacity_changes_no_colour(void)
{
    static const uint8_t ramp[FXL_LIGHT_RAMP_BYTES(9)];
    const fxl_light_settings settings = {
        .point_count = 1,
        .ramp = ramp,
        .levels = 9,
        .points = {{{Q16(-2), Q16(1), Q16(4)}, Q16(7), FXL_Q2_30_ONE}}};
    walls.surface[0].flags = FXL_SURFACE_LIT;
    walls.mapped_corners[0][1].normal = 1; /* so light goes beyond the ramp at both ends */
    for (uint32_t lit = 0; lit < 2; lit++) {
        uint32_t drawn = 0, other = 0;
        walls.surface[0].opacity = 16;
        walls.surface[0].division = lit ? FXL_DIVIDE_16 : FXL_DIVIDE_1;
        walls_begin();
        walls_light(&settings);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&walls.renderer, lit ? &walls.lit : NULL));
        walls_draw(walls.pixels);
        walls.surface[0].opacity = 15; /* one pixel of 16 shows what is behind */
        walls_draw(walls.again);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t x = i % WIDTH, y = i / WIDTH;
            if (x % 4 == 0 && y % 4 == 3) {
                other += walls.pixels[i] != walls.again[i];
            } else {
                TEST_ASSERT_EQUAL_HEX16(walls.again[i], walls.pixels[i]);
                drawn += walls.pixels[i] != walls.palette[BACKGROUND];
            }
        }
        TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT / 4, drawn);
        TEST_ASSERT_GREATER_THAN(10, other);
    }
}

/* surfaces 3.1a-b */
void test_the_second_level_is_found(void)
{
    walls_make_texture(FXL_TEXTURE_8);
    walls.mapped_corners[0][1].texel.u = walls.mapped_corners[0][2].texel.u = Q16(200);
    walls.mapped_corners[0][2].texel.v = Q16(120);
    memset(walls.texels, 9, 256);
    check_against_palette();
}

/* surfaces 4.1, rgb565 1.4c */
void test_a_texel_of_the_key_is_not_drawn(void)
{
    walls.surface[0].division = FXL_DIVIDE_1; /* the kernel rounds in another unit */
    walls_begin();
    walls.texture.flags = FXL_TEXTURE_KEYED;
    walls.texture.key_565 = walls.texels_565[33];
    walls_draw(walls.pixels);
    walls.texture.flags = 0;
    walls_draw(walls.again);
    uint32_t holes = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint16_t with = walls.pixels[i], without = walls.again[i];
        holes += with != without;
        TEST_ASSERT_TRUE(without == walls.texture.key_565
                             ? with != without || with == walls.palette[21]
                             : with == without);
    }
    TEST_ASSERT_GREATER_THAN(2, holes);
}

/* SPEC 9.5, rgb565 1.3a */
void test_indices_take_their_colour_of_the_palette(void)
{
    static const uint8_t colours[16] = {30,  41,  52, 63, 74, 85, 96, 107,
                                        118, 129, 3,  5,  7,  9,  11, 13};
    walls_make_texture(FXL_TEXTURE_8);
    walls_begin();
    walls_draw(walls.pixels);
    walls_make_texture(FXL_TEXTURE_565);
    walls_draw(walls.again);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
    walls_make_texture(FXL_TEXTURE_4);
    walls.texture.colours = colours;
    walls.surface[0].division = FXL_DIVIDE_1; /* the kernel rounds in another unit */
    walls_draw(walls.pixels);
    for (uint32_t i = 0; i < 16 * 16; i++) {
        walls.texels_565[i] = walls.palette[colours[walls.texels[i / 2] >> 4 * (i & 1) & 15]];
    }
    for (uint32_t i = 0; i < 8 * 8; i++) {
        walls.texels_565[256 + i] =
            walls.palette[colours[walls.texels[128 + i / 2] >> 4 * (i & 1) & 15]];
    }
    walls_make_texture(FXL_TEXTURE_565);
    walls_draw(walls.again);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
}

/* Indices have a key of their own, whose colour other indices may have too. */
/* surfaces 4.1 */
void test_an_index_of_the_key_is_not_drawn(void)
{
    static uint16_t shown[HEIGHT * WIDTH];
    walls_make_texture(FXL_TEXTURE_8);
    walls.surface[0].division = FXL_DIVIDE_1; /* the kernel rounds in another unit */
    walls.palette[walls.texels[34]] = walls.palette[walls.texels[33]];
    walls_begin();
    walls_draw(walls.again);
    walls.texture.flags = FXL_TEXTURE_KEYED;
    walls.texture.key = walls.texels[33];
    walls_draw(walls.pixels);
    for (uint32_t i = 0; i < sizeof walls.texels / sizeof walls.texels[0]; i++) {
        walls.texels_565[i] = walls.texels[i] == walls.texture.key ? 1 : 2;
    }
    walls_make_texture(FXL_TEXTURE_565);
    memcpy(shown, walls.again, sizeof shown);
    walls_draw(walls.again); /* 1 where the key is, 2 where another texel is */
    uint32_t holes = 0, texels = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        if (walls.again[i] == 1) {
            holes += walls.pixels[i] != shown[i];
        } else {
            texels += walls.again[i] == 2;
            TEST_ASSERT_EQUAL_HEX16(shown[i], walls.pixels[i]);
        }
    }
    TEST_ASSERT_GREATER_THAN(2, holes);
    TEST_ASSERT_GREATER_THAN(100, texels);
}

static void draw_with(const fxl_target *target, const fxl_painter *painter, uint16_t *to)
{
    walls_start(target);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set, painter));
    walls_draw(to);
}

/* The corners of the map are nearly on one line, so that u and v change by more than any word of texels
 * holds: a depth buffer changes no pixel of such a face. */
/* SPEC 9.1.1 */
void test_corners_of_a_map_that_are_nearly_on_a_line(void)
{
    static const uint16_t five[] = {0, 1, 2, 3, 4};
    static const fxl_face face = {{0, 0, -FXL_Q2_30_ONE}, 5, 20, FXL_INDICES_AT(0, 0)};
    static const fxl_model model = {
        .vertex_count = 5, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = Q16(1200)};
    uint32_t textured = 0;
    for (int32_t z = 1; z <= 64; z *= 8) {
        const fxl_q16_16 x = Q16(2 * z) / 3, y = Q16(z) / 2;
        const fxl_point vertices[] = {{-x, y, Q16(z)},
                                      {-x + 1, y, Q16(z)},
                                      {x, y - 1, Q16(z)},
                                      {x, -y, Q16(z)},
                                      {-x, -y, Q16(z)}};
        walls.scene.vertices = vertices;
        walls.scene.indices = five;
        walls.scene.faces = &face;
        walls.scene.models = &model;
        walls.scene.vertex_count = walls.scene.index_count = 5;
        walls.scene.face_count = walls.scene.model_count = walls.scene.instance_count = 1;
        walls.mapped_corners[0][1].texel = (fxl_texel){Q16(16000), Q16(-16000)};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&walls.scene, NULL));
        draw_with(&fxl_rgb565, FXL_SURFACES_OF(fxl_rgb565), walls.pixels);
        draw_with(&fxl_rgb565_depth_16, FXL_SURFACES_OF(fxl_rgb565_depth_16), walls.again);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
        draw_with(&fxl_rgb565, FXL_TEXTURES_OF(fxl_rgb565), walls.again);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
        draw_with(&fxl_rgb565_depth_16, FXL_TEXTURES_OF(fxl_rgb565_depth_16), walls.again);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            textured += walls.pixels[i] != walls.palette[BACKGROUND];
        }
    }
    TEST_ASSERT_GREATER_THAN(WIDTH * HEIGHT, textured);
}

/* --- bands ------------------------------------------------------------------------------- */

void test_bands_and_lists_change_no_pixel(void)
{
    static fxl_workspace other;
    static FXL_ALIGN_8 uint8_t other_memory[3000];
    walls.surface[1].flags = FXL_SURFACE_ADD;
    walls.face_map[1] = 2;
    walls_begin();
    walls_draw(walls.pixels);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &walls.renderer, other_memory, 3000));
    for (uint32_t words = 0; words < 3; words++) {
        walls.renderer.frame.display_list.capacity = words * 40;
        memset(walls.again, 0, sizeof walls.again);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
        for (uint16_t row = 0; row < HEIGHT; row = (uint16_t)(row + 2)) {
            const fxl_band band = band_of(walls.again + row * WIDTH, row, 2);
            fxl_rgb565.fill(NULL, &band, BACKGROUND);
            TEST_ASSERT_EQUAL(FXL_OK, row % 4
                                          ? fxl_frame_draw(&walls.renderer, &band)
                                          : fxl_frame_draw_with(&walls.renderer, &other, &band));
        }
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels, walls.again, WIDTH * HEIGHT);
    }
}

/* rgb565 1.2a */
void test_no_other_byte_is_written(void)
{
    static uint16_t wide[HEIGHT * (WIDTH + 3)];
    walls_begin();
    walls_draw(walls.pixels);
    for (uint32_t i = 0; i < HEIGHT * (WIDTH + 3); i++) {
        wide[i] = GUARD;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, wide + 1, WIDTH + 3));
    for (uint32_t y = 0; y < HEIGHT; y++) {
        const uint16_t *row = wide + y * (WIDTH + 3);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[0]);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[WIDTH + 1]);
        TEST_ASSERT_EQUAL_HEX16(GUARD, row[WIDTH + 2]);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(walls.pixels + y * WIDTH, row + 1, WIDTH);
    }
}

/* rgb565 1.1a-b, 1.1d */
void test_bytes_are_swapped_for_a_display(void)
{
    uint16_t two[2][3] = {{0x1234, 0xF00D, 0x5555}, {0xABCD, 1, 0x7777}};
    const uint16_t swapped[2][3] = {{0x3412, 0x0DF0, 0x5555}, {0xCDAB, 0x0100, 0x7777}};
    const fxl_band band = {.pixels = (uint8_t *)(void *)two[0], .width = 2, .stride = 3, .rows = 2};
    fxl_swap_rgb565(&band);
    TEST_ASSERT_EQUAL_HEX16_ARRAY(swapped[0], two[0], 6);
    TEST_ASSERT_EQUAL_HEX16(31 << 11 | 50 << 5 | 1, FXL_RGB565(255, 200, 15));
}

/* --- what is refused ----------------------------------------------------------------------- */

/* rgb565 2.3b, 3.3a-b */
void test_surfaces_of_the_wrong_kind_are_refused(void)
{
    TEST_ASSERT_EQUAL(FXL_E_RESERVED,
                      fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set,
                                          FXL_SURFACES_OF(fxl_palette)));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set,
                                                  FXL_SURFACES_OF(fxl_rgb565)));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&walls.renderer, &walls_eye));
    walls_make_texture(FXL_TEXTURE_8);
    walls.surface[1].flags = FXL_SURFACE_ADD;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&walls.set, &walls.scene, 8, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls.surface[1].flags = FXL_SURFACE_ADD | FXL_SURFACE_BLEND;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls.surface[1].flags = FXL_SURFACE_BLEND;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_surfaces_check(&walls.set, &walls.scene, 8, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls.texture.key_565 = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls_make_texture(FXL_TEXTURE_565);
    walls.texture.key = 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls.texture.key = 0;
    walls.texture.format = FXL_TEXTURE_565 + 1;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
    walls_make_texture(FXL_TEXTURE_565);
    walls.texture.texels++;
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_surfaces_check(&walls.set, &walls.scene, 16, NULL));
}

/* A band of pixels has a palette. */
/* rgb565 3.2a, 3.2c-d */
void test_bands_of_the_wrong_kind_are_refused(void)
{
    fxl_band band = band_of(walls.pixels, 0, HEIGHT);
    walls_begin();
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL(FXL_E_RANGE,
                      fxl_render(&walls.renderer, &walls_eye, walls.pixels, WIDTH - 1));
    band.first_row = 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw(&walls.renderer, &band));
    band.first_row = 0;
    band.palette = NULL;
    const uint32_t refused = walls.renderer.workspace.counters.refused_calls;
    memset(walls.pixels, 0x5A, sizeof walls.pixels);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL(refused + 1, walls.renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EACH_EQUAL_HEX16(0x5A5A, walls.pixels, WIDTH * HEIGHT);
}

/* A band with a palette has pixels of 16 bits, and the target of a byte would draw into half of them.
 */
/* rgb565 3.2b */
void test_a_target_of_bytes_refuses_a_band_with_a_palette(void)
{
    fxl_band band = band_of(walls.pixels, 0, HEIGHT);
    walls_start(&fxl_palette);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&walls.renderer, &walls_eye));
    const uint32_t refused = walls.renderer.workspace.counters.refused_calls;
    memset(walls.pixels, 0x5A, sizeof walls.pixels);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&walls.renderer, &band));
    TEST_ASSERT_EQUAL(refused + 1, walls.renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EACH_EQUAL_HEX16(0x5A5A, walls.pixels, WIDTH * HEIGHT);
    band.palette = NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&walls.renderer, &band));
}

/* rgb565 1.2c, 3.1a */
void test_flat_frames_need_no_surfaces(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, walls.indexed, WIDTH));
    walls_start(&fxl_rgb565);
    walls_draw(walls.pixels);
    for (uint32_t i = 0; i < sizeof walls.indexed; i++) {
        TEST_ASSERT_EQUAL_HEX16(walls.palette[walls.indexed[i]], walls.pixels[i]);
    }
}

/* --- a line behind a face that is blended ------------------------------------------------- */

/* Where a line is seen, the frame is the one in which the wall on which it lies has the line's colour
 * everywhere: the wall before it is mixed with the line, and with what the wall is. */
/* lines 2.6a */
void test_a_line_comes_before_what_is_blended(void)
{
    static const fxl_line line = {0, 2, {1, 0}, 20, 3, 0};
    static const uint32_t line_map[] = {0, 1, 1, 1};
    static const fxl_line_set set = {&line, 1, line_map};
    static fxl_lines lines;
    static uint16_t coloured[HEIGHT * WIDTH];
    uint32_t seen = 0, mixed = 0;
    walls.surface[1].flags = FXL_SURFACE_BLEND;
    walls.surface[1].opacity = 7;
    walls.face_map[1] = 2;
    for (uint32_t way = 0; way < 3; way++) {
        walls.face_map[0] = way == 1 ? 0 : 1;
        walls_start(&fxl_rgb565_depth_16);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set,
                                                      FXL_SURFACES_OF(fxl_rgb565_depth_16)));
        if (way == 2) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&walls.renderer, &lines, &set));
        }
        walls_draw(way == 0 ? walls.pixels : way == 1 ? coloured : walls.again);
    }
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        if (walls.again[i] != walls.pixels[i]) {
            TEST_ASSERT_EQUAL_HEX16(coloured[i], walls.again[i]);
            seen++;
            mixed += coloured[i] != walls.palette[20];
        }
    }
    TEST_ASSERT_TRUE(seen > 40 && mixed > 10 && mixed < seen);
}
