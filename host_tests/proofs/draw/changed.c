/* SPDX-License-Identifier: MIT */
#include "draw/changed_boxes.c"
#include "draw/changed.c"
#include "proof.h"

static fxl_screen_box any_box(void)
{
    const fxl_screen_box box = {nondet_u16(), nondet_u16(), nondet_u16(), nondet_u16()};
    ASSUME(box.columns >= 1 && box.first_column + box.columns <= FXL_SCREEN_MAX);
    ASSUME(box.rows >= 1 && box.first_row + box.rows <= FXL_SCREEN_MAX);
    return box;
}

static bool holds(const fxl_screen_box *box, uint32_t column, uint32_t row)
{
    return column >= box->first_column && column < (uint32_t)box->first_column + box->columns &&
           row >= box->first_row && row < (uint32_t)box->first_row + box->rows;
}

/* [[row]]
 * function = "box_about"
 * property = "any two boxes of a screen: a box of the screen that holds each pixel of both"
 * checks = 131
 */
void prove_box_about(void)
{
    const fxl_screen_box a = any_box(), b = any_box(), both = box_about(&a, &b);
    const uint32_t column = nondet_u32(), row = nondet_u32();
    ASSERT("it holds both", holds(&both, column, row) || !(holds(&a, column, row) || holds(&b, column, row)));
    ASSERT("it is of the screen", both.first_column + both.columns <= FXL_SCREEN_MAX && both.first_row + both.rows <= FXL_SCREEN_MAX);
    PROOF_ENDS();
}

/* [[row]]
 * function = "join_two"
 * property = "up to five boxes of a screen: each pixel stays in one, five become four, and without a join they stay"
 * checks = 254
 * unwind = 7
 */
void prove_join_two(void)
{
    fxl_screen_box boxes[FXL_CHANGED_BOXES_MAX + 1], before[FXL_CHANGED_BOXES_MAX + 1];
    uint32_t count = nondet_u32();
    const uint32_t had = count, column = nondet_u32(), row = nondet_u32();
    bool was_in = false, is_in = false;
    ASSUME(count <= FXL_CHANGED_BOXES_MAX + 1);
    for (uint32_t i = 0; i < FXL_CHANGED_BOXES_MAX + 1; i++) {
        boxes[i] = before[i] = any_box();
        was_in = was_in || (i < had && holds(&before[i], column, row));
    }
    const bool joined = join_two(boxes, &count);
    for (uint32_t i = 0; i < FXL_CHANGED_BOXES_MAX + 1; i++) {
        is_in = is_in || (i < count && holds(&boxes[i], column, row));
    }
    ASSERT("a pixel stays in one", is_in || !was_in);
    ASSERT("one less, or as many", count == had - (joined ? 1u : 0u));
    ASSERT("five become four", joined || had <= FXL_CHANGED_BOXES_MAX);
    PROOF_ENDS();
}

/* [[row]]
 * function = "find_pixels"
 * property = "coordinates of a vertex with any margin: the pixels that lie between them and on the screen"
 * checks = 24
 */
void prove_find_pixels(void)
{
    const int32_t size = nondet_s32(), pixel = nondet_s32();
    const fxl_q16_16 least = nondet_s32(), most = nondet_s32();
    uint16_t first = 0, count = 0;
    ASSUME(size >= 1 && size <= FXL_SCREEN_MAX && pixel >= 0 && pixel < size);
    ASSUME(least >= -3 * FXL_SCREEN_COORDINATE_MAX && least <= most && most <= 3 * FXL_SCREEN_COORDINATE_MAX);
    const bool found = find_pixels(least, most, size, &first, &count);
    ASSERT("it ends at the screen", !found || (count >= 1 && first + count <= size));
    ASSERT("a pixel that is touched is among them", pixel * 65536 > most || (pixel + 1) * 65536 <= least ||
           (found && pixel >= first && pixel < first + count));
    PROOF_ENDS();
}

/* [[row]]
 * function = "widen"
 * property = "pixels of a screen and a step of 1, 2, 4, 8 or all: multiples, or the screen's end, that hold them"
 * checks = 30
 */
void prove_widen(void)
{
    const uint32_t size = nondet_u32(), all = nondet_bool() ? size : 1u << (nondet_u32() & 3u);
    uint16_t first = nondet_u16(), count = nondet_u16();
    const uint32_t was_first = first, was_end = (uint32_t)first + count;
    ASSUME(size >= 1 && size <= FXL_SCREEN_MAX && count >= 1 && was_end <= size);
    widen(&first, &count, all, size);
    ASSERT("they hold those before", first <= was_first && (uint32_t)first + count >= was_end);
    ASSERT("they are of the screen", (uint32_t)first + count <= size);
    ASSERT("they begin and end with a step", first % all == 0 && ((uint32_t)first + count == size || (first + count) % all == 0));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/changed.c:fxl_changed_init"
 * property = "any record, memory and size, and null pointers: it knows no frame"
 * checks = 17
 */
void prove_changed_init(void)
{
    fxl_changed changed;
    static uint64_t memory[2];
    const fxl_status status = fxl_changed_init(nondet_bool() ? NULL : &changed, nondet_bool() ? NULL : (uint8_t *)memory + (nondet_u32() & 7u), nondet_size());
    ASSERT("it knows no frame", status != FXL_OK || (changed.renderer == NULL && changed.count == 0));
    PROOF_ENDS();
}
