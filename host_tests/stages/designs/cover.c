/* SPDX-License-Identifier: MIT */
#include "designs/cover.h"

#include <string.h>

/* place fill-rule: definition: the exact design */
static int8_t windings[FXL_SCREEN_MAX * FXL_SCREEN_MAX];

designs_edge designs_edge_of(const fxl_screen_polygon *outline, int number)
{
    const fxl_screen_point *from = &outline->points[number];
    const fxl_screen_point *to = &outline->points[(number + 1) % outline->count];
    if (from->y < to->y) {
        return (designs_edge){*from, *to, 1};
    }
    return (designs_edge){*to, *from, -1};
}

void designs_cover_begin(const designs_bitmap *bitmap)
{
    memset(windings, 0, (size_t)(bitmap->width * bitmap->height));
}

void designs_cover_add(const designs_bitmap *bitmap, int row, int64_t column, int winding)
{
    if (column < bitmap->width) {
        int8_t *at = &windings[row * bitmap->width + (column < 0 ? 0 : column)];
        *at = (int8_t)(*at + winding);
    }
}

void designs_cover_end(const designs_bitmap *bitmap)
{
    for (int row = 0; row < bitmap->height; row++) {
        int winding = 0;
        for (int i = row * bitmap->width; i < (row + 1) * bitmap->width; i++) {
            winding += windings[i];
            bitmap->pixels[i] = winding != 0;
        }
    }
}
