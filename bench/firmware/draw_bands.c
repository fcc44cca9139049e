/* SPDX-License-Identifier: MIT */
/* Draws with Fixel in bands of three rows, with the memory of boards/stm32vldiscovery, which has
 * 8 KB of RAM: 600 bytes of display list and no vertex cache. The order has as many entries as the
 * scene needs; a large sorted model needs more than that board has. */
#include "contract/system.h"
#include "draw.h"
#include "program.h"

#define ORDER_ENTRIES 8192u
#define BAND_ROWS     3u
#define LIST_WORDS    150u

static fxl_draw_entry order[ORDER_ENTRIES];
static uint32_t list[LIST_WORDS];
static fxl_renderer renderer;
static uint32_t order_used;

int draw_open(const fxl_scene_image *image)
{
    order_used = image->scene.draw_list_needed;
    const fxl_memory memory = {order, order_used, list, LIST_WORDS, NULL, 0};

    if (order_used > ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", order_used);
        return SYSTEM_EXIT_CAPACITY;
    }
    if (fxl_renderer_init_with(&renderer, &image->scene, &image->lens, &memory) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
    return draw_in_bands(&renderer, pose, whole, BAND_ROWS, NOT_CLEARED);
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof renderer + sizeof list + order_used * sizeof order[0]);
}

const fxl_counters *draw_counters(void)
{
    return &renderer.workspace.counters;
}
