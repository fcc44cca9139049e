/* A model of your own with its textures, light and depth. show is yours: it takes a frame of 320 x 240 pixels of RGB565. */
#include "model_scene.h" /* tools/scene.py export --c examples/model/model.glb --frames 24 -o model_scene.h */
#define ROWS 8 /* of the depth buffer: a frame is drawn in 30 parts */
int show(const uint16_t *pixels); /* 0: another frame, please */
static fxl_setup it;
static uint64_t memory[MODEL_SETUP_MEMORY(ROWS)];
static uint16_t pixels[240][320];
int main(void)
{
    if (fxl_setup_init(&it, &model_setup, ROWS, memory, sizeof memory)) { return 1; } /* fxl_setup_explain says why */
    for (uint32_t frame = 0; show(pixels[0]) == 0; frame++) {
        if (fxl_render(&it.renderer, fxl_setup_frame(&it, frame), pixels[0], 320)) { return 1; }
    }
    return 0;
}
