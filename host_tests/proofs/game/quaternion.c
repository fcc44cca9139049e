/* SPDX-License-Identifier: MIT */
#include "game/quaternion.c"
#include "products.h"

/* [[row]]
 * function = "over_norm"
 * property = "any part and norm of its contract: nothing overflows, and the quotient is within 1"
 * checks = 15
 * contract = true
 * unwind = 31
 */
void prove_over_norm(void)
{
    (void)over_norm(nondet_s64(), nondet_s64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_orientation_from_quaternion"
 * property = "any numbers and null pointers: nothing overflows, no part is above the norm, and each entry is within 1; refused, none is written"
 * checks = 148
 * uses = ["over_norm"]
 * stands_in = { fxl_multiply_s32 = "any_signed" }
 * unwind = 4
 */
void prove_from_quaternion(void)
{
    static fxl_quaternion given;
    static fxl_orientation made;
    ANY_CONTENT(&given);
    ANY_CONTENT(&made);
    const fxl_orientation before = made;
    const fxl_status status = fxl_orientation_from_quaternion(nondet_bool() ? NULL : &given, nondet_bool() ? NULL : &made);
    ASSERT("within 1", status != FXL_OK || (FXL_POINT_BELOW(&made.x, FXL_Q2_30_ONE) && FXL_POINT_BELOW(&made.y, FXL_Q2_30_ONE) &&
                                            FXL_POINT_BELOW(&made.z, FXL_Q2_30_ONE)));
    ASSERT("or untouched", status == FXL_OK || (made.x.x == before.x.x && made.y.y == before.y.y && made.z.z == before.z.z));
    PROOF_ENDS();
}

/* [[row]]
 * function = "beside_root"
 * property = "any difference and root of its contract: nothing overflows, and the number has an opposite"
 * checks = 58
 * contract = true
 * uses = ["fxl_divide_u64"]
 */
void prove_beside_root(void)
{
    (void)beside_root(nondet_s64(), nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "quaternion_of"
 * property = "any entries within 1: nothing overflows, the root is half at least, and w is not below 0"
 * checks = 97
 * uses = ["beside_root"]
 * unwind = 33
 */
void prove_quaternion_of(void)
{
    fxl_orientation rows;
    fxl_quaternion made;
    ASSUME(WITHIN(rows.x.x, FXL_Q2_30_ONE) && WITHIN(rows.x.y, FXL_Q2_30_ONE) &&
           WITHIN(rows.x.z, FXL_Q2_30_ONE));
    ASSUME(WITHIN(rows.y.x, FXL_Q2_30_ONE) && WITHIN(rows.y.y, FXL_Q2_30_ONE) &&
           WITHIN(rows.y.z, FXL_Q2_30_ONE));
    ASSUME(WITHIN(rows.z.x, FXL_Q2_30_ONE) && WITHIN(rows.z.y, FXL_Q2_30_ONE) &&
           WITHIN(rows.z.z, FXL_Q2_30_ONE));
    quaternion_of(&rows, &made);
    ASSERT("w is not below 0", made.w >= 0);
    PROOF_ENDS();
}
