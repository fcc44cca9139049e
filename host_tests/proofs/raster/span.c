/* SPDX-License-Identifier: MIT */
#define fxl_active_edges_next any_next
#include "raster/scan.c"
#include "proof.h"

/* Any span of a band, or none. */
bool any_next(fxl_active_edges *edges, fxl_span *span)
{
    (void)edges;
    const fxl_span any = {nondet_s16(), nondet_s16(), nondet_s16()};
    ASSUME(any.y >= 0 && any.y < FXL_SCREEN_MAX && any.x0 >= 0 && any.x0 < any.x1 && any.x1 <= FXL_SCREEN_MAX);
    if (nondet_bool()) {
        return false;
    }
    *span = any;
    return true;
}

/* [[row]]
 * function = "fxl_scan_next_of_active_edges"
 * property = "any span of a band: a trapezoid of one row, the left edge before the right one"
 * checks = 70
 * stubs = { fxl_active_edges_next = "any span of a band, or none" }
 */
void prove_scan_next_of_active_edges(void)
{
    fxl_scan scan;
    const fxl_trapezoid *found = fxl_scan_next_of_active_edges(&scan);
    ASSERT("of one row, left before right, in the band",
           found == NULL || (found == &scan.trapezoid && found->end_row == found->first_row + 1 && found->edges[0].x >= 0 &&
                             found->edges[0].x < found->edges[1].x && found->edges[1].x <= FXL_SCREEN_MAX));
    PROOF_ENDS();
}
