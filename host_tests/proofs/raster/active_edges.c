/* SPDX-License-Identifier: MIT */
#include "raster/active_edges.c"
#include "raster/any_outline.h"

#define ROWS   3
#define STRIDE 16

static bool is_row(int32_t row)
{
    return row >= -1 && row < FXL_SCREEN_MAX;
}

/* For fxl_slope_set: what its contract says. */
void any_slope(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t y, fxl_slope *slope)
{
    ASSERT("points of the screen", FXL_ON_SCREEN(top) && FXL_ON_SCREEN(bottom));
    ASSERT("that the row's centre lies between", y >= top->y && y < bottom->y);
    slope->x = nondet_s32();
    ASSUME(WITHIN(slope->x, 1 << 29));
}

/* The edges of an outline that the row crosses: some vertex lies above its centre, another below. */
static uint32_t find(fxl_active_edges *edges, uint32_t most)
{
    const uint32_t count = any_outline(), one = nondet_u32(), other = nondet_u32();
    edges->points = points;
    edges->count = (uint8_t)count;
    ASSUME(count <= most && edges->row >= 0 && edges->row < FXL_SCREEN_MAX && one < count && other < count);
    ASSUME(fxl_first_centre_from(points[one].y) <= edges->row && fxl_first_centre_from(points[other].y) > edges->row);
    find_edges(edges);
    return count;
}

/* [[row]]
 * function = "find_edges"
 * property = "any outline of up to 5 points that a row crosses: two edges or more, each with what its set-up requires"
 * checks = 229
 * unwind = 7
 * unwindset = { "any_outline.0" = 33 }
 * stands_in = { fxl_slope_set = "any_slope" }
 */
void prove_find_edges(void)
{
    fxl_active_edges edges;
    const uint32_t count = find(&edges, 5);
    ASSERT("two or more, and at most all", edges.found_count >= 2 && edges.found_count <= count && edges.found_count <= FXL_POLYGON_CAPACITY);
    PROOF_ENDS();
}

/* [[row]]
 * id = "find_edges, windings"
 * function = "find_edges"
 * property = "any outline of up to 4 points: as many edges go down as up"
 * checks = 231
 * unwind = 6
 * unwindset = { "any_outline.0" = 33 }
 * stands_in = { fxl_slope_set = "any_slope" }
 */
