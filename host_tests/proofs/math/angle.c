/* SPDX-License-Identifier: MIT */
#include "math/angle.c"
#include "proof.h"

/* [[row]]
 * function = "quarter_sine_q62"
 * property = "nothing overflows, and the sine is at most 1"
 * checks = 26
 * contract = true
 * uses = ["fxl_multiply_high"]
 * unwind = 12
 */
void prove_quarter_sine_q62(void)
{
    (void)quarter_sine_q62(nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_sin_q31"
 * property = "nothing overflows, and the sine is within -1 and 1, for every angle"
 * checks = 29
 * contract = true
 * uses = ["quarter_sine_q62"]
 */
void prove_sin_q31(void)
{
    (void)fxl_sin_q31(nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_cos_q31"
 * property = "the same of the cosine"
 * checks = 22
 * contract = true
 * uses = ["fxl_sin_q31"]
 */
void prove_cos_q31(void)
{
    (void)fxl_cos_q31(nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_sin"
 * property = "nothing overflows, and the sine is within -1 and 1, for every angle"
 * checks = 30
 * contract = true
 * uses = ["quarter_sine_q62"]
 */
void prove_sin(void)
{
    (void)fxl_sin(nondet_u32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_cos"
 * property = "the same of the cosine"
 * checks = 22
 * contract = true
 * uses = ["fxl_sin"]
 */
void prove_cos(void)
{
    (void)fxl_cos(nondet_u32());
    PROOF_ENDS();
}
