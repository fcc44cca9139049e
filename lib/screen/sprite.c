/* SPDX-License-Identifier: MIT */
#include "overlay_band.h"
#include "../paint/sprite_texel.h"

void fxl_overlay_sprite(const fxl_band *band, int64_t x, int64_t y, const fxl_sprite *sprite)
{
    const unsigned shift = fxl_sprite_shift(sprite);
    const size_t row_bytes = fxl_sprite_row_bytes(sprite);
    const fxl_stretch columns = fxl_clip_stretch(x, sprite->width, 0, band->width);
    const fxl_stretch rows =
        fxl_clip_stretch(y, sprite->height, band->first_row, band->first_row + band->rows);
    if (columns.first == columns.end) {
        return;
    }
    for (int32_t row = rows.first; row < rows.end; row++) {
        /* A pixel of the sprite in the band, so the differences are below its width and height. */
        uint8_t *to = band->pixels + (size_t)(row - band->first_row) * band->stride + columns.first;
        const uint8_t *from = sprite->pixels + (size_t)(row - y) * row_bytes;
        const uint32_t end = (uint32_t)(columns.end - x);
        for (uint32_t column = (uint32_t)(columns.first - x); column < end; column++) {
            fxl_sprite_put(sprite, from, column, shift, to);
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
