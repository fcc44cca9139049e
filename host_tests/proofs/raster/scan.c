/* SPDX-License-Identifier: MIT */
#include "raster/active_edges.c"
#define next_row next_row_of_scan
#include "raster/scan.c"
#include "raster/any_outline.h"

static fxl_band any_band(void)
{
    fxl_band band;
    ASSUME(band.width >= 1 && band.width <= FXL_SCREEN_MAX && band.rows >= 1);
    ASSUME(band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(band.columns == 0 ? band.first_column == 0 : band.first_column + band.columns <= band.width);
    return band;
}

/* [[row]]
 * function = "step"
 * property = "the remainder stays below the height, and nothing overflows"
 * checks = 148
 * contract = true
 */
void prove_step(void)
{
    fxl_slope *slope;
    (void)step(slope);
    PROOF_ENDS();
}

/* [[row]]
 * function = "step"
 * id = "step, its result"
 * property = "a row below: x and the error, over the height, are larger by the step and its error"
 * checks = 57
 */
void prove_step_result(void)
{
    fxl_slope slope;
    ASSUME(FXL_SLOPE(&slope) && WITHIN(slope.x, 1 << 29));
    const fxl_slope before = slope;
    const int32_t x = step(&slope);
    /* x height + error grows by step height + error_step, and the error stays below the height */
    const uint32_t sum = before.error + before.error_step;
    const bool carries = sum >= before.height;
    ASSERT("the pixel", x == before.x + before.step + carries && slope.x == x);
    ASSERT("the error", slope.error == (carries ? sum - before.height : sum) && slope.error < slope.height);
    ASSERT("the rest stays", slope.step == before.step && slope.error_step == before.error_step && slope.height == before.height);
    PROOF_ENDS();
}

/* [[row]]
 * function = "winding_after"
 * property = "for up to 12 edges: nothing is out of bounds; the next crossing lies to the right"
 * checks = 48
 * unwind = 33
 */
void prove_winding_after(void)
{
    fxl_active_edges edges;
    int32_t next;
    ASSUME(edges.found_count >= 1 && edges.found_count <= 12);
    for (uint32_t i = 0; i < 12; i++) {
        ASSUME(edges.found[i].winding == 1 || edges.found[i].winding == -1);
    }
    const int32_t x = nondet_s32(), winding = winding_after(&edges, x, &next);
    ASSERT("a winding for each edge at most", WITHIN(winding, FXL_POLYGON_CAPACITY));
    ASSERT("the next lies to the right", next > x || next == FXL_NO_CROSSING);
    PROOF_ENDS();
}

/* [[row]]
 * function = "end_of_two"
 * property = "of two edges, where the row begins at the lesser x: it ends at the greater, and there is no other stretch"
 * checks = 18
 */
void prove_end_of_two(void)
{
    fxl_active_edges edges;
    ASSUME(WITHIN(edges.found[0].slope.x, 1 << 28) && WITHIN(edges.found[1].slope.x, 1 << 28) && WITHIN(edges.x, 1 << 28));
    ASSUME(edges.x <= edges.found[0].slope.x && edges.x <= edges.found[1].slope.x); /* as find_edges leaves them */
    ASSUME(edges.x == edges.found[0].slope.x || edges.x == edges.found[1].slope.x);
    const int32_t x = edges.x, last = end_of_two(&edges);
    ASSERT("not to the left", last >= x);
    ASSERT("the next lies to the right", edges.x > last);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_active_edges_begin"
 * property = "its rows and columns are those of the band"
 * checks = 116
 * unwind = 33
 */
void prove_active_edges_begin(void)
{
    fxl_active_edges edges;
    const fxl_band band = any_band();
    const int32_t first = nondet_s32(), end = nondet_s32();
    ASSUME(WITHIN(first, 4096) && WITHIN(end, 4096));
    fxl_active_edges_begin(&edges, points, any_outline(), first, end, &band);
    ASSERT("rows of the band", edges.row >= -1 && edges.end_row <= FXL_SCREEN_MAX && edges.right <= band.width);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_rows_of_points"
 * property = "for up to 32 points: rows of the screen, the first not past the end"
 * checks = 35
 * unwind = 33
 */
void prove_rows_of_points(void)
{
    const uint32_t count = any_outline();
    const uint16_t height = nondet_u16();
    const fxl_rows rows = fxl_rows_of_points(points, count, height);
    ASSERT("rows of the screen", rows.first <= rows.end && rows.end <= height);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_scan_rows"
 * property = "the same of a polygon of up to 32 points"
 * checks = 41
 * unwind = 33
 */
void prove_scan_rows(void)
{
    fxl_screen_polygon polygon;
    ASSUME(polygon.count >= 3 && polygon.count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(WITHIN(polygon.points[i].x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(polygon.points[i].y, FXL_SCREEN_COORDINATE_MAX));
    }
    const uint16_t height = nondet_u16();
    const fxl_rows rows = fxl_scan_rows(&polygon, height);
    ASSERT("rows of the screen", rows.first <= rows.end && rows.end <= height);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_outline_has_rows"
 * property = "for up to 32 points: nothing is undefined"
 * checks = 40
 * unwind = 33
 */
void prove_outline_has_rows(void)
{
    fxl_screen_polygon polygon;
    ASSUME(polygon.count >= 3 && polygon.count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(WITHIN(polygon.points[i].x, FXL_SCREEN_COORDINATE_MAX) && WITHIN(polygon.points[i].y, FXL_SCREEN_COORDINATE_MAX));
    }
    (void)fxl_outline_has_rows(&polygon, nondet_u16());
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:survey"
 * property = "for up to 32 points: a vertex and rows of the outline; nothing overflows"
 * checks = 112
 * unwind = 33
 */
void prove_survey(void)
{
    outline found;
    const uint32_t count = any_outline();
    const uint16_t width = nondet_u16();
    ASSUME(width >= 1 && width <= FXL_SCREEN_MAX);
    survey(points, count, width, &found);
    ASSERT("a vertex of it", found.top < count);
    ASSERT("its rows", found.top_row <= found.end_row && found.top_row >= -4096 && found.end_row <= 4096);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_scan_begin"
 * property = "for every polygon, band and null pointer: nothing is undefined"
 * checks = 496
 * unwind = 33
 */
void prove_scan_begin(void)
{
    fxl_screen_polygon polygon;
    fxl_band band;
    fxl_scan scan;
    const fxl_status status = fxl_scan_begin(nondet_bool() ? &polygon : NULL, nondet_bool() ? &band : NULL,
                                             nondet_bool() ? &scan : NULL);
    ASSERT("its statuses", status == FXL_OK || status == FXL_E_ARGUMENT || status == FXL_E_DEGENERATE ||
                               status == FXL_E_CAPACITY || status == FXL_E_RANGE);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_scan_outline"
 * property = "for up to 32 points and any band: nothing is undefined"
 * checks = 450
 * unwind = 33
 */
void prove_scan_outline(void)
{
    fxl_scan scan;
    const fxl_band band = any_band();
    fxl_scan_outline(points, any_outline(), &band, &scan);
    (void)fxl_scan_reaches(&scan, &band);
    (void)fxl_scan_is_over(&scan);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/columns.h:fxl_band_is_within"
 * property = "columns fit the stride"
 * checks = 51
 */
void prove_band_is_within(void)
{
    const fxl_band band = any_band();
    ASSERT("within its frame", !fxl_band_is_within(&band, band.width, FXL_SCREEN_MAX) || fxl_band_columns(&band) <= band.stride);
    PROOF_ENDS();
}
