/* SPDX-License-Identifier: MIT */
#include "overlay_band.h"

/* A row of a sprite, from column `first` of the sprite on. shift: log2 of the pixels of a byte. */
static void draw_row(uint8_t *to, const uint8_t *from, uint32_t first, uint32_t end, unsigned shift,
                     const fxl_sprite *sprite)
{
    const uint32_t bits = sprite->bits, last = (1u << shift) - 1u, mask = 0xFFu >> (8u - bits);
    for (uint32_t column = first; column < end; column++) {
        const uint32_t place = (last - (column & last)) * bits; /* bug: sprite-bit-order */
        const uint32_t value = (uint32_t)from[column >> shift] >> place & mask;
        if (value != sprite->key) { /* bug: sprite-key */
            *to = sprite->colours != NULL ? sprite->colours[value] : (uint8_t)value;
        }
        to++;
    }
}

void fxl_overlay_sprite(const fxl_band *band, int64_t x, int64_t y, const fxl_sprite *sprite)
{
    const unsigned shift = sprite->bits == 1 ? 3 : sprite->bits == 4 ? 1 : 0;
    const size_t row_bytes = ((size_t)sprite->width * sprite->bits + 7) / 8;
    const fxl_stretch columns = fxl_clip_stretch(x, sprite->width, 0, band->width);
    const fxl_stretch rows =
        fxl_clip_stretch(y, sprite->height, band->first_row, band->first_row + band->rows);
    if (columns.first == columns.end) {
        return;
    }
    for (int32_t row = rows.first; row < rows.end; row++) {
        /* A pixel of the sprite in the band, so the differences are below its width and height. */
        draw_row(band->pixels + (size_t)(row - band->first_row) * band->stride + columns.first,
                 sprite->pixels + (size_t)(row - y) * row_bytes, (uint32_t)(columns.first - x),
                 (uint32_t)(columns.end - x), shift, sprite);
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
