/* Two cubes that intersect, one of which turns: a depth buffer of 16 bits shows each pixel's nearest face. */
#include <fixel.h>
#include <fixel/orientation.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
int show(const uint8_t *pixels); /* 0: another frame, please */
static uint64_t memory[CUBE_MEMORY], cells[FXL_DEPTH_BYTES(320, 8, 16) / 8]; /* eight rows: a frame is drawn in 30 parts */
static fxl_renderer renderer;
static uint8_t pixels[240][320];
int main(void)
{
    static const fxl_instance both[2] = {{{FXL_UNITS(-1), 0, 0}, 0, 0, 0}, {{FXL_RATIO(3, 4), FXL_RATIO(1, 4), FXL_RATIO(1, 2)}, 0, 0, 0}};
    fxl_scene scene = cube_scene;
    fxl_placement placement = FXL_PLACEMENT_NONE;
    fxl_config config = fxl_config_for(320, 240, &fxl_palette_depth_16);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-5)}, .pitch = FXL_DEGREES(-20)};
    const fxl_point axis = {1, 2, 1};
    scene.instances = both;
    scene.instance_count = 2;
    scene.placements = &placement;
    scene.first_turned = 1; /* the second cube has the placement */
    config.depth = cells;
    config.depth_size = sizeof cells;
    if (fxl_scene_check_all(&scene, NULL) || fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory)) { return 1; }
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        if (fxl_orientation_from_axis(&axis, frame * FXL_DEGREES(3), &placement.orientation) ||
            fxl_render(&renderer, &eye, pixels[0], 320)) { return 1; }
    }
    return 0;
}
