/* Text and a bar over the picture of a cube, in a palette of its own. */
#include <fixel.h>
#include <fixel/overlay.h>
#include "cube_scene.h" /* tools/scene.py export --c examples/cube/cube.obj -o cube_scene.h */
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
static uint8_t palette[256][3]; /* that of the cube, and three more colours */
int main(void)
{
    static const uint8_t more[9] = {255, 255, 255, 40, 200, 90, 60, 60, 70}; /* entries 7, 8 and 9 */
    const fxl_config config = fxl_config_default(320, 240);
    const fxl_pose eye = {.position = {0, FXL_UNITS(2), FXL_UNITS(-8)}, .pitch = FXL_DEGREES(-12)};
    const fxl_band whole = {.pixels = pixels[0], .width = 320, .stride = 320, .rows = 240};
    const fxl_text_style style = {.font = &fxl_font_5x7, .colour = 7};
    fxl_text_size size;
    for (int i = 0; i < 768; i++) { palette[i / 3][i % 3] = i / 3 < 7 ? cube_palette[i / 3][i % 3] : i / 3 < 10 ? more[i - 21] : 0; }
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) ||
        fxl_render(&renderer, &eye, pixels[0], 320) || fxl_measure_text("Six faces,\neight corners", &style, &size)) { return 1; }
    return fxl_draw_text(&whole, (320 - (int32_t)size.width) / 2, 20, "Six faces,\neight corners", &style) ||
           fxl_draw_text(&whole, 20, 212, "energy", &style) || fxl_draw_border(&whole, 20, 222, 104, 10, 7) ||
           fxl_draw_rectangle(&whole, 22, 224, 100, 6, 9) || fxl_draw_rectangle(&whole, 22, 224, 64, 6, 8);
}
