/* SPDX-License-Identifier: MIT */
/* Results against their definitions, by integers of 128 bits: of functions of several inputs, on inputs that a generator of a
 * fixed seed draws, of all lengths, and on the ends of their ranges; of small faces, on every triangle of a grid. */
#include "math/arith.c"
#include "math/plane.h"
#include "raster/edge.h"
#include "raster/tiny.c"

#include "enumeration.h"
#include "formula.h"

/* [[row]]
 * id = "fxl_square_root, its result"
 * function = "lib/math/plane.h:fxl_square_root"
 * property = "the root r with r^2 - r < value <= r^2 + r: the nearest, of a million values, and of those at which a million roots change"
 * checks = 3000000
 */
void enumerate_square_root(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide root = (wide)up_to(UINT32_MAX - 1);
        const uint64_t values[3] = {up_to(UINT64_MAX - UINT32_MAX - 1), (uint64_t)(root * root + root), (uint64_t)(root * root + root + 1)};
        for (int j = 0; j < 3; j++) {
            const wide r = fxl_square_root(values[j]);
            TRY(values[j], r * r - r < values[j] + (r == 0) && values[j] <= r * r + r);
        }
    }
}

/* [[row]]
 * id = "fxl_divide_u64, its result"
 * function = "lib/math/arith.c:fxl_divide_u64"
 * property = "the floor and its remainder, of a million quotients"
 * checks = 1000000
 */
/* [[row]]
 * id = "divide_digit, its result"
 * function = "lib/math/arith.c:divide_digit"
 * property = "the same, as the digits of a quotient"
 * checks = 1000000
 */
void enumerate_divide_u64(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint32_t denominator = (uint32_t)up_to(UINT32_MAX - 1) + 1;
        const uint64_t numerator = up_to(((uint64_t)denominator << 32) - 1);
        uint32_t remainder;
        const wide quotient = fxl_divide_u64(numerator, denominator, &remainder);
        TRY(numerator, quotient * denominator + remainder == numerator && remainder < denominator);
    }
}

/* [[row]]
 * id = "fxl_fraction, its result"
 * function = "lib/math/arith.c:fxl_fraction"
 * property = "the floor of 2^64 part / whole, of a million parts"
 * checks = 1000000
 */
/* [[row]]
 * id = "fraction_digit, its result"
 * function = "lib/math/arith.c:fraction_digit"
 * property = "the same, as the digits of a fraction"
 * checks = 1000000
 */
void enumerate_fraction(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint64_t whole = up_to((uint64_t)INT64_MAX - 1) + 1, part = up_to(whole - 1);
        TRY(part, fxl_fraction(part, whole) == (uint64_t)(((wide_unsigned)part << 64) / whole));
    }
}

/* [[row]]
 * id = "fxl_ratio, its result"
 * function = "lib/math/arith.c:fxl_ratio"
 * property = "the floor of the product, shifted as far as the depth to have 31 bits, over the rounded depth, to the nearest; refused above the limit, and only there: of a million ratios"
 * checks = 1000000
 */
void enumerate_ratio(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const int32_t factor = (int32_t)up_to((1 << 29) - 2) + 1, limit = (int32_t)up_to((1 << 29) - 2) + 1;
        const int64_t depth = (int64_t)up_to(((uint64_t)1 << 61) - 2) + 1;
        /* of every other one the ratio is near the limit */
        const wide near_limit = (wide)depth * limit / factor + between(4);
        const int64_t most = ((int64_t)1 << 61) - 1, any = between(most);
        const int64_t side = i % 2 != 0 && near_limit <= most ? (int64_t)(any < 0 ? -near_limit : near_limit) : any;
        unsigned shift = 0;
        while (depth >> shift >> 31 != 0) {
            shift++;
        }
        const wide scaled = shift == 0 ? depth : (depth + ((int64_t)1 << (shift - 1))) >> shift;
        const wide product = ((wide)factor * side) >> shift;
        const bool fits = product >= -(limit * scaled) && product <= limit * scaled;
        int32_t quotient = -7;
        TRY(side, fxl_ratio(factor, side, depth, limit, &quotient) == fits && quotient == (fits ? floor_of(2 * product + scaled, 2 * scaled) : -7));
    }
}

