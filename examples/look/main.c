/* A camera that flies about a cube and looks at it. show is yours: it takes a frame of 320 x 240 entries of cube_palette. */
#include <fixel.h>
#include <fixel/camera.h>
#include <fixel/player.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_point middle = {0, 0, 0};
    fxl_camera camera;
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory)) { return 1; }
    for (uint32_t frame = 0;; frame++) {
        fxl_pose eye = {.yaw = frame * FXL_DEGREES(3), .pitch = FXL_DEGREES(-30)};
        if (fxl_camera_from_pose(&eye, &camera)) { return 1; }
        eye.position.x = -(camera.axes.forward.x >> 14) * 5; /* five units behind the middle: 2.30 to 16.16 */
        eye.position.y = -(camera.axes.forward.y >> 14) * 5;
        eye.position.z = -(camera.axes.forward.z >> 14) * 5;
        if (fxl_pose_look_at(&eye, &middle) || fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
        if (show(pixels[0]) != 0) { return 0; }
    }
}
