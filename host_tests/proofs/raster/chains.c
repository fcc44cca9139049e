/* SPDX-License-Identifier: MIT */
#include "raster/chains.c"
#include "proof.h"

void prove_edge_set_far(void)
{
    fxl_screen_point *top, *bottom;
    fxl_edge *edge;
    (void)fxl_edge_set_far(top, bottom, nondet_s32(), nondet_s32(), edge);
    PROOF_ENDS();
}
