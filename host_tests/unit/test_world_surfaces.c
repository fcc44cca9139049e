/* SPDX-License-Identifier: MIT */
/* Surfaces of instances that a world recolours. */
#include <string.h>

#include "world_unit.h"

enum {
    TEXEL = 90 /* and the next */
};

static const uint8_t texels[2] = {TEXEL, TEXEL + 1};
static uint16_t face_map[12];
static fxl_texture texture;
static fxl_surface surface;
static fxl_mapped_face mapped;
static fxl_surface_set set;
static fxl_surfaces surfaces;

void setUp(void)
{
}

void tearDown(void)
{
}

/* The face -z of model 0 has a texture of two colours. */
static void attach(const tiny_scene *tiny)
{
    texture = (fxl_texture){.texels = texels, .log_width = 1, .levels = 1};
    surface = (fxl_surface){.texture = 1, .opacity = 16, .division = FXL_DIVIDE_1};
    mapped = (fxl_mapped_face){.texels = {{0, 0}, {0, Q16(2)}, {Q16(2), Q16(2)}}};
    memcpy(mapped.vertices, &tiny->corners[tiny->faces[4].first_index], sizeof mapped.vertices);
    memset(face_map, 0, sizeof face_map);
    face_map[4] = 1;
    set = (fxl_surface_set){.textures = &texture,
                            .surfaces = &surface,
                            .faces = &mapped,
                            .face_map = face_map,
                            .texture_count = 1,
                            .surface_count = 1,
                            .face_count = 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&world_renderer, &surfaces, &set,
                                                  FXL_SURFACES_OF(fxl_palette)));
}

/* The faces without a surface are recoloured, and those with one keep their texels. */
/* surfaces 6.2 */
void test_an_instance_that_is_recoloured_keeps_its_surfaces(void)
{
    static fxl_world_colours colours;
    const fxl_pose pose = {{Q16(2), Q16(1), Q16(-4)}, 0, 0, 0};
    const fxl_instance cube = {{0, 0, 0}, 0, 0, 0};
    const tiny_scene *tiny = world_start();
    uint32_t kept = 0, changed = 0;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_world_hide(&world, fxl_world_handle(i)));
    }
    for (uint32_t i = 0; i < 256; i++) {
        world_colours[i] = (uint8_t)(i + 100);
    }
    const fxl_handle handle = world_spawned(&cube, NULL);
    attach(tiny);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_colours(&world, &world_renderer, &colours));
    world_draw(&world_renderer, &pose, world_frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_recolour(&world, handle, 1));
    world_draw(&world_renderer, &pose, world_frames[1]);
    for (uint32_t i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
        const uint8_t before = world_frames[0][i];
        const bool is_texel = before == TEXEL || before == TEXEL + 1;
        const bool is_kept = is_texel || before == WORLD_BACKGROUND;
        TEST_ASSERT_EQUAL_UINT8(is_kept ? before : before + 100, world_frames[1][i]);
        kept += is_texel;
        changed += !is_kept;
    }
    TEST_ASSERT_TRUE(kept > 20 && changed > 10);
}