void prove_windings(void)
{
    fxl_active_edges edges;
    const uint32_t count = find(&edges, 4);
    int32_t sum = 0;
    for (uint32_t i = 0; i < 4; i++) {
        sum += i < edges.found_count ? edges.found[i].winding : 0;
    }
    ASSERT("as many go down as up", count <= 4 && sum == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "next_vertex_row"
 * property = "any outline of up to 8 points: a row below, at most the end"
 * checks = 46
 * unwind = 10
 * unwindset = { "any_outline.0" = 33 }
 */
void prove_next_vertex_row(void)
{
    fxl_active_edges edges;
    edges.count = (uint8_t)any_outline();
    ASSUME(edges.count <= 8);
    edges.points = points;
    ASSUME(is_row(edges.row) && edges.row < edges.end_row);
    const int32_t next = next_vertex_row(&edges);
    ASSERT("a row below, at most the end", next > edges.row && next <= edges.end_row);
    PROOF_ENDS();
}

/* For step: what its contract says. */
int32_t any_step(fxl_slope *slope)
{
    const int32_t x = nondet_s32();
    ASSERT("a slope near the screen", FXL_BELOW(slope->x, 1 << 30));
    ASSUME(WITHIN(x, 1 << 30));
    slope->x = x;
    return x;
}

/* [[row]]
 * function = "step_edges"
 * property = "up to 32 edges: nothing is out of bounds"
 * checks = 46
 * unwind = 33
 * stands_in = { step = "any_step" }
 */
void prove_step_edges(void)
{
    fxl_active_edges edges;
    ASSUME(edges.found_count >= 1 && edges.found_count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(WITHIN(edges.found[i].slope.x, 1 << 30));
    }
    step_edges(&edges);
    PROOF_ENDS();
}

/* For step_edges, find_edges and next_vertex_row: what their own rows assume and assert. */
void any_step_edges(fxl_active_edges *edges)
{
    ASSERT("edges were found", edges->found_count >= 2);
    edges->x = nondet_s32();
}

void any_find_edges(fxl_active_edges *edges)
{
    ASSERT("a row of the scan", is_row(edges->row) && edges->row >= 0 && edges->row < edges->end_row);
    edges->x = nondet_s32();
    edges->found_count = nondet_u8();
    ASSUME(edges->found_count >= 2 && edges->found_count <= FXL_POLYGON_CAPACITY);
}

int32_t any_vertex_row(const fxl_active_edges *edges)
{
    const int32_t next = nondet_s32();
    ASSERT("a row of the scan", is_row(edges->row) && edges->row < edges->end_row);
    ASSUME(next > edges->row && next <= edges->end_row);
    return next;
}

/* Between two rows: no edge begins or ends above steady_end, and edges were found if that lies below. */
static bool is_state(const fxl_active_edges *edges)
{
    return is_row(edges->row) && edges->end_row <= FXL_SCREEN_MAX && edges->steady_end <= edges->end_row &&
           (edges->row + 1 >= edges->steady_end || (edges->found_count >= 2 && edges->found_count <= FXL_POLYGON_CAPACITY));
}

/* [[row]]
 * function = "next_row"
 * property = "one step in any state: the next row, with two edges or more, until the end"
 * checks = 187
 * stands_in = { step_edges = "any_step_edges", find_edges = "any_find_edges", next_vertex_row = "any_vertex_row" }
 */
void prove_next_row(void)
{
    fxl_active_edges edges;
    ASSUME(edges.row >= -1 && is_state(&edges));
    const int32_t row = edges.row;
    if (next_row(&edges)) {
        ASSERT("the next row, with edges", edges.row == row + 1 && edges.row < edges.end_row && edges.found_count >= 2);
        ASSERT("a state again", is_state(&edges));
    } else {
        ASSERT("the last row was done", edges.row == row && row + 1 >= edges.end_row);
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "end_of_stretch"
 * property = "up to 4 edges, as many down as up: it ends at a crossing, and the next lies to the right"
 * checks = 66
 * unwind = 5
 */
void prove_end_of_stretch(void)
{
    fxl_active_edges edges;
    int32_t sum = 0;
    ASSUME(edges.found_count >= 2 && edges.found_count <= 4);
    for (uint32_t i = 0; i < 4; i++) {
        ASSUME((edges.found[i].winding == 1 || edges.found[i].winding == -1) && WITHIN(edges.found[i].slope.x, 1 << 30));
        sum += i < edges.found_count ? edges.found[i].winding : 0;
    }
    ASSUME(sum == 0 && WITHIN(edges.x, 1 << 30)); /* as find_edges leaves them */
    const int32_t x = edges.x, last = end_of_stretch(&edges);
    ASSERT("not to the left", last >= x);
    ASSERT("the next lies to the right", edges.x > last);
    PROOF_ENDS();
}

/* For next_row, end_of_two and end_of_stretch. Three rows and three stretches are to come. */
static unsigned rows_left, stretches_left;
bool any_next_row(fxl_active_edges *edges)
{
    if (rows_left == 0) {
        return false;
    }
    rows_left--;
    const int32_t row = edges->row;
    edges->row = nondet_s16();
    edges->x = nondet_s32();
    edges->found_count = nondet_u8();
    ASSUME(edges->row == row + 1 && edges->row < edges->end_row && edges->found_count >= 2);
    return true;
}

int32_t any_end(fxl_active_edges *edges)
{
    const int32_t x = edges->x, last = nondet_s32();
    edges->x = stretches_left != 0 ? nondet_s32() : FXL_NO_CROSSING;
    ASSUME(last >= x && edges->x > last);
    stretches_left -= stretches_left != 0;
    return last;
}

/* [[row]]
 * function = "fxl_active_edges_next"
 * property = "any state with up to 2 rows and 2 stretches to come: a span of the band, or none"
 * checks = 137
 * stands_in = { next_row = "any_next_row", end_of_two = "any_end", end_of_stretch = "any_end" }
 */
void prove_active_edges_next(void)
{
    fxl_active_edges edges;
    fxl_band band;
    fxl_span span;
    rows_left = stretches_left = 2;
    ASSUME(band.width <= FXL_SCREEN_MAX && band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(edges.left >= 0 && edges.left < edges.right && edges.right <= band.width);
    /* before its first row, or in a row, as fxl_active_edges_begin and next_row leave it */
    ASSUME(edges.row >= band.first_row - 1 && edges.row < edges.end_row && edges.end_row <= band.first_row + band.rows);
    ASSUME(edges.x == FXL_NO_CROSSING || (edges.row >= band.first_row && edges.found_count >= 2));
    if (fxl_active_edges_next(&edges, &span)) {
        ASSERT("a span of the band", span.y == edges.row && span.x0 >= edges.left && span.x0 < span.x1 && span.x1 <= edges.right);
        ASSERT("on the screen", span.y >= 0 && span.y < FXL_SCREEN_MAX && span.x0 >= 0 && span.x0 < span.x1 && span.x1 <= FXL_SCREEN_MAX);
        ASSERT("within the band", span.y >= band.first_row && span.y < band.first_row + band.rows && span.x0 >= 0 && span.x0 < span.x1 && span.x1 <= band.width);
    }
    PROOF_ENDS();
}

/* For memset: it writes a row of the band. */
void *any_memset(void *to, int byte, size_t size)
{
    (void)byte;
    ASSERT("pixels of the band", size >= 1 && size <= STRIDE && __CPROVER_w_ok(to, size));
    return to;
}

/* [[row]]
 * function = "fxl_active_edges_fill"
 * property = "up to 3 rows of up to 16 pixels: each stretch lies in its row of the band, and the last is above the next vertex"
 * checks = 146
 * stands_in = { step = "any_step", memset = "any_memset" }
 * stubs = { memset = "asserts that all bytes lie in the band" }
 */
void prove_active_edges_fill(void)
{
    static uint8_t pixels[ROWS * STRIDE];
    fxl_active_edges edges;
    fxl_band band;
    fxl_span span;
    band.pixels = pixels;
    ASSUME(band.stride == STRIDE && band.rows >= 1 && band.rows <= ROWS && band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(edges.left >= 0 && edges.left < edges.right && edges.right <= STRIDE && edges.row == span.y);
    ASSUME(span.y >= band.first_row && span.y < edges.steady_end && edges.steady_end <= band.first_row + band.rows);
    ASSUME(span.x0 >= edges.left && span.x0 < span.x1 && span.x1 <= edges.right && edges.found_count >= 2);
    ASSUME(WITHIN(edges.found[0].slope.x, 1 << 30) && WITHIN(edges.found[1].slope.x, 1 << 30));
    fxl_active_edges_fill(&edges, &span, &band, nondet_u8());
    ASSERT("a row of the band", edges.row >= span.y && edges.row < edges.steady_end);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/columns.h:fxl_band_begin_at_column_0"
 * property = "any column: so many bytes before"
 * checks = 23
 */
void prove_band_begin_at_column_0(void)
{
    fxl_band band;
    static uint8_t pixels[4096];
    const bool palette = nondet_bool();
    static const uint16_t colours[256];
    ASSUME(band.first_column < FXL_SCREEN_MAX);
    band.pixels = pixels;
    band.palette = palette ? colours : NULL;
    const uintptr_t before = (uintptr_t)band.pixels;
    fxl_band_begin_at_column_0(&band);
    ASSERT("so many bytes before", (uintptr_t)band.pixels + ((uintptr_t)band.first_column << palette) == before);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/columns.h:fxl_band_is_aligned"
 * property = "any band: of two bytes a pixel, its pixels and its palette begin at even addresses"
 * checks = 21
 */
void prove_band_is_aligned(void)
{
    fxl_band band;
    const uintptr_t places = (uintptr_t)band.pixels | (uintptr_t)band.palette;
    ASSERT("even, or without a palette", fxl_band_is_aligned(&band) == (band.palette == NULL || places % 2 == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/columns.h:fxl_pixel_at"
 * property = "a pixel of a byte, and of two, at any column of a row of four"
 * checks = 33
 */
void prove_pixel_at(void)
{
    uint16_t pixels[4];
    const uint32_t column = nondet_u32();
    ASSUME(column < 4);
    const uint32_t entry = fxl_pixel_at(fxl_kind_of_palette(NULL), pixels, column);
    ASSERT("a byte", entry == ((const uint8_t *)pixels)[column]);
    ASSERT("two", fxl_pixel_at(fxl_kind_of_palette(pixels), pixels, column) == pixels[column]);
    PROOF_ENDS();
}
