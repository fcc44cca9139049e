/* SPDX-License-Identifier: MIT */
#include "raster/edge.h"
#include "proof.h"

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_dividend"
 * property = "nothing overflows, and the dividend is at most 2^43"
 * checks = 11
 * contract = true
 * equations = true
 */
void prove_edge_dividend(void)
{
    (void)fxl_edge_dividend(nondet_s32(), nondet_s32(), nondet_s32(), nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_edge_first_pixel"
 * property = "nothing overflows, and the quotient fits"
 * checks = 186
 * contract = true
 * uses = ["fxl_edge_dividend", "fxl_divide_down"]
 */
void prove_edge_first_pixel(void)
{
    fxl_screen_point *top, *bottom;
    uint32_t *error;
    (void)fxl_edge_first_pixel(top, bottom, nondet_s32(), error);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_slope_set"
 * property = "nothing overflows; both remainders are below the height"
 * checks = 325
 * contract = true
 * uses = ["fxl_edge_first_pixel", "fxl_divide_floor"]
 */
void prove_slope_set(void)
{
    fxl_screen_point *top, *bottom;
    fxl_slope *slope;
    fxl_slope_set(top, bottom, nondet_s32(), slope);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_edge_advance"
 * property = "nothing overflows over the rows of a screen"
 * checks = 27
 */
void prove_edge_advance(void)
{
    fxl_edge edge;
    const uint32_t rows = nondet_u32();
    ASSUME(rows <= FXL_SCREEN_MAX && WITHIN(edge.x, 1 << 20) && WITHIN(edge.step, 1 << 20));
    fxl_edge_advance(&edge, rows);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * property = "nothing overflows"
 * checks = 24
 */
/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * id = "fxl_edge_divide by a divider of 32 bits"
 * property = "the same of the text for cores with a divider of 32 bits"
 * checks = 50
 * flags = ["-DFXL_CORE_HAS=3"]
 */
void prove_edge_divide(void)
{
    const uint32_t height = nondet_u32();
    const int32_t dividend = nondet_s32();
    ASSUME(height >= 1 && height <= FXL_EDGE_HEIGHT_MAX && WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    const fxl_edge_divider divider = fxl_edge_divider_of(height);
    int32_t whole;
    uint32_t fraction;
    fxl_edge_divide(&divider, dividend, &whole, &fraction);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_divider_shift"
 * property = "the largest shift, exactly; the loop ends"
 * checks = 11
 * unwind = 33
 */
void prove_edge_divider_shift(void)
{
    const uint32_t height = nondet_u32();
    ASSUME(height >= 1 && height <= FXL_EDGE_HEIGHT_MAX);
    const fxl_edge_divider divider = fxl_edge_divider_of(height);
    const unsigned shift = fxl_edge_divider_shift(&divider);
    ASSERT("the largest of them", shift <= 31 && (uint64_t)height << shift <= (uint64_t)1 << 32 &&
                                      (uint64_t)height << (shift + 1) >= (uint64_t)1 << 32);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_first_dividend"
 * property = "nothing overflows, and the dividend is in the range that the division takes"
 * checks = 5
 */
/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_first_dividend"
 * id = "fxl_edge_first_dividend in halves"
 * property = "the same of the text for cores without long products"
 * checks = 8
 * flags = ["-DFXL_CORE_HAS=0"]
 */
void prove_edge_first_dividend(void)
{
    const int32_t start = nondet_s32(), dx = nondet_s32(), height = nondet_s32(), top_y = nondet_s32();
    ASSUME(WITHIN(dx, (FXL_SCREEN_MAX + 1) * 65536) && height > 0 && height <= FXL_EDGE_HEIGHT_MAX);
    ASSUME(WITHIN(top_y, FXL_SCREEN_COORDINATE_MAX));
    const int32_t dividend = fxl_edge_first_dividend(start, dx, height, top_y);
    ASSERT("in the range of a dividend", WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    PROOF_ENDS();
}

/* --- an edge of a chain --------------------------------------------------------------------------------- */

static bool on_screen(const fxl_screen_point *point)
{
    return FXL_ON_SCREEN(point);
}

/* Two points of an outline that is scanned by chains. */
static bool is_edge(const fxl_screen_point *top, const fxl_screen_point *bottom)
{
    return on_screen(top) && on_screen(bottom) && bottom->y > top->y && bottom->y - top->y <= FXL_EDGE_HEIGHT_MAX &&
           WITHIN(bottom->x - top->x, (FXL_SCREEN_MAX + 1) * 65536);
}

/* For fxl_edge_divide: what rows of its own prove, that of Z3 also how large the whole part is. */
void any_divide(const fxl_edge_divider *divider, int32_t dividend, int32_t *whole, uint32_t *fraction)
{
    const int32_t any = nondet_s32(), size = dividend < 0 ? -dividend : dividend;
    ASSERT("a height", divider->height >= 1 && divider->height <= FXL_EDGE_HEIGHT_MAX);
    ASSERT("a dividend", WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    ASSUME(WITHIN(any, (divider->height >= 65536 ? size >> 16 : size) + 1));
    *whole = any;
    *fraction = nondet_u32();
}

/* For fxl_edge_divider_shift: what its own row asserts. */
unsigned any_shift(const fxl_edge_divider *divider)
{
    const unsigned shift = nondet_u32();
    ASSERT("a height", divider->height >= 1 && divider->height <= FXL_EDGE_HEIGHT_MAX);
    ASSUME(shift <= 31);
    return shift;
}

/* [[row]]
 * function = "fxl_edge_set_near"
 * property = "any edge of two rows or more: nothing overflows, each dividend is one that the division takes, and a row changes by at most 1,026 pixels"
 * checks = 170
 * stands_in = { fxl_edge_divide = "any_divide", fxl_edge_divider_shift = "any_shift", fxl_edge_first_dividend = "any_dividend" }
 */
void prove_edge_set_near(void)
{
    fxl_screen_point top, bottom;
    fxl_edge edge;
    ASSUME(is_edge(&top, &bottom) && bottom.y - top.y >= 65536);
    if (fxl_edge_set_near(&top, &bottom, nondet_u32(), &edge)) {
        ASSERT("near the screen", WITHIN(edge.x, 1 << 13) && WITHIN(edge.step, 1026));
    }
    PROOF_ENDS();
}

/* For fxl_edge_set_near, fxl_edge_set_far, fxl_divide_floor and fxl_edge_first_dividend. */
bool any_near(const fxl_screen_point *top, const fxl_screen_point *bottom, uint32_t last, fxl_edge *edge)
{
    ASSERT("an edge of two rows", is_edge(top, bottom) && bottom->y - top->y >= 65536 && last >= 1);
    if (nondet_bool()) {
        return false;
    }
    fxl_edge any;
    ASSUME(WITHIN(any.x, 1 << 13) && WITHIN(any.step, 1026));
    *edge = any;
    return true;
}

int32_t fxl_edge_set_far(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row, int32_t rows, fxl_edge *edge)
{
    const int32_t good = nondet_s32();
    (void)edge;
    ASSERT("an edge that crosses the row", is_edge(top, bottom) && WITHIN(row, FXL_SCREEN_MAX) && rows > 0 && fxl_centre_of(row) >= top->y &&
                                               fxl_centre_of(row) < bottom->y);
    ASSUME(good >= 1 && good <= rows);
    return good;
}

int32_t any_floor(int32_t numerator, int32_t denominator, int32_t *remainder)
{
    const int32_t quotient = nondet_s32();
    ASSERT("a divisor", denominator > 0 && numerator > INT32_MIN);
    ASSUME(numerator >= 0 ? quotient >= 0 && quotient <= numerator : quotient < 0 && quotient >= numerator);
    *remainder = nondet_s32();
    return quotient;
}

int32_t any_dividend(int32_t start, int32_t dx, int32_t height, int32_t top_y)
{
    const int32_t dividend = nondet_s32();
    (void)start;
    ASSERT("an edge", WITHIN(dx, (FXL_SCREEN_MAX + 1) * 65536) && height > 0 && height <= FXL_EDGE_HEIGHT_MAX);
    ASSERT("of the screen", WITHIN(top_y, FXL_SCREEN_COORDINATE_MAX));
    ASSUME(WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    return dividend;
}

/* [[row]]
 * function = "fxl_edge_set"
 * property = "any edge on any row that it crosses: nothing overflows, each set-up gets what it requires, and the edge holds for 1 to all of the rows"
 * checks = 216
 * stands_in = { fxl_edge_set_near = "any_near", fxl_divide_floor = "any_floor", fxl_edge_first_dividend = "any_dividend" }
 * stubs = { fxl_edge_set_far = "its contract" }
 */
void prove_edge_set(void)
{
    fxl_screen_point top, bottom;
    fxl_edge edge;
    const int32_t row = nondet_s32(), rows = nondet_s32();
    ASSUME(is_edge(&top, &bottom) && row >= 0 && row < FXL_SCREEN_MAX && rows > 0 && rows <= 4096);
    ASSUME(fxl_first_centre_from(top.y) <= row && fxl_first_centre_from(bottom.y) == row + rows);
    const int32_t good = fxl_edge_set(&top, &bottom, row, rows, &edge);
    ASSERT("for some of the rows", good >= 1 && good <= rows);
    PROOF_ENDS();
}
