/* SPDX-License-Identifier: MIT */
/* The walk over a side of a billboard, pixel by pixel, by its definition. */
#include "../../lib/paint/billboard_walk.h"
#include "unit.h"

enum {
    PIXELS = 64
};

/* place sampling: if billboards change too: the walk; the texel that is picked */
/* place fill-rule: definition: the pixels of a billboard */
/* The texel in which the centre of a pixel falls, and what is left, both exact. */
static void expect_place(const fxl_texel_walk *walk, fxl_q16_16 from, int32_t pixel,
                         uint32_t texels)
{
    const uint64_t along = (uint64_t)((int64_t)pixel * 65536 + 32768 - from) * texels;
    TEST_ASSERT_EQUAL_UINT32(along / walk->length, walk->texel);
    TEST_ASSERT_EQUAL_UINT32(along % walk->length, walk->rest);
}

/* Walks from the first centre on a side to the last. Returns how many centres fell on the border of
 * two texels. */
static uint32_t walk_side(fxl_q16_16 from, fxl_q16_16 end, uint32_t texels)
{
    const fxl_rows pixels = fxl_pixels_between(from, end, 0, PIXELS);
    fxl_texel_walk walk;
    uint32_t ties = 0;
    if (pixels.first == pixels.end) {
        return 0;
    }
    fxl_begin_walk(&walk, from, end, pixels.first, texels);
    TEST_ASSERT_EQUAL_UINT32(end - from, walk.length);
    for (int32_t pixel = pixels.first; pixel < pixels.end; pixel++) {
        expect_place(&walk, from, pixel, texels);
        TEST_ASSERT_TRUE(walk.texel < texels);
        ties += walk.rest == 0;
        fxl_take_step(&walk);
    }
    return ties;
}

/* Each texel is two pixels wide, and begins at a centre. */
/* billboards 3.1b */
void test_a_centre_on_a_border_shows_the_texel_that_begins_there(void)
{
    TEST_ASSERT_EQUAL_UINT32(4, walk_side(Q16(2.5), Q16(10.5), 4));
    TEST_ASSERT_EQUAL_UINT32(4, walk_side(Q16(-3.5), Q16(4.5), 8));
}

/* Any number of low..high whose lowest bits may be 0. */
static int32_t any_place(int32_t low, int32_t high)
{
    const int32_t unit = (int32_t)1 << unit_between(0, 16);
    return unit_between(low, high) / unit * unit;
}

/* billboards 3.1c */
void test_sides_of_any_length_and_place(void)
{
    uint32_t ties = 0;
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        const int32_t from = any_place(Q16(-PIXELS), Q16(PIXELS));
        const int32_t end = from + any_place(0, Q16(2 * PIXELS));
        ties += walk_side(from, end, i & 1 ? (uint32_t)unit_between(1, 1024) : 64);
    }
    TEST_ASSERT_TRUE(ties > UNIT_REPEAT / 1000);
    (void)walk_side(-FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX, UINT16_MAX);
    (void)walk_side(Q16(7.5), Q16(7.5) + 1, UINT16_MAX);
}

/* A centre on the first end is in, one on the last is out. */
/* billboards 3.1a */
void test_which_pixels_are_between(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        const int32_t from = any_place(Q16(-PIXELS), Q16(2 * PIXELS));
        const int32_t end = from + any_place(0, Q16(2 * PIXELS));
        const int32_t low = unit_between(0, PIXELS / 2), high = unit_between(low, PIXELS);
        const fxl_rows pixels = fxl_pixels_between(from, end, low, high);
        for (int32_t pixel = 0; pixel < PIXELS; pixel++) {
            const int32_t centre = pixel * 65536 + 32768;
            const bool is_between = pixel >= low && pixel < high && centre >= from && centre < end;
            TEST_ASSERT_EQUAL(is_between, pixel >= pixels.first && pixel < pixels.end);
        }
    }
}
