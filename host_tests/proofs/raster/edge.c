/* SPDX-License-Identifier: MIT */
#include "raster/edge.h"
#include "products.h"

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_dividend"
 * property = "nothing overflows, and the dividend is at most 2^43"
 * checks = 13
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
 * checks = 192
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
 * checks = 328
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
 * checks = 35
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
 * checks = 25
 */
/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * id = "fxl_edge_divide by a divider of 32 bits"
 * property = "the same of the text for cores with a divider of 32 bits"
 * checks = 58
 * flags = ["-DFXL_CORE_HAS=3"]
 * links = ["lib/math/arith.c"]
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
 * checks = 9
 */
/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_first_dividend"
 * id = "fxl_edge_first_dividend in halves"
 * property = "the same of the text for cores without long products"
 * checks = 15
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
 * checks = 171
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
 * checks = 226
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

/* --- results, of products and quotients that may be any ------------------------------------------------- */


/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_dividend"
 * id = "fxl_edge_dividend, its result"
 * property = "the fraction of the start times the height, and dx times t, less 1, over 2^16, rounded down"
 * checks = 12
 * stands_in = { fxl_multiply_u32 = "any_unsigned", fxl_multiply_s32 = "any_signed" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 */
void prove_edge_dividend_result(void)
{
    const int32_t start = nondet_s32(), dx = nondet_s32(), height = nondet_s32(), t = nondet_s32();
    ASSUME(WITHIN(dx, 1 << 29) && height > 0 && height <= 1 << 29 && t >= 0 && t < height);
    const uint32_t part = fxl_bits_32(start) % 65536u;
    const int64_t across = any_signed(dx, t);
    const uint64_t least = any_unsigned(part, (uint32_t)height);
    ASSUME(WITHIN(across, (int64_t)1 << 58) && least < (uint64_t)1 << 45);
    const int64_t sum = (int64_t)least + across - 1, dividend = fxl_edge_dividend(start, dx, height, t);
    ASSERT("the floor", dividend * 65536 <= sum && sum - dividend * 65536 < 65536);
    PROOF_ENDS();
}

int64_t __CPROVER_uninterpreted_dividend(int32_t, int32_t, int32_t, int32_t);

/* For fxl_edge_dividend: what its rows and that of Z3 say. */
int64_t some_dividend(int32_t start, int32_t dx, int32_t height, int32_t t)
{
    const int64_t dividend = __CPROVER_uninterpreted_dividend(start, dx, height, t);
    ASSERT("its range", WITHIN(dx, 1 << 29) && height > 0 && height <= 1 << 29 && t >= 0 && t < height);
    ASSUME(WITHIN(dividend, (int64_t)height << 14));
    return dividend;
}

/* For fxl_divide_down: it is at most 2^14, as the dividend is at most 2^14 heights. */
int32_t some_quotient(int64_t numerator, uint32_t denominator)
{
    const int32_t quotient = any_down(numerator, denominator);
    ASSUME(WITHIN(quotient, 1 << 14));
    return quotient;
}

/* [[row]]
 * function = "fxl_edge_first_pixel"
 * id = "fxl_edge_first_pixel, its result"
 * property = "the start's whole pixels, the floor of the dividend over the height, and 1"
 * checks = 85
 * stands_in = { fxl_edge_dividend = "some_dividend", fxl_divide_down = "some_quotient" }
 */
/* [[row]]
 * function = "fxl_edge_first_pixel"
 * id = "fxl_edge_first_pixel, its remainder"
 * property = "the error is what the floor leaves of the dividend, for heights of 1, 3, 65,537 and 2^28 + 1 units"
 * checks = 340
 * cases = [1, 3, 65537, 268435457]
 * stands_in = { fxl_edge_dividend = "some_dividend", fxl_divide_down = "some_quotient" }
 */
void prove_edge_first_pixel_result(void)
{
    fxl_screen_point top, bottom;
    const int32_t y = nondet_s32();
    uint32_t error;
    ASSUME(FXL_ON_SCREEN(&top) && FXL_ON_SCREEN(&bottom) && y >= top.y && y < bottom.y);
    const int32_t height = bottom.y - top.y, start = top.x - 32768;
    const int64_t dividend = some_dividend(start, bottom.x - top.x, height, y - top.y);
    const int32_t quotient = some_quotient(dividend, (uint32_t)height);
#ifdef CASE
    bottom.y = top.y + CASE;
    ASSUME(FXL_ON_SCREEN(&bottom) && height == CASE);
    (void)fxl_edge_first_pixel(&top, &bottom, y, &error);
    ASSERT("the remainder", error == fxl_low_32(fxl_bits_64(dividend)) - fxl_bits_32(quotient) * (uint32_t)CASE);
#else
    const int32_t whole = fxl_edge_first_pixel(&top, &bottom, y, &error) - quotient - 1;
    ASSERT("the pixel", whole * (int64_t)65536 <= start && start - whole * (int64_t)65536 < 65536);
#endif
    PROOF_ENDS();
}

int32_t __CPROVER_uninterpreted_pixel(int32_t, int32_t, int32_t, int32_t, int32_t);
uint32_t __CPROVER_uninterpreted_error(int32_t, int32_t, int32_t, int32_t, int32_t);
int32_t __CPROVER_uninterpreted_floor(int32_t, int32_t);
int32_t __CPROVER_uninterpreted_remainder(int32_t, int32_t);

/* For fxl_edge_first_pixel and fxl_divide_floor. */
int32_t some_pixel(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t y, uint32_t *error)
{
    *error = __CPROVER_uninterpreted_error(top->x, top->y, bottom->x, bottom->y, y);
    return __CPROVER_uninterpreted_pixel(top->x, top->y, bottom->x, bottom->y, y);
}

int32_t some_floor(int32_t numerator, int32_t denominator, int32_t *remainder)
{
    ASSERT("a divisor", denominator > 0 && numerator > INT32_MIN);
    *remainder = __CPROVER_uninterpreted_remainder(numerator, denominator);
    ASSUME(*remainder >= 0 && *remainder < denominator);
    return __CPROVER_uninterpreted_floor(numerator, denominator);
}

/* [[row]]
 * function = "fxl_slope_set"
 * id = "fxl_slope_set, its result"
 * property = "the first pixel of the row with its error, the floor of dx over the height with its remainder, and the height"
 * checks = 141
 * stands_in = { fxl_edge_first_pixel = "some_pixel", fxl_divide_floor = "some_floor" }
 */
void prove_slope_set_result(void)
{
    fxl_screen_point top, bottom;
    fxl_slope slope;
    const int32_t y = nondet_s32();
    int32_t remainder;
    uint32_t error;
    ASSUME(FXL_ON_SCREEN(&top) && FXL_ON_SCREEN(&bottom) && y >= top.y && y < bottom.y);
    fxl_slope_set(&top, &bottom, y, &slope);
    ASSERT("the pixel", slope.x == some_pixel(&top, &bottom, y, &error) && slope.error == error);
    ASSERT("the step", slope.step == some_floor(bottom.x - top.x, bottom.y - top.y, &remainder) && slope.error_step == (uint32_t)remainder);
    ASSERT("the height", slope.height == (uint32_t)(bottom.y - top.y));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_edge_advance"
 * id = "fxl_edge_advance, its result"
 * property = "x and fraction, as one number of 64 bits, are larger by so many steps, for 1, 2, 3 and 1,023 rows"
 * checks = 184
 * cases = [1, 2, 3, 1023]
 * stands_in = { fxl_multiply_u32 = "any_unsigned" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 */
#ifdef CASE
void prove_edge_advance_result(void)
{
    fxl_edge edge;
    const uint32_t rows = CASE;
    ASSUME(WITHIN(edge.x, 1 << 20) && WITHIN(edge.step, 1026));
    const fxl_edge before = edge;
    const uint64_t steps = any_unsigned(edge.step_fraction, rows);
    ASSUME(steps < (uint64_t)1 << 42);
    fxl_edge_advance(&edge, rows);
    ASSERT("the number", edge.x * ((int64_t)1 << 32) + edge.fraction ==
                             (before.x + (int64_t)(before.step * (int32_t)rows)) * ((int64_t)1 << 32) + before.fraction + (int64_t)steps);
    ASSERT("the step stays", edge.step == before.step && edge.step_fraction == before.step_fraction);
    PROOF_ENDS();
}
#endif

int32_t __CPROVER_uninterpreted_whole(uint32_t, int32_t);
uint32_t __CPROVER_uninterpreted_fraction(uint32_t, int32_t);
unsigned __CPROVER_uninterpreted_shift(uint32_t);
int32_t __CPROVER_uninterpreted_first(int32_t, int32_t, int32_t, int32_t);

/* For fxl_edge_divide, fxl_edge_divider_shift and fxl_edge_first_dividend. */
void some_divide(const fxl_edge_divider *divider, int32_t dividend, int32_t *whole, uint32_t *fraction)
{
    *whole = __CPROVER_uninterpreted_whole(divider->height, dividend);
    *fraction = __CPROVER_uninterpreted_fraction(divider->height, dividend);
    ASSUME(WITHIN(*whole, 1026));
}

unsigned some_shift(const fxl_edge_divider *divider)
{
    const unsigned shift = __CPROVER_uninterpreted_shift(divider->height);
    ASSUME(shift <= 31);
    return shift;
}

int32_t some_first(int32_t start, int32_t dx, int32_t height, int32_t top_y)
{
    return __CPROVER_uninterpreted_first(start, dx, height, top_y);
}

/* [[row]]
 * function = "fxl_edge_set_near"
 * id = "fxl_edge_set_near, its result"
 * property = "on the first row the start's whole pixels, the quotient of the first dividend and 1; the step is the quotient of dx; refused, and untouched, where so many rows need more bits than the shift"
 * checks = 177
 * stands_in = { fxl_edge_divide = "some_divide", fxl_edge_divider_shift = "some_shift", fxl_edge_first_dividend = "some_first" }
 */
void prove_edge_set_near_result(void)
{
    fxl_screen_point top, bottom;
    fxl_edge edge;
    const uint32_t last = nondet_u32();
    ASSUME(is_edge(&top, &bottom) && bottom.y - top.y >= 65536);
    const fxl_edge before = edge;
    const int32_t height = bottom.y - top.y, dx = bottom.x - top.x, start = top.x - 32768;
    const fxl_edge_divider divider = {(uint32_t)height};
    int32_t first, step;
    uint32_t first_fraction, step_fraction;
    some_divide(&divider, some_first(start, dx, height, top.y), &first, &first_fraction);
    some_divide(&divider, dx, &step, &step_fraction);
    if (fxl_edge_set_near(&top, &bottom, last, &edge)) {
        const int32_t whole = edge.x - first - 1;
        ASSERT("so many rows", last >> some_shift(&divider) == 0);
        ASSERT("the pixel", whole * (int64_t)65536 <= start && start - whole * (int64_t)65536 < 65536 && edge.fraction == first_fraction);
        ASSERT("the step", edge.step == step && edge.step_fraction == step_fraction);
    } else {
        ASSERT("too many rows", last >> some_shift(&divider) != 0);
        ASSERT("untouched", edge.x == before.x && edge.fraction == before.fraction && edge.step == before.step &&
                                edge.step_fraction == before.step_fraction);
    }
    PROOF_ENDS();
}

/* For fxl_edge_dividend, on the first row. */
int64_t first_of(int32_t start, int32_t dx, int32_t height, int32_t t)
{
    const int64_t dividend = __CPROVER_uninterpreted_dividend(start, dx, height, t);
    ASSUME(WITHIN(dividend, FXL_EDGE_DIVIDEND_MAX));
    return dividend;
}

/* [[row]]
 * function = "lib/raster/edge_divide.h:fxl_edge_first_dividend"
 * id = "fxl_edge_first_dividend, its result"
 * property = "the dividend of the first centre at or below the top"
 * checks = 9
 * stands_in = { fxl_edge_dividend = "first_of" }
 */
void prove_edge_first_dividend_result(void)
{
    const int32_t start = nondet_s32(), dx = nondet_s32(), height = nondet_s32(), top_y = nondet_s32();
    ASSUME(WITHIN(dx, (FXL_SCREEN_MAX + 1) * 65536) && height > 0 && height <= FXL_EDGE_HEIGHT_MAX);
    ASSUME(WITHIN(top_y, FXL_SCREEN_COORDINATE_MAX));
    const int32_t below = fxl_centre_of(fxl_first_centre_from(top_y)) - top_y;
    ASSERT("that row", fxl_edge_first_dividend(start, dx, height, top_y) == first_of(start, dx, height, below));
    PROOF_ENDS();
}
