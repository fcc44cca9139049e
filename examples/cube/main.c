#include <fixel.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY]; /* from CUBE_MEMORY_LEAST on, any size gives the same picture */
static uint8_t pixels[240][320];     /* entries of cube_palette */
int main(void)
{
    fxl_config config = fxl_config_default(320, 240); /* fov, near_z, far_z, inset, background: change any */
    fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) ||
        fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    return 0;
}
