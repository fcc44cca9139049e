/* SPDX-License-Identifier: MIT */
/* Every pixel of a polygon's bounding box is tested: for clippers that leave the sides of
 * the screen to the scan. */
#include "fixel/fill.h"
#include "fixel/scan_box.h"
#include "walk.h"

static bool paint(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    fxl_scan_box scan;
    fxl_span span;
    (void)renderer;
    fxl_scan_box_begin(points, count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        fxl_fill_span(band, &span, colour);
    }
    return true;
}

const fxl_painter fxl_painter_box = {.paint = paint};

const fxl_hidden fxl_hidden_box = {.walk = fxl_walk_by_distance, .painter = &fxl_painter_box};
