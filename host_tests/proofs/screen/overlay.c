/* SPDX-License-Identifier: MIT */
#include "screen/overlay.c"

#include "proof.h"

/* [[row]]
 * function = "lib/screen/overlay_band.h:fxl_clip_stretch"
 * property = "any stretch whose numbers have 33 bits, and any window: exactly its pixels that lie in the window, and nothing overflows"
 * checks = 6
 */
void prove_clip_stretch(void)
{
    const int64_t at = nondet_s64(), count = nondet_s64();
    const int32_t low = nondet_s32(), high = nondet_s32(), pixel = nondet_s32();
    ASSUME(WITHIN(at, (int64_t)1 << 33) && WITHIN(count, (int64_t)1 << 33) && low <= high);
    const fxl_stretch part = fxl_clip_stretch(at, count, low, high);
    ASSERT("its pixels in the window", (part.first <= pixel && pixel < part.end) == (at <= pixel && pixel < at + count && low <= pixel && pixel < high));
    ASSERT("within the window", low <= part.first && part.first <= part.end && part.end <= high);
    PROOF_ENDS();
}

/* [[row]]
 * function = "in_range"
 * property = "any two coordinates: exactly those of a line's range"
 * checks = 4
 */
void prove_in_range(void)
{
    const int64_t a = nondet_s32(), b = nondet_s32();
    ASSERT("both of them", in_range((int32_t)a, (int32_t)b) ==
                               (WITHIN(a, FXL_LINE_COORDINATE_MAX) && WITHIN(b, FXL_LINE_COORDINATE_MAX)));
    PROOF_ENDS();
}
