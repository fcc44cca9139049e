# SPDX-License-Identifier: MIT
"""The example changes of test_examples.py, as a contributor would make them."""

import dataclasses

RGB444 = """/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../raster/columns.h"

/* The upper four bits of each colour. */
static void prepare(uint16_t *entries, const uint8_t *palette)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++, palette += 3) {
        entries[i] = (uint16_t)((palette[0] & 0xF0u) << 4 | (palette[1] & 0xF0u) | palette[2] >> 4);
    }
}

static uint32_t entry_of_rgb565(uint32_t colour)
{
    return (colour >> 4 & 0xF00u) | (colour >> 3 & 0xF0u) | (colour >> 1 & 0xFu);
}

/* Two pixels are three bytes. A last pixel of a row has two, of which the lower four bits are 0. */
static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    for (uint32_t rows = band->rows; rows > 0; rows--, row += fxl_pixel_bytes(kind, band->stride)) {
        bool is_second = false;
        for (uint32_t x = band->first_column; x < fxl_band_end_column(band); x++) {
            const uint32_t pixel = fxl_pixel_at(kind, row, x);
            const uint32_t entry = kind.is_colour ? entry_of_rgb565(pixel) : pixels->entries[pixel];
            *out = (uint8_t)(is_second ? *out | entry >> 8 : entry >> 4);
            out++;
            *out = (uint8_t)(is_second ? entry : entry << 4);
            out += is_second;
            is_second = !is_second;
        }
        out += is_second;
    }
}

const fxl_pixel_format fxl_pixels_rgb444 = {12, 1, prepare, convert};
"""


@dataclasses.dataclass(frozen=True)
class Change:
    """edits: {file: its text, or [(old, new)]}; new: files that are not there before; places: what the tags say of the places of this
    example; only: what make test runs of the tests that the recipe names; commands: of make, that show the change; renewed: the change adds
    functions, so fixel prove --numbers renews the documents that count them."""
    word: str
    edits: dict
    new: frozenset
    places: str
    only: tuple
    commands: tuple = ()
    renewed: bool = False


CONVERTER = Change("converter", {
    "lib/screen/rgb444.c": RGB444,
    "lib/include/fixel/pixels.h": [
        ("to 24, 16 or 8 bits\n", "to 24, 16, 12 or 8 bits\n"), ("/* of a pixel: 24, 16, 8, 4 or 1 */", "/* of a pixel: 24, 16, 12, 8, 4 or 1 */"),
        ("extern const fxl_pixel_format fxl_pixels_grey4;", "extern const fxl_pixel_format fxl_pixels_rgb444;  /* red first; two pixels in three bytes */\n"
                                                            "extern const fxl_pixel_format fxl_pixels_grey4;")],
    "host_tests/unit/test_pixels.c": [
        ("    if (pixels.format == &fxl_pixels_grey4) {\n        const uint8_t byte",
         "    if (pixels.format == &fxl_pixels_rgb444) {\n"
         "        const uint8_t *at = out + row * ((3u * width + 1u) / 2u) + x / 2u * 3u;\n"
         "        return x % 2u == 0 ? (uint32_t)at[0] << 4 | at[1] >> 4 : (at[1] & 15u) << 8 | at[2];\n    }\n"
         "    if (pixels.format == &fxl_pixels_grey4) {\n        const uint8_t byte"),
        ("    return level_of(colour, pixels.format", "    if (pixels.format == &fxl_pixels_rgb444) {\n"
         "        return colour[0] / 16u * 256u + colour[1] / 16u * 16u + colour[2] / 16u;\n    }\n    return level_of(colour, pixels.format"),
        ("{340, 340, 170, 510, 90, 30, 34}", "{340, 340, 170, 510, 90, 30, 34, 260}")],
    "host_tests/unit/pixel_formats.h": [("&fxl_pixels_mono_pages}", "&fxl_pixels_mono_pages, &fxl_pixels_rgb444}")],
    "docs/extras/pixels.md": [
        ("| `fxl_pixels_grey4` | 4 |", "| `fxl_pixels_rgb444` | 12 | 256 ⌊r/16⌋ + 16 ⌊g/16⌋ + ⌊b/16⌋ | two pixels in three bytes, the left one first |\n"
                                       "| `fxl_pixels_grey4` | 4 |")],
    "host_tests/proofs/measured.toml": [
        ('"lib/screen/rgb332.c" = "convert prepare"\n', '"lib/screen/rgb332.c" = "convert prepare"\n"lib/screen/rgb444.c" = "convert entry_of_rgb565 prepare"\n'),
        ("screen", 3)],
}, frozenset({"lib/screen/rgb444.c"}), "^(?!a new file)", ("test_pixels", "test_pump"), renewed=True)

