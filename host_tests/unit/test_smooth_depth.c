/* SPDX-License-Identifier: MIT */
/* A triangle that is lit at its corners, with a depth buffer: painted by the rows of its light, and
 * by each way that other pixels are painted. The level of a pixel is the same, but for one where
 * two roundings differ. */
#include <math.h>
#include <string.h>

#include "draw/stages.h"
#include "draw/surface_polygon.h"
#include "paint/depth_code.h"
#include "fixel/all.h"
#include "unity.h"

enum {
    WIDTH = 40,
    HEIGHT = 30,
    PIXELS = WIDTH * HEIGHT,
    LEVELS = 8,
    BACKGROUND = 255,
    COLOUR = 10,
    IN_BEAM = 64, /* lit[c] = c + IN_BEAM */
    GLASS = 32
};

static const fxl_point in_one_octave[] = {
    {-70000, -60000, 200000}, {-40000, 70000, 210000}, {80000, -50000, 204000}};
static const fxl_point across[] = {
    {-90000, -80000, 249000}, {-60000, 90000, 288000}, {100000, -60000, 268000}};
static const fxl_point steep[] = {
    {-70000, -60000, 200000}, {-60000, 110000, 390000}, {90000, -50000, 204000}};
static const uint16_t indices[] = {0, 1, 2}, face_map[] = {1};
static const fxl_model model = {
    .vertex_count = 3, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 12 * 65536};
static const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
static const fxl_direction normals[] = {
    {0, 0, -FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {FXL_Q2_30_ONE, 0, 0}};
static const fxl_mapped_face mapped = {.corners = {0, 1, 2}};
static const fxl_corner of_texels[3] = {
    {{-9000, 70000}, 0, 0}, {{900000, 500000}, 1, 1}, {{300000, -2000000}, 2, 2}};
static const fxl_corner of_colours[3] = {{{FXL_CORNER_COLOUR(250, 30, 100), 0}, 0, 0},
                                         {{FXL_CORNER_COLOUR(20, 200, 130), 0}, 1, 1},
                                         {{FXL_CORNER_COLOUR(90, 90, 10), 0}, 2, 2}};
static const fxl_corner *mapped_corners;
static fxl_q16_16 near_z;
static const uint8_t texels[8 * 4] = {3, 14, 15, 92, 65, 35, 89, 79, 32, 38, 46, 26, 43, 38, 32, 79,
                                      50, 28, 84, 19, 71, 69, 39, 93, 75, 10, 58, 20, 97, 49, 44, 59};
static fxl_texture texture = {.texels = texels, .log_width = 3, .log_height = 2, .levels = 1};

/* The ramp is the blend table too: a level that is blended with the background shows GLASS more. */
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], lit[256];
static uint8_t rows[PIXELS], others[PIXELS];
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_lit_surfaces lit_surfaces;
static uint64_t memory[300], cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 16) / 8], room[256];
static const fxl_point *corners;
static uint32_t cells_size;
static const fxl_target *target;
static const fxl_painter *painter;
static uint16_t colours[256];
static bool by_list; /* the frame is drawn from a display list */

void setUp(void)
{
    corners = in_one_octave;
    mapped_corners = of_texels;
    near_z = 16384;
    cells_size = FXL_DEPTH_BYTES(WIDTH, 10, 16);
    target = &fxl_palette_depth_16;
    painter = FXL_SURFACES_OF(fxl_palette_depth_16);
    by_list = false;
    for (uint32_t i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + IN_BEAM);
        colours[i] = (uint16_t)(i * 31153u);
        for (uint32_t level = 0; level < LEVELS; level++) {
            ramp[256 * level + i] = (uint8_t)(level + (i == BACKGROUND ? GLASS : 0));
        }
    }
}

