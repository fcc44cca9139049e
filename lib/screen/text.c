/* SPDX-License-Identifier: MIT */
#include "overlay_band.h"

/* overlay 4.3 */
static bool has(const fxl_font *font, uint32_t character)
{
    return character >= font->first && character < (uint32_t)font->first + font->count;
}

static fxl_status check(const char *text, const fxl_text_style *style)
{
    if (text == NULL || style == NULL || style->font == NULL || style->font->bits == NULL ||
        style->font->glyphs == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_font *font = style->font;
    return font->first + font->count <= 256 && has(font, font->unknown) ? FXL_OK : FXL_E_RANGE;
}

/* overlay 4.3 */
static const fxl_glyph *glyph_of(const fxl_font *font, char character)
{
    const uint32_t code = (uint8_t)character;
    return &font->glyphs[(has(font, code) ? code : font->unknown) - font->first];
}

/* overlay 4.2 */
static uint32_t advance_of(const fxl_text_style *style, const fxl_glyph *glyph)
{
    return style->cell != 0 ? style->cell : glyph->advance;
}

/* The pen may go beyond 32 bits only after 2^23 characters of a line, and never beyond 64. */
/* overlay 4.1 */
fxl_status fxl_draw_text(const fxl_band *band, int32_t x, int32_t y, const char *text,
                         const fxl_text_style *style)
{
    fxl_status status = check(text, style);
    if (status == FXL_OK) {
        status = fxl_overlay_check(band);
    }
    if (status != FXL_OK) {
        return status;
    }
    const uint8_t colours[2] = {0, style->colour};
    int64_t pen = x, line = y;
    for (; *text != '\0'; text++) {
        if (*text == '\n') {
            pen = x;
            line += style->font->line_height;
            continue;
        }
        const fxl_glyph *glyph = glyph_of(style->font, *text);
        const fxl_sprite picture = {.pixels = style->font->bits + glyph->first_byte,
                                    .colours = colours,
                                    .width = glyph->width,
                                    .height = glyph->height,
                                    .bits = 1,
                                    .key = 0};
        /* In a cell: half of what is over is to the left, rounded down. */
        const int32_t over = style->cell != 0 ? (style->cell - glyph->advance) >> 1 : 0;
        fxl_overlay_sprite(band, pen + over + glyph->left, line + glyph->top, &picture);
        pen += advance_of(style, glyph);
    }
    return FXL_OK;
}

/* overlay 4.2 */
fxl_status fxl_measure_text(const char *text, const fxl_text_style *style, fxl_text_size *size)
{
    const fxl_status status = size == NULL ? FXL_E_ARGUMENT : check(text, style);
    if (status != FXL_OK) {
        return status;
    }
    fxl_text_size measured = {0, style->font->line_height};
    uint32_t width = 0; /* below 2^24 * 255 */
    for (; *text != '\0'; text++) {
        if (*text == '\n') {
            width = 0;
            measured.height += style->font->line_height;
        } else {
            width += advance_of(style, glyph_of(style->font, *text));
            measured.width = width > measured.width ? width : measured.width;
        }
    }
    *size = measured;
    return FXL_OK;
}
