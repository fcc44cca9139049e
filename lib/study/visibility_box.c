/* SPDX-License-Identifier: MIT */
/* The raster backend that tests every pixel of a polygon's bounding box, for clippers that leave
 * the sides of the screen to the scan. */
#include "fixel/stage/fill.h"
#include "scan_box.h"
#include "../draw/submit.h"
#include "methods.h"

static bool paint(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    fxl_scan_box scan;
    fxl_span span;
    (void)workspace;
    fxl_scan_box_begin(points, count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        fxl_fill_span(band, &span, colour);
    }
    return true;
}

const fxl_raster_backend fxl_raster_box = {.draw_polygon = paint};

const fxl_visibility fxl_visibility_box = {.submit = fxl_submit_by_distance,
                                           .backend = &fxl_raster_box};
