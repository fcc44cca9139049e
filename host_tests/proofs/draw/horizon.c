/* SPDX-License-Identifier: MIT */
#include "draw/horizon.c"
#include "products.h"

static fxl_horizon horizon;

/* [[row]]
 * function = "is_above"
 * property = "the first column of any row, and a sine of 0 or of the other sign: nothing overflows, and the side is that of the elevation exactly; of other columns the elevation is a sum"
 * checks = 67
 * clause = "horizon 1.3a"
 * stands_in = { fxl_multiply_s32 = "any_signed" }
 * unreached = { any_signed = "of two of one sign", fxl_multiply_u32 = "of two of one sign", x_of = "of two of one sign" }
 */
void prove_is_above(void)
{
    horizon_row row;
    threshold at;
    ASSUME(WITHIN(at.sine, FXL_Q2_30_ONE) && (at.sine == 0 || (row.elevation < 0) != (at.sine < 0)));
    ASSERT("by the sign", is_above(&row, 0, &at) == (row.elevation >= 0));
    PROOF_ENDS();
}

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
