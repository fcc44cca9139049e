/* SPDX-License-Identifier: MIT */
/* The display list: a frame's polygons of the screen, in the order of drawing, in memory of the
 * caller. begin computes a frame once into the list; draw draws it from the list band by band.
 * Internal. */
#ifndef FXL_DISPLAY_LIST_H
#define FXL_DISPLAY_LIST_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether two ranges have a row in common. Requires that neither is empty, or that first is not
 * below the other's end where one is. */
/* SPEC 7.4 */
static inline bool fxl_rows_meet(fxl_rows a, fxl_rows b)
{
    return a.first < b.end && b.first < a.end;
}

/* Appends a polygon that reaches the given rows of the screen. Returns false if it
 * does not fit: list untouched.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, rows.first < rows.end. Exact. */
bool fxl_display_list_append(fxl_display_list *list, const fxl_screen_polygon *polygon,
                             fxl_rows rows);

/* Finds the next polygon, from *place on, that reaches one of the given rows, and moves *place
 * behind it. *place is a number of words; begin with 0. The polygon lies in the list, which holds
 * no more of its points than its count. Returns null if there is none. Exact. */
const fxl_screen_polygon *fxl_display_list_next(const fxl_display_list *list, fxl_rows rows,
                                                uint32_t *place);

#ifdef __cplusplus
}
#endif

#endif