/* The frame of the triangle with a surface, and in beams or without. */
static void draw(const fxl_surface *surface, const fxl_beam *beam, void *frame)
{
    fxl_face face = {{0, 0, 0}, 3, COLOUR, {0, 1, 2}};
    fxl_plane plane;
    fxl_scene scene = {.vertices = corners,
                       .indices = indices,
                       .faces = &face,
                       .models = &model,
                       .instances = &instance,
                       .vertex_count = 3,
                       .index_count = 3,
                       .face_count = 1,
                       .model_count = 1,
                       .instance_count = 1};
    const fxl_surface_set set = {.textures = &texture,
                                 .texture_count = 1,
                                 .surfaces = surface,
                                 .faces = &mapped,
                                 .face_map = face_map,
                                 .corners = mapped_corners,
                                 .normals = normals,
                                 .surface_count = 1,
                                 .face_count = 1,
                                 .corner_count = 3,
                                 .normal_count = 3,
                                 .blend = ramp,
                                 .blend_count = LEVELS};
    const fxl_beam_set beams = {beam, 1, lit};
    const fxl_light_settings lamp = {.direction = {0, 0, FXL_Q2_30_ONE},
                                     .strength = FXL_Q2_30_ONE / 2,
                                     .ambient = FXL_Q2_30_ONE / 4,
                                     .ramp = ramp,
                                     .levels = LEVELS};
    const fxl_pose eye = {{0, 0, 0}, 0, 0, 0};
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.palette = target->pixel_bits == 16 ? colours : NULL;
    config.background = BACKGROUND;
    config.near_z = near_z;
    config.depth = cells;
    config.depth_size = cells_size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&corners[0], &corners[1], &corners[2], &plane));
    face.normal = plane.normal;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &set, painter));
    if (beam != NULL) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &beams, room, sizeof room));
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, &lit_surfaces));
    if (by_list) {
        const fxl_band band = {
            .pixels = frame, .width = WIDTH, .stride = WIDTH, .rows = HEIGHT, .palette = colours};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &eye));
        TEST_ASSERT_GREATER_THAN(0, renderer.frame.display_list.used);
        fxl_frame_fill(&renderer, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
    } else {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
    }
}

/* Draws the triangle by rows, and with another surface, whose levels are shown with so much more; counts
 * pixels that the other one leaves. */
static uint32_t left_by(const fxl_surface *surface, uint8_t more)
{
    static const fxl_surface plain = {.opacity = 16, .flags = FXL_SURFACE_LIT};
    uint32_t left = 0, covered = 0;
    draw(&plain, NULL, rows);
    draw(surface, NULL, others);
    for (uint32_t i = 0; i < PIXELS; i++) {
        if (rows[i] != BACKGROUND && others[i] == BACKGROUND) {
            left++;
        } else if (rows[i] != BACKGROUND) {
            TEST_ASSERT_INT_WITHIN(1, rows[i] + more, others[i]);
        } else {
            TEST_ASSERT_EQUAL(BACKGROUND, others[i]);
        }
        covered += rows[i] != BACKGROUND;
    }
    TEST_ASSERT_GREATER_THAN(200, covered);
    return left * 1000 / covered;
}

void test_a_stipple_has_the_light_of_the_whole_face(void)
{
    const fxl_surface half = {.opacity = 8, .flags = FXL_SURFACE_LIT};
    TEST_ASSERT_INT_WITHIN(60, 500, left_by(&half, 0));
}

void test_a_blended_face_has_the_light_of_an_opaque_one(void)
{
    const fxl_surface glass = {.opacity = 16, .flags = FXL_SURFACE_LIT | FXL_SURFACE_BLEND};
    TEST_ASSERT_EQUAL(0, left_by(&glass, GLASS));
}

