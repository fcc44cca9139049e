/* SPDX-License-Identifier: MIT */
#include "math/angle.c"
#include "proof.h"

void prove_quarter_sine_q62(void)
{
    (void)quarter_sine_q62(nondet_u32());
    PROOF_ENDS();
}

void prove_sin_q31(void)
{
    (void)fxl_sin_q31(nondet_u32());
    PROOF_ENDS();
}

void prove_cos_q31(void)
{
    (void)fxl_cos_q31(nondet_u32());
    PROOF_ENDS();
}

void prove_sin(void)
{
    (void)fxl_sin(nondet_u32());
    PROOF_ENDS();
}

void prove_cos(void)
{
    (void)fxl_cos(nondet_u32());
    PROOF_ENDS();
}
