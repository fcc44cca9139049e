/* SPDX-License-Identifier: MIT */
#include "submit.h"
#include "fixel/beam_light.h"

fxl_status fxl_attach_beams(fxl_renderer *renderer, const fxl_beam_set *set, void *memory,
                            uint32_t size)
{
    const fxl_status status =
        set != NULL
            ? fxl_renderer_set_beams(renderer, set->beams, set->count, set->lit, memory, size)
            : fxl_renderer_set_beams(renderer, NULL, 0, NULL, NULL, 0);
    if (status == FXL_OK) {
        renderer->check = fxl_check_combination;
    }
    return status;
}
