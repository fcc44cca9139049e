/* SPDX-License-Identifier: MIT */
#include "clip/split.c"
#include "proof.h"

/* [[row]]
 * function = "along"
 * property = "nothing overflows, and the result lies between the ends"
 * checks = 29
 * contract = true
 * uses = ["fxl_multiply_high"]
 */
void prove_along(void)
{
    (void)along(nondet_s32(), nondet_s32(), nondet_u64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_split_edge"
 * property = "nothing overflows, and the point is in range"
 * checks = 159
 * contract = true
 * uses = ["along", "fxl_intersection_fraction"]
 */
void prove_split_edge(void)
{
    fxl_point *front, *behind;
    (void)fxl_split_edge(front, behind, nondet_s64(), nondet_s64());
    PROOF_ENDS();
}