/* [[row]]
 * id = "fxl_edge_divide, its result"
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * property = "whole and fraction are the floor of 2^32 dividends over the height, and 1, of a million dividends"
 * checks = 1000000
 */
/* [[row]]
 * id = "fxl_edge_divide without a divider, its result"
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * property = "the same of the text for cores without a divider"
 * checks = 1000000
 * flags = ["-DFXL_CORE_HAS=0"]
 */
/* [[row]]
 * id = "fxl_edge_divide by a divider of 32 bits, its result"
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * property = "the same of the text for cores with a divider of 32 bits"
 * checks = 1000000
 * flags = ["-DFXL_CORE_HAS=3"]
 */
void enumerate_edge_divide(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const uint32_t height = (uint32_t)up_to(FXL_EDGE_HEIGHT_MAX - 1) + 1;
        const int32_t dividend = (int32_t)between(FXL_EDGE_DIVIDEND_MAX);
        const fxl_edge_divider divider = fxl_edge_divider_of(height);
        int32_t whole;
        uint32_t fraction;
        fxl_edge_divide(&divider, dividend, &whole, &fraction);
        TRY(dividend, (wide)whole * ((wide)1 << 32) + fraction == floor_of((wide)dividend * ((wide)1 << 32), height) + 1);
    }
}

/* A coordinate of the screen: every other one is a whole number of halves of a pixel, so that edges go through centres. */
static int32_t place(void)
{
    const int32_t any = (int32_t)between(FXL_SCREEN_COORDINATE_MAX);
    return draw() >> 40 & 1 ? any : any / 32768 * 32768;
}

/* Any edge of the screen, and a row's centre that it crosses. */
static int32_t any_edge(fxl_screen_point *top, fxl_screen_point *bottom)
{
    do {
        top->x = place();
        top->y = place();
        bottom->x = place();
        bottom->y = place();
    } while (fxl_first_centre_from(top->y) >= fxl_first_centre_from(bottom->y));
    const int32_t first = fxl_first_centre_from(top->y), rows = fxl_first_centre_from(bottom->y) - first;
    return first + (int32_t)up_to((uint64_t)rows - 1);
}

/* How far the centre of column x is to the right of an edge on a row, times the edge's height. */
static wide right_of(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row, int32_t x)
{
    return ((wide)x * 65536 + 32768 - top->x) * (bottom->y - top->y) -
           (wide)(bottom->x - top->x) * ((wide)row * 65536 + 32768 - top->y);
}

/* [[row]]
 * id = "first pixel of an edge"
 * function = "lib/raster/edge.h:fxl_edge_first_pixel"
 * property = "its centre is not left of the edge, and that of the pixel before it is, of a million edges and rows"
 * checks = 1000000
 */
void enumerate_first_pixel(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        fxl_screen_point top, bottom;
        const int32_t row = any_edge(&top, &bottom);
        uint32_t error;
        const int32_t x = fxl_edge_first_pixel(&top, &bottom, fxl_centre_of(row), &error);
        TRY(i, right_of(&top, &bottom, row, x) >= 0 && right_of(&top, &bottom, row, x - 1) < 0);
    }
}

/* [[row]]
 * id = "fxl_edge_dividend beside its formula"
 * function = "lib/raster/edge_divide.h:fxl_edge_dividend"
 * property = "the formula's dividend, at most 2^14 heights, of a million edges and rows"
 * checks = 1000000
 * formula = "fxl_edge_dividend bound"
 */
void enumerate_dividend(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        fxl_screen_point top, bottom;
        const int32_t row = any_edge(&top, &bottom), start = top.x - FXL_HALF_PIXEL;
        const wide h = bottom.y - top.y, dx = bottom.x - top.x, t = fxl_centre_of(row) - top.y, part = floor_rest(start, 65536);
        TRY(i, fxl_edge_dividend(start, (int32_t)dx, (int32_t)h, (int32_t)t) == dividend_dividend && dividend_dividend >= -16384 * h && dividend_dividend <= 16384 * h);
    }
}

