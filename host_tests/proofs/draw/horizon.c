/* SPDX-License-Identifier: MIT */
#include "draw/horizon.c"
#include "proof.h"

static fxl_horizon horizon;

/* [[row]]
 * function = "fxl_horizon_check"
 * property = "up to 64 sines: accepted where they are 1 to 64, ascend, and are within 1; null pointers are refused"
 * checks = 89
 * unwind = 65
 * stubs = { fxl_refuse = "not called" }
 */
void prove_horizon_check(void)
{
    static fxl_q2_30 sines[FXL_HORIZON_MAX];
    static uint8_t colours[FXL_HORIZON_MAX + 1];
    const uint32_t i = nondet_u32();
    ANY_CONTENT(&sines);
    horizon.sines = nondet_bool() ? NULL : sines;
    horizon.colours = nondet_bool() ? NULL : colours;
    horizon.count = nondet_u32();
    ASSUME(i < FXL_HORIZON_MAX);
    const fxl_status status = fxl_horizon_check(nondet_bool() ? NULL : &horizon);
    ASSERT("1 to 64, within 1", status != FXL_OK || (horizon.count >= 1 && horizon.count <= FXL_HORIZON_MAX && horizon.colours != NULL &&
                                                     (i >= horizon.count || WITHIN(sines[i], FXL_Q2_30_ONE))));
    ASSERT("ascending", status != FXL_OK || i == 0 || i >= horizon.count || sines[i - 1] <= sines[i]);
    PROOF_ENDS();
}

fxl_status fxl_refuse(fxl_workspace *workspace, fxl_status status)
{
    (void)workspace;
    ASSERT("refused", status != FXL_OK);
    return status;
}

/* [[row]]
 * function = "fxl_attach_horizon"
 * property = "any renderer, with a target or without, and null pointers: attached whole, detached, or nothing is changed"
 * checks = 34
 * stands_in = { fxl_horizon_check = "any_check" }
 * stubs = { fxl_refuse = "its own row" }
 */
fxl_status any_check(const fxl_horizon *of)
{
    ASSERT("there", of == &horizon);
    return nondet_bool() ? FXL_OK : FXL_E_RANGE;
}

void prove_attach_horizon(void)
{
    static fxl_renderer renderer;
    static fxl_target target;
    ANY_CONTENT(&renderer);
    ANY_CONTENT(&target);
    renderer.target = nondet_bool() ? NULL : &target;
    const fxl_horizon *const given = nondet_bool() ? NULL : &horizon, *const before = renderer.horizon;
    const fxl_status status = fxl_attach_horizon(nondet_bool() ? NULL : &renderer, given);
    ASSERT("attached, or untouched", renderer.horizon == (status == FXL_OK ? given : before));
    ASSERT("what clears", status != FXL_OK || renderer.fill == (given != NULL ? fill_horizon : target.fill));
    PROOF_ENDS();
}

#include "draw/horizon_rows.c"

/* [[row]]
 * function = "excess_of"
 * property = "any row and column, any elevation of 29 bits, and the square of any sine: nothing overflows, and the excess is below 2^60; with a sine of 0 the sign is that of the elevation"
 * checks = 19
 * clause = "horizon 1.3a"
 */
void prove_excess_of(void)
{
    horizon_row row;
    int32_t x, elevation;
    int64_t square;
    ASSUME(WITHIN(elevation, (1 << 29) - 1) && WITHIN(square, (int64_t)1 << 60));
    ASSUME(row.square >> 62 == 0 && row.square + (uint64_t)((int64_t)x * x) < (uint64_t)1 << 62);
    const int64_t excess = excess_of(&row, x, elevation, square);
    ASSERT("below 2^60", WITHIN(excess, (int64_t)1 << 60));
    ASSERT("by the sign", square != 0 || (excess >= 0) == (elevation >= 0));
    PROOF_ENDS();
}