STIPPLE = Change("stipple", {
    "lib/paint/texel_place.h": [
        ("Neighbours\n * in number are far apart, so the pattern is even at every opacity. */", "Rows are\n * filled one after the other, so the pattern is lines. */"),
        ("{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5}", "{0, 2, 1, 3, 8, 10, 9, 11, 4, 6, 5, 7, 12, 14, 13, 15}")],
    "SPEC.md": [("0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5", "0, 2, 1, 3, 8, 10, 9, 11, 4, 6, 5, 7, 12, 14, 13, 15")],
    "host_tests/unit/test_segments_texels.c": [("{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}", "{0, 2, 1, 3}, {8, 10, 9, 11}, {4, 6, 5, 7}, {12, 14, 13, 15}}")],
    "host_tests/proofs/paint/constants.py": [
        ("    \"\"\"The square of 4 x 4 by bits: those of x and y alternate, from the lowest on, the first one xor y.\"\"\"\n"
         "    return [((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1 for",
         "    \"\"\"The square of 4 x 4 by bits: those of y, from the lowest on, and then those of x.\"\"\"\n"
         "    return [(y & 1) << 3 | (y & 2) << 1 | (x & 1) << 1 | x >> 1 for")],
    "host_tests/breaks/paint.toml": [
        ("{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5}", "{0, 2, 1, 3, 8, 10, 9, 11, 4, 6, 5, 7, 12, 14, 13, 15}"),
        ("{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 5, 13}", "{0, 2, 1, 3, 8, 10, 9, 11, 4, 6, 5, 7, 12, 14, 15, 13}")],
    "host_tests/judges/reference/surface.c": [
        ("    int number = 0;\n    for (int k = 0; k < 2; k++) {\n        const int in_x = x >> k & 1, in_y = y >> k & 1;\n"
         "        number += (2 * (in_x ^ in_y) + in_y) << 2 * (1 - k);\n    }\n",
         "    const int number = 8 * (y & 1) + 4 * (y >> 1 & 1) + 2 * (x & 1) + (x >> 1 & 1);\n")],
}, frozenset(), "numbers of the pattern|definition: the pattern", ("test_segments_texels",),
    ("run BOARD=host SCENE=scenes/room.toml FRAMES=2",))

DRIVER = Change("driver", {
    "lib/include/fixel/display.h": [
        ("extern const fxl_display_driver fxl_st7735; ", "extern const fxl_display_driver fxl_ili9342;     /* 320 x 240 of 320 x 240, RGB565 */\nextern const fxl_display_driver fxl_st7735; "),
        ("extern const fxl_display_module fxl_module_st7789_240x320; ", "extern const fxl_display_module fxl_module_ili9342_320x240;          /* 2.0\" */\n"
                                                                          "extern const fxl_display_module fxl_module_st7789_240x320; ")],
    "lib/screen/modules.c": [
        ("/* The glass is mounted with its first row at the bottom", "/* Its glass lies on its long side. */\nconst fxl_display_driver fxl_ili9342 = OF_COLOURS(fxl_display_colour, 320, 240, 320, 240, 0x08, false);\n\n"
         "/* The glass is mounted with its first row at the bottom"),
        ("const fxl_display_module fxl_module_st7789_240x320 =", "const fxl_display_module fxl_module_ili9342_320x240 =\n    COLOURS(fxl_ili9342, 320, 240, 0, 0, 320, 240, 0x08, false);\n"
         "const fxl_display_module fxl_module_st7789_240x320 =")],
    "tools/fixel/board/controllers.py": [
        ("_ILI9488 = Ili9488, Glass", "_ILI9342 = Colour, Glass(320, 240, 320, 240, blue_first=True)\n_ILI9488 = Ili9488, Glass"),
        ('    "ili9341_240x320": _ILI9341,\n', '    "ili9341_240x320": _ILI9341, "ili9342": _ILI9342, "ili9342_320x240": _ILI9342,\n')],
    "host_tests/unit/controller.h": [
        ("    CONTROLLER_ST7735,\n", "    CONTROLLER_ILI9342,\n    CONTROLLER_ST7735,\n"),
        ("&fxl_gc9107, &fxl_ssd1322 \\\n", "&fxl_gc9107, &fxl_ssd1322, \\\n            &fxl_ili9342 \\\n")],
    "host_tests/unit/controller.c": [
        ("    [CONTROLLER_ST7735] = {", "    [CONTROLLER_ILI9342] = {&fxl_ili9342, PLAYS_MIPI, 1, 1, 320, 240, 320, 240, 0, BLUE_FIRST},\n    [CONTROLLER_ST7735] = {")],
    "host_tests/unit/test_modules.c": [
        ("    {&fxl_module_st7789_240x320, CONTROLLER_ST7789,", "    {&fxl_module_ili9342_320x240, CONTROLLER_ILI9342, 320, 240, 0, 0, 320, 240, false, false, true,\n     false},\n"
         "    {&fxl_module_st7789_240x320, CONTROLLER_ST7789,")],
    "docs/displays.md": [
        ("| `fxl_st7735` | 128 × 160 |", "| `fxl_ili9342` | 320 × 240 | 320 × 240 | RGB565 |\n| `fxl_st7735` | 128 × 160 |"),
        ("| `st7789_240x320` | 2.0\" |", "| `ili9342_320x240` | 2.0\" | 320 × 240 | 320 × 240 | 0, 0 | BGR | no | 0 | 10 MHz | ? | no |\n| `st7789_240x320` | 2.0\" |"),
        ("| `st7789_240x320` | 00; 60; C0; A0 |", "| `ili9342_320x240` | 08; 68; C8; A8 | 0, 0 |  |  |  |  | 16 bits | the data sheet |\n| `st7789_240x320` | 00; 60; C0; A0 |"),
        ("| ST7735 | 15 MHz |", "| ILI9342 | 10 MHz | 100 ns |\n| ST7735 | 15 MHz |")],
}, frozenset(), ".",
    ("host/test_display", "host/test_modules", "host/test_extra_commands"))

CHANGES = (CONVERTER, DRIVER, STIPPLE)
