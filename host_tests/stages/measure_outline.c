/* SPDX-License-Identifier: MIT */
/* What becomes of outlines: a list keeps them, a band is filled, a span buffer covers. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/order.h"
#include "reference/scan.h"
#include "stages/bridge.h"
#include "stages/measure.h"
#include "study/span_buffer.h"

const stages_tally stages_list_tally = {
    .stage = "list",
    .unit = "rows",
    .measure = "rows that a polygon is kept for, too many or too few, given the same 16.16 "
               "outline; and polygons that a list of any size gives back for a band, in order",
    .bound = "0",
};

/* Compares one polygon's rows on both sides. */
static fxl_rows measure_rows(stages_tally *tally, const fxl_screen_polygon *polygon,
                             ref_drawn *drawn, uint16_t height)
{
    fxl_rows rows = fxl_scan_rows(polygon, height);
    drawn->polygon = bridge_screen_polygon(polygon);
    drawn->rows = ref_scan_rows(&drawn->polygon, height);
    int none = rows.first == rows.end && drawn->rows.first == drawn->rows.end;
    int wrong = none ? 0 : abs(rows.first - drawn->rows.first) + abs(rows.end - drawn->rows.end);
    stages_count(tally, wrong, wrong == 0);
    return rows;
}

static int same(const fxl_screen_polygon *record, const ref_drawn *drawn)
{
    int equal = record->count == drawn->polygon.count && record->colour == drawn->polygon.colour;
    for (int i = 0; equal && i < record->count; i++) {
        equal = record->points[i].x / REF_ONE == drawn->polygon.points[i].x &&
                record->points[i].y / REF_ONE == drawn->polygon.points[i].y;
    }
    return equal;
}

/* Tells whether both lists return the same polygons for the wanted rows. */
static int plays_alike(const fxl_display_list *list, const ref_display_list *twin, fxl_rows wanted)
{
    ref_rows rows = {wanted.first, wanted.end};
    const fxl_screen_polygon *record;
    uint32_t place = 0;
    size_t twin_place = 0;
    while ((record = fxl_display_list_next(list, wanted, &place)) != NULL) {
        const ref_drawn *drawn = ref_display_list_next(twin, rows, &twin_place);
        if (!drawn || !same(record, drawn)) {
            return 0;
        }
    }
    return ref_display_list_next(twin, rows, &twin_place) == NULL;
}

void stages_measure_list(stages_tally *tally, const fxl_screen_polygon *polygons, uint32_t count,
                         uint16_t height, uint32_t words, fxl_rows wanted)
{
    fxl_display_list list = {malloc(words * sizeof(uint32_t) + 1), words, 0};
    ref_display_list twin = {0};
    uint32_t left = words; /* SPEC.md, section 7: two words and two for each point */
    int sound = list.words != NULL, fits = 1;
    for (uint32_t i = 0; i < count && sound && fits; i++) {
        ref_drawn drawn = {0};
        fxl_rows rows = measure_rows(tally, &polygons[i], &drawn, height);
        if (drawn.rows.first == drawn.rows.end) {
            continue;
        }
        uint32_t needed = 2 + 2 * (uint32_t)drawn.polygon.count;
        fits = needed <= left;
        left -= fits ? needed : 0;
        sound = fxl_display_list_append(&list, &polygons[i], rows) == fits &&
                (!fits || ref_display_list_append(&twin, &drawn));
    }
    tally->mismatched += !sound || !plays_alike(&list, &twin, wanted);
    ref_display_list_close(&twin);
    free(list.words);
}

/* --- fill ---------------------------------------------------------------------------------------- */

/* place fill-rule: the pixels that a design has wrong */
const stages_tally stages_fill_tally = {
    .stage = "fill",
    .unit = "pixels",
    .measure = "pixels of a polygon that differ from the winding rule tested exactly at every "
               "pixel centre, given the same 16.16 outline; a pixel drawn twice counts too",
    .bound = "0",
};

/* Marks the library's pixels. Returns how many it drew twice or outside. */
static uint32_t draw_fixed(const fxl_screen_polygon *polygon, const fxl_band *band, uint32_t *drawn)
{
    static fxl_scan scan;
    fxl_span span;
    uint32_t wrong = 0;
    *drawn = 0;
    if (fxl_scan_begin(polygon, band, &scan) != FXL_OK) {
        return 1;
    }
    while (fxl_scan_next(&scan, &span)) {
        int row = span.y - band->first_row;
        if (row < 0 || row >= band->rows || span.x0 < 0 || span.x1 > band->width ||
            span.x0 >= span.x1) {
            wrong++;
            continue;
        }
        uint8_t *pixels = band->pixels + row * band->stride;
        for (int x = span.x0; x < span.x1; x++) {
            wrong += pixels[x] != 0;
            pixels[x] = 1;
            ++*drawn;
        }
    }
    return wrong;
}

void stages_measure_fill(stages_tally *tally, const fxl_screen_polygon *polygon,
                         const fxl_band *band)
{
    uint32_t drawn, found = 0;
    uint32_t wrong = draw_fixed(polygon, band, &drawn);
    ref_screen_polygon exact = bridge_screen_polygon(polygon);
    ref_band exact_band = {band->pixels, band->width, band->stride, band->first_row, band->rows,
                           NULL};
    ref_scan box; /* for its bounding box; every pixel of the box is tested here */
    ref_scan_begin(&exact, &exact_band, &box);
    for (int y = box.y; y < box.y1; y++) {
        uint8_t *pixels = band->pixels + (y - band->first_row) * band->stride;
        for (int x = box.x0; x < box.x1; x++) {
            wrong += (pixels[x] != 0) != ref_scan_covers(&exact, x + 0.5, y + 0.5);
            found += pixels[x] != 0;
            pixels[x] = 0;
        }
    }
    if (found != drawn) { /* beyond the bounding box: rare, so clear all pixels */
        wrong += drawn - found;
        for (int i = 0; i < band->rows * band->stride; i++) {
            band->pixels[i] = 0;
        }
    }
    stages_count(tally, wrong, wrong == 0);
}

/* --- cover --------------------------------------------------------------------------------------- */

const stages_tally stages_cover_tally = {
    .stage = "cover",
    .unit = "pixels",
    .measure = "pixels of a polygon, and runs of covered ones, that differ from a mark for "
               "each pixel, given the same spans front to back and a pool of any size",
    .bound = "0",
};

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
