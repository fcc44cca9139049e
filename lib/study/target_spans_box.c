/* SPDX-License-Identifier: MIT */
#include "scan_box.h"
#include "target_spans.h"
#include "../draw/renderer.h"

static bool paint(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_spans_of(workspace);
    fxl_scan_box scan;
    fxl_span span;
    if (buffer->open_rows == 0) {
        return true;
    }
    fxl_scan_box_begin(polygon->points, polygon->count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        const fxl_trapezoid row = fxl_trapezoid_of_span(&span);
        if (!fxl_span_buffer_draw(buffer, &row, polygon->colour, band)) {
            return false;
        }
    }
    return true;
}

const fxl_target fxl_palette_spans_box = FXL_TARGET_OF_SPANS(paint);
