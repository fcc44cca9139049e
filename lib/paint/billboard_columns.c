/* SPDX-License-Identifier: MIT */
/* What the columns of a billboard show, looked up once for all rows that repeat a row of texels. It
 * knows entries of the palette, and no pixels. */
#include "../math/family.h"
#include "billboard_walk.h"

void fxl_billboard_find_texels(const fxl_billboard_row *row, fxl_billboard_columns *columns)
{
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    fxl_texel_walk along = row->along;
    for (uint32_t i = 0; !columns->has_texels && i < count; i++) {
        columns->texels[i] = (uint16_t)along.texel;
        fxl_take_step(&along);
    }
    columns->has_texels = true;
}

/* The value of a texel of a row. bits: of the sprite, or 8 for any. */
static inline uint32_t value_of(const fxl_billboard_row *row, uint32_t texel, uint32_t bits)
{
    return bits == 4 ? (uint32_t)row->texels[texel >> 1] >> (4u * (~texel & 1u)) & 15u
                     : fxl_sprite_value(row->sprite, row->texels, texel, row->shift);
}

/* Each texel once, for all its columns. A run ends where a hole begins, or the columns end: the list
 * has at most one end more than there are columns. bits: of the sprite, or 8 for any. */
/* billboards 3.2 */
static inline __attribute__((always_inline)) void find_entries(const fxl_billboard_row *row,
                                                               uint32_t count,
                                                               fxl_billboard_columns *columns,
                                                               uint32_t bits)
{
    const uint32_t key = row->sprite->key;
    uint32_t last = UINT32_MAX, ends = 0;
    uint8_t entry = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t texel = columns->texels[i];
        if (texel != last) {
            const uint32_t value = value_of(row, texel, bits);
            if ((value != key) != (ends & 1u)) {
                columns->runs[ends++] = (uint8_t)i;
            }
            entry = value != key ? fxl_sprite_colour(row->sprite, value) : 0;
        }
        last = texel;
        columns->entries[i] = entry;
    }
    if (ends & 1u) {
        columns->runs[ends++] = (uint8_t)count;
    }
    columns->ends = (uint8_t)ends;
}

/* Entries may be bytes of the sprite to the compiler, so it has a copy. */
void fxl_billboard_find_entries(const fxl_billboard_row *row, fxl_billboard_columns *columns)
{
    const fxl_sprite sprite = *row->sprite;
    fxl_billboard_row copy = *row;
    const uint32_t count = (uint32_t)(row->columns.end - row->columns.first);
    copy.sprite = &sprite;
    if (!FXL_IS_COMPACT && sprite.bits == 4) {
        find_entries(&copy, count, columns, 4);
    } else {
        find_entries(&copy, count, columns, 8);
    }
}
