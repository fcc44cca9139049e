/* SPDX-License-Identifier: MIT */
/* Pixels of RGB565 that are blended or added. */
#include "paint/paint_rgb565.c"
#include "paint/gradients.c"
#include "proof.h"

#ifndef CASE
#define CASE 16
#endif

/* --- colours ----------------------------------------------------------------------------------------------- */

static uint32_t channel_of(uint32_t colour, uint32_t k)
{
    return k == 0 ? colour >> 11 : k == 1 ? colour >> 5 & 63u : colour & 31u;
}

/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_add_565"
 * property = "each channel of any two colours is their sum, or its largest level"
 * checks = 1
 */
void prove_add_565(void)
{
    const uint32_t a = nondet_u16(), b = nondet_u16(), k = nondet_u32();
    ASSUME(k < 3);
    const uint32_t most = k == 1 ? 63 : 31, added = channel_of(a, k) + channel_of(b, k);
    const uint32_t found = fxl_add_565(a, b);
    ASSERT("a sum that is held", channel_of(found, k) == (added > most ? most : added));
    PROOF_ENDS();
}

/* [[row]]
 * function = "mix_row"
 * property = "any 3 pixels, blended by any part or added: nothing is out of bounds, and where what is above is as beneath, or adds 0, they stay"
 * checks = 95
 * unwind = 4
 */
void prove_mix_row(void)
{
    uint16_t above[3], pixels[3];
    fxl_paint_565 of;
    const uint32_t count = nondet_u32(), k = nondet_u32();
    ASSUME(count <= 3 && k < count && of.sixteenths <= 16);
    const uint16_t before = pixels[k];
    const bool is_hole = of.sixteenths == 0 ? above[k] == 0 : above[k] == before;
    mix_row(&of, above, pixels, count);
    ASSERT("a hole stays", !is_hole || pixels[k] == before);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_mixture_of_565"
 * property = "any two colours; fields of its words do not touch"
 * checks = 16
 */
/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_red_and_blue_565"
 * id = "red and blue of a mixture"
 * property = "of any colour: a word with 8 bits below each"
 * checks = 16
 */
/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_raised_green_565"
 * id = "green of a mixture"
 * property = "of any colour: a word with 13 bits below it"
 * checks = 16
 */
/* [[row]]
 * function = "lib/paint/texel_place.h:fxl_is_mixed_565"
 * id = "what is mixed"
 * property = "any paint"
 * checks = 16
 */
void prove_mixture_of_565(void)
{
    const uint32_t colour = nondet_u16(), dark = nondet_u16();
    fxl_paint paint;
    const fxl_mixture_565 mixture = fxl_mixture_of_565(colour, dark);
    ASSERT("dark, and a half", mixture.red_dark == fxl_red_and_blue_565(dark) + 0x04000080u && mixture.green_dark == fxl_raised_green_565(dark) + 4096u);
    ASSERT("red and blue", fxl_red_and_blue_565(colour) == (channel_of(colour, 0) << 27 | channel_of(colour, 2) << 8));
    ASSERT("green", fxl_raised_green_565(colour) == channel_of(colour, 1) << 13);
    ASSERT("blended, or added", fxl_is_mixed_565(&paint) == (paint.of_565.sixteenths != 0 || paint.of_565.adds));
    PROOF_ENDS();
}

/* --- lines ------------------------------------------------------------------------------------------------- */

/* [[row]]
 * function = "has_lines"
 * property = "any paint"
 * checks = 31
 */
void prove_has_lines(void)
{
    fxl_paint paint;
    ASSERT("texels", !has_lines(&paint) || paint.level.texels != NULL);
    PROOF_ENDS();
}

/* [[row]]
 * function = "after"
 * property = "any numbers"
 * checks = 36
 */
void prove_after(void)
{
    column_numbers at, step;
    const uint32_t columns = nondet_u32();
    ASSUME(columns < 1u << 16);
    (void)after(&at, &step, columns);
    PROOF_ENDS();
}

/* [[row]]
 * function = "log_of"
 * property = "any weights and rule: 0, 2, 3 or 4"
 * checks = 180
 */
void prove_log_of(void)
{
    fxl_paint paint;
    fxl_gradients gradients;
    paint.gradients = &gradients;
    const uint32_t log = log_of(&paint, nondet_s64());
    ASSERT("columns of a segment", log == 0 || (log >= 2 && log <= 4));
    PROOF_ENDS();
}

/* [[row]]
 * function = "divide"
 * property = "any numbers"
 * checks = 52
 */
void prove_divide(void)
{
    column_numbers at;
    int32_t u, v;
    const int32_t u_drop = nondet_s32(), v_drop = nondet_s32();
    ASSUME(u_drop >= -66 && u_drop <= 190 && v_drop >= -66 && v_drop <= 190);
    divide(&at, u_drop, v_drop, &u, &v);
    PROOF_ENDS();
}

/* [[row]]
 * function = "find_step"
 * property = "any numbers, and segments of up to 16 columns"
 * checks = 37
 */
void prove_find_step(void)
{
    column_numbers along, step;
    const uint32_t log = nondet_u32();
    ASSUME(log <= 4);
    find_step(&along, log, &step);
    PROOF_ENDS();
}

static uint16_t texels[8], palette[256];

/* [[row]]
 * function = "show_lines"
 * property = "texels of 8 and 16 bits, a texture of 4 x 2, any coordinates: nothing is out of bounds"
 * checks = 232
 * unwind = 5
 * cases = [8, 16]
 */
void prove_show_lines(void)
{
    fxl_paint paint;
    texel_line line;
    uint16_t shown[4];
    paint.level.texels = (const uint8_t *)texels;
    paint.level.colours = NULL;
    paint.level.log_width = 2;
    paint.level.columns_less_1 = 3;
    paint.level.rows_less_1 = 1;
    paint.of_565.palette = palette;
    ASSUME(line.count >= 1 && line.count <= 4);
    show_lines(&paint, &line, &line + 1, shown, CASE);
    PROOF_ENDS();
}
