/* SPDX-License-Identifier: MIT */
/* Smooth outlines in C. */
#include "paint/smooth_outline.c"
#include "proof.h"

#ifndef CASE
#define CASE 1
#endif

#define PIXELS 4

/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_part_of_565"
 * property = "ramps of 2, 3, 32 and 64 levels, and any light of them: the upper word of the product, on a core without long products"
 * checks = 12
 * cases = [1, 2, 31, 63]
 * flags = ["-DFXL_CORE_HAS=0"]
 */
void prove_part_of_565(void)
{
    const uint32_t light = nondet_u32(), part = (65536u + CASE / 2) / CASE;
    ASSUME(light <= ((uint32_t)CASE << 24) + fxl_half_part_565(CASE));
    ASSERT("of the product", fxl_part_of_565(light, part) == (uint32_t)((uint64_t)light * part >> 32));
    ASSERT("at most all", fxl_part_of_565(light, part) <= 256);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/outline_rows.h:fxl_keep_nearer"
 * property = "any code and cell: a nearer one is kept"
 * checks = 16
 */
/* [[row]]
 * function = "lib/paint/outline_rows.h:fxl_whole_edge"
 * property = "any edge: its sum with its step is what fxl_edge_step makes of it"
 * checks = 16
 */
void prove_keep_nearer(void)
{
    uint16_t cell = nondet_u16();
    const uint16_t before = cell;
    const uint32_t code = nondet_u32(), fraction = nondet_u32(), more = nondet_u32();
    const int32_t x = nondet_s32(), step = nondet_s32();
    const bool is_nearer = fxl_keep_nearer(&cell, code);
    ASSERT("nearer", is_nearer == (code >> 16 > before) && cell == (is_nearer ? code >> 16 : before));
    const uint64_t sum = fxl_whole_edge(x, fraction) + fxl_whole_edge(step, more);
    const uint64_t carry = ((uint64_t)fraction + more) >> 32;
    ASSERT("with the carry", sum >> 32 == fxl_bits_32(x) + fxl_bits_32(step) + (uint32_t)carry && fxl_low_32(sum) == fraction + more);
    PROOF_ENDS();
}

/* Any outline of a ramp, and a row of it whose codes and light do not come round. */
static outline any_outline(line *at, uint32_t count)
{
    outline of;
    ASSUME(of.end > 0 && of.end <= (64u << 24) && of.border <= (UINT32_MAX - (1u << 26)));
    const int64_t last = count - 1u;
    const int64_t light = fxl_signed_32(at->light) + last * fxl_signed_32(at->light_along);
    const int64_t code = at->code + last * fxl_signed_32(at->along);
    ASSUME(light >= INT32_MIN && light <= INT32_MAX && code >= 0 && code <= UINT32_MAX);
    return of;
}

/* [[row]]
 * function = "alike"
 * property = "rows of up to 4 pixels, no sum of which wraps: of the pixels that are alike, from 1 on, each has the code and the light that it has alone"
 * checks = 112
 * unwind = 5
 */
/* [[row]]
 * function = "piece_of"
 * property = "the same: codes below the border are less by what they are below it, and light is held within the ramp"
 * checks = 112
 * unwind = 5
 */
/* [[row]]
 * function = "place_of"
 * id = "below, of, or above the ramp"
 * property = "the same"
 * checks = 112
 * unwind = 5
 */
void prove_alike(void)
{
    line at;
    const uint32_t count = nondet_u32(), i = nondet_u32();
    ASSUME(count >= 1 && count <= PIXELS);
    const outline of = any_outline(&at, count);
    const uint32_t found = alike(&of, &at, count);
    const line piece = piece_of(&of, &at);
    ASSERT("at least one", found >= 1 && found <= count);
    ASSUME(i < found);
    const uint32_t code = at.code + i * at.along;
    const int32_t light = fxl_signed_32(at.light + i * at.light_along);
    const uint32_t held = light < 0 ? 0 : (uint32_t)light >= of.end ? of.end - 1u : (uint32_t)light;
    ASSERT("light", piece.light + i * piece.light_along == held);
    ASSERT("code", piece.code + i * piece.along == (code < of.border ? 2u * code - of.border : code));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/smooth_outline.c:paint_near"
 * id = "smooth: paint_near"
 * property = "up to 4 pixels of 8 and 16 bits, with light of a ramp of 2 levels: visible cells take the code, others stay with their pixels, none is out of bounds"
 * checks = 138
 * unwind = 6
 */
void prove_paint_near(void)
{
    uint8_t ramp[512];
    FXL_ALIGN_8 uint16_t cells[PIXELS], pixels[PIXELS];
    uint16_t before[PIXELS], beneath[PIXELS];
    outline of;
    line at;
    const uint32_t count = nondet_u32(), i = nondet_u32();
    const bool is_wide = nondet_bool();
    ASSUME(count >= 1 && count <= PIXELS && i < PIXELS);
    ASSUME(at.light < 2u << 24 && at.light_along == 0);
    of.ramp = is_wide ? NULL : ramp + nondet_u8();
    before[i] = cells[i];
    beneath[i] = pixels[i];
    const uint32_t code = at.code + at.along * i;
    paint_near(&of, at, cells, (uint8_t *)pixels, count);
    const bool is_visible = i < count && code >> 16 > before[i];
    ASSERT("a visible one is kept", cells[i] == (is_visible ? code >> 16 : before[i]));
    ASSERT("the others' pixels stay", !is_wide || is_visible || pixels[i] == beneath[i]);
    ASSERT("of the level", is_wide || !is_visible || ((uint8_t *)pixels)[i] == of.ramp[at.light >> 24 == 0 ? 0 : 256]);
    PROOF_ENDS();
}
