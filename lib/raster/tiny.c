/* SPDX-License-Identifier: MIT */
/* A file of its own: each target with a depth buffer would have these functions in several places.
 */
#include "scan.h"

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "columns.h"

/* The centres of a band that lie between the ends of a triangle: so many columns and rows. */
typedef struct {
    int32_t column, row, columns, rows;
} tiny_box;

/* place fill-rule: the edge functions of triangles of at most 2 x 2 centres */
/* The first centres from three coordinates on: *first becomes the least, and the result is how many
 * there are from it to the greatest. */
static inline int32_t count_centres(fxl_q16_16 a, fxl_q16_16 b, fxl_q16_16 c, int32_t *first)
{
    const fxl_q16_16 low = a < b ? a : b, high = a < b ? b : a;
    *first = fxl_first_centre_from(c < low ? c : low);
    return fxl_first_centre_from(c > high ? c : high) - *first;
}

/* Leaves of centres from *first on those from low to end. */
static inline void limit(int32_t *first, int32_t *count, int32_t low, int32_t end)
{
    int32_t last = *first + *count;
    *first = *first < low ? low : *first;
    last = last > end ? end : last;
    *count = last - *first;
}

/* An edge of an outline that goes clockwise, at a centre: not below 0 if the pixel is not outside
 * of the edge. It changes by dx from row to row, and by -dy from column to column.
 *
 * The edge function is dx (y - a.y) - dy (x - a.x), above 0 inside. A centre on a left or a top
 * edge, whose function is 0, is covered; of a right edge a unit is taken off. The centres on a
 * bottom edge are below the box. Points and centres are less than 4 pixels apart, 2^18. With y - a.y
 * = 2^9 h + l, 0 <= l < 2^9, products with h are below 2^28, their difference is below 2^29, and so
 * are those with l. The function without its 16 lowest bits is (upper + lower 2^-9) 2^-7, rounded
 * down twice, which is rounding down once. A centre's neighbours have functions that differ by a
 * multiple of 2^16: the bits that are lost change no sign. Exact. */
/* SPEC 5.2 */
static inline int32_t edge_at(const fxl_screen_point *a, const fxl_screen_point *b, fxl_q16_16 x,
                              fxl_q16_16 y) FXL_REQUIRES(FXL_BELOW(b->x - (int64_t)a->x, 4 * 65536))
    FXL_REQUIRES(FXL_BELOW(b->y - (int64_t)a->y, 4 * 65536))
        FXL_REQUIRES(FXL_BELOW(x - (int64_t)a->x, 4 * 65536))
            FXL_REQUIRES(FXL_BELOW(y - (int64_t)a->y, 4 * 65536)) FXL_ASSIGNS()
                FXL_ENSURES(FXL_BELOW(FXL_RESULT, 1 << 23))
{
    const int32_t dx = b->x - a->x, dy = b->y - a->y, along = x - a->x, down = y - a->y;
    const int32_t open = dy > 0;
    const int32_t upper = dx * (down >> 9) - dy * (along >> 9);
    const int32_t lower = dx * (down & 511) - dy * (along & 511) - open;
    return (upper + (lower >> 9)) >> 7;
}

/* For contracts: two points of a triangle; a point and the first centre of the box; the box. */
#define FXL_NEAR(a, b) \
    (FXL_BELOW((a)->x - (int64_t)(b)->x, 4 * 65536) && \
     FXL_BELOW((a)->y - (int64_t)(b)->y, 4 * 65536))
#define FXL_NEAR_BOX(a, box) \
    (FXL_BELOW((box)->column * (int64_t)65536 + FXL_HALF_PIXEL - (a)->x, 4 * 65536) && \
     FXL_BELOW((box)->row * (int64_t)65536 + FXL_HALF_PIXEL - (a)->y, 4 * 65536))
#define FXL_SMALL_BOX(box) \
    ((box)->rows > 0 && (box)->rows <= FXL_TINY_SIDE && (box)->columns > 0 && \
     (box)->columns <= FXL_TINY_SIDE && FXL_BELOW((box)->row, 4096) && \
     FXL_BELOW((box)->column, 4096))

/* The centres of a box that a clockwise triangle covers; 0 of one that goes the other way round. */
static uint32_t cover(const fxl_screen_point *a, const fxl_screen_point *b,
                      const fxl_screen_point *c, const tiny_box *box)
    FXL_REQUIRES(FXL_SMALL_BOX(box) && FXL_NEAR(a, b) && FXL_NEAR(b, c) && FXL_NEAR(c, a))
        FXL_REQUIRES(FXL_NEAR_BOX(a, box) && FXL_NEAR_BOX(b, box) && FXL_NEAR_BOX(c, box))
            FXL_ASSIGNS() FXL_ENSURES(FXL_RESULT >> (FXL_TINY_SIDE * FXL_TINY_SIDE) == 0)
{
    const fxl_q16_16 x = fxl_centre_of(box->column), y = fxl_centre_of(box->row);
    const int32_t ab = edge_at(a, b, x, y), bc = edge_at(b, c, x, y), ca = edge_at(c, a, x, y);
    const int32_t ab_along = ab - (b->y - a->y), bc_along = bc - (c->y - b->y),
                  ca_along = ca - (a->y - c->y);
    uint32_t outside = fxl_bits_32(ab | bc | ca) >> 31;
    outside |= fxl_bits_32(ab_along | bc_along | ca_along) >> 31 << 1;
    if (box->rows > 1) {
        const int32_t ab_down = b->x - a->x, bc_down = c->x - b->x, ca_down = a->x - c->x;
        outside |= fxl_bits_32((ab + ab_down) | (bc + bc_down) | (ca + ca_down)) >> 31 << 2;
        outside |=
            fxl_bits_32((ab_along + ab_down) | (bc_along + bc_down) | (ca_along + ca_down)) >>
            31 << 3;
    } else {
        outside |= 12;
    }
    return (box->columns > 1 ? 15u : 5u) & ~outside;
}

bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny)
{
    tiny_box box;
    box.rows = count_centres(points[0].y, points[1].y, points[2].y, &box.row);
    if (box.rows > FXL_TINY_SIDE) {
        return false;
    }
    box.columns = count_centres(points[0].x, points[1].x, points[2].x, &box.column);
    if (box.columns > FXL_TINY_SIDE) {
        return false;
    }
    limit(&box.row, &box.rows, band->first_row, band->first_row + band->rows);
    limit(&box.column, &box.columns, band->first_column, (int32_t)fxl_band_end_column(band));
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