/* [[row]]
 * id = "fxl_edge_first_pixel beside its remainder's formula"
 * function = "lib/raster/edge.h:fxl_edge_first_pixel"
 * property = "the formula's remainder, of a million edges and rows"
 * checks = 1000000
 * formula = "fxl_edge_first_pixel remainder"
 */
void enumerate_error(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        fxl_screen_point top, bottom;
        const int32_t row = any_edge(&top, &bottom), start = top.x - FXL_HALF_PIXEL;
        uint32_t error;
        (void)fxl_edge_first_pixel(&top, &bottom, fxl_centre_of(row), &error);
        const wide h = bottom.y - top.y, dx = bottom.x - top.x, t = fxl_centre_of(row) - top.y, part = floor_rest(start, 65536), n = error_dividend;
        TRY(i, error == error_remainder && error < h);
    }
}

/* [[row]]
 * id = "fxl_edge_first_pixel beside its pixel's formula"
 * function = "lib/raster/edge.h:fxl_edge_first_pixel"
 * property = "the formula's pixel, whose centre is not left of the edge, and the first, of a million edges and rows"
 * checks = 1000000
 * formula = "first pixel, by formula"
 */
void enumerate_pixel(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        fxl_screen_point top, bottom;
        const int32_t row = any_edge(&top, &bottom);
        uint32_t error;
        const int32_t x = fxl_edge_first_pixel(&top, &bottom, fxl_centre_of(row), &error);
        const wide X = top.x, h = bottom.y - top.y, P = (wide)(bottom.x - top.x) * (fxl_centre_of(row) - top.y), partH = pixel_part * h;
        const wide q = floor_of(pixel_dividend, h), qH = q * h, wholeH = pixel_whole * h;
        TRY(i, x == pixel_pixel && pixel_right >= 0 && pixel_before < 0);
    }
}

/* [[row]]
 * id = "fxl_edge_divide beside its formula"
 * function = "lib/raster/edge_divide.h:fxl_edge_divide"
 * property = "the formula's quotient, of a million dividends"
 * checks = 1000000
 * formula = "fxl_edge_divide bound"
 */
void enumerate_above(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const wide h = (wide)up_to(FXL_EDGE_HEIGHT_MAX - 1) + 1, dividend = between(FXL_EDGE_DIVIDEND_MAX), n = dividend * ((wide)1 << 32);
        const fxl_edge_divider divider = fxl_edge_divider_of((uint32_t)h);
        int32_t whole;
        uint32_t fraction;
        fxl_edge_divide(&divider, (int32_t)dividend, &whole, &fraction);
        TRY(dividend, (wide)whole * ((wide)1 << 32) + fraction == above_above && above_above == above_floor + 1);
    }
}

/* [[row]]
 * id = "first pixels of an edge on its rows"
 * function = "lib/raster/edge.h:fxl_edge_set"
 * property = "on each row for which the edge holds, up to 16 of them, x is the first pixel whose centre is not left of the edge, of a million edges"
 * checks = 5184747
 */
/* [[row]]
 * id = "first pixels of an edge of two rows or more"
 * function = "lib/raster/edge.h:fxl_edge_set_near"
 * property = "the same"
 * checks = 5184747
 */
void enumerate_edge_set(void)
{
    for (uint32_t i = 0; i < SAMPLES; i++) {
        fxl_screen_point top, bottom;
        int32_t row;
        do {
            row = any_edge(&top, &bottom);
        } while (bottom.y - top.y > FXL_EDGE_HEIGHT_MAX || llabs(bottom.x - top.x) > (FXL_SCREEN_MAX + 1) * 65536);
        fxl_edge edge;
        const int32_t rows = fxl_edge_set(&top, &bottom, row, fxl_first_centre_from(bottom.y) - row, &edge);
        for (int32_t below = 0; below < rows && below < 16; below++) {
            TRY(i, right_of(&top, &bottom, row + below, edge.x) >= 0 && right_of(&top, &bottom, row + below, edge.x - 1) < 0);
            fxl_edge_advance(&edge, 1);
        }
    }
}

