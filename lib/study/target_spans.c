/* SPDX-License-Identifier: MIT */
#include "../raster/scan.h"
#include "target_spans.h"
#include "../draw/renderer.h"

uint32_t fxl_spans_workspace_size(const fxl_lens *lens)
{
    return FXL_SPAN_BUFFER_BYTES_LEAST(lens->width, lens->height);
}

/* fxl_band_begin. */
static void begin(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_span_buffer_make(
        workspace->target_memory, workspace->target_memory_size, renderer->frame.view.lens.height);
    fxl_span_buffer_begin(buffer, band);
}

fxl_status fxl_spans_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band)
{
    return fxl_band_split_draw(renderer, workspace, band, begin);
}

static bool paint(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_spans_of(workspace);
    fxl_scan *scan = &workspace->work.scan;
    const fxl_trapezoid *trapezoid;
    if (buffer->open_rows == 0) {
        return true;
    }
    fxl_scan_outline(polygon->points, polygon->count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        if (!fxl_span_buffer_draw(buffer, trapezoid, polygon->colour, band)) {
            return false;
        }
    }
    return true;
}

const fxl_target fxl_palette_spans = FXL_TARGET_OF_SPANS(paint);
