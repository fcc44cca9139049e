/* SPDX-License-Identifier: MIT */
/* The text in C of fxl_draw_depth_outline_8 and fxl_draw_depth_outline_16. It draws an outline whose
 * pixels have one octave: codes are linear over all of it, so each row begins with a code that a sum
 * finds, and a pixel with a word. Others are drawn by the rows of depth_row.h. */
#include "../math/family.h"
#include "../math/memory.h"
#include "../math/pixel_centre.h"
#include "../raster/fill.h"
#include "../raster/scan.h"
#include "depth_outline.h"
#include "outline_rows.h"

#if FXL_DRAWS_DEPTH_OUTLINES && !FXL_KERNELS_ARMV7M

/* The codes of an outline. */
typedef struct {
    uint64_t at;   /* its upper word is the code in column 0 of row 0, modulo 2^32 */
    uint64_t down; /* its change a row */
    uint32_t step; /* of a code a pixel */
} sheet;

/* Sums wrap; that of a pixel of the screen does not. number: below 2^16. */
static inline uint64_t times(int64_t change, uint32_t number)
{
    return (uint64_t)fxl_multiply_s64_u16(change, number);
}

/* place fill-rule: the columns of an outline */
/* The columns that an outline between two chains can cover: first to end - 1. Its vertices lie in
 * the columns of the band, or at its end. */
static inline void find_columns(const fxl_screen_point *points, uint32_t count, uint32_t *first,
                                uint32_t *end)
{
    int32_t least = points[0].x, most = least;
    for (uint32_t i = 1; i < count; i++) {
        least = points[i].x < least ? points[i].x : least;
        most = points[i].x > most ? points[i].x : most;
    }
    *first = (uint32_t)fxl_first_centre_from(least);
    *end = (uint32_t)fxl_first_centre_from(most);
}

/* By how much the upper words of values fall and rise at most in a box, along one side of it: by a change for
 * each of count steps, rounded down, and by 1 more a step. Values on the screen are below 2^62. */
static inline void extend(int64_t change, uint32_t count, uint32_t *fall, uint32_t *rise)
{
    const uint32_t upper = fxl_bits_32((int32_t)(change >> 32)) * count;
    if (upper >> 31 != 0) {
        *fall -= upper;
    } else {
        *rise += upper;
    }
    *rise += count;
}

/* Whether all pixels of a box have one octave: then *codes has their codes, those of
 * fxl_depth_paint_row. They have it, if the least and the greatest value that the box can have differ below
 * their highest bit alone, which is one of the upper word. Bits of the sheet below 2^(32 - drop) are 0, and
 * what is shifted out of it belongs to no code, so its upper word is the value / 2^drop, rounded down. */
static inline bool find_sheet(const fxl_depth_outline *outline, uint32_t column, uint32_t columns,
                              uint32_t row, uint32_t rows, sheet *codes)
{
    const fxl_gradient *gradient = &outline->plane.gradient;
    const uint64_t corner =
        (uint64_t)gradient->at + times(gradient->along, column) + times(gradient->down, row);
    const uint32_t upper = (uint32_t)(corner >> 32);
    uint32_t fall = 0, rise = 1;
    extend(gradient->along, columns - 1u, &fall, &rise);
    extend(gradient->down, rows - 1u, &fall, &rise);
    const uint32_t least = upper - fall, most = upper + rise;
    if ((upper | fall | rise) >> 31 != 0 || upper <= fall || (least ^ most) > least) {
        return false;
    }
    const int32_t length = 64 - (int32_t)fxl_leading_zeros(least);
    const uint32_t number = fxl_bits_32(outline->one - length);
    const int32_t drop = length - 17 - (int32_t)outline->mantissa;
    if (number >= outline->octaves || fxl_bits_32(drop) - 1u > 30u) {
        return false;
    }
    const uint32_t above = outline->octaves - 2u - number;
    const uint32_t bias = (above << (outline->mantissa + 16u)) + 65536u;
    codes->at = (uint64_t)(fxl_depth_shifted(gradient->at, drop) + bias) << 32 |
                fxl_low_32(fxl_bits_64(gradient->at)) << (32 - drop);
    codes->down = (uint64_t)fxl_depth_shifted(gradient->down, drop) << 32 |
                  fxl_low_32(fxl_bits_64(gradient->down)) << (32 - drop);
    codes->step = fxl_depth_shifted(gradient->along, drop);
    return true;
}

#if FXL_KERNELS_ARMV6M

/* The rows of a scan between two chains. */
static inline __attribute__((always_inline)) void paint_rows(const sheet *codes,
                                                             const fxl_depth_outline *outline,
                                                             const fxl_band *band, uint32_t bits)
{
    const uint32_t row = fxl_bits_32(outline->scan->row), width = band->width;
    fxl_depth_sheet of;
    of.first = (uint32_t)((uintptr_t)outline->cells / 2) + (row - band->first_row) * width - 8u;
    of.line = codes->at + times((int64_t)codes->down, row) -
              ((uint64_t)(codes->step * of.first) << 32);
    of.down = codes->down - ((uint64_t)(codes->step * width) << 32);
    of.step = codes->step;
    of.filling = outline->filling;
    of.pixels = outline->pixels;
    of.width = width;
    if (bits == 8) {
        fxl_paint_depth_sheet_8(&of, outline->scan);
    } else {
        fxl_paint_depth_sheet_16(&of, outline->scan);
    }
}

#else

