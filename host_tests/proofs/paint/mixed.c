/* SPDX-License-Identifier: MIT */
/* Pixels of RGB565 that are blended or added. */
#include "paint/paint_rgb565.c"
#include "paint/gradients.c"
#include "proof.h"

#ifndef CASE
#define CASE 0
#endif

/* --- colours ----------------------------------------------------------------------------------------------- */

static uint32_t channel_of(uint32_t colour, uint32_t k)
{
    return k == 0 ? colour >> 11 : k == 1 ? colour >> 5 & 63u : colour & 31u;
}

/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_add_565"
 * property = "each channel of any two words of two colours is their sum, or its largest level"
 * checks = 4
 */
void prove_add_565(void)
{
    const uint32_t a = nondet_u32(), b = nondet_u32(), k = nondet_u32(), half = nondet_bool() ? 16 : 0;
    ASSUME(k < 3);
    const uint32_t most = k == 1 ? 63 : 31;
    const uint32_t added = channel_of(a >> half & 0xFFFFu, k) + channel_of(b >> half & 0xFFFFu, k);
    const uint32_t found = fxl_add_565(a, b) >> half & 0xFFFFu;
    ASSERT("a sum that is held", channel_of(found, k) == (added > most ? most : added));
    PROOF_ENDS();
}

/* [[row]]
 * function = "mixed_of"
 * property = "any two words, blended by each part or added: a colour that is blended with itself stays, and so does one to which 0 is added"
 * checks = 34
 * cases = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]
 */
/* [[row]]
 * function = "lib/paint/rgb565_colour.h:fxl_blend_spread_565"
 * id = "spread channels that are blended"
 * property = "any two words and each part: nothing is between the channels"
 * checks = 34
 * cases = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]
 */
void prove_mixed_of(void)
{
    const uint32_t above = nondet_u32(), beneath = nondet_u32();
    ASSERT("channels", (fxl_blend_spread_565(above, beneath, CASE) & ~FXL_SPREAD_565) == 0);
    ASSERT("stays", mixed_of(CASE == 0 ? 0 : beneath, beneath, CASE) == beneath);
    PROOF_ENDS();
}

/* [[row]]
 * function = "mix_row"
 * property = "1 to 5 pixels from either half of a word on, blended or added: nothing is out of bounds, and no other pixel is written"
 * checks = 129
 * unwind = 4
 */
/* [[row]]
 * function = "mix_words"
 * id = "words of mixed pixels"
 * property = "the same"
 * checks = 129
 * unwind = 4
 */
