/* SPDX-License-Identifier: MIT */
/* lv_fixel with an exported model that has textures, light and a depth buffer, set up by one call. */
#include "dashboard.h"
#include "model_scene.h"

#include <stdio.h>
#include <string.h>

#define FRAMES 4

static fxl_setup shown, own;
static uint64_t shown_memory[MODEL_SETUP_MEMORY(ROWS)], own_memory[MODEL_SETUP_MEMORY(HEIGHT)];

/* How many pixels of the display are not the library's own of a frame. */
static long frame_differs(uint32_t frame)
{
    static uint16_t pixels[HEIGHT][WIDTH];
    long differ = 0;
    if (fxl_render(&own.renderer, fxl_setup_frame(&own, frame), pixels, WIDTH) != FXL_OK) {
        return WIDTH * HEIGHT;
    }
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            differ += memcmp(&screen[y][2 * x], &pixels[y][x], 2) != 0;
        }
    }
    return differ;
}

void test_setup(void)
{
    long differ = 0;
    begin_display(LV_COLOR_FORMAT_RGB565);
    lv_obj_t *view = lv_fixel_create(lv_screen_active());
    const fxl_status statuses[] = {
        fxl_setup_init(&shown, &model_setup, ROWS, shown_memory, sizeof shown_memory),
        fxl_setup_init(&own, &model_setup, HEIGHT, own_memory, sizeof own_memory),
        lv_fixel_set_renderer(view, &shown.renderer, model_setup.palette)};
    for (uint32_t frame = 0; frame < FRAMES; frame++) {
        lv_fixel_set_pose(view, fxl_setup_frame(&shown, frame));
        lv_obj_invalidate(view);
        refresh();
        differ += frame_differs(frame);
    }
    printf("setup: %u %u %u, %ld pixels differ, %u frames, %u refused\n", statuses[0], statuses[1],
           statuses[2], differ, lv_fixel_get_counters(view).frames,
           lv_fixel_get_counters(view).refused);
    end_display();
}
