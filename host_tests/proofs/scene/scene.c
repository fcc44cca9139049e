/* SPDX-License-Identifier: MIT */
#include "scene/status.c"
#include "scene/crc.c"
#include "scene/reasons.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_status_text"
 * property = "never null, for every number"
 * checks = 1
 */
void prove_status_text(void)
{
    ASSERT("never null", fxl_status_text((fxl_status)nondet_s32()) != NULL);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/scene/reasons.c:fxl_explain"
 * property = "any list of up to 12 bytes that ends, and any status: nothing is read beyond it, and a sentence is one of the list"
 * checks = 55
 * unwind = 13
 */
void prove_explain(void)
{
    char list[12];
    ASSUME(list[10] == '\0' && list[11] == '\0'); /* of the last sentence, and of the list */
    const char *said = fxl_explain(nondet_bool() ? NULL : list, (fxl_status)nondet_s32());
    ASSERT("of the list", said == NULL || (said > list && said < list + sizeof list));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/scene/crc.c:fxl_crc"
 * property = "for up to 8 bytes: nothing is read out of bounds, and every remainder is in its table"
 * checks = 16
 * unwind = 9
 */
void prove_crc(void)
{
    uint8_t bytes[8];
    const size_t count = nondet_size();
    ASSUME(count <= sizeof bytes);
    (void)fxl_crc(nondet_u32(), bytes, count);
    PROOF_ENDS();
}
