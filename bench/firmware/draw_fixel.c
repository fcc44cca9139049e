/* SPDX-License-Identifier: MIT */
/* Draws with Fixel, the frame in one band, so it needs no display list; or in bands of
 * DRAW_BAND_ROWS, with a list of DRAW_LIST_WORDS. With DRAW_RGB565 it draws into RGB565, else into
 * palette indices; with DRAW_CLEARED it clears the frame too. */
#include "contract/system.h"
#include "draw.h"
#include "fixel/surfaces.h"
#include "plan.h"
#include "program.h"

#ifndef ORDER_ENTRIES
#define ORDER_ENTRIES 16384u /* a ground of 16,200 faces in one model takes 16,201 */
#endif
#define CACHE_ENTRIES 256u  /* at most */
#define LOOKS_BYTES   (4096u + FXL_DEPTH_BYTES(DRAW_PIXELS_MAX, 1, 16))

#ifdef DRAW_BAND_ROWS
static uint32_t list[DRAW_LIST_WORDS];
#define LIST_WORDS DRAW_LIST_WORDS
#else
static uint32_t *const list = NULL;
#define LIST_WORDS 0u
#endif

#ifdef DRAW_RGB565
#define PLAIN      fxl_rgb565
#define WITH_DEPTH fxl_rgb565_depth_16
#else
#define PLAIN      fxl_palette
#define WITH_DEPTH fxl_palette_depth_16
#endif
#define DRAWS(target) \
    { \
        &target, FXL_SURFACES_OF(target), FXL_SPRITES_OF(target) \
    }

static fxl_draw_entry order[ORDER_ENTRIES];
static fxl_cached_vertex cache[CACHE_ENTRIES];
static fxl_setup_plan plan;
static fxl_setup setup;
static uint32_t draw_list_needed;
static uint32_t cache_used;

/* What a scene has beside its faces, and a depth buffer of the whole frame. */
static uint64_t looks[LOOKS_BYTES / 8u];
static uint32_t looks_used, record_bytes;

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

int draw_open(const fxl_scene_image *image)
{
    static const walk_target plain = DRAWS(PLAIN);
    static const walk_target with_depth = DRAWS(WITH_DEPTH);
    static walk_methods methods;
    static walk_plan of;

    cache_used = cache_entries(&image->scene);
    draw_list_needed = image->scene.draw_list_needed;
    if (draw_list_needed > ORDER_ENTRIES) {
        text_with_number("bench: order entries needed", "", ": ", draw_list_needed);
        return SYSTEM_EXIT_CAPACITY;
    }
    methods = (walk_methods){&fxl_clipper_view, &fxl_by_distance,
                             image->depth_bits != 0 ? with_depth : plain};
    plan = (fxl_setup_plan){0};
    of = (walk_plan){.image = image,
                     .methods = &methods,
                     .tables = {order, draw_list_needed, list, LIST_WORDS, cache, cache_used},
                     .rows = image->lens.height,
                     .block = (uint8_t *)looks,
                     .size = sizeof looks};
    if (walk_plan_open(&of, &plan, &setup) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
    looks_used = of.used;
    record_bytes = image->surfaces.face_map != NULL || image->light.base != NULL
                       ? sizeof setup
                       : sizeof setup.renderer;
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
#ifdef DRAW_RGB565
    fxl_band copy = *whole;
    const fxl_band *band = &copy;
    copy.palette = setup.renderer.palette;
#else
    const fxl_band *band = whole;
#endif
#ifdef DRAW_BAND_ROWS
    return draw_in_bands(&setup.renderer, pose, band, DRAW_BAND_ROWS, NOT_CLEARED);
#else
    if (fxl_frame_begin(&setup.renderer, pose) != FXL_OK) {
        return false;
    }
#ifdef DRAW_CLEARED
    fxl_frame_fill(&setup.renderer, band, 0);
#endif
    return fxl_frame_draw(&setup.renderer, band) == FXL_OK;
#endif
}

uint32_t draw_memory(void)
{
    return (uint32_t)(record_bytes + cache_used * sizeof cache[0] +
                      draw_list_needed * sizeof order[0]) +
           4u * LIST_WORDS + looks_used;
}

const fxl_counters *draw_counters(void)
{
    return &setup.renderer.workspace.counters;
}
