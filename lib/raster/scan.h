/* SPDX-License-Identifier: MIT */
/* Scan conversion: from a polygon of the screen to the pixels that it covers.
 * This states the fill rule; `fixel places fill-rule` prints the code that obeys it.
 *
 * A polygon covers a pixel if the winding number of its outline about the pixel's
 * centre (i + 1/2, j + 1/2) is not zero. Ties follow the top-left rule: a centre
 * exactly on a left or a top edge is covered, a centre exactly on a right or a bottom
 * edge is not. Each edge is tested by itself, exactly, and with the same result in
 * either direction. So two polygons that share an edge neither leave a gap nor draw a
 * pixel twice, even if rounding made one of them slightly concave.
 */
#ifndef FXL_SCAN_H
#define FXL_SCAN_H

#include "fixel/records.h"
#include "../math/core.h"
#include "../math/family.h"
#include "../math/pixel_centre.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Begins to scan a polygon into a band. The polygon must outlive the scan.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, |x|, |y| <=
 * FXL_SCREEN_COORDINATE_MAX, and a band as fxl_band describes it.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_DEGENERATE: fewer than three vertices are left.
 * FXL_E_CAPACITY: too little memory.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: the scan has no pixels.
 * Exact: given the 16.16 vertices, coverage has no error at all.
 * Source: Bresenham's stepping along an edge, with an exact start. */
fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan);

/* Begins to scan an outline of count points into a band, without checks.
 * Requires what fxl_scan_begin requires, of outline and band. The points must outlive
 * the scan. Exact. */
void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan);

/* Whether the outline reaches a row of the band that the scan was begun with. Requires a scan that
 * was begun without an error. Exact. */
static inline bool fxl_scan_reaches(const fxl_scan *scan, const fxl_band *band)
{
    return scan->outline_first < scan->outline_end && scan->outline_end > band->first_row &&
           scan->outline_first < band->first_row + band->rows;
}

/* The rows, of a screen of height rows, that the polygon reaches: the rows whose
 * centres lie from its highest to its lowest vertex. It covers no centre of another row.
 * Requires what fxl_scan_begin requires of a polygon.
 * Exact: scan finds an edge on each of these rows, and on no others. */
fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height);

/* Returns the next trapezoid, or null if there are no more. Trapezoids come by rows
 * downward, and left to right within a row; no pixel is in two of them. The trapezoid
 * belongs to scan and is valid until the next call. It is a kernel: each family of
 * cores has its own, and all give the same bits. Exact. Source: A6. */
const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan);

#if FXL_KERNELS_ARMV6M

/* Goes down a chain of a scan to the edge that crosses a row, and sets the edge on that row. Returns the
 * row at which it ends. It is a kernel, which leaves an edge of one row, one that begins above the row, and
 * a high one to the text in C. */
int32_t fxl_scan_begin_edge(const fxl_scan *scan, fxl_chain *chain, int32_t row, fxl_edge *edge);
void fxl_scan_begin_any_edge(const fxl_scan *scan, fxl_chain *chain, int32_t row, fxl_edge *edge);

#endif

/* Whether the trapezoid that was returned is known to be the last; true saves a call. */
static inline bool fxl_scan_is_over(const fxl_scan *scan)
{
    return scan->trapezoid.end_row == scan->end_row;
}

/* Finds the next span: the same pixels, for targets that decide by spans.
 * Spans come by rows downward; those of a row come left to right and do not overlap.
 * Returns false if there are no more: span untouched. A scan is read either by
 * trapezoids or by spans, not by both. Exact. Source: A6. */
bool fxl_scan_next(fxl_scan *scan, fxl_span *span);

/* Returns the next span of a scan by active edges, as a trapezoid of one row; null if there are no
 * more. The kernel calls it if a scan has no more rows by chains and is not by chains. */
const fxl_trapezoid *fxl_scan_next_of_active_edges(fxl_scan *scan);

/* Right of every crossing. */
#define FXL_NO_CROSSING INT32_MAX

/* place fill-rule: the winding number */
/* place fill-rule: the rule in a header */
/* Begins a scan. Requires an outline and a band as fxl_scan_begin does. first_row and end_row are
 * fxl_first_centre_from of the highest and of the lowest vertex. The points must outlive the
 * scan. */
void fxl_active_edges_begin(fxl_active_edges *edges, const fxl_screen_point *points, uint32_t count,
                            int32_t first_row, int32_t end_row, const fxl_band *band);

/* The same from the points alone. Returns the outline's rows that are above the band's end. */
fxl_rows fxl_active_edges_outline(fxl_active_edges *edges, const fxl_screen_point *points,
                                  uint32_t count, const fxl_band *band);

/* Finds the next span. Returns false if there are no more: span untouched. */
bool fxl_active_edges_next(fxl_active_edges *edges, fxl_span *span);

/* For FXL_SMALL: fills the span that fxl_active_edges_next found. Where two edges cross its row, it
 * fills the rows below that the same two cross, too, and goes to the last of them. */
void fxl_active_edges_fill(fxl_active_edges *edges, const fxl_span *span, const fxl_band *band,
                           uint8_t colour);

/* --- tiny triangles ---------------------------------------------------------- */

/* Columns and rows of what fxl_tiny_find finds, and of what fxl_tiny_cover takes, which takes no
 * more centres than a word has bits. */
