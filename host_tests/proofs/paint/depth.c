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
 * checks = 79
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

/* --- the ends of a run of cells of 32 bits --------------------------------------------------------------------- */

/* Four at once, and one more: on the columns from 0 on. */
#define RUN 5

static uint32_t run[RUN], run_before[RUN];

/* Any run of so many columns, its codes, which do not come round, and the one behind it. */
static fxl_depth_line any_run(int32_t columns, uint32_t codes[RUN + 1])
{
    const fxl_depth_line line = {nondet_u32(), nondet_u32()};
    ASSUME(columns >= 1 && columns <= RUN);
    codes[0] = line.code;
    for (int32_t i = 0; i < RUN; i++) {
        codes[i + 1] = codes[i] + line.step;
        ASSUME(i + 1 >= columns || (line.step >> 31 == 0 ? codes[i + 1] >= codes[i] : codes[i + 1] < codes[i]));
        run_before[i] = run[i];
    }
    return line;
}

/* [[row]]
 * id = "fxl_depth_visible_end, its result"
 * function = "lib/paint/depth_cells.h:fxl_depth_visible_end"
 * property = "runs of up to 5 cells of 32 bits, by either rule: the first hidden column, or the end; what is before it is kept where it keeps, no other cell changes, and the line goes along"
 * checks = 318
 * unwind = 7
 * unreached = { fxl_depth_keep_visible = "of cells of 16 bits" }
 */
void prove_visible_end(void)
{
    const int32_t x0 = 0, x1 = nondet_s32();
    const fxl_depth_rule rule = {true, nondet_bool()};
    const bool keeps_codes = nondet_bool();
    uint32_t codes[RUN + 1];
    fxl_depth_line line = any_run(x1, codes);
    const int32_t end = fxl_depth_visible_end(run, x0, x1, &line, keeps_codes, rule);
    ASSERT("a column, or the end", end >= x0 && end <= x1);
    for (int32_t i = 0; i < RUN; i++) {
        const bool visible = fxl_depth_passes(run_before, i, codes[i], rule);
        ASSERT("visible ones before it", i >= end || visible);
        ASSERT("a hidden one", i != end || end == x1 || !visible);
        ASSERT("kept, or as it was", run[i] == (i < end && keeps_codes ? codes[i] : run_before[i]));
    }
    ASSERT("the line goes along", line.code == codes[end]);
    PROOF_ENDS();
}

/* [[row]]
 * id = "fxl_depth_hidden_end, its result"
 * function = "lib/paint/depth_cells.h:fxl_depth_hidden_end"
 * property = "runs of up to 5 cells of 32 bits, by either rule: the first visible column, or the end, and the line goes along"
 * checks = 280
 * unwind = 7
 * unreached = { fxl_depth_codes_have_next = "of cells of 16 bits", fxl_depth_skip_hidden = "the same", fxl_depth_go_on = "the same" }
 */
