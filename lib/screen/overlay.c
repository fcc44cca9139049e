/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../paint/rgb565_colour.h"
/* place sampling: if billboards change too: sprites over a picture, which read the same texels */
#include "../paint/sprite_texel.h"
#include "../raster/columns.h"
#include "../raster/draw_outline.h"
#include "../raster/fill.h"
#include "overlay_band.h"

/* A line along its major axis: from place `from` to place `to`, both included, from <= to. */
typedef struct {
    int32_t from, to; /* pixels */
    int32_t across;   /* at from */
    int32_t rise;     /* change across from `from` to `to`, no larger than to - from */
} pixel_line;

/* Draws the part of the line within low <= place < high. At place `from` + k the line is at
 * across + k rise / length, so its pixel there is floor((2 k rise + length) / (2 length)) beyond
 * across. Coordinates are below 2^29, so k, rise and length are below 2^30, and the numerator is
 * below 2^61 + 2^30. The quotient is at most |rise|. */
/* overlay 2.1 */
static void draw_part(const pixel_line *line, bool upright, int32_t low, int32_t high,
                      uint8_t colour, const fxl_band *band)
{
    const int32_t length = line->to - line->from;
    const fxl_stretch part = fxl_clip_stretch(line->from, (int64_t)length + 1, low, high);
    if (part.first == part.end) {
        return;
    }
    const int64_t pixel = length > 0 ? 2 * (int64_t)length : 2;
    const int64_t sum = 2 * fxl_multiply_s32(part.first - line->from, line->rise) + pixel / 2;
    const int32_t moved = fxl_divide_down(sum, (uint32_t)pixel);
    fxl_line_pixels pixels = {.across = line->across + moved,
                              .left = sum - moved * pixel,
                              .pixel = pixel,
                              .step = 2 * (int64_t)line->rise,
                              .upright = upright};
    fxl_draw_line_pixels(&pixels, part.first, part.end, colour, band);
}

/* overlay 1.2 */
static bool in_range(int32_t a, int32_t b)
{
    return fxl_within(a, FXL_LINE_COORDINATE_MAX) && fxl_within(b, FXL_LINE_COORDINATE_MAX);
}

/* overlay 1.2 */
fxl_status fxl_draw_line(const fxl_band *band, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                         uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status != FXL_OK) {
        return status;
    }
    if (!in_range(x0, y0) || !in_range(x1, y1)) {
        return FXL_E_RANGE;
    }
    fxl_band from_0 = *band;
    fxl_band_begin_at_column_0(&from_0);
    const int32_t width = x1 - x0, height = y1 - y0; /* below 2^30 */
    if ((height < 0 ? -height : height) > (width < 0 ? -width : width)) {
        const pixel_line line = {height < 0 ? y1 : y0, height < 0 ? y0 : y1, height < 0 ? x1 : x0,
                                 height < 0 ? -width : width};
        draw_part(&line, true, band->first_row, band->first_row + band->rows, colour, &from_0);
    } else {
        const pixel_line line = {width < 0 ? x1 : x0, width < 0 ? x0 : x1, width < 0 ? y1 : y0,
                                 width < 0 ? -height : height};
        draw_part(&line, false, band->first_column,
                  (int32_t)fxl_band_end_column(band), colour, &from_0);
    }
    return FXL_OK;
}

/* overlay 1.3 */
fxl_status fxl_overlay_check(const fxl_band *band)
{
    if (band == NULL || band->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_band_is_aligned(band)) {
        return FXL_E_ALIGNMENT;
    }
    return band->width >= 1 && band->width <= FXL_SCREEN_MAX &&
                   fxl_band_is_within(band, band->width, FXL_SCREEN_MAX)
               ? FXL_OK
               : FXL_E_RANGE;
}

/* The columns of a stretch that the band has. */
/* overlay 1.1 */
static fxl_stretch clip_columns(const fxl_band *band, int64_t x, int64_t width)
{
    return fxl_clip_stretch(x, width, band->first_column,
                            (int32_t)fxl_band_end_column(band));
}

/* In pixels, from the band's first. */
static size_t place_of(const fxl_band *band, int32_t row, int32_t column)
{
    return (size_t)(row - band->first_row) * band->stride +
           ((size_t)column - band->first_column);
}

/* Pixels of a row of the band, at least one. */
/* overlay 1.3 */
static void fill_row(const fxl_band *band, int32_t row, const fxl_stretch *columns, uint8_t colour)
{
    if (fxl_kind_of_band(band).is_colour) {
        uint16_t *pixels =
            (uint16_t *)(void *)band->pixels + place_of(band, row, columns->first);
        fxl_fill_row_rgb565(pixels, pixels + (columns->end - columns->first),
                            band->palette[colour]);
    } else {
        const int32_t first = band->first_column;
        const fxl_span span = {(int16_t)row, (int16_t)(columns->first - first),
                               (int16_t)(columns->end - first)};
        fxl_fill_span(band, &span, colour);
    }
}

/* overlay 1.1 */
static void fill(const fxl_band *band, int64_t x, int64_t y, int64_t width, int64_t height,
                 uint8_t colour)
{
    const fxl_stretch columns = clip_columns(band, x, width);
    const fxl_stretch rows =
        fxl_clip_stretch(y, height, band->first_row, band->first_row + band->rows);
    for (int32_t row = rows.first; row < rows.end && columns.first < columns.end; row++) {
        fill_row(band, row, &columns, colour);
    }
}

/* overlay 1.1, 1.4 */
fxl_status fxl_draw_rectangle(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                              int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status == FXL_OK) {
        fill(band, x, y, width, height, colour);
    }
    return status;
}

fxl_status fxl_draw_border(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                           int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status == FXL_OK && width > 0 && height > 0) {
        fill(band, x, y, width, 1, colour);
        fill(band, x, (int64_t)y + height - 1, width, 1, colour);
        fill(band, x, y, 1, height, colour);
        fill(band, (int64_t)x + width - 1, y, 1, height, colour);
    }
    return status;
}

void fxl_overlay_sprite(const fxl_band *band, int64_t x, int64_t y, const fxl_sprite *sprite)
{
    const unsigned shift = fxl_sprite_shift(sprite);
    const size_t row_bytes = fxl_sprite_row_bytes(sprite);
    const fxl_stretch columns = clip_columns(band, x, sprite->width);
    const fxl_stretch rows =
        fxl_clip_stretch(y, sprite->height, band->first_row, band->first_row + band->rows);
    if (columns.first == columns.end) {
        return;
    }
    for (int32_t row = rows.first; row < rows.end; row++) {
        /* A pixel of the sprite in the band, so the differences are below its width and height. */
        size_t to = place_of(band, row, columns.first);
        const uint8_t *from = sprite->pixels + (size_t)(row - y) * row_bytes;
        const uint32_t end = (uint32_t)(columns.end - x);
        for (uint32_t column = (uint32_t)(columns.first - x); column < end; column++) {
            const uint32_t value = fxl_sprite_value(sprite, from, column, shift);
            if (value != sprite->key) {
                fxl_set_pixel(band, to, fxl_sprite_colour(sprite, value));
            }
            to++;
        }
    }
}

fxl_status fxl_draw_sprite(const fxl_band *band, int32_t x, int32_t y, const fxl_sprite *sprite)
{
    if (sprite == NULL || sprite->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = fxl_overlay_check(band);
    if (status != FXL_OK) {
        return status;
    }
    if (sprite->bits != 1 && sprite->bits != 4 && sprite->bits != 8) {
        return FXL_E_RANGE;
    }
    fxl_overlay_sprite(band, x, y, sprite);
    return FXL_OK;
}
