/* SPDX-License-Identifier: MIT */
#include "paint/depth_row.h"
#include "paint/depth_outline.h"
#include "paint/depth_rows.h"
#include "proof.h"

#ifndef CASE
#define CASE 16 /* bits a cell */
#endif

#define CELLS 4
#define ROWS  2

static struct {
    fxl_depth_head head;
    uint32_t cells[ROWS * CELLS];
} memory;
static fxl_depth_plane plane;
static fxl_band band;
static fxl_depth_painting painting;

static void any_painting(void)
{
    ANY_CONTENT(&memory);
    ANY_CONTENT(&plane);
    ANY_CONTENT(&band);
    ANY_CONTENT(&painting);
    ASSUME(memory.head.scale.octaves >= 1 && memory.head.scale.octaves <= 24 && memory.head.scale.mantissa >= 11 && memory.head.scale.mantissa <= 15);
    ASSUME(band.width == CELLS && band.stride == CELLS && band.rows >= 1 && band.rows <= ROWS && band.first_row + band.rows <= FXL_SCREEN_MAX);
    ASSUME(WITHIN(plane.gradient.along, (int64_t)1 << 52));
    painting.plane = &plane;
    painting.head = &memory.head;
    painting.band = &band;
}

/* --- a run ------------------------------------------------------------------------------------------------- */

static void any_columns(int32_t *x0, int32_t *x1)
{
    *x0 = nondet_s32();
    *x1 = nondet_s32();
    ASSUME(*x0 >= 0 && *x0 < *x1 && *x1 <= CELLS);
}

static fxl_depth_rule any_rule(void)
{
    const fxl_depth_rule rule = {CASE == 32, nondet_bool()};
    return rule;
}

/* For the kernels: so many of the run's cells. */
uint32_t fxl_depth_keep_visible(uint16_t *cells, uint32_t count, uint32_t code, uint32_t step)
{
    const uint32_t kept = nondet_u32();
    (void)code, (void)step;
    ASSERT("cells of the row", count >= 1 && __CPROVER_w_ok(cells, count * sizeof *cells));
    ASSUME(kept <= count);
    return kept;
}

uint32_t fxl_depth_skip_hidden(const uint16_t *cells, uint32_t count, uint32_t code, uint32_t step)
{
    const uint32_t hidden = nondet_u32();
    (void)code, (void)step;
    ASSERT("cells of the row", count >= 1 && __CPROVER_r_ok(cells, count * sizeof *cells));
    ASSUME(hidden <= count);
    return hidden;
}

/* [[row]]
 * function = "lib/paint/depth_cells.h:fxl_depth_visible_end"
 * property = "runs of up to 4 cells of 16 or 32 bits, by either rule: nothing is out of bounds, and it ends at a hidden one"
 * checks = 362
 * unwind = 6
 * cases = [16, 32]
 * stubs = { fxl_depth_keep_visible = "any number of the run's", fxl_depth_skip_hidden = "any number of the run's" }
 */
