/* SPDX-License-Identifier: MIT */
/* A file of its own, so that a program which has fxl_renderer_init choose does not link it. */
#include "renderer.h"
#include "submit.h"

/* combinations 1.5 */
FXL_COLD fxl_status fxl_renderer_choose(fxl_renderer *renderer, const fxl_config *config)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = FXL_E_ARGUMENT;
    if (config != NULL && config->target != NULL) {
        const fxl_order *order = fxl_order_of(config);
        status = renderer->scene == NULL || fxl_has_attachments(renderer) ? FXL_E_ORDER
                 : order->choose != NULL ? order->choose(renderer, config)
                                         : fxl_choose_with_memory(renderer, config);
    }
    return status == FXL_OK ? status : fxl_refuse(&renderer->workspace, status);
}
