/* SPDX-License-Identifier: MIT */
/* A pump that draws and sends what changed. A file of its own, so that a program which sends whole
 * frames links none of it. */
#include "pump_frame.h"

fxl_status fxl_pump_widen(const fxl_pump *pump, fxl_changed *changed)
{
    if (pump == NULL || changed == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (pump->sink.wait == NULL) {
        return FXL_E_ORDER;
    }
    uint32_t columns, rows;
    fxl_pump_steps(pump, &columns, &rows);
    return fxl_changed_widen(changed, columns, rows);
}

/* changed 4.1 */
fxl_status fxl_pump_changed(fxl_pump *pump, fxl_renderer *renderer, const fxl_pose *eye,
                            fxl_changed *changed)
{
    if (pump == NULL || renderer == NULL || changed == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_pump_check_renderer(pump, renderer);
    if (status == FXL_OK) {
        status = fxl_frame_begin(renderer, eye);
    }
    if (status == FXL_OK) {
        status = fxl_changed_find(changed, renderer);
    }
    if (status == FXL_OK) {
        status = fxl_pump_widen(pump, changed);
    }
    for (uint32_t i = 0; status == FXL_OK && i < changed->count; i++) {
        status = fxl_pump_begin_box(pump, &changed->boxes[i]);
        if (status == FXL_OK) {
            status = fxl_pump_draw_bands(pump, renderer);
        }
        if (status != FXL_OK) {
            changed->renderer = NULL; /* the display does not show this frame: the next is whole */
        }
    }
    return status;
}
