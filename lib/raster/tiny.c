/* SPDX-License-Identifier: MIT */
/* A file of its own: each target with a depth buffer would have these functions in several places.
 */
#include "tiny.h"

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "columns.h"

/* The centres of a band that lie between the ends of a triangle: so many columns and rows. */
typedef struct {
    int32_t column, row, columns, rows;
} tiny_box;

static inline void extend(fxl_q16_16 *low, fxl_q16_16 *high, fxl_q16_16 place)
{
    *low = place < *low ? place : *low;
    *high = place > *high ? place : *high;
}

/* place fill-rule: the edge functions of triangles of at most 4 x 4 centres */
/* Finds the box. Returns false if the triangle has more centres than FXL_TINY_SIDE, of the band or
 * not, in a row or a column: *box is undefined then. So its points are less than FXL_TINY_SIDE + 1
 * pixels apart. */
static inline bool find_box(const fxl_screen_point *points, const fxl_band *band, tiny_box *box)
{
    fxl_q16_16 top = points[0].y, bottom = top, left = points[0].x, right = left;
    extend(&top, &bottom, points[1].y);
    extend(&top, &bottom, points[2].y);
    int32_t row = fxl_first_centre_from(top), end_row = fxl_first_centre_from(bottom);
    if (end_row - row > FXL_TINY_SIDE) {
        return false;
    }
    extend(&left, &right, points[1].x);
    extend(&left, &right, points[2].x);
    int32_t column = fxl_first_centre_from(left), end_column = fxl_first_centre_from(right);
    if (end_column - column > FXL_TINY_SIDE) {
        return false;
    }
    const int32_t first_row = band->first_row, band_end = first_row + band->rows;
    const int32_t first_column = band->first_column,
                  band_right = (int32_t)fxl_band_end_column(band);
    row = row < first_row ? first_row : row;
    end_row = end_row > band_end ? band_end : end_row;
    column = column < first_column ? first_column : column;
    end_column = end_column > band_right ? band_right : end_column;
    box->column = column;
    box->row = row;
    box->columns = end_column - column;
    box->rows = end_row - row;
    return true;
}

/* An edge of an outline that goes clockwise, at a centre: not below 0 if the pixel is not outside
 * of the edge. It changes by dx from row to row, and by -dy from column to column.
 *
 * The edge function is dx (y - a.y) - dy (x - a.x), above 0 inside. A centre on a left or a top
 * edge, whose function is 0, is covered; of a right edge a unit is taken off. The centres on a
 * bottom edge are below the box. Points and centres are less than 6 pixels apart, 2^19, so the
 * products are below 2^38, and without their 16 lowest bits below 2^23. A centre's neighbours have
 * functions that differ by a multiple of 2^16: the bits that are lost change no sign. Exact. */
/* SPEC 5.2 */
static inline int32_t edge_at(const fxl_screen_point *a, const fxl_screen_point *b, fxl_q16_16 x,
                              fxl_q16_16 y)
    FXL_REQUIRES(FXL_BELOW(b->x - (int64_t)a->x, 6 * 65536))
    FXL_REQUIRES(FXL_BELOW(b->y - (int64_t)a->y, 6 * 65536))
    FXL_REQUIRES(FXL_BELOW(x - (int64_t)a->x, 6 * 65536))
    FXL_REQUIRES(FXL_BELOW(y - (int64_t)a->y, 6 * 65536))
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, 1 << 23))
{
    const int32_t dx = b->x - a->x, dy = b->y - a->y;
    const int32_t open = dy > 0;
    return (int32_t)((fxl_multiply_s32(dx, y - a->y) - fxl_multiply_s32(dy, x - a->x) - open) >>
                     16);
}

/* For contracts: two points of a triangle; a point and the first centre of the box; the box. */
#define FXL_NEAR(a, b)                                     \
    (FXL_BELOW((a)->x - (int64_t)(b)->x, 5 * 65536) &&     \
     FXL_BELOW((a)->y - (int64_t)(b)->y, 5 * 65536))
#define FXL_NEAR_BOX(a, box)                                                              \
    (FXL_BELOW((box)->column * (int64_t)65536 + FXL_HALF_PIXEL - (a)->x, 5 * 65536) &&    \
     FXL_BELOW((box)->row * (int64_t)65536 + FXL_HALF_PIXEL - (a)->y, 5 * 65536))
#define FXL_SMALL_BOX(box)                                                            \
    ((box)->rows > 0 && (box)->rows <= FXL_TINY_SIDE && (box)->columns > 0 &&         \
     (box)->columns <= FXL_TINY_SIDE && FXL_BELOW((box)->row, 4096) &&                \
     FXL_BELOW((box)->column, 4096))

/* The centres of a box that a clockwise triangle covers; 0 of one that goes the other way round. */
static uint32_t cover(const fxl_screen_point *a, const fxl_screen_point *b,
                      const fxl_screen_point *c, const tiny_box *box)
    FXL_REQUIRES(FXL_SMALL_BOX(box) && FXL_NEAR(a, b) && FXL_NEAR(b, c) && FXL_NEAR(c, a))
    FXL_REQUIRES(FXL_NEAR_BOX(a, box) && FXL_NEAR_BOX(b, box) && FXL_NEAR_BOX(c, box))
    FXL_ASSIGNS() FXL_ENSURES(FXL_RESULT >> (FXL_TINY_SIDE * FXL_TINY_SIDE) == 0)
{
    const fxl_q16_16 x = fxl_centre_of(box->column), y = fxl_centre_of(box->row);
    int32_t ab = edge_at(a, b, x, y), bc = edge_at(b, c, x, y), ca = edge_at(c, a, x, y);
    uint32_t pixels = 0;
    for (int32_t j = 0; j < box->rows; j++) {
        int32_t of_ab = ab, of_bc = bc, of_ca = ca;
        for (int32_t i = 0; i < box->columns; i++) {
            pixels |= (uint32_t)((of_ab | of_bc | of_ca) >= 0) << (FXL_TINY_SIDE * j + i);
            of_ab -= b->y - a->y;
            of_bc -= c->y - b->y;
            of_ca -= a->y - c->y;
        }
        ab += b->x - a->x;
        bc += c->x - b->x;
        ca += a->x - c->x;
    }
    return pixels;
}

bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny)
{
    tiny_box box;
    if (!find_box(points, band, &box)) {
        return false;
    }
    tiny->column = box.column;
    tiny->row = box.row;
    tiny->pixels = 0;
    if (box.rows > 0 && box.columns > 0) {
        tiny->pixels = cover(points, points + 1, points + 2, &box);
        /* Rounded to the screen, it may go the other way round. */
        if (tiny->pixels == 0 && edge_at(points, points + 1, points[2].x, points[2].y) < 0) {
            tiny->pixels = cover(points, points + 2, points + 1, &box);
        }
    }
    return true;
}
