/* SPDX-License-Identifier: MIT */
/* A renderer whose lens moves its centre, or becomes orthographic. A file of its own, so that a
 * program whose lens stays as it is links none of it. */
#include "../view/view.h"
#include "renderer.h"
#include "submit.h"

/* A valid lens of the same screen. */
static void set_lens(fxl_renderer *renderer, const fxl_lens *lens)
{
    fxl_view *view = &renderer->frame.view;
    const uint32_t frame = view->frame;
    fxl_view_set_lens(view, lens);
    view->frame = frame; /* clippers tell frames apart by it */
    renderer->frame.state = FXL_FRAME_NONE;
}

fxl_status fxl_renderer_set_centre(fxl_renderer *renderer, fxl_q16_16 x, fxl_q16_16 y)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    fxl_lens lens = renderer->frame.view.lens;
    const fxl_status status = fxl_lens_set_centre(&lens, x, y);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    set_lens(renderer, &lens);
    return FXL_OK;
}

fxl_status fxl_renderer_set_orthographic(fxl_renderer *renderer, fxl_q16_16 scale)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_lens *before = &renderer->frame.view.lens;
    fxl_lens lens;
    fxl_status status = FXL_E_ORDER;
    if (renderer->scene != NULL && !fxl_has_attachments(renderer)) {
        status = fxl_lens_orthographic(before->width, before->height, scale, before->near_z,
                                       before->far_z, &lens);
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    set_lens(renderer, &lens);
    fxl_take_lens(renderer);
    FXL_COUNT_CHANGE(&renderer->workspace);
    return FXL_OK;
}
