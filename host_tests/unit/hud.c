/* SPDX-License-Identifier: MIT */
#include "hud.h"

/* A heart, 4 bits a pixel: 0 is the colour key, 1 its colour, 2 its shade. */
static const uint8_t heart_pixels[] = {
    0x01, 0x10, 0x11, 0x00, /* .##.##.  */
    0x11, 0x11, 0x11, 0x10, /* #######  */
    0x11, 0x11, 0x11, 0x20, /* ######s  */
    0x01, 0x11, 0x12, 0x00, /* .####s.  */
    0x00, 0x11, 0x20, 0x00, /* ..##s..  */
    0x00, 0x02, 0x00, 0x00, /* ...s...  */
};

bool hud_draw(const fxl_band *band, int32_t width, int32_t height, const char *score,
              const hud_colours *colours)
{
    const uint8_t heart_colours[16] = {0, colours->heart, colours->shade};
    const fxl_sprite heart = {heart_pixels, heart_colours, 7, 6, 4, 0};
    const fxl_text_style text = {&fxl_font_5x7, colours->text, 0},
                         digits = {&fxl_font_5x7, colours->text, 6};
    const int32_t x = width / 2, y = height / 2;
    fxl_text_size size;
    int failed = fxl_measure_text(score, &digits, &size) != FXL_OK;
    failed += fxl_draw_rectangle(band, 0, 0, width, 12, colours->panel) != FXL_OK;
    failed += fxl_draw_line(band, 0, 12, width - 1, 12, colours->line) != FXL_OK;
    failed += fxl_draw_text(band, 3, 2, "Score", &text) != FXL_OK;
    failed += fxl_draw_text(band, width - 3 - (int32_t)size.width, 2, score, &digits) != FXL_OK;
    failed += fxl_draw_line(band, x - 6, y, x + 6, y, colours->line) != FXL_OK;
    failed += fxl_draw_line(band, x, y - 6, x, y + 6, colours->line) != FXL_OK;
    for (int32_t i = 0; i < 3; i++) {
        failed += fxl_draw_sprite(band, 3 + 9 * i, height - 9, &heart) != FXL_OK;
    }
    failed += fxl_draw_border(band, width - 34, height - 9, 32, 7, colours->line) != FXL_OK;
    failed += fxl_draw_rectangle(band, width - 32, height - 7, 19, 3, colours->heart) != FXL_OK;
    return failed == 0;
}
