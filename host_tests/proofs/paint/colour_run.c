/* SPDX-License-Identifier: MIT */
#include "paint/colour_run.c"
#include "proof.h"

/* [[row]]
 * function = "fxl_paint_colour_run"
 * property = "any words: no other pixel is written, and the first one has the levels of the words; runs of up to 4 pixels"
 * checks = 48
 */
void prove_paint_colour_run(void)
{
    uint16_t pixels[5];
    fxl_colour_words words;
    const uint32_t count = nondet_u32();
    ASSUME(count <= 4);
    const uint16_t behind = pixels[count];
    fxl_paint_colour_run(&words, pixels, count);
    ASSERT("no pixel behind the last one", pixels[count] == behind);
    ASSERT("the first one's levels", count == 0 || pixels[0] == (uint16_t)(words.both >> 27 << 11 | words.green >> 26 << 5 | (words.both >> 11 & 31u)));
    PROOF_ENDS();
}