void prove_depth_visible_end(void)
{
    int32_t x0, x1;
    const fxl_depth_rule rule = any_rule();
    const bool keeps = nondet_bool();
    any_painting();
    any_columns(&x0, &x1);
    fxl_depth_line line = {nondet_u32(), nondet_u32()};
    const int32_t end = fxl_depth_visible_end(memory.cells, x0, x1, &line, keeps, rule);
    ASSERT("a column, or the end", end >= x0 && end <= x1);
    ASSERT("a hidden one", end == x1 || (keeps && !rule.wide && !rule.or_equal) || !fxl_depth_passes(memory.cells, end, line.code, rule));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_cells.h:fxl_depth_hidden_end"
 * property = "runs of up to 4 cells of 16 or 32 bits, by either rule: nothing is out of bounds, and it ends at a visible one"
 * checks = 302
 * unwind = 6
 * cases = [16, 32]
 * stubs = { fxl_depth_keep_visible = "any number of the run's", fxl_depth_skip_hidden = "any number of the run's" }
 */
void prove_depth_hidden_end(void)
{
    int32_t x0, x1;
    const fxl_depth_rule rule = any_rule();
    any_painting();
    any_columns(&x0, &x1);
    fxl_depth_line line = {nondet_u32(), nondet_u32()};
    const bool by_kernel = !rule.wide && (!rule.or_equal || fxl_depth_codes_have_next(&line, (uint32_t)(x1 - x0)));
    const int32_t end = fxl_depth_hidden_end(memory.cells, x0, x1, &line, rule);
    ASSERT("a column, or the end", end >= x0 && end <= x1);
    ASSERT("a visible one", end == x1 || by_kernel || fxl_depth_passes(memory.cells, end, line.code, rule));
    PROOF_ENDS();
}

/* Whether a pixel is visible, by the definition: of 16 bits a cell the code's upper half counts. */
static bool is_visible(const void *cells, int32_t x, uint32_t code, fxl_depth_rule rule)
{
    const uint64_t cell = CASE == 32 ? ((const uint32_t *)cells)[x] : (uint64_t)((const uint16_t *)cells)[x] << 16;
    const uint64_t nearness = CASE == 32 ? code : code - code % 65536u;
    return nearness > cell || (rule.or_equal && nearness == cell);
}

/* [[row]]
 * id = "depth test"
 * function = "lib/paint/depth_cells.h:fxl_depth_passes"
 * property = "a pixel is visible where its code is above its cell, or as far and equal ones are; of cells of 16 bits without the lower half"
 * checks = 108
 * cases = [16, 32]
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_passes(void)
{
    const int32_t x = nondet_s32();
    const uint32_t code = nondet_u32();
    const fxl_depth_rule rule = any_rule();
    any_painting();
    ASSUME(x >= 0 && x < CELLS);
    ASSERT("whether it is visible", fxl_depth_passes(memory.cells, x, code, rule) == is_visible(memory.cells, x, code, rule));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_cells.h:fxl_depth_keep"
 * property = "any cell: no other changes, and the pixel passes again only where equal ones do"
 * checks = 148
 * cases = [16, 32]
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_keep(void)
{
    const int32_t x = nondet_s32(), beside = nondet_s32();
    const bool wide = CASE == 32;
    const uint32_t code = nondet_u32();
    any_painting();
    ASSUME(x >= 0 && x < CELLS && beside >= 0 && beside < CELLS && beside != x);
    const uint32_t kept = wide ? memory.cells[beside] : ((uint16_t *)memory.cells)[beside];
    fxl_depth_keep(memory.cells, x, code, wide);
    ASSERT("no other cell", kept == (wide ? memory.cells[beside] : ((uint16_t *)memory.cells)[beside]));
    /* a pixel never hides itself: it passes again only where equal ones do */
    ASSERT("the pixel's own", !fxl_depth_passes(memory.cells, x, code, (fxl_depth_rule){wide, false}) &&
                                  fxl_depth_passes(memory.cells, x, code, (fxl_depth_rule){wide, true}));
    PROOF_ENDS();
}

/* For fxl_depth_visible_end and fxl_depth_hidden_end: a column, or the end. Where the one ends, the other goes on. */
int32_t any_visible_end(void *cells, int32_t x, int32_t end, fxl_depth_line *line, bool keeps, fxl_depth_rule rule)
{
    const int32_t found = nondet_s32();
    (void)line, (void)rule, (void)keeps;
    ASSERT("columns of the row", cells != NULL && x >= 0 && x < end && end <= CELLS);
    ASSUME(found >= x && found <= end);
    return found;
}

int32_t any_hidden_end(const void *cells, int32_t x, int32_t end, fxl_depth_line *line, fxl_depth_rule rule)
{
    const int32_t found = nondet_s32();
    (void)line, (void)rule;
    ASSERT("columns of the row", cells != NULL && x >= 0 && x < end && end <= CELLS);
    ASSUME(found > x && found <= end); /* the pixel at x is hidden */
    return found;
}