/* A pixel of 8 or 16 bits. */
static inline __attribute__((always_inline)) void
paint_pixel(uint16_t *cell, void *pixel, uint32_t code, uint32_t filling, uint32_t bits)
{
    if (fxl_keep_nearer(cell, code)) {
        if (bits == 16) {
            *(uint16_t *)pixel = (uint16_t)filling;
        } else {
            *(uint8_t *)pixel = (uint8_t)filling;
        }
    }
}

#define SHORT 8 /* pixels */

/* count pixels of a row, from 1 on. The last ones, most rows' all, have no test of the end. */
static inline __attribute__((always_inline)) void paint_codes(uint16_t *cells, uint8_t *pixels,
                                                              uint32_t count, uint32_t code,
                                                              uint32_t step, uint32_t filling,
                                                              uint32_t bits)
{
    const uint32_t bytes = bits / 8u;
    for (; count > SHORT; count -= 4) {
        for (uint32_t i = 0; i < 4; i++) {
            paint_pixel(cells + i, pixels + i * bytes, code, filling, bits);
            code += step;
        }
        cells += 4;
        pixels += 4 * bytes;
    }
    /* The row ends SHORT pixels after these; they may lie before its first one. */
    uintptr_t cell = (uintptr_t)(cells + count) - SHORT * sizeof *cells;
    uintptr_t pixel = (uintptr_t)(pixels + count * bytes) - SHORT * bytes;
#if FXL_CORE_ARMV6M /* whose offsets are not below 0 */
    FXL_HIDE(cell);
    FXL_HIDE(pixel);
#endif
#define PAINT(left) \
    case (left): \
        paint_pixel((uint16_t *)cell + (SHORT - (left)), \
                    (uint8_t *)pixel + (SHORT - (left)) * bytes, code, filling, bits); \
        code += step; \
        __attribute__((fallthrough))
    switch (count) {
        PAINT(8);
        PAINT(7);
        PAINT(6);
        PAINT(5);
        PAINT(4);
        PAINT(3);
        PAINT(2);
    default:
        paint_pixel((uint16_t *)cell + (SHORT - 1), (uint8_t *)pixel + (SHORT - 1) * bytes, code,
                    filling, bits);
        break;
    }
}

/* The rows of a scan between two chains. */
static inline __attribute__((always_inline)) void paint_rows(const sheet *codes,
                                                             const fxl_depth_outline *outline,
                                                             const fxl_band *band, uint32_t bits)
{
    const uint32_t width = band->width, bytes = bits / 8u, step = codes->step;
    const uint32_t filling = outline->filling;
    const uint64_t down = codes->down;
    const fxl_trapezoid *trapezoid;
    while ((trapezoid = fxl_scan_next_trapezoid(outline->scan)) != NULL) {
        const uint32_t row = (uint32_t)trapezoid->first_row;
        const size_t place = (size_t)(row - band->first_row) * width;
        uint64_t line = codes->at + times((int64_t)down, row);
        uint16_t *cells = outline->cells + place;
        uint8_t *pixels = band->pixels + place * bytes;
        uint64_t a = fxl_whole_edge(trapezoid->edges[0].x, trapezoid->edges[0].fraction),
                 b = fxl_whole_edge(trapezoid->edges[1].x, trapezoid->edges[1].fraction);
        const uint64_t a_step =
            fxl_whole_edge(trapezoid->edges[0].step, trapezoid->edges[0].step_fraction);
        const uint64_t b_step =
            fxl_whole_edge(trapezoid->edges[1].step, trapezoid->edges[1].step_fraction);
        for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
            int32_t x0 = (int32_t)(a >> 32), x1 = (int32_t)(b >> 32);
            if (x0 > x1) {
                const int32_t x = x0;
                x0 = x1;
                x1 = x;
            }
            if (x0 < x1) {
                paint_codes(cells + x0, pixels + (uint32_t)x0 * bytes, (uint32_t)(x1 - x0),
                            (uint32_t)(line >> 32) + step * (uint32_t)x0, step, filling, bits);
            }
            a += a_step;
            b += b_step;
            line += down;
            cells += width;
            pixels += width * bytes;
        }
    }
}

#endif

static inline __attribute__((always_inline)) fxl_depth_drawn draw(const fxl_screen_point *points,
                                                                  uint32_t count,
                                                                  const fxl_band *band,
                                                                  const fxl_depth_outline *outline,
                                                                  uint32_t bits)
{
    const fxl_scan *scan = outline->scan;
    fxl_scan_outline(points, count, band, outline->scan);
    if (!scan->by_chains) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    if (!fxl_scan_reaches(scan, band)) {
        return FXL_DEPTH_NO_ROW;
    }
    uint32_t first, end;
    find_columns(points, count, &first, &end);
    if (first < end) {
        sheet codes;
        const uint32_t row = (uint32_t)scan->row;
        if (!find_sheet(outline, first, end - first, row, (uint32_t)scan->end_row - row, &codes)) {
            return FXL_DEPTH_NOT_DRAWN;
        }
        paint_rows(&codes, outline, band, bits);
    }
    return FXL_DEPTH_DRAWN;
}

fxl_depth_drawn fxl_draw_depth_outline_8(const fxl_screen_point *points, uint32_t count,
                                         const fxl_band *band, fxl_depth_outline *outline)
{
    return draw(points, count, band, outline, 8);
}

fxl_depth_drawn fxl_draw_depth_outline_16(const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band, fxl_depth_outline *outline)
{
    return draw(points, count, band, outline, 16);
}

#endif
