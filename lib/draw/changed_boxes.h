/* SPDX-License-Identifier: MIT */
/* The boxes of what changed. Internal. */
#ifndef FXL_CHANGED_BOXES_H
#define FXL_CHANGED_BOXES_H

#include "fixel/changed.h"
#include "submit.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline fxl_screen_box fxl_box_of_frame(const fxl_lens *lens)
{
    const fxl_screen_box all = {0, lens->width, 0, lens->height};
    return all;
}

/* Adds a box of the frame to those that *changed has; five are joined until there are four. */
void fxl_changed_join(fxl_changed *changed, const fxl_screen_box *box);

/* Adds the box of an instance of a scene, which is the renderer's or has its tables, as the
 * renderer's frame shows it: as a billboard, or as its model where that is null. None is added for
 * one that covers no pixel. */
void fxl_changed_show(fxl_changed *changed, const fxl_renderer *renderer, const fxl_scene *scene,
                      uint32_t number, const fxl_billboard *billboard);

#ifdef __cplusplus
}
#endif

#endif