static int32_t painted_to, painted_end;
static void any_paint(const void *with, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    (void)with, (void)cells, (void)line;
    ASSERT("left to right, none twice", x0 >= painted_to && x0 < x1 && x1 <= painted_end);
    painted_to = x1;
}

/* [[row]]
 * function = "fxl_depth_paint_line"
 * property = "rows of up to 4 cells: it ends, and what is painted goes left to right, no pixel twice"
 * checks = 54
 * unwind = 6
 * stands_in = { fxl_depth_visible_end = "any_visible_end", fxl_depth_hidden_end = "any_hidden_end" }
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_paint_line(void)
{
    int32_t x0, x1;
    any_painting();
    any_columns(&x0, &x1);
    painted_to = x0;
    painted_end = x1;
    const fxl_depth_line line = {nondet_u32(), nondet_u32()};
    fxl_depth_paint_line(&painting, memory.cells, x0, x1, line, any_rule(), any_paint, NULL);
    PROOF_ENDS();
}

/* --- the octaves of a row ------------------------------------------------------------------------------------ */

/* For fxl_depth_octave_of and fxl_depth_octave_of_word: what their rows assume and assert. */
void any_octave_of(fxl_depth_scale scale, const fxl_depth_plane *of, int64_t value, fxl_depth_octave *octave)
{
    fxl_depth_octave any;
    (void)value;
    ASSERT("of the plane", of == &plane && scale.octaves >= 1 && scale.octaves <= 24);
    ASSUME(any.drop >= -31 && any.drop <= 35);
    *octave = any;
}

void any_octave_of_word(fxl_depth_scale scale, const fxl_depth_plane *of, uint32_t value, fxl_depth_octave *octave)
{
    any_octave_of(scale, of, value, octave);
}

/* For fxl_depth_octave_holds: any answer. */
bool any_holds(const fxl_depth_octave *octave, int64_t value)
{
    (void)value;
    ASSERT("of the painting", octave == &painting.octave);
    return nondet_bool();
}

/* [[row]]
 * function = "lib/paint/depth_code.h:fxl_depth_octave_holds"
 * property = "any octave and value: low <= value < high"
 * checks = 13
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_octave_holds(void)
{
    const fxl_depth_octave octave = {nondet_s64(), nondet_s64(), 0, 0, 0, false};
    const int64_t value = nondet_s64();
    ASSERT("from low to below high", fxl_depth_octave_holds(&octave, value) == (value >= octave.low && value < octave.high));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_depth_words_end"
 * property = "any 16 columns of the screen: it ends, after one column or more"
 * checks = 49
 * unwind = 6
 * stands_in = { fxl_depth_octave_of_word = "any_octave_of_word", fxl_depth_octave_holds = "any_holds" }
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_words_end(void)
{
    const int32_t x0 = nondet_s32(), x1 = nondet_s32();
    any_painting();
    ASSUME(x0 >= 0 && x0 < x1 && x1 <= FXL_SCREEN_MAX && x1 - x0 <= 16);
    const int32_t end = fxl_depth_words_end(&painting, nondet_u32(), x0, x1);
    ASSERT("a column or more", end > x0 && end <= x1);
    ASSERT("its shift", painting.octave.drop >= -31 && painting.octave.drop <= 35);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_depth_octave_end"
 * property = "any 8 columns of the screen, and a plane that changes by up to 2^52 a pixel: nothing overflows, and it ends, after one column or more"
 * checks = 52
 * unwind = 5
 * stands_in = { fxl_depth_octave_of = "any_octave_of", fxl_depth_octave_holds = "any_holds" }
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_octave_end(void)
{
    const int32_t x0 = nondet_s32(), x1 = nondet_s32();
    const int64_t depth = nondet_s64();
    any_painting();
    ASSUME(x0 >= 0 && x0 < x1 && x1 <= FXL_SCREEN_MAX && x1 - x0 <= 8 && WITHIN(depth, ((int64_t)1 << 62) - 1));
    ASSUME(painting.octave.drop >= -31 && painting.octave.drop <= 35);
    const int32_t end = fxl_depth_octave_end(&painting, depth, x0, x1);
    ASSERT("a column or more", end > x0 && end <= x1);
    ASSERT("its shift", painting.octave.drop >= -31 && painting.octave.drop <= 35);
    PROOF_ENDS();
}

/* For fxl_depth_words_end, fxl_depth_octave_end and fxl_depth_paint_line. */
int32_t any_words_end(fxl_depth_painting *of, uint32_t depth, int32_t x0, int32_t x1)
{
    const int32_t end = nondet_s32();
    (void)depth;
    ASSERT("columns of the row", of == &painting && x0 >= 0 && x0 < x1 && x1 <= CELLS);
    of->octave.drop = nondet_s32();
    ASSUME(of->octave.drop >= -31 && of->octave.drop <= 35 && end > x0 && end <= x1);
    return end;
}

