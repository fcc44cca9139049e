/* SPDX-License-Identifier: MIT */
/* Modules: sizes and offsets on which public libraries agree. */
#include "fixel/modules.h"

/* A module of colours. */
#define COLOURS(driver, width, height, left, top, columns, rows, access, is_inverted) \
    { \
        &(driver), width, height, left, top, columns, rows, access, is_inverted, 0, 0, 0, NULL \
    }

/* A module of pages, mounted upside down. */
#define PAGES(driver, width, height, left, columns, com_pins, offset, current_reference) \
    { \
        &(driver), width, height, left, 0, columns, 64, 0x09, false, com_pins, offset, \
            current_reference, NULL \
    }

/* An SH1107 whose glass has the lines from `first` on. */
#define LINES_FROM(first, width) \
    { \
        &fxl_sh1107, width, 128, 0, 0, 128, 128, 0x00, false, 0, (128 - (first)) & 127, 0, NULL \
    }

/* place driver: records of its modules */
const fxl_display_module fxl_module_ili9341_240x320 =
    COLOURS(fxl_ili9341, 240, 320, 0, 0, 240, 320, 0x48, false);
const fxl_display_module fxl_module_st7789_240x320 =
    COLOURS(fxl_st7789, 240, 320, 0, 0, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7789_240x240 =
    COLOURS(fxl_st7789, 240, 240, 0, 0, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7789_135x240 =
    COLOURS(fxl_st7789, 135, 240, 52, 40, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7789_172x320 =
    COLOURS(fxl_st7789, 172, 320, 34, 0, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7789_170x320 =
    COLOURS(fxl_st7789, 170, 320, 35, 0, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7789_240x280 =
    COLOURS(fxl_st7789, 240, 280, 0, 20, 240, 320, 0x00, true);
const fxl_display_module fxl_module_st7735_128x160 =
    COLOURS(fxl_st7735, 128, 160, 0, 0, 128, 160, 0xC0, false);
const fxl_display_module fxl_module_st7735_128x160_green =
    COLOURS(fxl_st7735, 128, 160, 2, 1, 132, 162, 0xC8, false);
const fxl_display_module fxl_module_st7735_128x128 =
    COLOURS(fxl_st7735, 128, 128, 2, 3, 132, 132, 0xC8, false);
const fxl_display_module fxl_module_st7735_128x128_row_32 =
    COLOURS(fxl_st7735, 128, 128, 0, 32, 128, 160, 0xC8, false);
const fxl_display_module fxl_module_st7735_80x160 =
    COLOURS(fxl_st7735, 80, 160, 26, 1, 132, 162, 0xC8, true);
const fxl_display_module fxl_module_st7735_80x160_column_24 =
    COLOURS(fxl_st7735, 80, 160, 24, 0, 128, 160, 0xC0, false);
const fxl_display_module fxl_module_st7796_320x480 =
    COLOURS(fxl_st7796, 320, 480, 0, 0, 320, 480, 0x48, false);
const fxl_display_module fxl_module_st7796_222x480 =
    COLOURS(fxl_st7796, 222, 480, 49, 0, 320, 480, 0x48, true);
const fxl_display_module fxl_module_ili9488_320x480 =
    COLOURS(fxl_ili9488, 320, 480, 0, 0, 320, 480, 0x48, false);
const fxl_display_module fxl_module_gc9a01_240x240 =
    COLOURS(fxl_gc9a01, 240, 240, 0, 0, 240, 240, 0x48, true);
const fxl_display_module fxl_module_ssd1351_128x128 =
    COLOURS(fxl_ssd1351, 128, 128, 0, 0, 128, 128, 0x74, false);
const fxl_display_module fxl_module_ssd1351_128x96 =
    COLOURS(fxl_ssd1351, 128, 96, 0, 0, 128, 96, 0x74, false);
const fxl_display_module fxl_module_ssd1306_128x64 =
    PAGES(fxl_ssd1306, 128, 64, 0, 128, 0x12, 0, 0);
const fxl_display_module fxl_module_ssd1306_128x64_com_02 =
    PAGES(fxl_ssd1306, 128, 64, 0, 128, 0x02, 0, 0);
const fxl_display_module fxl_module_ssd1306_128x32 =
    PAGES(fxl_ssd1306, 128, 32, 0, 128, 0x02, 0, 0);
const fxl_display_module fxl_module_ssd1306_64x48 = PAGES(fxl_ssd1306, 64, 48, 32, 128, 0x12, 0, 0);
const fxl_display_module fxl_module_ssd1306_64x32 = PAGES(fxl_ssd1306, 64, 32, 32, 128, 0x12, 0, 0);
const fxl_display_module fxl_module_ssd1306_72x40 =
    PAGES(fxl_ssd1306, 72, 40, 28, 128, 0x12, 0, 0x30);
const fxl_display_module fxl_module_ssd1309_128x64 =
    PAGES(fxl_ssd1309, 128, 64, 0, 128, 0x12, 0, 0);
const fxl_display_module fxl_module_ssd1309_128x64_column_2 =
    PAGES(fxl_ssd1309_132, 128, 64, 2, 132, 0x12, 0, 0);
const fxl_display_module fxl_module_sh1106_128x64 = PAGES(fxl_sh1106, 128, 64, 2, 132, 0x12, 0, 0);
const fxl_display_module fxl_module_sh1106_72x40 =
    PAGES(fxl_sh1106, 72, 40, 30, 132, 0x12, 0x0C, 0);
const fxl_display_module fxl_module_sh1107_128x128 = LINES_FROM(0, 128);
const fxl_display_module fxl_module_sh1107_128x128_column_96 = LINES_FROM(96, 128);
const fxl_display_module fxl_module_sh1107_64x128 = LINES_FROM(32, 64);
const fxl_display_module fxl_module_sh1107_80x128 = LINES_FROM(24, 80);
