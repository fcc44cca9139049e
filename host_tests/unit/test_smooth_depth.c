/* SPDX-License-Identifier: MIT */
/* A triangle that is lit at its corners, with a depth buffer: painted by the rows of its light, and
 * by each way that other pixels are painted. The level of a pixel is the same, but for one where
 * two roundings differ. */
#include <string.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "unity.h"

enum {
    WIDTH = 40,
    HEIGHT = 30,
    PIXELS = WIDTH * HEIGHT,
    LEVELS = 8,
    BACKGROUND = 255,
    COLOUR = 10,
    IN_BEAM = 64 /* lit[c] = c + IN_BEAM */
};

static const fxl_point corners[] = {
    {-70000, -60000, 200000}, {-40000, 70000, 210000}, {80000, -50000, 204000}};
static const uint16_t indices[] = {0, 1, 2}, face_map[] = {1};
static const fxl_model model = {
    .vertex_count = 3, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 5 * 65536};
static const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
static const fxl_direction normals[] = {
    {0, 0, -FXL_Q2_30_ONE}, {0, FXL_Q2_30_ONE, 0}, {FXL_Q2_30_ONE, 0, 0}};
static const fxl_mapped_face mapped = {.vertices = {0, 1, 2}, .normals = {0, 1, 2}};

/* The ramp is the blend table too: what is blended hides what is beneath. */
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], lit[256];
static uint8_t rows[PIXELS], others[PIXELS];
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_light light;
static fxl_lit_surfaces lit_surfaces;
static uint64_t memory[300], cells[FXL_DEPTH_BYTES(WIDTH, 10, 16) / 8], room[256];

void setUp(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + IN_BEAM);
        for (uint32_t level = 0; level < LEVELS; level++) {
            ramp[256 * level + i] = (uint8_t)level;
        }
    }
}

void tearDown(void)
{
}

/* The frame of the triangle with a surface, and in beams or without. */
static void draw(const fxl_surface *surface, const fxl_beam *beam, uint8_t *frame)
{
    fxl_face face = {{0, 0, 0}, 0, 3, COLOUR, 0};
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
    const fxl_surface_set set = {.surfaces = surface,
                                 .faces = &mapped,
                                 .face_map = face_map,
                                 .normals = normals,
                                 .surface_count = 1,
                                 .face_count = 1,
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
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_palette_depth_16);
    config.background = BACKGROUND;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&corners[0], &corners[1], &corners[2], &plane));
    face.normal = plane.normal;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &set,
                                                  FXL_SURFACES_OF(fxl_palette_depth_16)));
    if (beam != NULL) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &beams, room, sizeof room));
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&renderer, &lit_surfaces));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &eye, frame, WIDTH));
}

/* Draws the triangle by rows, and with another surface; counts pixels that the other one leaves. */
static uint32_t left_by(const fxl_surface *surface)
{
    static const fxl_surface plain = {.opacity = 16, .flags = FXL_SURFACE_LIT};
    uint32_t left = 0, covered = 0;
    draw(&plain, NULL, rows);
    draw(surface, NULL, others);
    for (uint32_t i = 0; i < PIXELS; i++) {
        if (rows[i] != BACKGROUND && others[i] == BACKGROUND) {
            left++;
        } else if (rows[i] != BACKGROUND) {
            TEST_ASSERT_INT_WITHIN(1, rows[i], others[i]);
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
    TEST_ASSERT_INT_WITHIN(60, 500, left_by(&half));
}

void test_a_blended_face_has_the_light_of_an_opaque_one(void)
{
    const fxl_surface glass = {.opacity = 16, .flags = FXL_SURFACE_LIT | FXL_SURFACE_BLEND};
    TEST_ASSERT_EQUAL(0, left_by(&glass));
}

void test_a_face_divided_at_each_pixel_has_the_same_light(void)
{
    const fxl_surface exact = {.opacity = 16, .flags = FXL_SURFACE_LIT, .division = FXL_DIVIDE_1};
    TEST_ASSERT_EQUAL(0, left_by(&exact));
}

/* beams 6.1 */
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