/* Rows of light are for opaque pixels that all of a face has. Over black the sum is the face's own pixel. */
void test_an_added_face_has_the_pixels_of_a_stippled_one(void)
{
    static const fxl_surface half = {.opacity = 8, .flags = FXL_SURFACE_LIT};
    static const fxl_surface added = {.opacity = 16, .flags = FXL_SURFACE_LIT | FXL_SURFACE_ADD};
    static uint16_t frames[2][PIXELS];
    uint32_t covered = 0;
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    colours[BACKGROUND] = 0;
    colours[COLOUR] = UINT16_MAX;
    corners = steep;
    cells_size = sizeof cells;
    draw(&half, NULL, frames[0]);
    draw(&added, NULL, frames[1]);
    for (uint32_t i = 0; i < PIXELS; i++) {
        if (frames[0][i] != 0) {
            TEST_ASSERT_EQUAL_HEX16(frames[0][i], frames[1][i]);
            covered++;
        }
    }
    TEST_ASSERT_GREATER_THAN(100, covered);
}

void test_a_face_divided_at_each_pixel_has_the_same_light(void)
{
    const fxl_surface exact = {.opacity = 16, .flags = FXL_SURFACE_LIT, .division = FXL_DIVIDE_1};
    TEST_ASSERT_EQUAL(0, left_by(&exact, 0));
}

/* beams 6.1b */
void test_a_piece_in_a_beam_has_the_light_of_the_whole_face(void)
{
    static const fxl_surface plain = {.opacity = 16, .flags = FXL_SURFACE_LIT};
    const fxl_point from = {0, 0, 65536};
    const fxl_point window[] = {{-16000, 60000, 131072},
                                {16000, 60000, 131072},
                                {16000, -60000, 131072},
                                {-16000, -60000, 131072}};
    fxl_beam beam;
    uint32_t in_beam = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    draw(&plain, NULL, rows);
    draw(&plain, &beam, others);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const bool is_in_beam = others[i] >= IN_BEAM && others[i] != BACKGROUND;
        TEST_ASSERT_INT_WITHIN(1, rows[i], others[i] - (is_in_beam ? IN_BEAM : 0));
        in_beam += is_in_beam;
    }
    TEST_ASSERT_GREATER_THAN(50, in_beam);
}

/* The code of the triangle's pixel, of its plane in double (SPEC.md, section 10.2). */
static double exact_code(int x, int y)
{
    const fxl_lens *lens = &renderer.frame.view.lens;
    const double e1[3] = {corners[1].x - (double)corners[0].x, corners[1].y - (double)corners[0].y,
                          corners[1].z - (double)corners[0].z};
    const double e2[3] = {corners[2].x - (double)corners[0].x, corners[2].y - (double)corners[0].y,
                          corners[2].z - (double)corners[0].z};
    const double n[3] = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2],
                         e1[0] * e2[1] - e1[1] * e2[0]};
    const double to[3] = {x + 0.5 - WIDTH / 2.0, HEIGHT / 2.0 - y - 0.5, lens->focal / 65536.0};
    const double volume = n[0] * corners[0].x + n[1] * corners[0].y + n[2] * corners[0].z;
    const double depth =
        lens->near_z * (n[0] * to[0] + n[1] * to[1] + n[2] * to[2]) / (volume * to[2]);
    const fxl_depth_scale scale = fxl_depth_scale_of(lens);
    const int octave = -1 - ilogb(depth);
    return (ldexp(depth, octave + 1) - 1 + scale.octaves - 1 - octave) * (1 << scale.mantissa) + 1;
}

/* The codes of the pixels that the face covers, where `rows` shows it, of which some are nearer than 16 times
 * near, the end of an octave, and some not. */
static void check_codes(uint32_t least)
{
    const uint16_t *codes = (const uint16_t *)(const void *)(cells + 1);
    const fxl_depth_scale scale = fxl_depth_scale_of(&renderer.frame.view.lens);
    uint32_t nearer = 0, farther = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (rows[i] == BACKGROUND) {
            continue;
        }
        const double code = exact_code(i % WIDTH, i / WIDTH);
        TEST_ASSERT_TRUE(codes[i] <= code + 0.001 &&
                         codes[i] >= code - 1 - 4096 / 65536.0 - 0.001);
        const bool is_nearer = code >= ((scale.octaves - 4) << scale.mantissa) + 1;
        nearer += is_nearer;
        farther += !is_nearer;
    }
    TEST_ASSERT_TRUE(nearer >= least && farther >= least);
}

