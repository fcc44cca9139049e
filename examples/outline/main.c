/* A drawing of a cube in black and white: outlines, and no edge that is hidden. Entries 0 and 1 are white and black. */
#include <fixel.h>
#include <fixel/orientation.h>
#include <fixel/wire.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
const uint8_t palette[256][3] = {{255, 255, 255}, {0, 0, 0}}; /* for show */
static fxl_renderer renderer;
static fxl_outlines outlines;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    static const fxl_outline_style ink = {.line = 1, .fill = 0};
    fxl_scene scene = cube_scene;
    fxl_placement placement = FXL_PLACEMENT_NONE;
    fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-5)}, .pitch = FXL_DEGREES(-20)};
    const fxl_point axis = {1, 2, 0};
    scene.placements = &placement;
    scene.placement_code = &fxl_turned_instances;
    config.background = 0;
    if (fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory) ||
        fxl_attach_outlines(&renderer, &outlines, &ink)) { return 1; }
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        if (fxl_orientation_from_axis(&axis, frame * FXL_DEGREES(3), &placement.orientation) ||
            fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
