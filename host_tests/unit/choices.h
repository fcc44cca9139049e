/* SPDX-License-Identifier: MIT */
/* The orders and targets of tests that give a renderer's tables themselves, in pairs. */
#ifndef CHOICES_H
#define CHOICES_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "study/targets.h"

typedef struct {
    const fxl_order *order;
    const fxl_target *target;
} choice;

static const choice choice_sorted = {&fxl_by_distance, &fxl_palette};
static const choice choice_box = {&fxl_by_distance, &fxl_palette_box};
static const choice choice_spans = {&fxl_by_distance, &fxl_palette_spans};
static const choice choice_spans_box = {&fxl_by_distance, &fxl_palette_spans_box};
static const choice choice_depth_16 = {&fxl_by_distance, &fxl_palette_depth_16};
static const choice choice_depth_32 = {&fxl_by_distance, &fxl_palette_depth_32};
static const choice choice_tree = {&fxl_by_tree, &fxl_palette};
static const choice choice_tree_spans = {&fxl_by_tree, &fxl_palette_spans};

/* Gives a renderer an order and a target, which share the memory: the least that the order needs,
 * so without pieces of a tree, and the rest for the target. */
static inline fxl_status choice_take(fxl_renderer *renderer, const choice *pair, void *memory,
                                     uint32_t size)
{
    fxl_config config = fxl_config_for(1, 1, pair->target);
    uint32_t least = 0;
    if (pair->order->memory_size != NULL) {
        least = (pair->order->memory_size(renderer->scene) + 7u) & ~7u;
    }
    least = size < least ? size : least;
    config.order = pair->order;
    config.tree = memory;
    config.tree_size = least;
    config.depth = memory != NULL ? (uint8_t *)memory + least : NULL;
    config.depth_size = size - least;
    return fxl_renderer_choose(renderer, &config);
}

#endif
