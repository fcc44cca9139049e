/* SPDX-License-Identifier: MIT */
#include "paint/billboard.c"
#include "proof.h"

#define SHOWN 4 /* columns */
#define WIDTH 8 /* of the sprite */

static uint8_t texels[WIDTH], colours[16];
static fxl_sprite sprite;
static fxl_billboard_row row;
static fxl_billboard_columns columns;

static void any_row(void)
{
    static const uint8_t shifts[9] = {0, 3, 0, 0, 1, 0, 0, 0, 0};
    const uint32_t bits = nondet_u32();
    ASSUME(bits == 1 || bits == 4 || bits == 8);
    sprite.bits = (uint8_t)bits;
    sprite.colours = bits < 8 ? colours : NULL;
    row.sprite = &sprite;
    row.texels = texels;
    row.shift = shifts[bits];
    ASSUME(row.columns.first < row.columns.end && row.columns.end - row.columns.first <= SHOWN);
    for (uint32_t i = 0; i < SHOWN; i++) {
        ASSUME(columns.texels[i] < WIDTH);
    }
}

/* [[row]]
 * function = "fxl_billboard_find_texels"
 * property = "any walk, up to 4 columns: nothing is out of bounds, they are there afterwards, and no other is written"
 * checks = 83
 * narrows = "the number of a texel, which lies in the sprite: no row says so of a walk"
 * unwind = 6
 */
void prove_billboard_find_texels(void)
{
    const uint32_t behind = nondet_u32();
    any_row();
    ASSUME(behind >= (uint32_t)(row.columns.end - row.columns.first) && behind <= SHOWN);
    const uint16_t before = columns.texels[behind];
    fxl_billboard_find_texels(&row, &columns);
    ASSERT("they are there", columns.has_texels);
    ASSERT("no other is written", columns.texels[behind] == before);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_billboard_find_entries"
 * property = "any sprite, up to 4 columns: nothing is out of bounds, and runs are in the columns, in their order and not empty"
 * checks = 178
 * unwind = 6
 */
void prove_billboard_find_entries(void)
{
    const uint32_t i = nondet_u32();
    ASSUME(i < SHOWN);
    any_row();
    fxl_billboard_find_entries(&row, &columns);
    ASSERT("both ends", columns.ends % 2 == 0 && columns.ends <= SHOWN + 1);
    ASSERT("in order", i + 1 >= columns.ends || columns.runs[i] < columns.runs[i + 1]);
    ASSERT("of the columns", i >= columns.ends || columns.runs[i] <= row.columns.end - row.columns.first);
    PROOF_ENDS();
}
