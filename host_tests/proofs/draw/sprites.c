/* SPDX-License-Identifier: MIT */
/* The pixels of a billboard in RGB565, with a depth buffer. */
#include "draw/sprites_rgb565_depth_16.c"
#include "proof.h"

#define SHOWN 4 /* columns */
#define WIDTH 8 /* of the sprite */

static uint16_t palette[256], pixels[SHOWN], cells[SHOWN];
static uint8_t texels[WIDTH], colours[16];
static fxl_band band;
static fxl_sprite sprite;
static fxl_billboard_row row;
static sprite_columns columns;
static sprite_place place;

static void any_row(void)
{
    static const uint8_t shifts[9] = {0, 3, 0, 0, 1, 0, 0, 0, 0};
    const uint32_t bits = nondet_u32();
    ASSUME(bits == 1 || bits == 4 || bits == 8);
    sprite.bits = (uint8_t)bits;
    sprite.key = nondet_u16();
    sprite.colours = bits < 8 ? colours : NULL;
    band.palette = palette;
    place.band = &band;
    place.code = nondet_u32();
    place.beyond = nondet_u32();
    row.sprite = &sprite;
    row.texels = texels;
    row.shift = shifts[bits];
    row.columns.first = nondet_u16();
    row.columns.end = nondet_u16();
    ASSUME(row.columns.first < row.columns.end && row.columns.end - row.columns.first <= SHOWN);
    for (uint32_t i = 0; i < SHOWN; i++) {
        columns.texels[i] = nondet_u16();
        ASSUME(columns.texels[i] < WIDTH);
    }
}

/* [[row]]
 * function = "lib/draw/sprites_text.h:find_texels"
 * property = "any walk, up to 4 columns: nothing is out of bounds"
 * checks = 73
 * unwind = 6
 */
void prove_find_texels(void)
{
    any_row();
    find_texels(&row, &columns);
    ASSERT("they are there", columns.has_texels);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/sprites_text.h:find_colours"
 * property = "any sprite, up to 4 columns: nothing is out of bounds, and runs are in the columns, in their order and not empty"
 * checks = 172
 * unwind = 6
 */
void prove_find_colours(void)
{
    const uint32_t i = nondet_u32();
    ASSUME(i < SHOWN);
    any_row();
    if (sprite.bits == 4 && nondet_bool()) {
        find_colours(&row, &band, &columns, 4);
    } else {
        find_colours(&row, &band, &columns, 8);
    }
    ASSERT("both ends", columns.ends % 2 == 0 && columns.ends <= SHOWN + 1);
    ASSERT("in order", i + 1 >= columns.ends || columns.runs[i] < columns.runs[i + 1]);
    ASSERT("of the columns", i >= columns.ends || columns.runs[i] <= row.columns.end - row.columns.first);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/sprites_text.h:show_texels"
 * property = "any sprite, up to 4 columns: nothing is out of bounds, and no cell becomes farther"
 * checks = 256
 * unwind = 6
 */
void prove_show_texels(void)
{
    const uint32_t i = nondet_u32();
    ASSUME(i < SHOWN);
    any_row();
    ASSUME(place.beyond <= (place.code >> 16) + 1);
    const uint16_t before = cells[i];
    if (sprite.bits == 4 && nondet_bool()) {
        show_texels(&row, &place, columns.texels, cells, pixels, 4);
    } else {
        show_texels(&row, &place, columns.texels, cells, pixels, 8);
    }
    ASSERT("as near", cells[i] >= before);
    PROOF_ENDS();
}
