/* SPDX-License-Identifier: MIT */
#include "../../src/raster/fill_row.h"
#include "paint.h"

static void paint_trapezoid(const fxl_paint *paint, const fxl_trapezoid *trapezoid,
                            const fxl_band *band)
{
    const fxl_gradients *gradients = paint->gradients;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    fxl_paint_row row;
    row.pixels = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    for (row.y = trapezoid->first_row; row.y < trapezoid->end_row; row.y++) {
        const int32_t x0 = a.x <= b.x ? a.x : b.x, x1 = a.x <= b.x ? b.x : a.x;
        if (x0 < x1) {
            row.weight = gradients->weight.at + gradients->weight.down * row.y;
            for (uint32_t i = 0; i < gradients->count; i++) {
                row.attributes[i] =
                    gradients->attributes[i].at + gradients->attributes[i].down * row.y;
            }
            fxl_paint_pixels(paint, &row, x0, x1);
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        row.pixels += band->stride;
    }
}

void fxl_paint_polygon(const fxl_paint *paint, const fxl_screen_point *points, uint32_t count,
                       const fxl_band *band, fxl_scan *scan)
{
    const fxl_trapezoid *trapezoid;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        paint_trapezoid(paint, trapezoid, band);
    }
}
