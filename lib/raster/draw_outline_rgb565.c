/* SPDX-License-Identifier: MIT */
#include "fill.h"
#include "scan.h"

#define FXL_DRAW_OUTLINE         fxl_draw_outline_rgb565
#define FXL_DRAW_BY_ACTIVE_EDGES fxl_draw_by_active_edges_rgb565
#define FXL_FILL_TRAPEZOID       fxl_fill_trapezoid_rgb565
#define FXL_COLOUR               uint16_t

/* rgb565 3.1 */
static void fill_span(const fxl_active_edges *edges, const fxl_span *span, const fxl_band *band,
                      uint16_t colour)
{
    (void)edges;
    uint16_t *row =
        (uint16_t *)(void *)band->pixels + (size_t)(span->y - band->first_row) * band->stride;
    fxl_fill_row_rgb565(row + span->x0, row + span->x1, colour);
}

#include "draw_outline_text.h"
