/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "reference/scan.h"
#include "stages/bridge.h"
#include "stages/measure.h"

/* place fill-rule: the pixels that a design has wrong */
stages_tally stages_fill_tally(const char *input)
{
    return (stages_tally){
        .stage = "fill",
        .input = input,
        .unit = "pixels",
        .measure = "pixels of a polygon that differ from the winding rule tested exactly at every "
                   "pixel centre, given the same 16.16 outline; a pixel drawn twice counts too",
        .bound = "0",
    };
}

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