void prove_mix_row(void)
{
    FXL_ALIGN_8 uint16_t above[6], pixels[6];
    fxl_paint_565 of;
    const uint32_t count = nondet_u32(), k = nondet_u32(), first = nondet_u32();
    ASSUME(count >= 1 && count <= 5 && k < 6 && first <= 1 && of.sixteenths <= 16);
    const uint16_t before = pixels[k];
    mix_row(of.sixteenths, above + first, pixels + first, count);
    ASSERT("no other", pixels[k] == before || (k >= first && k < first + count));
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
 * function = "has_plain_lines"
 * id = "mixed: has_plain_lines"
 * property = "any paint"
 * checks = 65
 */
/* [[row]]
 * function = "has_plain_texels"
 * id = "mixed: has_plain_texels"
 * property = "any paint"
 * checks = 65
 */
/* [[row]]
 * function = "is_keyed"
 * id = "mixed: is_keyed"
 * property = "any paint"
 * checks = 65
 */
/* [[row]]
 * function = "has_holes"
 * id = "mixed: has_holes"
 * property = "any paint"
 * checks = 65
 */
/* [[row]]
 * function = "has_lines"
 * property = "any paint"
 * checks = 65
 */
void prove_has_lines(void)
{
    fxl_paint paint;
    uint8_t texel;
    paint.level.texels = nondet_bool() ? &texel : NULL; /* CBMC takes an unset pointer for null once it was compared */
    const uint32_t others = FXL_TEXTURE_CLAMP | FXL_LEVEL_IN_BEAM;
    const bool is_plain = paint.level.colours == NULL && (paint.level.flags & others) == 0;
    const bool is_keyed_one = (paint.level.flags & FXL_TEXTURE_KEYED) != 0, is_first = paint.of_565.part_of_level == 0;
    ASSERT("of 8 or 16 bits, repeated, in no beam", has_plain_texels(&paint) == is_plain);
    ASSERT("such texels, all drawn, in no light", has_plain_lines(&paint) == (is_plain && is_first && paint.opacity == 16 && paint.level.texels != NULL));
    ASSERT("a key", is_keyed(&paint) == is_keyed_one);
    ASSERT("a key is a hole, and so is an opacity", has_holes(&paint) == (is_keyed_one || paint.opacity < 16));
    ASSERT("texels in one light", has_lines(&paint) == (paint.level.texels != NULL && (is_first || (paint.is_evenly_lit && !has_holes(&paint)))));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/paint_row.h:after"
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
 * function = "lib/paint/paint_row.h:log_at"
 * property = "any weights and rule: 0, 2, 3 or 4"
 * checks = 195
 */
/* [[row]]
 * function = "lib/paint/paint_row.h:has_sixteens"
 * property = "the same: only with FXL_DIVIDE_16"
 * checks = 195
 */
/* [[row]]
 * function = "lib/paint/paint_row.h:weight_after"
 * property = "the same: from 1 on"
 * checks = 195
 */
void prove_log_of(void)
{
    fxl_paint paint;
    fxl_gradients gradients;
    fxl_paint_row row;
    const uint32_t x0 = nondet_u32(), x1 = nondet_u32();
    ASSUME(x0 < x1 && x1 < 1u << 15);
    ASSUME(gradients.weight_min[0] <= (uint32_t)1 << 31 && gradients.weight_min[1] <= (uint32_t)1 << 31); /* as power_up leaves them */
    paint.gradients = &gradients;
    const uint32_t log = log_at(&paint, &row, x0), weight = weight_after(&paint, &row, x0 & ~15u);
    ASSERT("columns of a segment", log == 0 || (log >= 2 && log <= 4));
    ASSERT("a weight", weight >= 1 && weight <= INT32_MAX);
    ASSERT("16 columns", !has_sixteens(&paint, &row, x0, x1) || paint.division == FXL_DIVIDE_16);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/paint_row.h:divide"
 * property = "any numbers: fxl_attribute_of"
 * checks = 84
 */
/* [[row]]
 * function = "lib/paint/paint_row.h:upper_32"
 * property = "any number"
 * checks = 84
 */
void prove_divide(void)
{
    column_numbers at;
    fxl_gradients gradients;
    int32_t u, v;
    divide(&gradients, &at, &u, &v);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/paint_row.h:find_step"
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
 * checks = 476
 * unwind = 3
 * cases = [0, 1, 2, 3]
 */
void prove_show_lines(void)
{
    fxl_paint paint;
    texel_line line;
    uint16_t shown[2];
    paint.level.texels = (const uint8_t *)texels;
    paint.level.colours = NULL;
    paint.level.log_width = 2;
    paint.level.columns_less_1 = 3;
    paint.level.rows_less_1 = 1;
    paint.of_565.palette = palette;
    ASSUME(line.count >= 1 && line.count <= 2);
    show_lines(&paint, &line, &line + 1, shown, (CASE & 1) != 0, (CASE & 2) != 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "show_any"
 * property = "any texture of 4 x 2 of 8 bits, repeated or clamped, and any coordinates: nothing is out of bounds"
 * checks = 242
 * unwind = 3
 * narrows = "the conversions in it that are meant go through no named function yet"
 */
void prove_show_any(void)
{
    fxl_paint paint;
    texel_line line;
    uint16_t shown[2];
    const uint8_t in_beam[256] = {0};
    paint.level.texels = (const uint8_t *)texels;
    paint.level.colours = NULL;
    paint.level.log_width = 2;
    paint.level.columns_less_1 = 3;
    paint.level.rows_less_1 = 1;
    paint.in_beam = in_beam;
    paint.of_565.palette = palette;
    ASSUME(line.count >= 1 && line.count <= 2);
    show_any(&paint, &line, &line + 1, shown);
    PROOF_ENDS();
}

/* [[row]]
 * function = "drawn_of_four"
 * property = "any opacity from 1 on and any row: four bits, all of them where it is 16"
 * checks = 100
 * unwind = 5
 */
/* [[row]]
 * function = "leave_out"
 * property = "any pattern and any 4 pixels: what is drawn stays, and a hole is as beneath, or 0"
 * checks = 100
 * unwind = 5
 */
/* [[row]]
 * function = "mix_evenly"
 * property = "any 2 pixels in any light: nothing is out of bounds"
 * checks = 100
 * unwind = 5
 */
void prove_leave_out(void)
{
    fxl_paint paint;
    uint16_t pixels[4], colours[4];
    const uint32_t k = nondet_u32();
    const int32_t x = nondet_s32(), y = nondet_s32();
    const bool adds = nondet_bool();
    ASSUME(k < 4 && x >= 0 && x < 1024 && y >= 0 && y < 1024 && paint.opacity >= 1 && paint.opacity <= 16);
    const uint32_t drawn = drawn_of_four(&paint, y);
    const uint16_t before = colours[k];
    ASSERT("four bits", drawn <= 15 && (paint.opacity < 16 || drawn == 15));
    leave_out(drawn, adds, x, pixels, colours, 4);
    ASSERT("drawn or beneath", colours[k] == ((drawn >> ((uint32_t)x + k) % 4 & 1u) != 0 ? before : adds ? 0 : pixels[k]));
    mix_evenly(&paint, pixels + 2, pixels + 4);
    PROOF_ENDS();
}
