/* A board that turns as an IMU says, in bands for 16 KB of RAM. display_rows is yours: it takes rows of 320 entries of board_palette. */
#include <fixel.h>
#include <fixel/orientation.h>
#include "board_scene.h" /* tools/scene.py export --c examples/attitude/board.obj -o board_scene.h */
#include "log.h"
enum { WIDTH = 320, HEIGHT = 240, ROWS = 4 };
void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *pixels);
static uint64_t memory[BOARD_MEMORY / 2], cells[FXL_DEPTH_BYTES(WIDTH, ROWS, 16) / 8];
static fxl_renderer renderer;
static uint8_t pixels[ROWS][WIDTH];
/* A line of the sensor, "w x y z\n"; returns where the next one begins. Its axes are right-handed: x right, y forward, z up. */
static const char *read_attitude(const char *text, fxl_orientation *orientation)
{
    int32_t n[4] = {0, 0, 0, 0};
    for (int i = 0; i < 4; i++, text++) {
        const int32_t sign = *text == '-' ? -1 : 1;
        for (text += *text == '-'; *text >= '0' && *text <= '9'; text++) { n[i] = n[i] * 10 + sign * (*text - '0'); }
    }
    const fxl_quaternion turned = {n[0], -n[1], -n[3], -n[2]}; /* Fixel's axes: x right, y up, z forward */
    return fxl_orientation_from_quaternion(&turned, orientation) ? NULL : text;
}
int main(void)
{
    const fxl_pose eye = {.position = {0, FXL_RATIO(5, 2), FXL_UNITS(-5)}, .pitch = FXL_DEGREES(-27)};
    fxl_scene scene = board_scene;
    fxl_placement placement = FXL_PLACEMENT_NONE;
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_palette_depth_16);
    scene.placements = &placement;
    scene.placement_code = &fxl_turned_instances;
    config.depth = cells;
    config.depth_size = sizeof cells;
    if (fxl_renderer_init(&renderer, &scene, &config, memory, sizeof memory)) { return 1; }
    for (const char *text = imu_log; *text;) {
        text = read_attitude(text, &placement.orientation);
        if (text == NULL || fxl_frame_begin(&renderer, &eye)) { return 1; }
        for (uint16_t y = 0; y < HEIGHT; y += ROWS) {
            const fxl_band band = {.pixels = pixels[0], .width = WIDTH, .stride = WIDTH, .first_row = y, .rows = ROWS};
            fxl_frame_fill(&renderer, &band, 0);
            if (fxl_frame_draw(&renderer, &band)) { return 1; }
            display_rows(y, ROWS, pixels[0]);
        }
    }
    return 0;
}
