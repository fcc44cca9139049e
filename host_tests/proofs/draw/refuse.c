/* SPDX-License-Identifier: MIT */
#include "draw/renderer.c"
#include "proof.h"

void prove_refuse(void)
{
    fxl_workspace workspace;
    const uint32_t before = workspace.counters.refused_calls;
    const fxl_status status = (fxl_status)nondet_u8();
    ASSERT("its status", fxl_refuse(&workspace, status) == status);
    ASSERT("counted", workspace.counters.refused_calls == before + 1u);
    PROOF_ENDS();
}
