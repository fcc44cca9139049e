/* SPDX-License-Identifier: MIT */
/* The target that tests every pixel of a polygon's bounding box, for clippers that leave
 * the sides of the screen to the scan. */
#include "../draw/submit.h"
#include "../raster/fill.h"
#include "targets.h"
#include "scan_box.h"

static bool paint(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
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
    .pixel_bits = 8, .fill = fxl_fill_band, .draw_band = fxl_draw_band, .flat = paint};
