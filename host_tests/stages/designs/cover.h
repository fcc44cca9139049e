/* SPDX-License-Identifier: MIT */
/* From "this edge begins at this column of this row" to covered pixels. How a
 * design finds the column is its own business. */
#ifndef DESIGNS_COVER_H
#define DESIGNS_COVER_H

#include <string.h>

#include "designs/design.h"

/* place fill-rule: definition: the exact design */
/* An edge of an outline from top to bottom; winding is +1 where the outline
 * walks it downward, -1 upward. */
typedef struct {
    fxl_screen_point top, bottom;
    int winding;
} designs_edge;

static int8_t windings[FXL_SCREEN_MAX * FXL_SCREEN_MAX];

static inline designs_edge designs_edge_of(const fxl_screen_polygon *outline, int number)
{
    const fxl_screen_point *from = &outline->points[number];
    const fxl_screen_point *to = &outline->points[(number + 1) % outline->count];
    if (from->y < to->y) {
        return (designs_edge){*from, *to, 1};
    }
    return (designs_edge){*to, *from, -1};
}

/* Between begin and end: pixels of the row from column on wind once more. */
static inline void designs_cover_begin(const designs_bitmap *bitmap)
{
    memset(windings, 0, (size_t)(bitmap->width * bitmap->height));
}

static inline void designs_cover_add(const designs_bitmap *bitmap, int row, int64_t column, int winding)
{
    if (column < bitmap->width) {
        int8_t *at = &windings[row * bitmap->width + (column < 0 ? 0 : column)];
        *at = (int8_t)(*at + winding);
    }
}

static inline void designs_cover_end(const designs_bitmap *bitmap)
{
    for (int row = 0; row < bitmap->height; row++) {
        int winding = 0;
        for (int i = row * bitmap->width; i < (row + 1) * bitmap->width; i++) {
            winding += windings[i];
            bitmap->pixels[i] = winding != 0;
        }
    }
}

#endif
