/* SPDX-License-Identifier: MIT */
/* Draws as the walk does on a board: in bands that are cleared first, with the scene's light,
 * beams, surfaces, billboards and depth buffer. Compiled once for each size of memory that
 * `make costs` measures, and once for `make bench PIXELS= ORDER= DEPTH=`: bench/bench.mk says
 * which. What the scene has beside its faces has a room of its own, so the display list has all its
 * words. */
#include "contract/system.h"
#include "draw.h"
#include "plan.h"
#include "program.h"

#ifndef DRAW_ORDER_ENTRIES
#define DRAW_ORDER_ENTRIES 8192u
#endif
#ifndef DRAW_ROOM_BYTES
#define DRAW_ROOM_BYTES (8u * DRAW_LIST_WORDS + 65536u) /* room_of in costs.py */
#endif

static fxl_draw_entry order[DRAW_ORDER_ENTRIES];
static uint32_t list[DRAW_LIST_WORDS];
static uint64_t room[DRAW_ROOM_BYTES / 8u];
static fxl_setup_plan plan;
static fxl_setup setup;
#if DRAW_CACHE_ENTRIES > 0
static fxl_cached_vertex cache[DRAW_CACHE_ENTRIES];
#else
static fxl_cached_vertex *const cache = NULL;
#endif
static uint8_t background;
static uint32_t order_used, room_used;

int draw_open(const fxl_scene_image *image)
{
    static walk_methods methods;
    static walk_plan of;

    order_used = image->scene.draw_list_needed + DRAW_ORDER_MORE;
    background = image->background;
    if (order_used > DRAW_ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", order_used);
        return SYSTEM_EXIT_CAPACITY;
    }
    plan = (fxl_setup_plan){0};
    of =
        (walk_plan){.image = image,
                    .methods = &methods,
                    .tables = {order, order_used, list, DRAW_LIST_WORDS, cache, DRAW_CACHE_ENTRIES},
                    .block = (uint8_t *)room,
                    .size = sizeof room};
    if (!walk_methods_choose(&methods, image) || walk_plan_open(&of, &plan, &setup) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
    room_used = of.used;
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
    fxl_band band = *whole;

    band.palette = setup.renderer.palette;
    return draw_in_bands(&setup.renderer, pose, &band, DRAW_BAND_ROWS, background);
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof setup + sizeof list + order_used * sizeof order[0] +
                      DRAW_CACHE_ENTRIES * sizeof(fxl_cached_vertex)) +
           room_used;
}

const fxl_counters *draw_counters(void)
{
    return &setup.renderer.workspace.counters;
}

fxl_renderer *draw_renderer(void)
{
    return &setup.renderer;
}
