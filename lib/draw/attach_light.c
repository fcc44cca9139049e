/* SPDX-License-Identifier: MIT */
/* A file of its own, so that a program which sets a light links no look at what goes together. */
#include "submit.h"
#include "fixel/light.h"

fxl_status fxl_attach_light(fxl_renderer *renderer, fxl_light *light,
                            const fxl_light_settings *settings)
{
    const fxl_status status = fxl_renderer_set_light(renderer, light, settings);
    if (status == FXL_OK) {
        renderer->check = fxl_check_combination;
    }
    return status;
}
