/* A cube in the light of a lamp that flies about it, in fog. show is yours: it takes a frame of 320 x 240 entries of palette. */
#include <fixel.h>
#include <fixel/camera.h>
#include <fixel/light.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
static uint8_t palette[256][3], ramp[FXL_LIGHT_RAMP_BYTES(32)]; /* 32 shades */
static fxl_renderer renderer;
static fxl_light light;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    static const uint8_t colour[3] = {230, 190, 120};
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-5)}, .pitch = FXL_DEGREES(-20)};
    fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 8, .point_count = 1, .fog_near = FXL_UNITS(4), .fog_far = FXL_UNITS(16),
                               .points = {{{0, 0, 0}, FXL_UNITS(8), FXL_Q2_30_ONE}}, .ramp = ramp, .levels = 32};
    for (int i = 0; i < 96; i++) { palette[i / 3][i % 3] = (uint8_t)(20 + colour[i % 3] * (i / 3) / 31); }
    for (int i = 0; i < 32 * 256; i++) { ramp[i] = (uint8_t)(i / 256); } /* all faces are of one colour: its shade is the level */
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory)) { return 1; }
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        fxl_camera circle;
        if (fxl_camera_from_pose(&(fxl_pose){.yaw = frame * FXL_DEGREES(6)}, &circle)) { return 1; }
        lamp.points[0].position = (fxl_point){(circle.axes.forward.x >> 14) * 3, FXL_UNITS(2), (circle.axes.forward.z >> 14) * 3};
        if (fxl_attach_light(&renderer, &light, &lamp) || fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