void prove_hidden_end(void)
{
    const int32_t x0 = 0, x1 = nondet_s32();
    const fxl_depth_rule rule = {true, nondet_bool()};
    uint32_t codes[RUN + 1];
    fxl_depth_line line = any_run(x1, codes);
    const int32_t end = fxl_depth_hidden_end(run, x0, x1, &line, rule);
    ASSERT("beyond a hidden one", fxl_depth_passes(run, x0, codes[x0], rule) || (end > x0 && end <= x1));
    for (int32_t i = 0; i < RUN; i++) {
        const bool visible = fxl_depth_passes(run, i, codes[i], rule);
        ASSERT("hidden ones before it", i >= end || !visible);
        ASSERT("a visible one", i != end || end == x1 || visible);
    }
    ASSERT("the line goes along", line.code == codes[end]);
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
 * checks = 24
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
 * checks = 139
 */
void prove_depth_octave_of(void)
{
    const fxl_depth_scale scale = any_scale();
    fxl_depth_plane plane;
    fxl_depth_octave octave;
    ASSUME(WITHIN(plane.one, 1 << 20));
    fxl_depth_octave_of(scale, &plane, nondet_s64(), &octave);
    ASSERT("its shift", octave.drop >= -31 && octave.drop <= 35);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_octave_of_word"
 * property = "every shift is in its range, and the octave holds the word"
 * checks = 70
 */
void prove_depth_octave_of_word(void)
{
    const fxl_depth_scale scale = any_scale();
    fxl_depth_plane plane;
    fxl_depth_octave octave;
    ASSUME(plane.one < FXL_DEPTH_IS_BENT + scale.octaves);
    const uint32_t value = nondet_u32();
    fxl_depth_octave_of_word(scale, &plane, value, &octave);
    ASSERT("its shift", octave.drop >= -31 && octave.drop <= 35);
    ASSERT("the word's own", fxl_depth_octave_holds(&octave, value));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_shifted"
 * property = "the lowest 32 bits of the floor, exactly"
 * checks = 18
 */
void prove_depth_shifted(void)
{
    const int64_t value = nondet_s64();
    const int32_t drop = nondet_s32();
    ASSUME(drop > -32 && drop < 64);
    const uint32_t shifted = fxl_depth_shifted(value, drop);
    ASSERT("the lowest bits of the floor", shifted == (drop >= 0 ? fxl_low_32(fxl_bits_64(value >> drop)) : fxl_low_32(fxl_bits_64(value)) << -drop));
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
    ASSUME(of.kind < 8);
    return of;
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:colour_of"
 * property = "no texel is read that is not of the level, and without light it is that of the column and row of u and v, for any words; levels of up to 8 texels"
 * checks = 141
 */
void prove_colour_of_words(void)
{
    const fxl_texel_outline of = any_texels();
    fxl_texel_words at;
    const uint32_t columns = of.columns_mask + 1u, rows = of.rows_mask / columns + 1u;
    const uint32_t place = (at.v >> 16) / columns % rows * columns + (at.u >> 24) % columns;
    const bool is_wide = (of.kind & FXL_TEXELS_WIDE) != 0;
    const uint32_t texel = is_wide ? texels[place] : palette[of.texels[place]];
    ASSERT("of the column and row", colour_of(&of, &at, false, is_wide) == texel);
    ASSERT("lit", colour_of(&of, &at, true, is_wide) <= 0xFFFFu);
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
    const uint32_t word = at.code + of.planes.along.code * i;
    const bool is_near = nondet_bool();
    uint32_t code = word;
    const fxl_outline_row row = {0, 0, count, cells, (uint8_t *)pixels};
    if (is_near) {
        paint_near(&of, at, &row, nondet_bool(), (of.kind & FXL_TEXELS_WIDE) != 0);
    } else {
        code = word < of.border ? 2u * word - of.border : word;
        paint_any(&of, at, &row);
    }
    const bool is_visible = i < count && (code >> 16 > before[i] || (!is_near && of.or_equal && code >> 16 == before[i]));
    ASSERT("a visible one is kept", cells[i] == (is_visible ? code >> 16 : before[i]));
    ASSERT("the others' pixels stay", is_visible || pixels[i] == beneath[i]);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:words_of"
 * property = "any words, up to 3 rows and 3 columns: those of as many steps, modulo 2^32"
 * checks = 98
 * unwind = 5
 */
void prove_words_of(void)
{
    fxl_texel_planes of;
    fxl_outline_row row;
    ASSUME(row.x <= 3 && row.y <= 3);
    const fxl_texel_words there = words_of(&of, &row);
    fxl_texel_words at = of.at;
    for (uint32_t i = 0; i < row.y; i++) {
        step(&at, &of.down);
    }
    for (uint32_t i = 0; i < row.x; i++) {
        step(&at, &of.along);
    }
    ASSERT("as by steps", there.code == at.code && there.u == at.u && there.v == at.v && there.light == at.light);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_texel_words_of"
 * property = "gradients in words: each word is the gradient's, and light is 0 where it is none of them"
 * checks = 254
 */
/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_texel_planes_scale"
 * property = "any words, shifts of up to 16 bits: rounded down, and no other word changes"
 * checks = 254
 */
void prove_texel_words(void)
{
    fxl_gradients gradients;
    fxl_depth_plane depth;
    fxl_texel_planes of;
    const uint32_t u_drop = nondet_u32(), v_drop = nondet_u32();
    ASSUME(u_drop <= 8 && v_drop <= 16 && (gradients.count == 2 || gradients.count == 3));
    const int32_t u = fxl_signed_32(fxl_low_32(fxl_bits_64(gradients.attributes[FXL_ATTRIBUTE_U].along)));
    const int32_t v = fxl_signed_32(fxl_low_32(fxl_bits_64(gradients.attributes[FXL_ATTRIBUTE_V].down)));
    fxl_texel_words_of(&gradients, &depth, &of);
    ASSERT("u and v", of.along.u == fxl_bits_32(u) && of.down.v == fxl_bits_32(v));
    ASSERT("light, or none", of.along.light == (gradients.count == 3 ? fxl_low_32(fxl_bits_64(gradients.attributes[FXL_SEGMENT_LIGHT].along)) : 0));
    ASSERT("depth", of.at.code == fxl_low_32(fxl_bits_64(depth.gradient.at)) && of.down.code == fxl_low_32(fxl_bits_64(depth.gradient.down)));
    fxl_texel_planes_scale(&of, u_drop, v_drop);
    ASSERT("u, by its level", of.along.u == fxl_bits_32(u >> u_drop));
    ASSERT("v, by its level and columns", of.down.v == fxl_bits_32(v >> v_drop));
    ASSERT("depth stays", of.at.code == fxl_low_32(fxl_bits_64(depth.gradient.at)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:fxl_texel_outline_of_surface"
 * property = "any paint of a level with sides of up to 256 texels: its masks, and whether pixels are lit and of 16 bits"
 * checks = 160
 */
void prove_texel_outline_of_surface(void)
{
    struct {
        fxl_depth_head head;
        uint16_t cells[4];
    } memory;
    fxl_paint paint;
    fxl_texel_outline of;
    const uint32_t rows = nondet_u32();
    ASSUME(rows <= 8 && paint.level.log_width <= 8 && paint.level.rows_less_1 == (1u << rows) - 1u);
    fxl_texel_outline_of_surface(&memory.head, &paint, &of);
    ASSERT("the cells", of.cells == memory.cells);
    ASSERT("rows", of.rows_mask == ((1u << rows) - 1u) << paint.level.log_width);
    ASSERT("lit", ((of.kind & FXL_TEXELS_LIT) != 0) == (paint.of_565.part_of_level != 0));
    ASSERT("wide", ((of.kind & FXL_TEXELS_WIDE) != 0) == ((paint.level.flags & FXL_LEVEL_565) != 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/texel_outline.c:fxl_texel_outline_of_face"
 * property = "any triangle, whatever the one before was: what pixels there are, and even light"
 * checks = 90
 */
void prove_texel_outline_of_face(void)
{
    struct {
        fxl_depth_head head;
        uint16_t cells[4];
    } memory;
    fxl_paint paint;
    fxl_texel_outline of;
    const int32_t one = nondet_s32();
    const uint32_t kind = of.kind & FXL_TEXELS_WIDE;
    ASSUME(paint.levels_less_1 < 64 && of.kind < 16);
    ASSUME(((of.kind & FXL_TEXELS_LIT) != 0) == (of.part_of_level != 0));
    ASSUME(memory.head.scale.octaves >= 1 && memory.head.scale.octaves <= 24 && memory.head.scale.mantissa >= 11 && memory.head.scale.mantissa <= 15);
    ASSUME(one == FXL_DEPTH_IS_LINEAR || (one >= FXL_DEPTH_IS_BENT && one < FXL_DEPTH_IS_BENT + memory.head.scale.octaves));
    fxl_texel_outline_of_face(&memory.head, &paint, one, &of);
    ASSERT("lit", ((of.kind & FXL_TEXELS_LIT) != 0) == (of.part_of_level != 0));
    ASSERT("wide", (of.kind & FXL_TEXELS_WIDE) == kind);
    ASSERT("bent", ((of.kind & FXL_TEXELS_BENT) != 0) == (one != FXL_DEPTH_IS_LINEAR));
    ASSERT("even light", !paint.is_evenly_lit || of.planes.along.light == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_smooth_outline_set"
 * property = "any plane and light in words, any paint, pixels of 8 or 16 bits: the steps are the planes', and there is a limit exactly where codes have no border"
 * checks = 254
 */
void prove_smooth_outline_set(void)
{
    struct {
        fxl_depth_head head;
        uint16_t cells[4];
    } memory;
    static uint8_t pixels[8], ramp[256];
    static uint16_t colours[256];
    fxl_gradients gradients;
    fxl_depth_plane plane;
    fxl_paint paint;
    fxl_band band;
    fxl_smooth_outline smooth;
    band.pixels = pixels;
    gradients.shifts[0] = 53; /* light in words */
    paint.gradients = &gradients;
    paint.ramp = ramp;
    paint.of_565.palette = colours;
    ASSUME(paint.levels_less_1 < 64 && band.width <= 2048 && band.first_row < 2048);
    ASSUME(memory.head.scale.octaves >= 1 && memory.head.scale.octaves <= 24 && memory.head.scale.mantissa >= 11 && memory.head.scale.mantissa <= 15);
    ASSUME(plane.one == FXL_DEPTH_IS_LINEAR || (plane.one >= FXL_DEPTH_IS_BENT && plane.one < FXL_DEPTH_IS_BENT + memory.head.scale.octaves));
    fxl_smooth_outline_set(&memory.head, &plane, &paint, &band, nondet_bool() ? 1 : 2, &smooth);
    ASSERT("the cells", smooth.cells == memory.cells);
    ASSERT("steps", smooth.words.code_along == fxl_low_32(fxl_bits_64(plane.gradient.along)));
    ASSERT("a limit", (smooth.limit == 0) == (smooth.border != 0));
    PROOF_ENDS();
}
