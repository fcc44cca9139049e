/* SPDX-License-Identifier: MIT */
#include "raster/scan.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_edge_set_far"
 * property = "any edge of the screen: nothing overflows, and it holds for 1 to all of the rows"
 * checks = 297
 * contract = true
 * unwind = 33
 * uses = ["fxl_slope_set"]
 */
void prove_edge_set_far(void)
{
    fxl_screen_point *top, *bottom;
    fxl_edge *edge;
    (void)fxl_edge_set_far(top, bottom, nondet_s32(), nondet_s32(), edge);
    PROOF_ENDS();
}

#ifndef CASE
#define CASE 1 /* for the rows that have none */
#endif

#define POINTS 5

static fxl_screen_point points[POINTS];
static int32_t top, end; /* rows of the outline */

/* An outline that is scanned by chains: survey says what of. */
static uint32_t any_outline(void)
{
    const uint32_t count = nondet_u32(), lowest = nondet_u32();
    ANY_CONTENT(points);
    top = nondet_s32();
    end = nondet_s32();
    ASSUME(count >= 3 && count <= POINTS && lowest < count);
    ASSUME(WITHIN(top, 4096) && WITHIN(end, 4096) && top <= end && end - top < FXL_EDGE_HEIGHT_MAX >> 16);
    for (uint32_t i = 0; i < POINTS; i++) {
        ASSUME(WITHIN(points[i].y, FXL_SCREEN_COORDINATE_MAX) && points[i].x > -32768 && points[i].x <= FXL_SCREEN_MAX * 65536 + 32768);
        ASSUME(i >= count || (fxl_first_centre_from(points[i].y) >= top && fxl_first_centre_from(points[i].y) <= end));
    }
    ASSUME(fxl_first_centre_from(points[lowest].y) == end);
    return count;
}

/* For fxl_edge_set: what its own row assumes and asserts. */
int32_t any_set(const fxl_screen_point *above, const fxl_screen_point *below, int32_t row, int32_t rows, fxl_edge *edge)
{
    fxl_edge any;
    const int32_t good = nondet_s32();
    ASSERT("an edge", below->y > above->y && below->y - above->y <= FXL_EDGE_HEIGHT_MAX && WITHIN(below->x - above->x, (FXL_SCREEN_MAX + 1) * 65536));
    ASSERT("that crosses the row", rows > 0 && fxl_first_centre_from(above->y) <= row && fxl_first_centre_from(below->y) == row + rows);
    ASSUME(good >= 1 && good <= rows);
    *edge = any;
    return good;
}

/* [[row]]
 * function = "begin_edge"
 * property = "any outline of up to 5 points that is scanned by chains, any vertex above the row, in both directions: the loop ends, the edge crosses the row, and the next one begins above its end"
 * checks = 313
 * cases = [1, 2]
 * unwind = 7
 * stands_in = { fxl_edge_set = "any_set" }
 * stubs = { fxl_active_edges_next = "not called", fxl_active_edges_begin = "not called" }
 */
void prove_begin_edge(void)
{
    fxl_scan scan;
    fxl_edge edge;
    fxl_chain chain;
    const uint32_t count = any_outline();
    const int32_t row = nondet_s32();
    scan.points = points;
    scan.count = (uint8_t)count;
    chain.onward = (uint8_t)(CASE == 1 ? 1 : count - 1);
    ASSUME(row >= 0 && row < FXL_SCREEN_MAX && row < end && chain.vertex < count);
    ASSUME(fxl_first_centre_from(points[chain.vertex].y) <= row);
    begin_edge(&scan, &chain, row, &edge);
    ASSERT("for a row or more of the outline", chain.end_row > row && chain.end_row <= end && chain.end_row <= 4096);
    ASSERT("the next edge begins above its end", chain.vertex < count && fxl_first_centre_from(points[chain.vertex].y) <= chain.end_row);
    PROOF_ENDS();
}

