/* SPDX-License-Identifier: MIT */
/* The pixels of a sprite. Internal. */
#ifndef FXL_SPRITE_TEXEL_H
#define FXL_SPRITE_TEXEL_H

#include "fixel/overlay.h"

/* log2 of the pixels of a byte. */
static inline unsigned fxl_sprite_shift(const fxl_sprite *sprite)
{
    return sprite->bits == 1 ? 3 : sprite->bits == 4 ? 1 : 0;
}

static inline size_t fxl_sprite_row_bytes(const fxl_sprite *sprite)
{
    return ((size_t)sprite->width * sprite->bits + 7) / 8;
}

/* The value of a pixel of a row of the sprite. shift: that of the sprite. */
static inline uint32_t fxl_sprite_value(const fxl_sprite *sprite, const uint8_t *row,
                                        uint32_t column, unsigned shift)
{
    const uint32_t bits = sprite->bits, last = (1u << shift) - 1u, mask = 0xFFu >> (8u - bits);
    const uint32_t place = (last - (column & last)) * bits;
    return (uint32_t)row[column >> shift] >> place & mask;
}

static inline uint8_t fxl_sprite_colour(const fxl_sprite *sprite, uint32_t value)
{
    return sprite->colours != NULL ? sprite->colours[value] : (uint8_t)value;
}

#endif
