/* SPDX-License-Identifier: MIT */
#include "paint/depth_runs.c"
#include "paint/depth_row.h"
#include "paint/texel_outline.c"
#include "proof.h"

/* The depth test of a run: four cells at once and the rest, so six cells have every path. */
#define CELLS 6

/* [[row]]
 * function = "fxl_depth_keep_visible"
 * property = "for runs of up to 6 cells, any codes and any cells: visible cells keep their code, others stay, none is out of bounds"
 * checks = 78
 * unwind = 10
 */
void prove_depth_keep_visible(void)
{
    uint16_t cells[CELLS], before[CELLS];
    const uint32_t count = nondet_u32(), code = nondet_u32(), step = nondet_u32(), i = nondet_u32();
    ASSUME(count <= CELLS && i < CELLS);
    before[i] = cells[i];
    const uint32_t kept = fxl_depth_keep_visible(cells, count, code, step);
    const uint32_t of_i = (code + i * step) >> 16;
    ASSERT("at most all", kept <= count);
    ASSERT("visible ones are kept", i >= kept || (of_i > before[i] && cells[i] == of_i));
    ASSERT("others stay", i < kept || cells[i] == before[i]);
    ASSERT("it ends at a hidden one", i != kept || kept == count || of_i <= before[i]);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_depth_skip_hidden"
 * property = "for runs of up to 6 cells: it ends at the first visible one"
 * checks = 72
 * unwind = 10
 */
void prove_depth_skip_hidden(void)
{
    uint16_t cells[CELLS];
    const uint32_t count = nondet_u32(), code = nondet_u32(), step = nondet_u32(), i = nondet_u32();
    ASSUME(count <= CELLS && i < CELLS);
    const uint32_t hidden = fxl_depth_skip_hidden(cells, count, code, step);
    const uint32_t of_i = (code + i * step) >> 16;
    ASSERT("at most all", hidden <= count);
    ASSERT("hidden ones are skipped", i >= hidden || of_i <= cells[i]);
    ASSERT("it ends at a visible one", i != hidden || hidden == count || of_i > cells[i]);
    PROOF_ENDS();
}

static fxl_depth_scale any_scale(void)
{
    fxl_depth_scale scale;
    ASSUME(scale.octaves >= 1 && scale.octaves <= 24 && scale.mantissa >= 11 && scale.mantissa <= 15);
    return scale;
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_scale_of"
 * property = "for every lens: 1 to 24 octaves, 11 to 15 bits, at most 65,536 codes"
 * checks = 19
 */
void prove_depth_scale_of(void)
{
    fxl_lens lens;
    ASSUME(lens.near_z >= FXL_NEAR_MIN && lens.near_z < lens.far_z && lens.far_z <= FXL_FAR_MAX);
    const fxl_depth_scale scale = fxl_depth_scale_of(&lens);
    ASSERT("octaves", scale.octaves >= 1 && scale.octaves <= 24);
    ASSERT("mantissa", scale.mantissa >= 11 && scale.mantissa <= 15);
    ASSERT("codes", ((uint32_t)scale.octaves << scale.mantissa) + 1 <= 65536);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_octave_of"
 * property = "nothing overflows, and every shift is in its range"
 * checks = 133
 */
void prove_depth_octave_of(void)
{
    const fxl_depth_scale scale = any_scale();
    fxl_depth_plane plane;
    fxl_depth_octave octave;
    ASSUME(WITHIN(plane.one, 1 << 20));
    fxl_depth_octave_of(scale, &plane, nondet_s64(), &octave);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_octave_of_word"
 * property = "every shift is in its range, and the octave holds the word"
 * checks = 68
 */
void prove_depth_octave_of_word(void)
{
    const fxl_depth_scale scale = any_scale();
    fxl_depth_plane plane;
    fxl_depth_octave octave;
    ASSUME(plane.one < FXL_DEPTH_IS_BENT + scale.octaves);
    const uint32_t value = nondet_u32();
    fxl_depth_octave_of_word(scale, &plane, value, &octave);
    ASSERT("the word's own", fxl_depth_octave_holds(&octave, value));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_shifted"
 * property = "the lowest 32 bits of the floor, exactly"
 * checks = 17
 */
void prove_depth_shifted(void)
{
    const int64_t value = nondet_s64();
    const int32_t drop = nondet_s32();
    ASSUME(drop > -32 && drop < 64);
    const uint32_t shifted = fxl_depth_shifted(value, drop);
    ASSERT("the lowest bits of the floor", shifted == (drop >= 0 ? (uint32_t)(value >> drop) : (uint32_t)value << -drop));
    PROOF_ENDS();
}

/* --- texels in words --------------------------------------------------------------------------- */

#define WIDTH 3
#define ROWS  2

static FXL_ALIGN_8 uint16_t texels[8];
static uint16_t palette[256];

/* Any words, of a texture of 8 texels of 8 or of 16 bits: 1 x 8 to 8 x 1. */
static fxl_texel_outline any_texels(void)
{
    fxl_texel_outline of;
    const uint32_t columns = nondet_u32(), rows = nondet_u32();
    ASSUME(columns <= 3 && rows <= 3 - columns);
    of.texels = (const uint8_t *)(const void *)texels;
    of.palette = palette;
    of.columns_mask = (1u << columns) - 1u;
    of.rows_mask = ((1u << rows) - 1u) << columns;
    ASSUME(of.is_wide <= 1);
    return of;
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:colour_of"
 * property = "no texel is read that is not of the level, and without light it is that of the column and row of u and v, for any words"
 * checks = 139
 */
void prove_colour_of_words(void)
{
    const fxl_texel_outline of = any_texels();
    fxl_texel_words at;
    const uint32_t columns = of.columns_mask + 1u, rows = of.rows_mask / columns + 1u;
    const uint32_t place = (at.v >> 16) / columns % rows * columns + (at.u >> 24) % columns;
    const uint32_t texel = of.is_wide ? texels[place] : palette[of.texels[place]];
    ASSERT("of the column and row", colour_of(&of, &at, false, of.is_wide != 0) == texel);
    ASSERT("lit", colour_of(&of, &at, true, of.is_wide != 0) <= 0xFFFFu);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:paint_near"
 * property = "runs of up to 4 pixels of any words: visible cells take the code, others stay with their pixels, none is out of bounds"
 * checks = 291
 * unwind = 6
 */
/* [[row]]
 * function = "lib/paint/texel_outline.c:paint_any"
 * property = "the same in any order, and beyond the end of an octave a cell is not nearer than the word"
 * checks = 291
 * unwind = 6
 */
void prove_paint_near(void)
{
    const fxl_texel_outline of = any_texels();
    fxl_texel_words at;
    uint16_t cells[4], pixels[4], before[4], beneath[4];
    const uint32_t count = nondet_u32(), i = nondet_u32();
    ASSUME(count >= 1 && count <= 4 && i < 4);
    before[i] = cells[i];
    beneath[i] = pixels[i];
    const uint32_t word = at.code + of.along.code * i;
    const bool is_near = nondet_bool();
    uint32_t code = word;
    if (is_near) {
        paint_near(&of, at, cells, pixels, count, nondet_bool(), of.is_wide != 0);
    } else {
        code = word < of.border ? 2u * word - of.border : word;
        paint_any(&of, at, cells, pixels, count);
    }
    const bool is_visible = i < count && (code >> 16 > before[i] || (!is_near && of.or_equal && code >> 16 == before[i]));
    ASSERT("a visible one is kept", cells[i] == (is_visible ? code >> 16 : before[i]));
    ASSERT("the others' pixels stay", is_visible || pixels[i] == beneath[i]);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:words_at"
 * property = "any words and any number of pixels: those of as many steps, modulo 2^32"
 * checks = 106
 * unwind = 5
 */
/* [[row]]
 * id = "shifted of texels in words"
 * function = "lib/paint/texel_outline.c:shifted"
 * property = "any value: the lower word of it over a power of two of up to 16 bits, rounded down"
 * checks = 106
 * unwind = 5
 */
void prove_words_at(void)
{
    fxl_texel_words at, along;
    const uint32_t count = nondet_u32(), drop = nondet_u32();
    ASSUME(count <= 3 && drop <= 16);
    const fxl_texel_words there = words_at(&at, &along, count);
    for (uint32_t i = 0; i < count; i++) {
        step(&at, &along);
    }
    ASSERT("as by steps", there.code == at.code && there.u == at.u && there.v == at.v && there.light == at.light);
    const int64_t value = nondet_s64();
    ASSUME(value > -((int64_t)1 << 40) && value < (int64_t)1 << 40);
    const int32_t word = (int32_t)shifted(value, drop), lower = (int32_t)value;
    const int64_t rest = lower - (int64_t)word * ((int64_t)1 << drop);
    ASSERT("rounded down", rest >= 0 && rest < (int64_t)1 << drop);
    PROOF_ENDS();
}

/* [[row]]
 * id = "set_words of texels"
 * function = "lib/paint/texel_outline.c:set_words"
 * property = "gradients in words, a level that leaves up to 8 bits out, up to 256 columns: each shift is below 17, and each word is the gradient's"
 * checks = 211
 */
void prove_set_words(void)
{
    fxl_gradients gradients;
    fxl_paint paint;
    fxl_depth_plane depth;
    fxl_texel_outline of;
    paint.gradients = &gradients;
    const uint32_t u_drop = nondet_u32(), v_drop = nondet_u32();
    ASSUME(u_drop <= 8 && v_drop <= 8 && paint.level.log_width <= 8 && (gradients.count == 2 || gradients.count == 3));
    gradients.shifts[FXL_ATTRIBUTE_U] = (int8_t)(FXL_SHIFT_OF_TEXELS - (int32_t)u_drop);
    gradients.shifts[FXL_ATTRIBUTE_V] = (int8_t)(FXL_SHIFT_OF_TEXELS - (int32_t)v_drop);
    set_words(&paint, &depth, &of);
    const int32_t u = (int32_t)gradients.attributes[FXL_ATTRIBUTE_U].along, v = (int32_t)gradients.attributes[FXL_ATTRIBUTE_V].down;
    ASSERT("u, by its level", of.along.u == (uint32_t)(u >> u_drop));
    ASSERT("v, by its level and columns", of.down.v == (uint32_t)(v >> (v_drop + 8 - paint.level.log_width)));
    ASSERT("light, or none", of.along.light == (gradients.count == 3 ? (uint32_t)gradients.attributes[FXL_SEGMENT_LIGHT].along : 0));
    ASSERT("depth", of.at.code == (uint32_t)depth.gradient.at && of.down.code == (uint32_t)depth.gradient.down);
    PROOF_ENDS();
}