int32_t any_octave_end(fxl_depth_painting *of, int64_t depth, int32_t x0, int32_t x1)
{
    ASSERT("a shift", of->octave.drop >= -31 && of->octave.drop <= 35);
    return any_words_end(of, fxl_low_32(fxl_bits_64(depth)), x0, x1);
}

void any_line(const fxl_depth_painting *of, void *cells, int32_t x0, int32_t x1, fxl_depth_line line, fxl_depth_rule rule,
              fxl_run_painter *paint, const void *with)
{
    const uint8_t *first = (const uint8_t *)cells;
    const size_t size = rule.wide ? 4 : 2;
    (void)line, (void)with;
    ASSERT("cells of the band", of == &painting && paint == any_paint && x0 >= painted_to && x0 < x1 && x1 <= painted_end &&
                                    first >= (const uint8_t *)memory.cells &&
                                    first + CELLS * size <= (const uint8_t *)memory.cells + band.rows * CELLS * size);
    painted_to = x1;
}

/* [[row]]
 * function = "fxl_depth_paint_row"
 * property = "rows of up to 4 cells of 16 and 32 bits, any plane that changes by up to 2^52 a pixel: nothing overflows, and each column is tested once, in cells of the band"
 * checks = 434
 * cases = [16, 32]
 * unwind = 6
 * stands_in = { fxl_depth_words_end = "any_words_end", fxl_depth_octave_end = "any_octave_end", fxl_depth_paint_line = "any_line" }
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_paint_row(void)
{
    int32_t x0, x1;
    const int32_t y = nondet_s32();
    any_painting();
    any_columns(&x0, &x1);
    ASSUME(y >= band.first_row && y < band.first_row + band.rows);
    ASSUME(WITHIN(plane.gradient.at, ((int64_t)1 << 62) - 1) && WITHIN(plane.gradient.down, (int64_t)1 << 52));
    ASSUME(painting.octave.drop >= -31 && painting.octave.drop <= 35); /* as fxl_depth_begin leaves it */
    painted_to = x0;
    painted_end = x1;
    fxl_depth_paint_row(&painting, y, x0, x1, CASE == 16 ? 16 : 32, any_paint, NULL);
    ASSERT("all of the row", painted_to == x1);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_depth_begin"
 * property = "any plane and band: no depth is of its octave"
 * checks = 58
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_begin(void)
{
    fxl_depth_painting of;
    any_painting();
    fxl_depth_begin(&of, &memory, &plane, &band);
    ASSERT("a shift", of.octave.drop >= -31 && of.octave.drop <= 35);
    ASSERT("no octave yet", !fxl_depth_octave_holds(&of.octave, nondet_s64()));
    ASSERT("all are kept", of.head == &memory.head && of.plane == &plane && of.band == &band && of.keeps == FXL_DEPTH_KEEPS_ALL);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_rows.h:fxl_depth_rows_go"
 * property = "any plane and row: nothing overflows, and the cells are those of the row"
 * checks = 214
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_rows(void)
{
    fxl_depth_rows rows;
    any_painting();
    const int32_t y = nondet_s32();
    ASSUME(y >= band.first_row && y < band.first_row + band.rows);
    ASSUME(WITHIN(plane.gradient.at, ((int64_t)1 << 62) - 1) && WITHIN(plane.gradient.down, (int64_t)1 << 52));
    ASSERT("none that is linear or bent", !fxl_depth_rows_take(&painting) || !fxl_depth_is_in_words(&plane));
    fxl_depth_rows_begin(&painting, &rows);
    fxl_depth_rows_go(&painting, y, &rows);
    ASSERT("cells of the row", (uint8_t *)rows.cells == (uint8_t *)memory.cells + (size_t)(y - band.first_row) * CELLS * 2);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_outline.h:fxl_depth_outline_begin"
 * property = "any plane and band: what is taken is front to back, has all columns, and the cells of the band"
 * checks = 124
 * stubs = { fxl_depth_keep_visible = "not called", fxl_depth_skip_hidden = "not called" }
 */
void prove_depth_outline_begin(void)
{
    fxl_depth_outline outline;
    static uint8_t pixels[ROWS * CELLS * 2];
    const uint32_t pixel_bytes = nondet_bool() ? 1 : 2;
    any_painting();
    band.pixels = pixels;
    outline.plane = plane;
    const bool begun = fxl_depth_outline_can_draw(&memory.head, &band, pixel_bytes) && fxl_depth_outline_begin(&memory, &band, pixel_bytes, &outline);
    ASSERT("front to back, all columns", !begun || (!memory.head.or_equal && band.columns == 0 && !fxl_depth_is_in_words(&plane)));
    ASSERT("its cells", !begun || (uint8_t *)outline.cells == (uint8_t *)memory.cells);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_outline.h:fxl_tiny_codes_find"
 * property = "a box of the screen: nothing overflows, and what is found is shifted by 1 to 31 bits"
 * checks = 302
 * contract = true
 */
void prove_tiny_codes_find(void)
{
    fxl_tiny tiny;
    fxl_tiny_codes codes;
    fxl_depth_scale scale;
    ANY_CONTENT(&plane);
    (void)fxl_tiny_codes_find(&plane, &tiny, scale, &codes);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/depth_outline.h:fxl_depth_tiny_draw"
 * property = "two pixels beside or above each other, of 8 or 16 bits: nothing overflows, and no cell or pixel beside the band is written"
 * checks = 2034
 * unwind = 3
 * cases = [1108, 1208, 2108, 1116, 1216, 2116]
 * uses = ["fxl_tiny_codes_find"]
 */
/* A case: the columns, the rows, the bits of a pixel. */
void prove_depth_tiny_draw(void)
{
    fxl_tiny tiny;
    uint16_t pixels[ROWS * CELLS];
    any_painting();
    ASSUME(WITHIN(plane.gradient.at, (int64_t)1 << 59) && WITHIN(plane.gradient.along, (int64_t)1 << 49) && WITHIN(plane.gradient.down, (int64_t)1 << 49));
    ASSUME(WITHIN(plane.one, 199));
    tiny.columns = CASE / 1000;
    tiny.rows = CASE / 100 % 10;
    ASSUME(tiny.row >= 0 && tiny.row <= ROWS - tiny.rows && tiny.column >= 0 && tiny.column <= CELLS - tiny.columns);
    ASSUME(tiny.pixels << (tiny.rows * tiny.columns) == 0);
    ASSUME(band.first_row == 0 && band.rows == ROWS);
    band.pixels = (uint8_t *)pixels;
    (void)fxl_depth_tiny_draw(&plane, &tiny, &memory.head, &band, 0xC3u, CASE % 100);
    PROOF_ENDS();
}
