/* SPDX-License-Identifier: MIT */
#include "rgb565_scene.h"

rgb565_walls walls;

static const fxl_point vertices[] = {
    {Q16(-4), Q16(3), Q16(6)},  {Q16(4), Q16(3), Q16(6)},   {Q16(4), Q16(-3), Q16(6)},
    {Q16(-4), Q16(-3), Q16(6)}, {Q16(-2), Q16(4), Q16(5)},  {Q16(1), Q16(2), Q16(5)},
    {Q16(1), Q16(-2), Q16(5)},  {Q16(-2), Q16(-3), Q16(5)}, {Q16(-9), Q16(1), Q16(12)},
    {Q16(9), Q16(1), Q16(12)},  {Q16(9), Q16(-1), Q16(12)}, {Q16(-9), Q16(-1), Q16(12)}};
static const uint16_t indices[] = {0, 1, 2, 3};
static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 20, FXL_INDICES_AT(0, 0)},
                                 {{0, 0, -FXL_Q2_30_ONE}, 4, 21, FXL_INDICES_AT(0, 0)},
                                 {{0, 0, -FXL_Q2_30_ONE}, 4, 22, FXL_INDICES_AT(0, 0)}};
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
const fxl_pose walls_eye = {{Q16(0.3), Q16(0.2), 0}, 1 << 26, 0, 1 << 27};

static FXL_ALIGN_8 uint8_t memory[3000];
static FXL_ALIGN_8 uint8_t depth[FXL_DEPTH_BYTES(WIDTH, 8, 32)];

void walls_make_texture(uint8_t format)
{
    walls.texture = (fxl_texture){
        .texels = walls.texels, .log_width = 4, .log_height = 4, .format = format, .levels = 2};
    if (format == FXL_TEXTURE_565) {
        walls.texture.texels = (const uint8_t *)(const void *)walls.texels_565;
    }
}

void walls_make(void)
{
    walls.scene = (fxl_scene){.vertices = vertices,
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
        walls.palette[i] = (uint16_t)(i * 40503u + 11);
    }
    for (uint32_t i = 0; i < sizeof walls.texels; i++) {
        walls.texels[i] = (uint8_t)(i * 7 + (i >> 4) * 3);
        walls.texels_565[i] = walls.palette[walls.texels[i]];
    }
    walls_make_texture(FXL_TEXTURE_565);
    walls.surface[0] = (fxl_surface){.texture = 1, .opacity = 16};
    walls.surface[1] = (fxl_surface){.opacity = 16};
    for (uint16_t i = 0; i < 2; i++) {
        walls.surface[i].first_corner = 3u * i;
        walls.mapped[i] = (fxl_mapped_face){.surface = i, .corners = {0, 1, 2}};
        walls.mapped_corners[i][0] = (fxl_corner){{0, 0}, 0, 0};
        walls.mapped_corners[i][1] = (fxl_corner){{Q16(40), 0}, 1, 0};
        walls.mapped_corners[i][2] = (fxl_corner){{Q16(40), Q16(24)}, 2, 0};
    }
    walls.face_map[0] = 1;
    walls.face_map[1] = walls.face_map[2] = 0;
    walls.set = (fxl_surface_set){.textures = &walls.texture,
                                  .surfaces = walls.surface,
                                  .faces = walls.mapped,
                                  .face_map = walls.face_map,
                                  .corners = walls.mapped_corners[0],
                                  .normals = normals,
                                  .texture_count = 1,
                                  .surface_count = 2,
                                  .face_count = 2,
                                  .corner_count = 6,
                                  .normal_count = 2};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&walls.scene, NULL));
    walls_start(&fxl_palette);
}

void walls_start(const fxl_target *target)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.background = BACKGROUND;
    config.palette = target->pixel_bits == 16 ? walls.palette : NULL;
    config.depth = target->depth_bits != 0 ? depth : NULL;
    config.depth_size = target->depth_bits != 0 ? sizeof depth : 0;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_renderer_init(&walls.renderer, &walls.scene, &config, memory, sizeof memory));
}

void walls_begin(void)
{
    walls_start(&fxl_rgb565);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&walls.renderer, &walls.surfaces, &walls.set,
                                                  FXL_SURFACES_OF(fxl_rgb565)));
}

void walls_hide_others(uint16_t colour)
{
    walls.surface[0] = (fxl_surface){.opacity = 16};
    walls.face_map[0] = walls.face_map[2] = 1;
    walls.palette[20] = walls.palette[22] = colour;
}

void walls_light(const fxl_light_settings *settings)
{
    static fxl_light light;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&walls.renderer, &light, settings));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lit(&walls.renderer, &walls.lit));
}

void walls_draw(uint16_t *to)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&walls.renderer, &walls_eye, to, WIDTH));
}
