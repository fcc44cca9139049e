/* SPDX-License-Identifier: MIT */
#include "raster/draw_outline.c"
#undef FXL_DRAW_OUTLINE
#undef FXL_DRAW_BY_ACTIVE_EDGES
#undef FXL_FILL_TRAPEZOID
#undef FXL_COLOUR
#undef FXL_DRAW_OUTLINE_TEXT_H
#define fill_span fill_span_565
#include "raster/draw_outline_rgb565.c"
#include "proof.h"

#ifndef CASE
#define CASE 0 /* for the rows that have none */
#endif

#define ROWS   2
#define STRIDE 8

static uint16_t pixels[ROWS * STRIDE];
static fxl_screen_polygon polygon;
static fxl_scan scan;
static unsigned left;

static fxl_band any_band(void)
{
    fxl_band band;
    band.pixels = (uint8_t *)pixels;
    ASSUME(band.stride == STRIDE && band.width >= 1 && band.width <= STRIDE && band.rows >= 1 && band.rows <= ROWS);
    ASSUME(band.first_row + band.rows <= FXL_SCREEN_MAX);
    return band;
}

static const fxl_band *drawn;

/* For the scan: up to 3 trapezoids or spans of the band. */
void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band, fxl_scan *to)
{
    ASSERT("of the polygon", points == polygon.points && count >= 3 && count <= FXL_POLYGON_CAPACITY && to == &scan);
    left = 3;
    drawn = band;
}

const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *of)
{
    ASSERT("begun", of == &scan);
    if (left == 0) {
        return NULL;
    }
    left--;
    return &of->trapezoid;
}

fxl_rows fxl_rows_of_points(const fxl_screen_point *points, uint32_t count, uint16_t height)
{
    fxl_rows rows;
    ASSERT("of the polygon", points == polygon.points && count >= 3 && count <= FXL_POLYGON_CAPACITY);
    ASSUME(rows.first <= rows.end && rows.end <= height);
    return rows;
}

void fxl_active_edges_begin(fxl_active_edges *edges, const fxl_screen_point *points, uint32_t count, int32_t first_row, int32_t end_row,
                            const fxl_band *band)
{
    ASSERT("of the polygon", points == polygon.points && count >= 3 && count <= FXL_POLYGON_CAPACITY && edges == &scan.active_edges);
    ASSERT("rows of the screen", first_row >= 0 && first_row <= end_row && end_row <= FXL_SCREEN_MAX);
    left = 3;
    drawn = band;
}

bool fxl_active_edges_next(fxl_active_edges *edges, fxl_span *span)
{
    fxl_span any;
    ASSERT("begun", edges == &scan.active_edges);
    ASSUME(any.y >= drawn->first_row && any.y < drawn->first_row + drawn->rows && any.x0 >= 0 && any.x0 < any.x1 && any.x1 <= drawn->width);
    if (left == 0) {
        return false;
    }
    left--;
    *span = any;
    return true;
}

/* For what fills: it gets pixels of the band. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    (void)colour;
    ASSERT("the scan's", band == drawn && trapezoid == &scan.trapezoid);
}

void fxl_fill_trapezoid_rgb565(const fxl_band *band, const fxl_trapezoid *trapezoid, uint16_t colour)
{
    (void)colour;
    ASSERT("the scan's", band == drawn && trapezoid == &scan.trapezoid);
}

void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    (void)colour;
    ASSERT("the scan's", band == drawn && span->x0 >= 0 && span->x1 <= band->width);
}

void fxl_active_edges_fill(fxl_active_edges *edges, const fxl_span *span, const fxl_band *band, uint8_t colour)
{
    (void)edges, (void)span, (void)band, (void)colour;
    ASSERT("not of this build", false);
}

void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour)
{
    (void)colour;
    ASSERT("pixels of the band", pixel >= pixels && pixel < end && end <= pixels + ROWS * STRIDE);
}

static bool draw(unsigned kind, const fxl_band *band)
{
    const uint32_t colour = nondet_u32();
    ANY_CONTENT(&polygon);
    ANY_CONTENT(&scan);
    ASSUME(polygon.count >= 3 && polygon.count <= FXL_POLYGON_CAPACITY && colour <= (kind % 2 != 0 ? UINT16_MAX : UINT8_MAX));
    return kind == 0   ? fxl_draw_outline(&scan, &polygon, band, colour)
           : kind == 1 ? fxl_draw_outline_rgb565(&scan, &polygon, band, colour)
           : kind == 2 ? fxl_draw_by_active_edges(&scan, &polygon, band, colour)
                       : fxl_draw_by_active_edges_rgb565(&scan, &polygon, band, colour);
}

/* [[row]]
 * function = "lib/raster/draw_outline_text.h:fxl_draw_outline"
 * property = "any polygon, and up to 3 trapezoids or spans of the band, in bytes and RGB565: what is filled are pixels of the band"
 * checks = 1134
 * cases = [0, 1, 2, 3]
 * stubs = { fxl_scan_outline = "begins", fxl_scan_next_trapezoid = "up to 3", fxl_active_edges_begin = "begins", fxl_active_edges_next = "up to 3 spans of the band", fxl_rows_of_points = "any rows", fxl_fill_trapezoid = "has a row", fxl_fill_trapezoid_rgb565 = "has a row", fxl_fill_span = "has a row", fxl_fill_row_rgb565 = "asserts that all lies within the band", fxl_active_edges_fill = "not of this build" }
 */
void prove_draw_outline(void)
{
    const fxl_band band = any_band();
    (void)draw(CASE, &band);
    PROOF_ENDS();
}
