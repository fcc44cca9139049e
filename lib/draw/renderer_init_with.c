/* SPDX-License-Identifier: MIT */
/* The usual clipper, order and target. A file of its own, so that a program which names others links
 * none of these. */
#include "renderer.h"

fxl_status fxl_renderer_init_with(fxl_renderer *renderer, const fxl_scene *scene,
                                  const fxl_lens *lens, const fxl_memory *memory)
{
    fxl_status status = fxl_renderer_init_bare(renderer, scene, lens, memory);
    if (status == FXL_OK) {
        renderer->clipper = &fxl_clipper_view;
        renderer->order = &fxl_by_distance;
        renderer->target = &fxl_palette;
        fxl_take_lens(renderer);
        renderer->fill = fxl_palette.fill;
    }
    return status;
}
