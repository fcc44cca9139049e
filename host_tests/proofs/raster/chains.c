/* SPDX-License-Identifier: MIT */
#include "raster/chains.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_edge_set_far"
 * property = "any edge of the screen: nothing overflows, and it holds for 1 to all of the rows"
 * checks = 292
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
