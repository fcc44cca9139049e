/* SPDX-License-Identifier: MIT */
#include "scene/status.c"
#include "scene/crc.c"
#include "proof.h"

void prove_status_text(void)
{
    ASSERT("never null", fxl_status_text((fxl_status)nondet_s32()) != NULL);
    PROOF_ENDS();
}

void prove_crc(void)
{
    uint8_t bytes[8];
    const size_t count = nondet_size();
    ASSUME(count <= sizeof bytes);
    (void)fxl_crc(nondet_u32(), bytes, count);
    PROOF_ENDS();
}
