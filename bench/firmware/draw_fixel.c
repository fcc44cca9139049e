/* SPDX-License-Identifier: MIT */
/* Draws with Fixel, the frame in one band, so it needs no display list; or in bands of
 * DRAW_BAND_ROWS, with a list of DRAW_LIST_WORDS. With DRAW_RGB565 it draws into RGB565, else into
 * palette indices. */
#include "bands.h"
#include "contract/system.h"
#include "draw.h"
#include "fixel/surfaces.h"
#include "looks.h"
#include "text.h"

#define ORDER_ENTRIES 8192u /* a terrain of 8,000 faces in one model takes 8001 */
#define CACHE_ENTRIES 256u  /* at most */
#define LOOKS_BYTES   4096u

#ifdef DRAW_BAND_ROWS
static uint32_t list[DRAW_LIST_WORDS];
#define LIST_WORDS DRAW_LIST_WORDS
#else
static uint32_t *const list = NULL;
#define LIST_WORDS 0u
#endif

#ifdef DRAW_RGB565
#define PLAIN               fxl_rgb565
#define PLAIN_SURFACES      FXL_SURFACES_OF(fxl_rgb565)
#define WITH_DEPTH          fxl_rgb565_depth_16
#define WITH_DEPTH_SURFACES FXL_SURFACES_OF(fxl_rgb565_depth_16)
#else
#define PLAIN               fxl_palette
#define PLAIN_SURFACES      FXL_SURFACES_OF(fxl_palette)
#define WITH_DEPTH          fxl_palette_depth_16
#define WITH_DEPTH_SURFACES FXL_SURFACES_OF(fxl_palette_depth_16)
#endif

static fxl_draw_entry order[ORDER_ENTRIES];
static fxl_cached_vertex cache[CACHE_ENTRIES];
static fxl_renderer renderer;
static uint32_t draw_list_needed;
static uint32_t cache_used;

/* Of a scene with surfaces, and of one that asks for a depth buffer. */
static uint64_t looks[LOOKS_BYTES / 8u];
static uint64_t cells[FXL_DEPTH_BYTES(DRAW_PIXELS_MAX, 1, 16) / 8u];
static uint32_t looks_used, cells_used;
#ifdef DRAW_RGB565
static uint16_t palette[256];
#endif

/* Entries for the vertices of the scene's largest model, a power of two. */
static uint32_t cache_entries(const fxl_scene *scene)
{
    uint32_t vertices = 1, entries = 1;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const uint32_t count = scene->models[i].vertex_count;
        vertices = count > vertices ? count : vertices;
    }
    while (entries < vertices && entries < CACHE_ENTRIES) {
        entries *= 2u;
    }
    return entries;
}

/* Gives the renderer a target, with what the target needs. */
static fxl_status choose(const fxl_scene_image *image, const fxl_target *target)
{
    fxl_config config = fxl_config_for(1, 1, target);
#ifdef DRAW_RGB565
    for (uint32_t i = 0; i < 256u; i++) {
        const uint8_t *colour = image->palette + 3u * i;
        palette[i] = FXL_RGB565(colour[0], colour[1], colour[2]);
    }
    config.palette = palette;
#endif
    config.depth = cells;
    cells_used = image->depth_bits == 0
                     ? 0
                     : FXL_DEPTH_BYTES((uint32_t)image->lens.width * image->lens.height, 1, 16);
    config.depth_size = cells_used;
    return fxl_renderer_choose(&renderer, &config);
}

/* The surfaces of a scene, its light at run time, and its depth buffer, which holds the whole
 * frame. Nothing where the scene has none of them. */
static fxl_status open_looks(const fxl_scene_image *image)
{
    const bool has_depth = image->depth_bits != 0;
    const fxl_status status = choose(image, has_depth ? &WITH_DEPTH : &PLAIN);
    looks_used = walk_looks_bytes(image);
    if (looks_used > LOOKS_BYTES) {
        return FXL_E_CAPACITY;
    }
    return status == FXL_OK
               ? walk_looks_open(image, has_depth ? WITH_DEPTH_SURFACES : PLAIN_SURFACES, &renderer,
                                 (uint8_t *)looks)
               : status;
}

int draw_open(const fxl_scene_image *image)
{
    cache_used = cache_entries(&image->scene);
    draw_list_needed = image->scene.draw_list_needed;
    const fxl_memory memory = {order, draw_list_needed, list, LIST_WORDS, cache, cache_used};

    if (draw_list_needed > ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", draw_list_needed);
        return SYSTEM_EXIT_CAPACITY;
    }
    return fxl_renderer_init_with(&renderer, &image->scene, &image->lens, &memory) == FXL_OK &&
                   open_looks(image) == FXL_OK
               ? SYSTEM_EXIT_DONE
               : SYSTEM_EXIT_RENDER;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
#ifdef DRAW_RGB565
    fxl_band copy = *whole;
    const fxl_band *band = &copy;
    copy.palette = palette;
#else
    const fxl_band *band = whole;
#endif
#ifdef DRAW_BAND_ROWS
    return draw_in_bands(&renderer, pose, band, DRAW_BAND_ROWS, NOT_CLEARED);
#else
    return fxl_frame_begin(&renderer, pose) == FXL_OK && fxl_frame_draw(&renderer, band) == FXL_OK;
#endif
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof renderer + cache_used * sizeof cache[0] +
                      draw_list_needed * sizeof order[0]) +
           4u * LIST_WORDS + looks_used + cells_used;
}

const fxl_counters *draw_counters(void)
{
    return &renderer.workspace.counters;
}
