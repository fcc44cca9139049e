/* SPDX-License-Identifier: MIT */
#include "billboard_paint.h"

#include "../../src/math/arith.h"
#include "../../src/math/pixel_centre.h"
#include "../overlay/sprite_texel.h"

/* The texels along a side, pixel by pixel: texel + rest / length is the exact place, where length
 * is that of the side in 1/65536 pixel, 1..2^29. */
typedef struct {
    uint32_t texel, rest;
    uint32_t step, step_rest;
    uint32_t length;
} texel_walk;

/* Begins at the centre of a pixel, which lies on the side: from <= centre < end. Both products are
 * below 2^29 2^16, and both quotients below 2^32, since the length is at least 1. */
static void begin_walk(texel_walk *walk, fxl_q16_16 from, fxl_q16_16 end, int32_t pixel,
                       uint32_t texels)
{
    const uint32_t along = (uint32_t)(fxl_centre_of(pixel) - from);
    walk->length = (uint32_t)(end - from);
    walk->texel = fxl_divide_u64(fxl_multiply_u32(along, texels), walk->length, &walk->rest);
    const uint64_t pixel_of_texels = (uint64_t)texels << 16; /* bug: sprite-step */
    walk->step = fxl_divide_u64(pixel_of_texels, walk->length, &walk->step_rest);
}

/* The next pixel. Both rests are below length. */
static inline void take_step(texel_walk *walk)
{
    walk->texel += walk->step;
    walk->rest += walk->step_rest;
    if (walk->rest >= walk->length) { /* bug: sprite-carry */
        walk->rest -= walk->length;
        walk->texel += 1;
    }
}

/* The pixels of low <= pixel < high whose centres lie in from <= centre < end. */
static fxl_rows pixels_between(fxl_q16_16 from, fxl_q16_16 end, int32_t low, int32_t high)
{
    const int32_t first = fxl_first_centre_from(from), behind = fxl_first_centre_from(end);
    fxl_rows pixels = {(uint16_t)low, (uint16_t)low};
    if (first < high && behind > low && first < behind) {
        pixels.first = (uint16_t)(first > low ? first : low);
        pixels.end = (uint16_t)(behind < high ? behind : high);
    }
    return pixels;
}

void fxl_billboard_paint(const fxl_sprite *sprite, const fxl_screen_point *left_top,
                         const fxl_screen_point *right_bottom, const fxl_band *band)
{
    const fxl_rows columns = pixels_between(left_top->x, right_bottom->x, 0, band->width);
    const fxl_rows rows =
        pixels_between(left_top->y, right_bottom->y, band->first_row, band->first_row + band->rows);
    if (columns.first == columns.end || rows.first == rows.end) {
        return;
    }
    const unsigned shift = fxl_sprite_shift(sprite);
    const size_t row_bytes = fxl_sprite_row_bytes(sprite);
    texel_walk down, first, along;
    begin_walk(&down, left_top->y, right_bottom->y, rows.first, sprite->height);
    begin_walk(&first, left_top->x, right_bottom->x, columns.first, sprite->width);
    for (uint32_t row = rows.first; row < rows.end; row++) {
        uint8_t *to = band->pixels + (size_t)(row - band->first_row) * band->stride + columns.first;
        const uint8_t *texels = sprite->pixels + down.texel * row_bytes;
        along = first;
        for (uint32_t column = columns.first; column < columns.end; column++) {
            fxl_sprite_put(sprite, texels, along.texel, shift, to);
            to++;
            take_step(&along);
        }
        take_step(&down);
    }
}
