/* SPDX-License-Identifier: MIT */
/* The greys that displays show, against docs/formats.md, section 4. */
#include "unit.h"

#define SIZE 8u /* rows and columns of the dither matrix */

static uint8_t palette[768];
static uint16_t table[256];

/* Entry i is the grey i; its luma is i. */
static void even_greys(uint32_t highest)
{
    uint32_t i;

    for (i = 0; i < sizeof palette; i++) {
        palette[i] = (uint8_t)(i / 3u);
    }
    fxl_grey_table(table, palette, highest);
}

static uint8_t luma(uint8_t red, uint8_t green, uint8_t blue)
{
    const uint8_t colour[3] = {red, green, blue};

    return fxl_luma(colour);
}

/* B(x, y), bit by bit. */
static uint32_t dither(uint32_t x, uint32_t y)
{
    uint32_t sum = 0;
    uint32_t k;

    for (k = 0; k < 3; k++) {
        sum = 4u * sum + 2u * (((x ^ y) >> k) & 1u) + ((y >> k) & 1u);
    }
    return sum;
}

/* formats 4.1a */
void test_luma(void)
{
    uint32_t i;

    TEST_ASSERT_EQUAL(54, luma(255, 0, 0)); /* 54 * 255 / 256 = 53.79 */
    TEST_ASSERT_EQUAL(182, luma(0, 255, 0));
    TEST_ASSERT_EQUAL(19, luma(0, 0, 255));
    TEST_ASSERT_EQUAL(0, luma(2, 0, 1)); /* 127 / 256 */
    TEST_ASSERT_EQUAL(1, luma(1, 0, 4)); /* 130 / 256 */
    for (i = 0; i < 256; i++) {
        TEST_ASSERT_EQUAL(i, luma((uint8_t)i, (uint8_t)i, (uint8_t)i));
    }
}

/* A pixel is lighter than the level below its colour where, and only where,
 * the fraction exceeds the threshold: 128 r > 255 (2 B + 1). */
static void assert_levels(uint32_t highest)
{
    uint32_t colour, x, y;

    even_greys(highest);
    for (colour = 0; colour < 256; colour++) {
        const uint32_t whole = colour * highest / 255u, rest = colour * highest % 255u;

        for (y = 0; y < SIZE; y++) {
            for (x = 0; x < SIZE; x++) {
                const uint32_t up = 128u * rest > 255u * (2u * dither(x, y) + 1u);

                TEST_ASSERT_EQUAL(whole + up, fxl_grey_level(table[colour], x, y));
            }
        }
    }
}

/* formats 4.2a-b */
void test_every_colour_at_every_place_on_16_greys(void)
{
    assert_levels(15);
}

/* formats 4.3a, 4.3c-d */
void test_every_colour_at_every_place_on_2_greys(void)
{
    assert_levels(1);
}

/* formats 4.2a-b */
void test_every_colour_at_every_place_on_4_greys(void)
{
    assert_levels(3);
}

/* formats 4.3f */
void test_256_greys_are_not_dithered(void)
{
    uint32_t colour;

    even_greys(255);
    for (colour = 0; colour < 256; colour++) {
        TEST_ASSERT_EQUAL(colour, fxl_grey_level(table[colour], colour, colour / SIZE));
    }
}

/* formats 4.3a, 4.3e */
void test_the_pattern_of_half_and_of_a_quarter(void)
{
    static const char *half = "#.#.#.#.\n.#.#.#.#\n#.#.#.#.\n.#.#.#.#\n"
                              "#.#.#.#.\n.#.#.#.#\n#.#.#.#.\n.#.#.#.#\n";
    static const char *quarter = "#.#.#.#.\n........\n#.#.#.#.\n........\n"
                                 "#.#.#.#.\n........\n#.#.#.#.\n........\n";
    char text[SIZE * (SIZE + 1u) + 1u];
    const char *expected[2] = {quarter, half};
    uint32_t i, x, y;

    even_greys(1);
    for (i = 0; i < 2; i++) {
        char *to = text;

        for (y = 0; y < SIZE; y++) {
            for (x = 0; x < SIZE; x++) {
                *to++ = fxl_grey_level(table[i == 0 ? 64 : 128], x, y) != 0 ? '#' : '.';
            }
            *to++ = '\n';
        }
        *to = '\0';
        TEST_ASSERT_EQUAL_STRING(expected[i], text);
    }
}

/* formats 4.4 */
void test_the_pattern_repeats_every_8_pixels(void)
{
    uint32_t colour;

    even_greys(15);
    for (colour = 0; colour < 256; colour++) {
        const uint32_t x = colour * 5u, y = colour * 3u;

        TEST_ASSERT_EQUAL(fxl_grey_level(table[colour], x % SIZE, y % SIZE),
                          fxl_grey_level(table[colour], x, y));
        TEST_ASSERT_EQUAL(fxl_grey_level(table[colour], x % SIZE, y % SIZE),
                          fxl_grey_level(table[colour], x + 1016u, y + 1016u));
    }
}
