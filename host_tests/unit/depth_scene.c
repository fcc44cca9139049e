/* SPDX-License-Identifier: MIT */
#include "depth_scene.h"

#include "frame_bands.h"
#include "mapped_quad.h"

static const fxl_point vertices[] = {
    {-8 * 65536, -32768, 16 * 65536},    {8 * 65536, -32768, 16 * 65536},
    {8 * 65536, -32768, -4 * 65536},     {-8 * 65536, -32768, -4 * 65536},
    {-6 * 65536, -2 * 65536, 4 * 65536}, {-6 * 65536, 2 * 65536, 4 * 65536},
    {6 * 65536, 2 * 65536, 4 * 65536},   {6 * 65536, -2 * 65536, 4 * 65536},
    {-4 * 65536, -3 * 65536, 0},         {-4 * 65536, 3 * 65536, 0},
    {4 * 65536, 3 * 65536, 8 * 65536},   {4 * 65536, -3 * 65536, 8 * 65536}};
static const uint16_t indices[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
static const fxl_face faces[] = {{{0, FXL_Q2_30_ONE, 0}, 4, 10, FXL_INDICES_AT(0, 0)},
                                 {{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(0, 4)},
                                 {{759250125, 0, -759250125}, 4, 30, FXL_INDICES_AT(0, 8)}};
static const fxl_model models[] = {
    {.vertex_count = 4, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = 19 * 65536},
    {.first_vertex = 4,
     .vertex_count = 4,
     .first_face = 1,
     .face_count = 1,
     .kind = FXL_MODEL_CONVEX,
     .radius = 8 * 65536},
    {.first_vertex = 8,
     .vertex_count = 4,
     .first_face = 2,
     .face_count = 1,
     .kind = FXL_MODEL_CONVEX,
     .radius = 12 * 65536}};
static const fxl_instance instances[] = {
    {{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 0}, {{0, 0, 0}, 2, 0, 0}};

static depth_scene scene_made;

const fxl_pose depth_scene_eye = {{0, 0, 0}, 6u << 23, 0u - (2u << 23), 1u << 23};

depth_scene *depth_scene_make(void)
{
    const quad_tables tables = {vertices, indices, faces, models, instances};
    depth_scene *made = &scene_made;
    memset(made, 0, sizeof *made);
    made->scene = quad_tables_scene(&tables, DEPTH_SCENE_QUADS);
    for (uint32_t i = 0; i < sizeof made->texels; i++) {
        made->texels[i] = (uint8_t)(((i >> 2) + (i >> 4)) % 2 == 0 ? 99 : 98);
    }
    made->texture =
        (fxl_texture){.texels = made->texels, .log_width = 3, .log_height = 3, .levels = 1};
    made->surface = (fxl_surface){.texture = 1, .opacity = 16};
    made->mapped = (fxl_mapped_face){.corners = {0, 1, 2}};
    made->mapped_corners[0] = (fxl_corner){{0, 8 * 65536}, 0, 0};
    made->mapped_corners[1] = (fxl_corner){{0, 0}, 1, 0};
    made->mapped_corners[2] = (fxl_corner){{48 * 65536, 0}, 2, 0};
    made->set = quad_surface_set(&made->texture, &made->surface, &made->mapped,
                                 made->mapped_corners, made->face_map);
    made->config = mapped_quad_floor_config(DEPTH_SCENE_WIDTH, DEPTH_SCENE_HEIGHT);
    made->config.background = DEPTH_SCENE_BACKGROUND;
    return made;
}

static void start(depth_scene *made, const fxl_target *target, uint32_t depth_size)
{
    const fxl_painter *const painters[] = {FXL_SURFACES_OF(fxl_palette),
                                           FXL_SURFACES_OF(fxl_palette_depth_16),
                                           FXL_SURFACES_OF(fxl_palette_depth_32)};
    made->config.target = target;
    made->config.depth = made->cells;
    made->config.depth_size = depth_size;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&made->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init(&made->renderer, &made->scene, &made->config,
                                                made->memory, sizeof made->memory));
    if (made->is_mapped) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&made->renderer, &made->surfaces, &made->set,
                                                      painters[target->depth_bits / 16u]));
    }
}

void depth_scene_start(depth_scene *made)
{
    start(made, &fxl_palette, 0);
}

void depth_scene_start_with(depth_scene *made, const fxl_target *target)
{
    start(made, target, sizeof made->cells);
}

void depth_scene_draw(depth_scene *made, uint8_t *frame)
{
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_render(&made->renderer, &depth_scene_eye, frame, DEPTH_SCENE_WIDTH));
}

void depth_scene_draw_in_bands(depth_scene *made, uint16_t rows, uint32_t list_words)
{
    made->renderer.frame.display_list.capacity = list_words;
    memset(made->again, 0, sizeof made->again);
    frame_draw_pose(&made->renderer, &depth_scene_eye, made->again, rows, DEPTH_SCENE_BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(made->frame, made->again, sizeof made->frame);
}

void depth_scene_check_bands(depth_scene *made, const fxl_target *target)
{
    static const uint32_t sizes[] = {FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, 1, 32),
                                     FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, 5, 16), sizeof made->cells};
    depth_scene_draw(made, made->frame);
    for (uint32_t i = 0; i < 3; i++) {
        start(made, target, sizes[i]);
        for (uint32_t words = 0; words <= 128; words += 32) {
            depth_scene_draw_in_bands(made, 4, words);
            depth_scene_draw_in_bands(made, DEPTH_SCENE_HEIGHT, words);
            const bool whole =
                sizes[i] >= FXL_DEPTH_BYTES(DEPTH_SCENE_WIDTH, DEPTH_SCENE_HEIGHT, 16) &&
                target == &fxl_palette_depth_16;
            TEST_ASSERT_EQUAL(whole, made->renderer.workspace.counters.split_bands == 0);
        }
    }
}
