/* SPDX-License-Identifier: MIT */
/* What a first program calls: the usual clipper, one block of memory,
 * whole frames. A file of its own, so that a program which sets others does not link these. */
#include "fixel.h"

#include "renderer.h"
#include "submit.h"

FXL_COLD fxl_config fxl_config_for(uint16_t width, uint16_t height, const fxl_target *target)
{
    fxl_config config;
    config.width = width;
    config.height = height;
    config.fov = FXL_DEGREES(60);
    config.near_z = FXL_RATIO(1, 4);
    config.far_z = FXL_UNITS(256);
    config.inset = FXL_INSET_DEFAULT;
    config.background = 0;
    config.target = target;
    config.order = NULL;
    config.palette = NULL;
    config.depth = config.tree = NULL;
    config.depth_size = config.tree_size = 0;
    return config;
}

static fxl_memory divide(const fxl_scene *scene, uint8_t *block, size_t size)
{
    const size_t order = fxl_aligned(scene->draw_list_needed * sizeof(fxl_draw_entry));
    size_t remaining = size - order;
    const uint32_t entries = fxl_cache_entries(scene, remaining / 4);
    const size_t cache = entries * sizeof(fxl_cached_vertex);
    size_t words = (remaining - cache) / sizeof(uint32_t);
    fxl_memory memory;
    memory.draw_list = (fxl_draw_entry *)(void *)block;
    memory.draw_list_capacity = scene->draw_list_needed;
    memory.cache = entries > 0 ? (fxl_cached_vertex *)(void *)(block + order) : NULL;
    memory.cache_capacity = entries;
    memory.display_list = (uint32_t *)(void *)(block + order + cache);
    memory.display_list_capacity = words < UINT32_MAX ? (uint32_t)words : UINT32_MAX;
    return memory;
}

/* The order and the target. Most have neither memory nor anything to look at. */
static fxl_status choose(fxl_renderer *renderer, const fxl_config *config)
{
    const fxl_order *order = fxl_order_of(config);
    const fxl_target *target = config->target;
    fxl_status (*own)(fxl_renderer *, const fxl_config *) =
        order->choose != NULL ? order->choose : target->choose;
    if (own != NULL) {
        return own(renderer, config);
    }
    renderer->order = order;
    renderer->target = target;
    renderer->fill = target->fill;
    return FXL_OK;
}

FXL_COLD fxl_status fxl_renderer_init(fxl_renderer *renderer, const fxl_scene *scene,
                                      const fxl_config *config, void *memory, size_t memory_size)
{
    fxl_lens lens;
    if (renderer == NULL || scene == NULL || config == NULL || memory == NULL ||
        config->target == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (((uintptr_t)memory & 7u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    if (scene->draw_list_needed == 0) {
        return FXL_E_ORDER;
    }
    fxl_status status = fxl_lens_from_fov(config->width, config->height, config->fov,
                                          config->near_z, config->far_z, config->inset, &lens);
    if (status != FXL_OK) {
        return status;
    }
    const size_t least = fxl_aligned(scene->draw_list_needed * sizeof(fxl_draw_entry));
    if (memory_size < least) {
        renderer->memory_missing = (uint32_t)(least - memory_size);
        return FXL_E_CAPACITY;
    }
    const fxl_memory tables = divide(scene, (uint8_t *)memory, memory_size);
    status = fxl_renderer_init_bare(renderer, scene, &lens, &tables);
    if (status != FXL_OK) {
        return status;
    }
    renderer->frame.background = config->background;
    renderer->clipper = &fxl_clipper_view;
    return choose(renderer, config);
}

/* SPEC 4.1 */
fxl_status fxl_render(fxl_renderer *renderer, const fxl_pose *eye, void *pixels, uint16_t stride)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_lens *lens = &renderer->frame.view.lens;
    fxl_band whole;
    fxl_status status = FXL_OK;
    whole.width = lens->width;
    whole.rows = lens->height;
    whole.pixels = (uint8_t *)pixels;
    whole.stride = stride;
    whole.first_row = 0;
    whole.first_column = 0;
    whole.columns = 0;
    whole.palette = renderer->palette;
    if (pixels == NULL) {
        status = FXL_E_ARGUMENT;
    } else if (stride < lens->width) {
        status = FXL_E_RANGE;
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    status = fxl_begin_one_band(renderer, eye);
    if (status != FXL_OK) {
        return status;
    }
    renderer->fill(renderer, &whole, renderer->frame.background);
    return renderer->target->draw_band(renderer, &renderer->workspace, &whole);
}