/* Depths from 3.8 to 4.4 units: near is 1/4. */
/* SPEC 10.2b-c, 10.3b, 10.3e */
void test_codes_of_a_face_that_crosses_the_end_of_an_octave(void)
{
    static const fxl_surface plain = {.opacity = 16, .flags = FXL_SURFACE_LIT};
    corners = across;
    cells_size = sizeof cells;
    draw(&plain, NULL, rows);
    check_codes(30);
}

/* Depths from 2.1 to 7.5 units, in three octaves: colours may be words where depths are not. */
/* SPEC 10.2b-c, 10.3b, 10.3e */
void test_codes_of_a_face_with_colours_in_three_octaves(void)
{
    static const fxl_point deep[] = {
        {-60000, -50000, 138000}, {-240000, 200000, 490000}, {250000, -180000, 470000}};
    static const fxl_point thin[] = {
        {-60000, -50000, 138000}, {190000, 176000, 470000}, {240000, 184000, 490000}};
    static const fxl_point *const triangles[] = {deep, thin};
    static uint16_t frame[PIXELS];
    static const uint8_t divisions[] = {FXL_AFFINE, FXL_DIVIDE_16, FXL_DIVIDE_1};
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    mapped_corners = of_colours;
    near_z = 13107; /* 1/5 */
    cells_size = sizeof cells;
    for (uint32_t i = 0; i < 2 * sizeof divisions; i++) {
        const fxl_surface surface = {
            .opacity = 16, .flags = FXL_SURFACE_COLOURS, .division = divisions[i / 2]};
        corners = triangles[i % 2];
        draw(&surface, NULL, frame);
        for (uint32_t k = 0; k < PIXELS; k++) {
            rows[k] = frame[k] == colours[BACKGROUND] ? BACKGROUND : COLOUR;
        }
        check_codes(i % 2 == 0 ? 30 : 4);
    }
}

/* Light that changes by many levels where the depth does too is divided: no plane of light alone is
 * near it. */
void test_a_steep_face_has_the_light_of_one_divided_at_each_pixel(void)
{
    const fxl_surface exact = {.opacity = 16, .flags = FXL_SURFACE_LIT, .division = FXL_DIVIDE_1};
    corners = steep;
    TEST_ASSERT_EQUAL(0, left_by(&exact, 0));
}

/* A triangle with texels, which is drawn from its corners to its pixels, and from a display list. */
static void check_texels_of_list(const fxl_surface *surface)
{
    static uint16_t frames[2][PIXELS], codes[2][PIXELS];
    fxl_counters counters[2];
    uint32_t covered = 0;
    for (int i = 0; i < 2; i++) {
        by_list = i == 1;
        draw(surface, NULL, frames[i]);
        memcpy(codes[i], cells + 1, sizeof codes[i]);
        counters[i] = renderer.workspace.counters;
    }
    for (uint32_t i = 0; i < PIXELS; i++) {
        covered += frames[0][i] != colours[BACKGROUND];
    }
    TEST_ASSERT_GREATER_THAN(40, covered);
    TEST_ASSERT_EQUAL_MEMORY(frames[1], frames[0], sizeof frames[0]);
    TEST_ASSERT_EQUAL_MEMORY(codes[1], codes[0], sizeof codes[0]);
    TEST_ASSERT_EQUAL(counters[1].drawn, counters[0].drawn);
    TEST_ASSERT_EQUAL(counters[1].clipped, counters[0].clipped);
    TEST_ASSERT_EQUAL(counters[1].outside, counters[0].outside);
}

