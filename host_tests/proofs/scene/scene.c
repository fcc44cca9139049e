/* SPDX-License-Identifier: MIT */
#include "scene/status.c"
#include "scene/crc.c"
#include "scene/reasons.c"
#include "proof.h"

void prove_status_text(void)
{
    ASSERT("never null", fxl_status_text((fxl_status)nondet_s32()) != NULL);
    PROOF_ENDS();
}

void prove_explain(void)
{
    char list[12];
    ASSUME(list[10] == '\0' && list[11] == '\0'); /* of the last sentence, and of the list */
    const char *said = fxl_explain(nondet_bool() ? NULL : list, (fxl_status)nondet_s32());
    ASSERT("of the list", said == NULL || (said > list && said < list + sizeof list));
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
