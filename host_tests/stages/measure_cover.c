/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "reference/scan.h"
#include "stages/bridge.h"
#include "stages/measure.h"
#include "study/span_buffer.h"

stages_tally stages_cover_tally(const char *input)
{
    return (stages_tally){
        .stage = "cover",
        .input = input,
        .unit = "pixels",
        .measure = "pixels of a polygon, and runs of covered ones, that differ from a mark for "
                   "each pixel, given the same spans front to back and a pool of any size",
        .bound = "0",
    };
}

/* Both sides, and a band for each. */
typedef struct {
    fxl_span_buffer *buffer;
    fxl_band band;
    ref_span_buffer cover;
    ref_band twin;
} sides;

/* Returns the number of intervals in the band; -1 where they are not in order or touch. */
static long runs_of(const fxl_span_buffer *buffer)
{
    long runs = 0;
    for (uint32_t row = 0; row < buffer->row_count; row++) {
        int32_t end = -1;
        for (uint32_t at = buffer->rows[row]; at != FXL_COVERED_END; at = buffer->pool[at].next) {
            const fxl_covered *covered = &buffer->pool[at];
            if (covered->x0 <= end || covered->x1 <= covered->x0 || covered->x1 > buffer->width) {
                return -1;
            }
            end = covered->x1;
            runs++;
        }
    }
    return runs;
}

/* Draws one polygon on both sides. Returns false where the pool is full. Different results are a
 * mismatch. */
static bool cover_polygon(sides *of, const fxl_screen_polygon *polygon, stages_tally *tally)
{
    static fxl_scan scan;
    fxl_span span;
    if (fxl_scan_begin(polygon, &of->band, &scan) != FXL_OK) {
        tally->mismatched++;
        return false;
    }
    while (fxl_scan_next(&scan, &span)) {
        const ref_span same = {span.y, span.x0, span.x1};
        const fxl_trapezoid row = fxl_trapezoid_of_span(&span);
        bool taken = fxl_span_buffer_draw(of->buffer, &row, polygon->colour, &of->band);
        if (taken != ref_span_buffer_draw(&of->cover, &same, polygon->colour, &of->twin,
                                          of->buffer->capacity)) {
            tally->mismatched++;
            return false;
        }
        if (!taken) {
            return false;
        }
    }
    return true;
}

static uint32_t differing(const sides *of)
{
    uint32_t wrong = 0;
    for (int i = 0; i < of->band.rows * of->band.width; i++) {
        wrong += of->band.pixels[i] != of->twin.pixels[i];
    }
    return wrong;
}

void stages_measure_cover(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                          uint16_t width, fxl_rows rows, uint32_t intervals)
{
    const uint16_t height = (uint16_t)(rows.end - rows.first);
    const uint32_t size = FXL_SPAN_BUFFER_BYTES(height, intervals);
    const size_t pixels = (size_t)width * height;
    void *room = malloc(size);
    bool *covered = malloc(pixels * sizeof *covered);
    sides of = {.band = {.pixels = calloc(pixels, 1), .width = width, .stride = width, .first_row = rows.first, .rows = height},
                .twin = {calloc(pixels, 1), width, width, rows.first, height}};
    if (room && covered && of.band.pixels && of.twin.pixels) {
        of.buffer = fxl_span_buffer_make(room, size, height);
        fxl_span_buffer_begin(of.buffer, &of.band);
        ref_span_buffer_begin(&of.cover, covered, &of.twin);
        for (uint32_t i = 0, more = 1; i < count && more; i++) {
            more = cover_polygon(&of, &polygons[i], tally);
            uint32_t wrong = differing(&of);
            wrong += runs_of(of.buffer) != ref_span_buffer_intervals(&of.cover);
            stages_count(tally, wrong, wrong == 0);
        }
    } else {
        tally->mismatched++;
    }
    free(room);
    free(covered);
    free(of.band.pixels);
    free(of.twin.pixels);
}
