/* SPDX-License-Identifier: MIT */
#include "fill.h"
#include "scan.h"

#define FXL_DRAW_OUTLINE         fxl_draw_outline
#define FXL_DRAW_BY_ACTIVE_EDGES fxl_draw_by_active_edges
#define FXL_FILL_TRAPEZOID       fxl_fill_trapezoid
#define FXL_COLOUR               uint8_t

static void fill_span(fxl_active_edges *edges, const fxl_span *span, const fxl_band *band,
                      uint8_t colour)
{
    if (FXL_IS_SMALL) {
        fxl_active_edges_fill(edges, span, band, colour);
    } else {
        fxl_fill_span(band, span, colour);
    }
}

#include "draw_outline_text.h"