/* SPEC 9.1.1v */
void test_which_textures_are_functions_of_the_screen(void)
{
    const fxl_surface surface = {.texture = 1, .opacity = 16, .division = FXL_DIVIDE_16};
    const fxl_texture repeated = {.format = FXL_TEXTURE_8};
    fxl_surfaces none = {.beams = NULL};
    for (uint32_t flags = 0; flags < 256; flags++) {
        fxl_surface one = surface;
        fxl_texture shown = repeated;
        one.flags = (uint8_t)flags;
        TEST_ASSERT_EQUAL((flags & ~(uint32_t)FXL_SURFACE_LIT) == 0,
                          fxl_may_have_words(&none, &one, &shown));
        one.flags = 0;
        shown.flags = (uint8_t)flags; /* clamped, or with a key */
        TEST_ASSERT_EQUAL(flags == 0, fxl_may_have_words(&none, &one, &shown));
    }
    for (uint8_t opacity = 1; opacity <= 16; opacity++) {
        fxl_surface one = surface;
        one.opacity = opacity;
        TEST_ASSERT_EQUAL(opacity == 16, fxl_may_have_words(&none, &one, &repeated));
    }
    for (uint8_t division = 0; division <= FXL_AFFINE; division++) {
        fxl_surface one = surface;
        one.division = division;
        TEST_ASSERT_EQUAL(division == FXL_DIVIDE_16 || division == FXL_AFFINE,
                          fxl_may_have_words(&none, &one, &repeated));
    }
    const fxl_texture nibbles = {.format = FXL_TEXTURE_4};
    TEST_ASSERT_FALSE(fxl_may_have_words(&none, &surface, &nibbles));
    static const fxl_shader beams;
    none.beams = &beams;
    TEST_ASSERT_FALSE(fxl_may_have_words(&none, &surface, &repeated));
}

/* In one octave, across the end of one, partly beside the screen, too steep for words, thin, and steep: both
 * are not small, but may be in words. */
/* SPEC 9.1.1 */
void test_texels_drawn_at_once_are_those_of_a_display_list(void)
{
    static const fxl_point cut[] = {
        {-190000, -60000, 200000}, {-40000, 70000, 210000}, {80000, -50000, 204000}};
    static const fxl_point thin[] = {
        {-190000, 133000, 204000}, {20000, 0, 204000}, {182000, -130000, 205000}};
    static const fxl_point sloping[] = {
        {-190000, 10000, 200000}, {0, 50000, 290000}, {195000, -5000, 210000}};
    static const fxl_point *const triangles[] = {in_one_octave, across, cut, steep, thin, sloping};
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    cells_size = sizeof cells;
    for (uint32_t kind = 0; kind < 24; kind++) {
        const fxl_surface surface = {.texture = 1,
                                     .opacity = 16,
                                     .flags = (kind & 1u) != 0 ? FXL_SURFACE_LIT : 0,
                                     .division = (kind & 2u) != 0 ? FXL_AFFINE : FXL_DIVIDE_16};
        corners = triangles[kind >> 2];
        check_texels_of_list(&surface);
    }
}

/* --- texels that are not in words: they are where those of words are ------------------------- */

static uint8_t entry_of(uint16_t pixel)
{
    uint32_t i = 0;
    while (i < 255 && colours[i] != pixel) {
        i++;
    }
    TEST_ASSERT_EQUAL_HEX16(colours[i], pixel);
    return (uint8_t)i;
}

/* The pixels of a surface, of which few are other texels than the words'. Counts those that it leaves
 * out, and those in the beam, which show lit[c]. */
static void check_same_texels(const fxl_surface *surface, const fxl_beam *beam, uint32_t *left,
                              uint32_t *in_beam)
{
    static const fxl_surface in_words = {.texture = 1, .opacity = 16, .division = FXL_DIVIDE_16};
    static uint16_t frames[2][PIXELS];
    uint32_t covered = 0, differing = 0;
    draw(&in_words, NULL, frames[0]);
    draw(surface, beam, frames[1]);
    *left = *in_beam = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        const uint8_t wanted = entry_of(frames[0][i]), shown = entry_of(frames[1][i]);
        if (wanted == BACKGROUND) {
            TEST_ASSERT_EQUAL(BACKGROUND, shown);
            continue;
        }
        covered++;
        *left += shown == BACKGROUND;
        *in_beam += beam != NULL && shown == (uint8_t)(wanted + IN_BEAM);
        differing += shown != BACKGROUND && shown != wanted &&
                     (beam == NULL || shown != (uint8_t)(wanted + IN_BEAM));
    }
    TEST_ASSERT_GREATER_THAN(200, covered);
    TEST_ASSERT_LESS_THAN(covered / 20, differing);
}

