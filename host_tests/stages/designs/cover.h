/* SPDX-License-Identifier: MIT */
/* From "this edge begins at this column of this row" to covered pixels. How a
 * design finds the column is its own business. */
#ifndef DESIGNS_COVER_H
#define DESIGNS_COVER_H

#include "designs/design.h"

/* place fill-rule: definition: the exact design */
/* An edge of an outline from top to bottom; winding is +1 where the outline
 * walks it downward, -1 upward. */
typedef struct {
    fxl_screen_point top, bottom;
    int winding;
} designs_edge;

designs_edge designs_edge_of(const fxl_screen_polygon *outline, int number);

/* Between begin and end: pixels of the row from column on wind once more. */
void designs_cover_begin(const designs_bitmap *bitmap);
void designs_cover_add(const designs_bitmap *bitmap, int row, int64_t column, int winding);
void designs_cover_end(const designs_bitmap *bitmap);

#endif