#define FXL_TINY_SIDE    2
#define FXL_TINY_LONGEST 8
#define FXL_TINY_CENTRES 32

/* Compiled for few bytes, triangles are scanned whatever their size. */
#define FXL_HAS_TINY (!FXL_IS_SMALL && !FXL_IS_COMPACT)

/* The centres between the ends of a triangle: so many columns and rows. pixels has those that it
 * covers: the highest bit is that of the first column of the first row, the next one that of the
 * next column, and a row follows the row above. */
typedef struct {
    int32_t column, row, columns, rows;
    uint32_t pixels;
} fxl_tiny;

/* Whether fxl_tiny_cover takes a box of at least one row, all of whose rows are a band's. */
static inline bool fxl_tiny_fits(const fxl_tiny *box, const fxl_band *band)
{
    return (uint32_t)box->columns - 1u < FXL_TINY_LONGEST && box->rows <= FXL_TINY_LONGEST &&
           box->columns * box->rows <= FXL_TINY_CENTRES && box->row >= band->first_row &&
           box->row + box->rows <= band->first_row + band->rows;
}

/* place fill-rule: the edge functions of triangles of few centres */
/* The edge from a to b of an outline that goes clockwise, at a centre that both are relative to: not
 * below 0 if the pixel is not outside of the edge. It changes by dx from row to row, and by -dy from
 * column to column.
 *
 * The edge function is a.x b.y - b.x a.y, above 0 inside. A centre on a left or a top edge, whose
 * function is 0, is covered; of a right edge a unit is taken off. The centres on a bottom edge are
 * below the box. With y = 2^10 h + l, 0 <= l < 2^10, |h| <= 576, products with h are below 2^29, and
 * their difference is below 2^30; those with l are below 2^30, and their difference is below 2^31. The
 * function without its 16 lowest bits is (upper + lower 2^-10) 2^-6, rounded down twice, which is
 * rounding down once. A centre's neighbours have functions that differ by a multiple of 2^16: the
 * bits that are lost change no sign. Exact. */
/* SPEC 5.2 */
static inline int32_t fxl_tiny_edge(const fxl_screen_point *a, const fxl_screen_point *b)
    FXL_REQUIRES(FXL_OBJECT(a) && FXL_OBJECT(b))
        FXL_REQUIRES(FXL_BELOW(a->x, 9 * 65536) && FXL_BELOW(a->y, 9 * 65536))
            FXL_REQUIRES(FXL_BELOW(b->x, 9 * 65536) && FXL_BELOW(b->y, 9 * 65536)) FXL_ASSIGNS()
                FXL_ENSURES(FXL_BELOW(FXL_RESULT, 1 << 24))
{
    const int32_t open = b->y > a->y;
    const int32_t upper = a->x * (b->y >> 10) - b->x * (a->y >> 10);
    const int32_t lower = a->x * (b->y & 1023) - b->x * (a->y & 1023) - open;
    return (upper + (lower >> 10)) >> 6;
}

/* Finds tiny->pixels, those of a scan, by the exact edge functions at each centre. Returns false if
 * the triangle may go counterclockwise, as rounding to the screen can make it: pixels untouched.
 * Requires of the centres 1 to FXL_TINY_LONGEST rows and columns, at most FXL_TINY_CENTRES in all, of those
 * between the least and the greatest coordinates, which lie less than 9 pixels apart. Exact.
 * The sum of the three functions is twice the area, less what rounding down takes away. A function
 * is below 2^24, and its change along the box below 2^23. */
static inline bool fxl_tiny_cover(const fxl_screen_point *points, fxl_tiny *tiny)
{
    const fxl_q16_16 x = fxl_centre_of(tiny->column), y = fxl_centre_of(tiny->row);
    const fxl_screen_point a = {points[0].x - x, points[0].y - y},
                           b = {points[1].x - x, points[1].y - y},
                           c = {points[2].x - x, points[2].y - y};
    int32_t ab = fxl_tiny_edge(&a, &b), bc = fxl_tiny_edge(&b, &c), ca = fxl_tiny_edge(&c, &a);
    if (ab + bc + ca < 0) {
        return false;
    }
    const int32_t ab_along = b.y - a.y, bc_along = c.y - b.y, ca_along = a.y - c.y;
    const int32_t columns = tiny->columns;
    const int32_t ab_row = b.x - a.x + columns * ab_along, bc_row = c.x - b.x + columns * bc_along,
                  ca_row = a.x - c.x + columns * ca_along;
    uint32_t outside = 0;
    for (int32_t rows = tiny->rows; rows > 0; rows--) {
        for (int32_t left = columns; left > 0; left--) {
            outside = outside << 1 | fxl_bits_32(ab | bc | ca) >> 31;
            ab -= ab_along;
            bc -= bc_along;
            ca -= ca_along;
        }
        ab += ab_row;
        bc += bc_row;
        ca += ca_row;
    }
    tiny->pixels = ~outside << (32 - columns * tiny->rows);
    return true;
}

/* The same for the centres of a band, all of whose columns are drawn. Returns false also if there are
 * more than FXL_TINY_SIDE of a side outside of the band or in it: *tiny is undefined then. Exact. */
bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny);

#ifdef __cplusplus
}
#endif

#endif