/* SPEC 9.1.1 */
void test_texels_without_words_are_those_of_words(void)
{
    static const fxl_surface plain = {.texture = 1, .opacity = 16, .division = FXL_DIVIDE_16};
    const fxl_point from = {0, 0, 65536};
    const fxl_point window[] = {{-16000, 60000, 131072},
                                {16000, 60000, 131072},
                                {16000, -60000, 131072},
                                {-16000, -60000, 131072}};
    uint32_t left, in_beam;
    fxl_surface surface = plain;
    fxl_beam beam;
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    cells_size = sizeof cells;
    surface.division = FXL_DIVIDE_8;
    check_same_texels(&surface, NULL, &left, &in_beam);
    TEST_ASSERT_EQUAL(0, left);
    surface = plain;
    surface.opacity = 8;
    check_same_texels(&surface, NULL, &left, &in_beam);
    TEST_ASSERT_GREATER_THAN(100, left);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&from, window, 4, &beam));
    check_same_texels(&plain, &beam, &left, &in_beam);
    TEST_ASSERT_TRUE(left == 0 && in_beam > 50);
}

/* SPEC 9.1.1 */
void test_texels_of_4_bits_are_those_of_bytes(void)
{
    static const fxl_surface plain = {.texture = 1, .opacity = 16, .division = FXL_DIVIDE_16};
    static uint8_t bytes[sizeof texels], halves[sizeof texels / 2], of_half[16];
    static uint16_t frames[2][PIXELS];
    const fxl_texture of_bytes = texture;
    uint32_t covered = 0, differing = 0;
    for (uint32_t i = 0; i < sizeof texels; i++) {
        of_half[i % 16] = (uint8_t)(i % 16 * 3 + 100);
        bytes[i] = (uint8_t)(texels[i] % 16 * 3 + 100);
        halves[i / 2] = (uint8_t)(halves[i / 2] | (texels[i] & 15) << i % 2 * 4);
    }
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    cells_size = sizeof cells;
    texture.texels = bytes;
    draw(&plain, NULL, frames[0]);
    texture.texels = halves;
    texture.colours = of_half;
    texture.format = FXL_TEXTURE_4;
    draw(&plain, NULL, frames[1]);
    texture = of_bytes;
    for (uint32_t i = 0; i < PIXELS; i++) {
        covered += frames[0][i] != colours[BACKGROUND];
        differing += frames[0][i] != frames[1][i];
    }
    TEST_ASSERT_GREATER_THAN(200, covered);
    TEST_ASSERT_LESS_THAN(covered / 20, differing);
}

/* A texture with levels, of which the face shows the largest alone. */
/* SPEC 9.1.1, 9.4 */
void test_levels_that_are_too_small_are_not_seen(void)
{
    static const fxl_surface plain = {.texture = 1, .opacity = 16, .division = FXL_DIVIDE_16};
    static uint8_t levels[32 + 8 + 2 + 1];
    static uint16_t frames[2][PIXELS];
    const fxl_texture of_one = texture;
    memcpy(levels, texels, sizeof texels);
    target = &fxl_rgb565_depth_16;
    painter = FXL_SURFACES_OF(fxl_rgb565_depth_16);
    cells_size = sizeof cells;
    draw(&plain, NULL, frames[0]);
    texture.texels = levels;
    texture.levels = 4;
    draw(&plain, NULL, frames[1]);
    texture = of_one;
    TEST_ASSERT_EQUAL_HEX16_ARRAY(frames[0], frames[1], PIXELS);
}
