/* SPDX-License-Identifier: MIT */
/* Draws with Fixel, any clipper, order and target, the frame in one band. */
#include "combination.h"
#include "contract/system.h"
#include "fixel/beams.h"
#include "program.h"

/* Zeroes take space in the image, and the scene follows them: all together must be below 480 KB. */
#define ORDER_ENTRIES 12288u
#define CACHE_ENTRIES 256u
#define CLIPPER_BYTES 16384u
#define HIDDEN_BYTES  65536u
#define LIGHT_BYTES   8192u

static fxl_draw_entry order[ORDER_ENTRIES];
static fxl_cached_vertex cache[CACHE_ENTRIES];
static uint64_t clipper_room[CLIPPER_BYTES / 8u], hidden_room[HIDDEN_BYTES / 8u];
static uint64_t light_room[LIGHT_BYTES / 8u];
static fxl_renderer renderer;
static uint32_t order_used, hidden_used, pieces_used, light_used;

/* The order and the target, and their memory: of the target the chosen size, or the least. */
static fxl_config choice_for(const fxl_scene_image *image)
{
    fxl_config config =
        fxl_config_for(image->lens.width, image->lens.height, combination_chosen.target);

    config.order = combination_chosen.order;
    if (config.order->memory_size != NULL) {
        config.tree_size = (config.order->memory_size(&image->scene) + 7u) & ~7u;
    }
    if (config.target->memory_size != NULL) {
        const uint32_t least = config.target->memory_size(&image->lens);

        config.depth_size = least < combination_chosen.room ? combination_chosen.room : least;
    }
    config.tree = hidden_room;
    config.depth = (uint8_t *)hidden_room + config.tree_size;
    return config;
}

int draw_open(const fxl_scene_image *image)
{
    const fxl_memory memory = {order, ORDER_ENTRIES, NULL, 0, cache, CACHE_ENTRIES};
    const fxl_config config = choice_for(image);
    const fxl_beam_set beams = {image->scene.beams, image->scene.beam_count, image->scene.lit};

    order_used = image->scene.draw_list_needed;
    hidden_used = config.tree_size + config.depth_size;
    light_used = image->scene.beam_count > 0
                     ? fxl_beam_light_workspace_size(image->scene.beams, image->scene.beam_count)
                     : 0;
    if (order_used > ORDER_ENTRIES || hidden_used > HIDDEN_BYTES || light_used > LIGHT_BYTES ||
        combination_chosen.clipper->workspace_size > CLIPPER_BYTES) {
        text_with_number("bench: order entries needed", "", ": ", order_used);
        text_with_number("bench: bytes of workspace needed", "", ": ", hidden_used);
        return SYSTEM_EXIT_CAPACITY;
    }
    if (fxl_renderer_init_bare(&renderer, &image->scene, &image->lens, &memory) != FXL_OK ||
        fxl_renderer_set_clipper(&renderer, combination_chosen.clipper, clipper_room,
                                 combination_chosen.clipper->workspace_size) != FXL_OK ||
        fxl_renderer_choose(&renderer, &config) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
    if (light_used > 0 && fxl_attach_beams(&renderer, &beams, light_room, light_used) != FXL_OK) {
        return SYSTEM_EXIT_RENDER;
    }
    combination_prepare(&renderer);
    return SYSTEM_EXIT_DONE;
}

bool draw_frame(const fxl_pose *pose, const fxl_band *band)
{
    return fxl_frame_begin(&renderer, pose) == FXL_OK && fxl_frame_draw(&renderer, band) == FXL_OK;
}

uint32_t draw_memory(void)
{
    return (uint32_t)(sizeof renderer + sizeof cache + order_used * sizeof order[0]) +
           combination_chosen.clipper->workspace_size + hidden_used + pieces_used + light_used;
}

/* Called after each frame. */
const fxl_counters *draw_counters(void)
{
    pieces_used = combination_memory(&renderer);
    return &renderer.workspace.counters;
}

fxl_renderer *draw_renderer(void)
{
    return &renderer;
}

/* Methods that need only their workspace. */
__attribute__((weak)) void combination_prepare(fxl_renderer *prepared)
{
    (void)prepared;
}

__attribute__((weak)) uint32_t combination_memory(const fxl_renderer *prepared)
{
    (void)prepared;
    return 0;
}
