/* SPDX-License-Identifier: MIT */
#include "scene/bsp_node.h"
#include "proof.h"

/* [[row]]
 * function = "fxl_bsp_is_front"
 * property = "any checked node and any point below 2^30: nothing overflows, and the distance is that of both halves"
 * checks = 86
 * stands_in = { fxl_dot = "any_dot" }
 */
/* As check_plane of lib/scene/bsp_check.c leaves a node: its row asserts it. */
void prove_bsp_is_front(void)
{
    fxl_bsp_node node;
    fxl_point point;
    ASSUME(FXL_DIRECTION(&node.normal) && FXL_POINT_BELOW(&point, 1 << 30));
    const fxl_q18_46 distance = fxl_bsp_distance(&node);
    ASSERT("both halves", (uint32_t)distance == node.distance_low && (int32_t)(distance >> 32) == (int32_t)node.distance_high);
    (void)fxl_bsp_is_front(&node, &point);
    PROOF_ENDS();
}

/* For fxl_dot: what its contract says. */
fxl_q18_46 any_dot(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    const fxl_q18_46 dot = nondet_s64();
    ASSERT("a unit normal, below 2^30", FXL_DIRECTION(direction) && WITHIN(x, 1 << 30) && WITHIN(y, 1 << 30) && WITHIN(z, 1 << 30));
    ASSUME(WITHIN(dot, (int64_t)7 << 59));
    return dot;
}
