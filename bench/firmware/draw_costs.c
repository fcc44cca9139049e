/* SPDX-License-Identifier: MIT */
/* Draws as the walk does on a board: in bands that are cleared first, with the scene's light,
 * beams, surfaces, billboards and depth buffer. Compiled once for each size of memory that
 * `make costs` measures, and once for `make bench PIXELS= ORDER= DEPTH=`: bench/bench.mk says
 * which. What the scene has beside its faces has a room of its own, so the display list has all its
 * words. */
#include "bands.h"
#include "billboards.h"
#include "contract/system.h"
#include "draw.h"
#include "looks.h"
#include "methods.h"
#include "text.h"

#ifndef DRAW_ORDER_ENTRIES
#define DRAW_ORDER_ENTRIES 8192u
#endif
#ifndef DRAW_ROOM_BYTES
#define DRAW_ROOM_BYTES (8u * DRAW_LIST_WORDS + 65536u) /* room_of in costs_renewal.py */
#endif

static fxl_draw_entry order[DRAW_ORDER_ENTRIES];
static uint32_t list[DRAW_LIST_WORDS];
static uint64_t room[DRAW_ROOM_BYTES / 8u];
static fxl_renderer renderer;
#if DRAW_CACHE_ENTRIES > 0
static fxl_cached_vertex cache[DRAW_CACHE_ENTRIES];
#else
static fxl_cached_vertex *const cache = NULL;
#endif
static uint8_t background;
static uint32_t order_used, room_used;
static walk_methods methods;

/* What the scene has, then what the methods want, as the walk shares its memory. */
static fxl_status open_looks(const fxl_scene_image *image)
{
    uint8_t *const bytes = (uint8_t *)room;
    const uint32_t looks = walk_looks_bytes(image), billboards = walk_billboards_bytes(image);
    const uint32_t taken = looks + billboards;
    fxl_status status;

    if (taken > DRAW_ROOM_BYTES || !walk_methods_choose(&methods, image, DRAW_ROOM_BYTES - taken)) {
        return FXL_E_CAPACITY;
    }
    room_used = taken + walk_methods_bytes(&methods);
    if (room_used > DRAW_ROOM_BYTES) {
        return FXL_E_CAPACITY;
    }
    status = walk_methods_set(&methods, image, &renderer, bytes + taken);
    if (status == FXL_OK) {
        status = walk_looks_open(image, methods.draws.surfaces, &renderer, bytes);
    }
    return status == FXL_OK
               ? walk_billboards_open(image, methods.draws.sprites, &renderer, bytes + looks)
               : status;
}

int draw_open(const fxl_scene_image *image)
{
    order_used = image->scene.draw_list_needed + DRAW_ORDER_MORE;
    background = image->background;
    const fxl_memory memory = {order, order_used, list, DRAW_LIST_WORDS, cache, DRAW_CACHE_ENTRIES};

    if (order_used > DRAW_ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", order_used);
        return SYSTEM_EXIT_CAPACITY;
    }
    return fxl_renderer_init_with(&renderer, &image->scene, &image->lens, &memory) == FXL_OK &&
                   open_looks(image) == FXL_OK
               ? SYSTEM_EXIT_DONE
               : SYSTEM_EXIT_RENDER;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
    fxl_band band = *whole;

    band.palette = renderer.palette;
    return draw_in_bands(&renderer, pose, &band, DRAW_BAND_ROWS, background);
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof renderer + sizeof list + order_used * sizeof order[0] +
                      DRAW_CACHE_ENTRIES * sizeof(fxl_cached_vertex)) +
           room_used;
}

const fxl_counters *draw_counters(void)
{
    return &renderer.workspace.counters;
}

fxl_renderer *draw_renderer(void)
{
    return &renderer;
}
