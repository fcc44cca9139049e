/* SPDX-License-Identifier: MIT */
/* The targets of the study. */
#include "targets.h"

#include "../draw/renderer.h"
#include "../math/arith.h"
#include "../raster/fill.h"
#include "../raster/scan.h"
#include "scan_box.h"
#include "span_buffer.h"

/* --- every pixel of a bounding box is tested, for clippers that leave the sides to the scan --- */

static bool paint_box(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                      const fxl_band *band)
{
    fxl_scan_box scan;
    fxl_span span;
    (void)workspace;
    fxl_scan_box_begin(polygon->points, polygon->count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        fxl_fill_span(band, &span, polygon->colour);
    }
    return true;
}

const fxl_target fxl_palette_box = {
    .pixel_bits = 8, .fill = fxl_fill_band_palette, .draw_band = fxl_draw_band, .flat = paint_box};

/* --- a span buffer ---------------------------------------------------------------------------- */

/* spans 3.1, 3.2 */
fxl_status fxl_band_split_draw(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band, fxl_band_begin *begin)
{
    const uint32_t end = (uint32_t)band->first_row + band->rows;
    fxl_band part = *band;
    uint16_t rows = band->rows;
    while (part.first_row < end) {
        const fxl_counters before = workspace->counters;
        part.rows = (uint16_t)(end - part.first_row < rows ? end - part.first_row : rows);
        begin(renderer, workspace, &part);
        if (fxl_draw_band(renderer, workspace, &part) == FXL_OK) {
            part.first_row = (uint16_t)(part.first_row + part.rows);
            part.pixels += (size_t)part.rows * part.stride;
        } else {
            FXL_ASSERT(part.rows > 1);
            workspace->counters = before;
            if (workspace->counters.split_bands < UINT16_MAX) {
                workspace->counters.split_bands++;
            }
            rows = (uint16_t)((part.rows + 1) / 2);
        }
    }
    return FXL_OK;
}

/* fxl_target.memory_size: the span buffer fills all the memory of the target. */
static uint32_t workspace_size(const fxl_lens *lens)
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

/* fxl_target.draw_band. */
static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    return fxl_band_split_draw(renderer, workspace, band, begin);
}

static fxl_span_buffer *spans_of(const fxl_workspace *workspace)
{
    return (fxl_span_buffer *)workspace->target_memory;
}

static bool paint_spans(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                        const fxl_band *band)
{
    fxl_span_buffer *buffer = spans_of(workspace);
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

/* A target of a span buffer that paints a flat face by a function. */
#define TARGET_OF_SPANS(paints) \
    { \
        .pixel_bits = 8, .near_first = true, .fill = fxl_fill_band_palette, \
        .choose = fxl_choose_with_memory, .memory_size = workspace_size, .draw_band = draw_band, \
        .flat = (paints) \
    }

const fxl_target fxl_palette_spans = TARGET_OF_SPANS(paint_spans);

static bool paint_spans_box(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                            const fxl_band *band)
{
    fxl_span_buffer *buffer = spans_of(workspace);
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

const fxl_target fxl_palette_spans_box = TARGET_OF_SPANS(paint_spans_box);
