/* SPDX-License-Identifier: MIT */
/* What a pump asks of a renderer whose frames it sends. Internal. */
#ifndef FXL_PUMP_FRAME_H
#define FXL_PUMP_FRAME_H

#include "../raster/columns.h"
#include "fixel/pump.h"

/* FXL_E_RANGE: a screen of another size than the pump's. FXL_E_COMBINATION: a renderer of RGB565 and
 * a pump of palette indices, or the other way round. */
static inline fxl_status fxl_pump_check_renderer(const fxl_pump *pump, const fxl_renderer *renderer)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    if (lens->width != pump->config.width || lens->height != pump->config.height) {
        return FXL_E_RANGE;
    }
    return renderer->target != NULL && renderer->target->has_palette !=
                                           fxl_kind_of_palette(pump->config.palette).is_colour
               ? FXL_E_COMBINATION
               : FXL_OK;
}

/* The bands of a frame, or of a box, that has begun: each is cleared, drawn and sent. */
static inline fxl_status fxl_pump_draw_bands(fxl_pump *pump, fxl_renderer *renderer)
{
    fxl_status status = FXL_OK;
    for (const fxl_band *band; status == FXL_OK && (band = fxl_pump_band(pump)) != NULL;) {
        fxl_frame_fill(renderer, band, renderer->frame.background);
        status = fxl_frame_draw(renderer, band);
        if (status == FXL_OK) {
            status = fxl_pump_send(pump);
        }
    }
    return status;
}

#endif
