/* SPDX-License-Identifier: MIT */
/* Draws with Fixel in bands. Unless the build says otherwise they have three rows, and the memory
 * is that of boards/stm32vldiscovery, which has 8 KB of RAM: 600 bytes of display list and no
 * vertex cache. The order has as many entries as the scene needs; a large sorted model needs more
 * than that board has. With DRAW_CLEARS each band is cleared first, and light and surfaces are
 * drawn, as the walk does. */
#include "contract/system.h"
#include "draw.h"
#include "fixel/light.h"
#include "fixel/surfaces.h"
#include "fixel/stage/fill.h"
#include "text.h"

#define ORDER_ENTRIES 8192u
#ifndef DRAW_BAND_ROWS
#define DRAW_BAND_ROWS     3u
#define DRAW_LIST_WORDS    150u
#define DRAW_CACHE_ENTRIES 0u
#define DRAW_CLEARS        0
#endif

static fxl_order_entry order[ORDER_ENTRIES];
static uint32_t list[DRAW_LIST_WORDS];
static fxl_renderer renderer;
#if DRAW_CACHE_ENTRIES > 0
static fxl_cached_vertex cache[DRAW_CACHE_ENTRIES];
#else
static fxl_cached_vertex *const cache = NULL;
#endif
#if DRAW_CLEARS
#define TEXTURES_MAX 64u
static uint8_t background;
static fxl_light light;
static fxl_surfaces surfaces;
static fxl_surface_set surface_set;
static fxl_texture textures[TEXTURES_MAX];
#endif
static uint32_t order_used;

#if DRAW_CLEARS
/* The looks of the scene's faces. */
static fxl_status open_looks(const fxl_scene_image *image)
{
    const bool is_lit = image->light.base != NULL;
    fxl_light_settings settings;
    fxl_status status = FXL_OK;
    if (is_lit) {
        fxl_light_settings_of(&image->light, &settings);
        status = fxl_renderer_set_light(&renderer, &light, &settings);
    }
    if (status == FXL_OK && image->surfaces.face_map != NULL) {
        status = fxl_surfaces_open(image, textures, TEXTURES_MAX, &surface_set, NULL);
        if (status == FXL_OK) {
            status = fxl_renderer_set_surfaces(&renderer, &surfaces, &surface_set);
        }
        if (status == FXL_OK && is_lit) {
            status = fxl_renderer_light_surfaces(&renderer, &light);
        }
    }
    return status;
}
#endif

int draw_open(const fxl_scene_image *image)
{
    order_used = image->scene.order_needed;
#if DRAW_CLEARS
    background = image->background;
#endif
    const fxl_memory memory = {order, order_used, list, DRAW_LIST_WORDS, cache, DRAW_CACHE_ENTRIES};

    if (order_used > ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", order_used);
        return SYSTEM_EXIT_CAPACITY;
    }
    if (fxl_renderer_init_with(&renderer, &image->scene, &image->lens, &memory) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
#if DRAW_CLEARS
    if (open_looks(image) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
#endif
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
    fxl_band band = *whole;

    if (fxl_frame_begin(&renderer, pose) != FXL_OK) {
        return false;
    }
    for (uint32_t row = 0; row < whole->rows; row += DRAW_BAND_ROWS) {
        const uint32_t left = whole->rows - row;
        band.pixels = whole->pixels + row * whole->stride;
        band.first_row = (uint16_t)row;
        band.rows = (uint16_t)(left < DRAW_BAND_ROWS ? left : DRAW_BAND_ROWS);
#if DRAW_CLEARS
        fxl_fill_band(&band, background);
#endif
        if (fxl_frame_draw(&renderer, &band) != FXL_OK) {
            return false;
        }
    }
    return true;
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof renderer + sizeof list + order_used * sizeof order[0] +
                      DRAW_CACHE_ENTRIES * sizeof(fxl_cached_vertex));
}

const fxl_counters *draw_counters(void)
{
    return &renderer.workspace.counters;
}