/* For begin_edge. */
void any_begin_edge(const fxl_scan *scan, fxl_chain *chain, int32_t row, fxl_edge *edge)
{
    fxl_edge any;
    ASSERT("a row of the scan", row >= 0 && row < scan->end_row && chain->end_row == row);
    chain->end_row = nondet_s16();
    chain->vertex = nondet_u8();
    ASSUME(chain->end_row > row && chain->end_row <= 4096);
    *edge = any;
}

/* For fxl_active_edges_next: any span of a band, or none. */
bool fxl_active_edges_next(fxl_active_edges *edges, fxl_span *span)
{
    (void)edges;
    const fxl_span any = {nondet_s16(), nondet_s16(), nondet_s16()};
    ASSUME(any.y >= 0 && any.y < FXL_SCREEN_MAX && any.x0 >= 0 && any.x0 < any.x1 && any.x1 <= FXL_SCREEN_MAX);
    *span = any;
    return nondet_bool();
}

void fxl_active_edges_begin(fxl_active_edges *edges, const fxl_screen_point *of, uint32_t count, int32_t first_row, int32_t end_row,
                            const fxl_band *band)
{
    (void)edges, (void)of, (void)count, (void)first_row, (void)end_row, (void)band;
}

/* Between two calls: the trapezoid's edges are those of the chains, and both chains end at its end or below. */
static bool is_scan(const fxl_scan *scan)
{
    const fxl_trapezoid *last = &scan->trapezoid;
    return scan->end_row <= FXL_SCREEN_MAX && last->first_row >= 0 && last->first_row <= last->end_row && last->end_row <= FXL_SCREEN_MAX &&
           scan->chains[0].end_row >= last->end_row && scan->chains[1].end_row >= last->end_row && scan->chains[0].end_row <= 4096 &&
           scan->chains[1].end_row <= 4096 && WITHIN(last->edges[0].x, 1 << 21) && WITHIN(last->edges[1].x, 1 << 21) &&
           WITHIN(last->edges[0].step, 1026) && WITHIN(last->edges[1].step, 1026);
}

/* [[row]]
 * function = "fxl_scan_next_trapezoid"
 * property = "one step in any state: rows of the scan, at least one, from the end of those before; both chains end there or below"
 * checks = 348
 * stands_in = { begin_edge = "any_begin_edge" }
 * stubs = { fxl_active_edges_next = "any span of a band, or none", fxl_active_edges_begin = "not called" }
 */
void prove_scan_next_trapezoid(void)
{
    fxl_scan scan;
    ASSUME(is_scan(&scan));
    const int32_t row = scan.trapezoid.end_row;
    const fxl_trapezoid *found = fxl_scan_next_trapezoid(&scan);
    if (found != NULL && row < scan.end_row) {
        ASSERT("the rows from there", found == &scan.trapezoid && found->first_row == row && found->end_row > row && found->end_row <= scan.end_row);
        ASSERT("both chains end there or below", scan.chains[0].end_row >= found->end_row && scan.chains[1].end_row >= found->end_row);
        ASSERT("it ends at one of them", found->end_row == scan.end_row || found->end_row == scan.chains[0].end_row ||
                                             found->end_row == scan.chains[1].end_row);
    }
    PROOF_ENDS();
}

int32_t __CPROVER_uninterpreted_below(int32_t, uint32_t, int32_t, uint32_t);

static int32_t x_below(const fxl_edge *edge)
{
    return __CPROVER_uninterpreted_below(edge->x, edge->fraction, edge->step, edge->step_fraction);
}

/* For fxl_edge_advance, whose rows say where x is. */
void a_row_lower(fxl_edge *edge, uint32_t rows)
{
    ASSERT("a row", rows == 1);
    edge->x = x_below(edge);
    edge->fraction = nondet_u32();
}

