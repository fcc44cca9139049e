/* SPDX-License-Identifier: MIT */
#include "overlay_unit.h"

uint8_t overlay_drawn[OVERLAY_HEIGHT][OVERLAY_STRIDE];
uint8_t overlay_wanted[OVERLAY_HEIGHT][OVERLAY_STRIDE];
uint16_t overlay_drawn_565[OVERLAY_HEIGHT][OVERLAY_STRIDE];
static uint16_t palette[256];
const fxl_band overlay_band = {.pixels = overlay_drawn[1],
                               .width = OVERLAY_WIDTH,
                               .stride = OVERLAY_STRIDE,
                               .first_row = OVERLAY_FIRST,
                               .rows = OVERLAY_HEIGHT - 2};
const fxl_band overlay_band_565 = {.pixels = (uint8_t *)overlay_drawn_565[1],
                                   .width = OVERLAY_WIDTH,
                                   .stride = OVERLAY_STRIDE,
                                   .first_row = OVERLAY_FIRST,
                                   .rows = OVERLAY_HEIGHT - 2,
                                   .palette = palette};

/* Two indices have two colours: the factor is odd. */
uint16_t overlay_colour_of(uint32_t index)
{
    return (uint16_t)(index * 40503u + 12345u);
}

void overlay_clear(void)
{
    memset(overlay_drawn, OVERLAY_GROUND, sizeof overlay_drawn);
    for (uint32_t i = 0; i < OVERLAY_HEIGHT * OVERLAY_STRIDE; i++) {
        overlay_drawn_565[i / OVERLAY_STRIDE][i % OVERLAY_STRIDE] =
            overlay_colour_of(OVERLAY_GROUND);
    }
}

void overlay_begin(void)
{
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = overlay_colour_of(i);
    }
    overlay_clear();
    memset(overlay_wanted, OVERLAY_GROUND, sizeof overlay_wanted);
}

void overlay_want(int64_t x, int64_t y, uint8_t colour)
{
    if (x >= 0 && x < OVERLAY_WIDTH && y >= OVERLAY_FIRST &&
        y < OVERLAY_FIRST + OVERLAY_HEIGHT - 2) {
        overlay_wanted[y - OVERLAY_FIRST + 1][x] = colour;
    }
}

void overlay_want_sprite(int64_t x, int64_t y, const fxl_sprite *sprite)
{
    const uint32_t row_bytes = (sprite->width * sprite->bits + 7u) / 8u;
    for (uint32_t row = 0; row < sprite->height; row++) {
        for (uint32_t column = 0; column < sprite->width; column++) {
            const uint32_t bit = column * sprite->bits;
            uint32_t value = 0;
            for (uint32_t k = bit; k < bit + sprite->bits; k++) {
                value = value << 1 |
                        (uint32_t)(sprite->pixels[row * row_bytes + k / 8] >> (7 - k % 8) & 1);
            }
            if (value != sprite->key) {
                overlay_want(x + column, y + row,
                             sprite->colours == NULL ? (uint8_t)value : sprite->colours[value]);
            }
        }
    }
}

void overlay_expect_equal(void)
{
    TEST_ASSERT_EQUAL_MEMORY(overlay_wanted, overlay_drawn, sizeof overlay_drawn);
    for (uint32_t i = 0; i < OVERLAY_HEIGHT * OVERLAY_STRIDE; i++) {
        TEST_ASSERT_EQUAL_HEX16(
            overlay_colour_of(overlay_wanted[i / OVERLAY_STRIDE][i % OVERLAY_STRIDE]),
            overlay_drawn_565[i / OVERLAY_STRIDE][i % OVERLAY_STRIDE]);
    }
}

void overlay_expect_wanted(void)
{
    overlay_expect_equal();
    overlay_begin();
}

fxl_status overlay_sprite_at(int32_t x, int32_t y, const fxl_sprite *sprite)
{
    const fxl_status status = fxl_draw_sprite(&overlay_band, x, y, sprite);
    TEST_ASSERT_EQUAL(status, fxl_draw_sprite(&overlay_band_565, x, y, sprite));
    return status;
}

fxl_status overlay_text_at(int32_t x, int32_t y, const char *text, const fxl_text_style *style)
{
    const fxl_status status = fxl_draw_text(&overlay_band, x, y, text, style);
    TEST_ASSERT_EQUAL(status, fxl_draw_text(&overlay_band_565, x, y, text, style));
    return status;
}

int32_t overlay_any(void)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, 0, -1, OVERLAY_FIRST, OVERLAY_WIDTH};
    const int32_t kind = unit_between(0, 15);
    return kind == 0   ? ends[unit_between(0, 5)]
           : kind == 1 ? (int32_t)unit_random()
                       : unit_between(-12, 40);
}
