/* SPDX-License-Identifier: MIT */
/* The walk over the pixels of a billboard; its callers differ in how they paint a row. Internal. */
#ifndef FXL_BILLBOARD_WALK_H
#define FXL_BILLBOARD_WALK_H

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "sprite_texel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place sampling: if billboards change too: a billboard's texel, its value, the sprite */
/* The texels along a side, pixel by pixel: texel + rest / length is the exact place, where length
 * is that of the side in 1/65536 pixel, 1..2^29. */
typedef struct {
    uint32_t texel, rest;
    uint32_t step, step_rest;
    uint32_t length;
} fxl_texel_walk;

/* Begins at the centre of a pixel, which lies on the side: from <= centre < end. Both products are
 * below 2^29 2^16, and both quotients below 2^32, since the length is at least 1. */
/* billboards 3.1 */
static inline void fxl_begin_walk(fxl_texel_walk *walk, fxl_q16_16 from, fxl_q16_16 end,
                                  int32_t pixel, uint32_t texels)
{
    const uint32_t along = (uint32_t)(fxl_centre_of(pixel) - from);
    walk->length = (uint32_t)(end - from);
    walk->texel = fxl_divide_u64(fxl_multiply_u32(along, texels), walk->length, &walk->rest);
    const uint64_t pixel_of_texels = (uint64_t)texels << 16;
    walk->step = fxl_divide_u64(pixel_of_texels, walk->length, &walk->step_rest);
}

/* The next pixel. Both rests are below length. */
/* billboards 3.1 */
static inline void fxl_take_step(fxl_texel_walk *walk)
{
    walk->texel += walk->step;
    walk->rest += walk->step_rest;
    if (walk->rest >= walk->length) {
        walk->rest -= walk->length;
        walk->texel += 1;
    }
}

/* place fill-rule: the rows and columns of a billboard, and the texel at the first centre */
/* The pixels of low <= pixel < high whose centres lie in from <= centre < end. */
/* billboards 3.1 */
static inline fxl_rows fxl_pixels_between(fxl_q16_16 from, fxl_q16_16 end, int32_t low,
                                          int32_t high)
{
    const int32_t first = fxl_first_centre_from(from), behind = fxl_first_centre_from(end);
    fxl_rows pixels = {(uint16_t)low, (uint16_t)low};
    if (first < high && behind > low && first < behind) {
        pixels.first = (uint16_t)(first > low ? first : low);
        pixels.end = (uint16_t)(behind < high ? behind : high);
    }
    return pixels;
}

/* A row of a billboard: pixels columns.first <= x < columns.end of a band's row. */
typedef struct {
    const fxl_sprite *sprite;
    const uint8_t *texels; /* of its row of texels */
    fxl_texel_walk along;  /* from columns.first on */
    fxl_rows columns;
    uint32_t y;
    unsigned shift;   /* of the sprite */
    bool is_repeated; /* its texels are those of the row before */
    bool is_single;   /* they are neither those nor the ones of the next row */
} fxl_billboard_row;

#define FXL_BILLBOARD_COLUMNS 64 /* that are painted together */

/* A row of texels as it stands in these columns of the screen, until another one is drawn. */
typedef struct {
    uint16_t texels[FXL_BILLBOARD_COLUMNS];
    uint8_t entries[FXL_BILLBOARD_COLUMNS];  /* of the palette, where there is no hole */
    uint8_t runs[FXL_BILLBOARD_COLUMNS + 1]; /* the first column and the end of each run without a hole */
    uint8_t ends;                            /* that are listed; both of a run */
    bool has_texels; /* all rows have the same ones */
} fxl_billboard_columns;

/* Finds the texels of at most FXL_BILLBOARD_COLUMNS columns, where they are not yet there. */
void fxl_billboard_find_texels(const fxl_billboard_row *row, fxl_billboard_columns *columns);

/* Looks up the texels of a row. */
void fxl_billboard_find_entries(const fxl_billboard_row *row, fxl_billboard_columns *columns);

/* Paints a row; with: the painter's own. */
typedef void fxl_billboard_row_painter(fxl_billboard_row *row, const void *with);

/* Calls a painter for each row of the billboard that reaches columns of the band. A pixel whose centre lies in
 * left <= x < right, top <= y < bottom shows the texel in which its centre falls: column
 * floor((x - left) * sprite->width / (right - left)), row likewise. Exact. Requires a sprite that
 * was checked, and corners within FXL_SCREEN_COORDINATE_MAX, left <= right and top <= bottom. */
static inline void fxl_billboard_walk_rows(const fxl_sprite *sprite,
                                           const fxl_screen_point *left_top,
                                           const fxl_screen_point *right_bottom,
                                           const fxl_band *band, fxl_rows columns,
                                           fxl_billboard_row_painter *paint, const void *with)
{
    fxl_billboard_row row;
    row.columns =
        fxl_pixels_between(left_top->x, right_bottom->x, columns.first, columns.end);
    const fxl_rows rows = fxl_pixels_between(left_top->y, right_bottom->y, band->first_row,
                                             band->first_row + band->rows);
    if (rows.first == rows.end) {
        return;
    }
    const size_t row_bytes = fxl_sprite_row_bytes(sprite);
    fxl_texel_walk down, first;
    fxl_begin_walk(&down, left_top->y, right_bottom->y, rows.first, sprite->height);
    fxl_begin_walk(&first, left_top->x, right_bottom->x, row.columns.first, sprite->width);
    row.sprite = sprite;
    row.shift = fxl_sprite_shift(sprite);
    row.texels = NULL;
    for (row.y = rows.first; row.y < rows.end; row.y++) {
        const uint32_t texel = down.texel;
        fxl_take_step(&down);
        row.is_repeated = row.texels == sprite->pixels + texel * row_bytes;
        row.is_single = !row.is_repeated && down.texel != texel;
        row.texels = sprite->pixels + texel * row_bytes;
        row.along = first;
        paint(&row, with);
    }
}

#ifdef __cplusplus
}
#endif

#endif