/* For fxl_scan_next_trapezoid: the rows from its end, or none. */
const fxl_trapezoid *any_trapezoid(fxl_scan *scan)
{
    if (scan->trapezoid.end_row >= scan->end_row) {
        return NULL;
    }
    fxl_trapezoid any;
    const int32_t row = scan->trapezoid.end_row;
    ASSUME(any.first_row == row && any.end_row > row && any.end_row <= scan->end_row);
    ASSUME(WITHIN(any.edges[0].x, 1 << 13) && WITHIN(any.edges[1].x, 1 << 13) && WITHIN(any.edges[0].step, 1026) && WITHIN(any.edges[1].step, 1026));
    scan->trapezoid = any;
    return &scan->trapezoid;
}

/* [[row]]
 * function = "lib/raster/scan.c:next_row_of_chains"
 * property = "any state with up to 3 rows to come: it ends, with a row of the scan or none"
 * checks = 256
 * narrows = "x of an edge, which lies on the screen: that is the exactness of fxl_edge, which no row of CBMC states"
 * stands_in = { fxl_scan_next_trapezoid = "any_trapezoid" }
 * stubs = { fxl_active_edges_next = "not called", fxl_active_edges_begin = "not called" }
 */
void prove_next_row_of_chains(void)
{
    fxl_scan scan;
    fxl_span span;
    ASSUME(is_scan(&scan) && scan.end_row - scan.row <= 3 && scan.row >= 0 && scan.row <= FXL_SCREEN_MAX);
    ASSUME(scan.row <= scan.trapezoid.end_row && scan.trapezoid.end_row <= scan.end_row);
    if (next_row_of_chains(&scan, &span)) {
        ASSERT("a row, left before right", span.y >= 0 && span.y < scan.end_row && scan.row == span.y + 1);
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/scan.c:next_row_of_chains"
 * id = "a row's ends"
 * property = "any row within a trapezoid, whose edges differ there: from the lesser x of the two edges, a row lower, to the greater; none of a scan that is over"
 * checks = 264
 * unwind = 2
 * stands_in = { fxl_edge_advance = "a_row_lower", fxl_scan_next_trapezoid = "any_trapezoid" }
 * stubs = { fxl_active_edges_next = "not called", fxl_active_edges_begin = "not called" }
 */
void prove_row_ends(void)
{
    fxl_scan scan;
    fxl_span span;
    const bool is_over = nondet_bool();
    ASSUME(is_scan(&scan) && scan.row >= 0 && scan.trapezoid.end_row <= FXL_SCREEN_MAX);
    ASSUME(is_over ? scan.row >= scan.trapezoid.end_row && scan.trapezoid.end_row >= scan.end_row : scan.row < scan.trapezoid.end_row);
    const int32_t row = scan.row, a = x_below(&scan.trapezoid.edges[0]), b = x_below(&scan.trapezoid.edges[1]);
    ASSUME(a != b && a >= 0 && b >= 0 && a <= FXL_SCREEN_MAX && b <= FXL_SCREEN_MAX);
    ASSERT("a row, or none", next_row_of_chains(&scan, &span) == !is_over);
    ASSERT("its ends", is_over || (span.x0 == (a < b ? a : b) && span.x1 == (a < b ? b : a)));
    ASSERT("that row", is_over || (span.y == row && scan.row == row + 1 && scan.trapezoid.first_row == row));
    PROOF_ENDS();
}

/* For next_row_of_chains. */
bool any_row(fxl_scan *scan, fxl_span *span)
{
    ASSERT("by chains", scan->by_chains);
    return fxl_active_edges_next(&scan->active_edges, span);
}

/* [[row]]
 * function = "lib/raster/scan.c:fxl_scan_next"
 * property = "either kind of scan: rows come from its own"
 * checks = 19
 * stands_in = { next_row_of_chains = "any_row" }
 * stubs = { fxl_active_edges_next = "any span of a band, or none", fxl_active_edges_begin = "not called" }
 */
void prove_scan_next(void)
{
    fxl_scan scan;
    fxl_span span;
    scan.by_chains = nondet_bool();
    (void)fxl_scan_next(&scan, &span);
    PROOF_ENDS();
}
