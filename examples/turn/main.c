/* A cube that turns: 24 lines. show is yours: it takes a frame of 320 x 240 entries of cube_palette. */
#include <fixel.h>
#include <fixel/orientation.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    fxl_scene scene = cube_scene; /* the tables stay in flash; this record points at a turn */
    fxl_placement placement = FXL_PLACEMENT_NONE;
    scene.placements = &placement; /* of the instances from first_turned on: of the only one */
    scene.placement_code = &fxl_turned_instances;
    fxl_config config = fxl_config_default(320, 240);
    fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    fxl_point axis = {1, 2, 0}; /* of any length */
    if (fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory)) { return 1; }
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        if (fxl_orientation_from_axis(&axis, frame * FXL_DEGREES(3), &placement.orientation) ||
            fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
