/* SPDX-License-Identifier: MIT */
/* A renderer whose lens moves its centre. A file of its own, so that a program whose lens stays as
 * it is links none of it. */
#include "../view/view.h"
#include "renderer.h"

fxl_status fxl_renderer_set_centre(fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    fxl_view *view = &renderer->frame.view;
    fxl_lens lens = view->lens;
    const fxl_status status = fxl_lens_set_centre(&lens, x, y);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    const uint32_t frame = view->frame;
    fxl_view_set_lens(view, &lens);
    view->frame = frame; /* clippers tell frames apart by it */
    renderer->frame.state = FXL_FRAME_NONE;
    return FXL_OK;
}