int32_t fxl_edge_set_far(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row, int32_t rows, fxl_edge *edge)
{
    (void)rows;
    edge->x = fxl_edge_first_pixel(top, bottom, fxl_centre_of(row), &edge->fraction);
    edge->step = 0;
    edge->step_fraction = 0;
    return 1;
}

/* --- small faces ------------------------------------------------------------------------------------------- */

/* Whether a triangle that goes clockwise covers a centre, by the definition: not outside of any edge, and on an edge only where
 * that is a left or a top one. */
static bool covers(const fxl_screen_point *points, int64_t x, int64_t y)
{
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        const fxl_screen_point a = points[i], b = points[(i + 1) % 3];
        const wide side = (wide)(b.x - a.x) * (y - a.y) - (wide)(b.y - a.y) * (x - a.x);
        const bool is_left_or_top = b.y < a.y || (b.y == a.y && b.x > a.x);
        inside = inside && (side > 0 || (side == 0 && is_left_or_top));
    }
    return inside;
}

/* Coordinates of the grid: quarters of a pixel from 0 to 2, and a unit before and after those on which a centre may lie. */
static const int32_t places[] = {0, 16384, 32767, 32768, 32769, 49152, 65536, 81920, 98303, 98304, 98305, 114688, 131072};

#define PLACES   (int32_t)(sizeof places / sizeof places[0])
#define OF(n)    {places[(n) % PLACES], places[(n) / PLACES]}
#define EVERY    (PLACES * PLACES)

static void try_triangle(int32_t input, const fxl_screen_point *points, const fxl_band *band)
{
    const fxl_screen_point back[3] = {points[0], points[2], points[1]};
    const wide area = (wide)(points[1].x - points[0].x) * (points[2].y - points[0].y) - (wide)(points[1].y - points[0].y) * (points[2].x - points[0].x);
    fxl_tiny tiny;
    if (!fxl_tiny_find(area < 0 ? back : points, band, &tiny)) {
        return;
    }
    for (int32_t row = 0; row < 3; row++) {
        for (int32_t column = 0; column < 3; column++) {
            const int32_t down = row - tiny.row, along = column - tiny.column;
            const bool is_here = down >= 0 && down < tiny.rows && along >= 0 && along < tiny.columns && (tiny.pixels << (tiny.columns * down + along) >> 31) != 0;
            const bool is_in_band = column < band->width && row >= band->first_row && row < band->first_row + band->rows;
            TRY(input, is_here == (is_in_band && area != 0 && covers(area > 0 ? points : back, column * 65536 + 32768, row * 65536 + 32768)));
        }
    }
}

/* [[row]]
 * id = "pixels of small triangles"
 * function = "lib/raster/tiny.c:fxl_tiny_find"
 * property = "the pixels of the band whose centres lie within, by the top-left rule: every triangle of a grid of 13 x 13 points, on centres and a unit beside them"
 * checks = 51359427
 */
/* [[row]]
 * id = "edge function of small triangles"
 * function = "lib/raster/scan.h:fxl_tiny_edge"
 * property = "the same"
 * checks = 51359427
 */
/* [[row]]
 * id = "cover of small triangles"
 * function = "lib/raster/scan.h:fxl_tiny_cover"
 * property = "the same"
 * checks = 51359427
 */
void enumerate_tiny(void)
{
    fxl_band bands[2] = {{0}, {0}};
    bands[0].width = bands[0].rows = 3;
    bands[1].width = 1;
    bands[1].first_row = bands[1].rows = 1;
    for (int32_t a = 0; a < EVERY; a++) {
        for (int32_t b = 0; b < EVERY; b++) {
            for (int32_t c = 0; c < EVERY; c++) {
                const fxl_screen_point points[3] = {OF(a), OF(b), OF(c)};
                try_triangle((a * EVERY + b) * EVERY + c, points, &bands[(a + b + c) % 7 == 0]);
            }
        }
    }
    for (uint32_t i = 0; i < SAMPLES; i++) { /* any coordinates, which end anywhere */
        fxl_screen_point points[3];
        for (int j = 0; j < 3; j++) {
            points[j].x = (int32_t)(draw() >> 40) % 131072;
            points[j].y = (int32_t)(draw() >> 40) % 131072;
        }
        try_triangle((int32_t)i, points, bands);
    }
}
