/* A crate of planks that turns by a lamp: 51 lines. show is yours: it takes a frame of 320 x 240 entries of palette. */
#include <fixel.h>
#include <fixel/orientation.h>
#include <fixel/surfaces.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
static uint8_t pixels[240][320], planks[32][32], ramp[FXL_LIGHT_RAMP_BYTES(16)];
static uint8_t palette[256][3]; /* 16 browns, each in 16 shades: shade s of brown c is 16 c + s */
static const uint8_t brown[3] = {240, 176, 104};
static const fxl_texture texture = {.texels = planks[0], .log_width = 5, .log_height = 5, .levels = 1};
static const fxl_surface wood = {.texture = 1, .flags = FXL_SURFACE_LIT, .opacity = 16};
static const uint16_t face_map[6] = {1, 2, 3, 4, 5, 6};
static fxl_mapped_face faces[6];
static fxl_corner corners[18]; /* three of each face */
static fxl_direction normals[6]; /* of each face one, at all of its corners */
static fxl_renderer renderer;
static fxl_surfaces surfaces;
static fxl_lit_surfaces lit;
static fxl_light light;
static uint64_t memory[CUBE_MEMORY];
int main(void)
{
    const fxl_surface_set set = {&texture, &wood, faces, face_map, corners, normals, 1, 1, 6, 18, 6, NULL, 0, 0};
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 4, .point_count = 1, .ramp = ramp, .levels = 16,
        .points = {{{FXL_UNITS(-2), FXL_UNITS(3), FXL_UNITS(-4)}, FXL_UNITS(9), FXL_Q2_30_ONE}}};
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-5)}, .pitch = FXL_DEGREES(-20)};
    const fxl_point axis = {1, 2, 0}; /* of any length */
    fxl_placement placement = FXL_PLACEMENT_NONE;
    fxl_scene scene = cube_scene; /* the tables stay in flash; this record points at a placement */
    scene.placements = &placement;
    scene.placement_code = &fxl_turned_instances;
    for (int i = 0; i < 768; i++) { palette[i / 3][i % 3] = (uint8_t)(brown[i % 3] * (i / 48 + 8) / 23 * (i / 3 % 16) / 15); }
    for (int i = 0; i < 4096; i++) { ramp[i] = (uint8_t)(i % 16 * 16 + i / 256); }
    for (int i = 0; i < 1024; i++) { /* a frame about planks with grain */
        const int x = i % 32, y = i / 32, rim = x < 4 || y < 4 || x > 27 || y > 27;
        planks[y][x] = (uint8_t)(rim ? 12 + (x + y) % 3 : y % 8 == 3 ? 1 : 6 + (x * 5 + y * 23) % 7 % 4);
    }
    for (uint16_t i = 0; i < 18; i++) {
        corners[i] = (fxl_corner){{FXL_UNITS(32 * (i % 3 > 0)), FXL_UNITS(32 * (i % 3 > 1))}, fxl_face_indices(scene.indices, &scene.faces[i / 3])[i % 3], i / 3};
        faces[i / 3].corners[i % 3] = i;
        normals[i / 3] = scene.faces[i / 3].normal;
    }
    if (fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) || fxl_attach_lit(&renderer, &lit) ||
        fxl_attach_surfaces(&renderer, &surfaces, &set, FXL_TEXTURES_OF(fxl_palette)) || fxl_attach_light(&renderer, &light, &lamp)) { return 1; }
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        if (fxl_orientation_from_axis(&axis, frame * FXL_DEGREES(3), &placement.orientation) ||
            fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
