/* SPDX-License-Identifier: MIT */
/* What the files of draw share beside submit.h. Internal. */
#ifndef FXL_RENDERER_H
#define FXL_RENDERER_H

#include "fixel/render.h"

/* Counts a call that is refused; answers its status. */
fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status);

/* fxl_frame_begin. in_bands: the frame will be drawn in several bands. Then it pays to measure the
 * rows of what the display list had no room for. A frame of one band leaves the list empty: to
 * write a polygon and read it once costs more instructions than to draw it at once. */
fxl_status fxl_begin(fxl_renderer *renderer, const fxl_pose *pose, bool in_bands);

/* The order and the target of a renderer, and their memory, aligned to 8 bytes. */
typedef struct fxl_choice {
    const fxl_order *order;
    const fxl_target *target;
    bool near_first;
    void *order_memory, *target_memory;
    uint32_t order_size, target_size; /* bytes */
} fxl_choice;

/* Gives an order and a target to a renderer that is initialised. FXL_E_CAPACITY: renderer
 * untouched. */
fxl_status fxl_renderer_choose(fxl_renderer *renderer, const fxl_choice *choice);

/* Entries of a scene's order_needed that are for the instances, whatever instance_count becomes in
 * a world. The others are for the faces of one model. */
static inline uint32_t fxl_order_instances_most(const fxl_scene *scene)
{
    return scene->instance_capacity > 0 ? scene->instance_capacity : scene->instance_count;
}

/* Bytes, rounded up to what any table may begin at. */
static inline size_t fxl_aligned(size_t bytes)
{
    return (bytes + 7u) & ~(size_t)7u;
}

/* Entries of a vertex cache for the largest model of a scene, a power of two, or as many as fit so
 * many bytes. */
uint32_t fxl_cache_entries(const fxl_scene *scene, size_t bytes);

#endif
