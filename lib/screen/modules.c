/* SPDX-License-Identifier: MIT */
/* The records of controllers and of modules: constants of data sheets, and sizes and offsets on
 * which public libraries agree. What the commands mean is in the file of the family: colour.c,
 * oled.c, pages.c, memory_lcd.c. */
#include "fixel/driver.h"

/* place driver: its record, and those of its modules */
/* --- controllers: commands of MIPI's Display Command Set ----------------------------------------
 */

/* One whose common glass is `width` columns of all that the memory has, from the first one on. */
#define OF_COLOURS(family, columns, rows, width, height, access, is_inverted) \
    { \
        &(family), NULL, 0, columns, rows, width, height, 0, access, is_inverted, false \
    }
/* One with commands: the family's list, the memory, the glass and what is before it. */
#define WITH_COMMANDS(family, commands, columns, rows, width, height, left, access, is_inverted) \
    { \
        &(family), commands, sizeof(commands), columns, rows, width, height, left, access, \
            is_inverted, false \
    }

/* Its glass is blue, green, red, and its columns run from right to left. */
const fxl_display_driver fxl_ili9341 =
    OF_COLOURS(fxl_display_colour, 240, 320, 240, 320, 0x48, false);

/* The glass is mounted with its first row at the bottom, and its first column at the right. */
const fxl_display_driver fxl_st7735 =
    OF_COLOURS(fxl_display_colour, 132, 162, 128, 160, 0xC0, false);

const fxl_display_driver fxl_st7789 =
    OF_COLOURS(fxl_display_colour, 240, 320, 240, 320, 0x00, true);
const fxl_display_driver fxl_st7796 =
    OF_COLOURS(fxl_display_colour, 320, 480, 320, 480, 0x48, false);

/* It takes no pixels of 16 bits on SPI. */
const fxl_display_driver fxl_ili9488 =
    OF_COLOURS(fxl_display_colour_18, 320, 480, 320, 480, 0x48, false);

/* Which way its columns are joined to the glass is a setting too, and the access is right for one
 * of them alone. */
static const uint8_t gc9a01_commands[] = {
    1,
    0xFE, /* unlock those below: first half */
    1,
    0xEF, /* second half */
    3,
    0xB6,
    0x00,
    0x00, /* columns and rows are scanned from the first one on */
    /* Two registers that its data sheet does not describe. Without them there is no picture, as the
     * author of micropython-nano-gui found; all public drivers set them so. */
    11,
    0x66,
    0x3C,
    0x00,
    0xCD,
    0x67,
    0x45,
    0x45,
    0x10,
    0x00,
    0x00,
    0x00,
    11,
    0x67,
    0x00,
    0x3C,
    0x00,
    0x00,
    0x00,
    0x01,
    0x54,
    0x10,
    0x32,
    0x98,
    0,
};
const fxl_display_driver fxl_gc9a01 =
    WITH_COMMANDS(fxl_display_colour, gc9a01_commands, 240, 240, 240, 240, 0, 0x48, true);

/* Voltages, clocks and the order of the scan. Its data sheet describes the registers behind the
 * lock in part; all public drivers set these so. */
static const uint8_t gc9107_commands[] = {
    1,    0xFE, /* unlock those below: first half */
    1,    0xEF, /* second half */
    2,    0xB0, 0xC0, 2,    0xB2, 0x2F, 2,    0xB3, 0x03, 2,    0xB6, 0x19, 2,    0xB7, 0x01, 2,
    0xAC, 0xCB, 2,    0xAB, 0x0E, 2,    0xB4, 0x04, 2,    0xA8, 0x19, 2,    0xB8, 0x08, 2,    0xE8,
    0x24, 2,    0xE9, 0x48, 2,    0xEA, 0x22, 2,    0xC6, 0x30, 2,    0xC7, 0x18, 0,
};
const fxl_display_driver fxl_gc9107 =
    WITH_COMMANDS(fxl_display_colour, gc9107_commands, 128, 160, 128, 160, 0, 0x08, false);

/* --- controllers: OLEDs of windows --------------------------------------------------------------
 */

static const uint8_t ssd1351_commands[] = {
    2, 0xFD, 0x12,             /* unlock */
    2, 0xFD, 0xB1,             /* unlock the commands below */
    1, 0xAE,                   /* off */
    2, 0xB3, 0xF1,             /* clock: the fastest, divided by 2 */
    2, 0xB5, 0x00,             /* pins are not used */
    2, 0xAB, 0x01,             /* its own voltage regulator on */
    2, 0xB1, 0x32,             /* lengths of discharge and precharge */
    2, 0xBE, 0x05,             /* voltage of a row at rest */
    4, 0xC1, 0xC8, 0x80, 0xC8, /* contrast of each colour */
    2, 0xC7, 0x0F,             /* and of all: the highest */
    4, 0xB4, 0xA0, 0xB5, 0x55, /* low voltage from outside */
    2, 0xB6, 0x01,             /* second precharge */
    0,
};
/* Bits 6, 5 and 2: 16 bits a pixel, odd and even rows on two sides, red in the upper bits. */
const fxl_display_driver fxl_ssd1351 =
    WITH_COMMANDS(fxl_display_ssd1351, ssd1351_commands, 128, 128, 128, 128, 0, 0x74, false);

static const uint8_t ssd1331_commands[] = {
    1, 0xAE,                                     /* off */
    2, 0xAD, 0x8E,                               /* voltage from outside */
    2, 0xB0, 0x0B,                               /* power save off */
    2, 0xB1, 0x31,                               /* lengths of discharge and precharge */
    2, 0xB3, 0xF0,                               /* clock: the fastest */
    2, 0x8A, 0x64, 2, 0x8B, 0x78, 2, 0x8C, 0x64, /* second precharge of each colour */
    2, 0xBB, 0x3A,                               /* voltage of the precharge */
    2, 0xBE, 0x3E,                               /* voltage of a row at rest */
    2, 0x87, 0x06,                               /* current of all colours */
    2, 0x81, 0x91, 2, 0x82, 0x50, 2, 0x83, 0x7D, /* contrast of each colour */
    0,
};
/* Bits 6, 5, 4 and 1: 16 bits a pixel, odd and even rows on two sides, mounted upside down. */
const fxl_display_driver fxl_ssd1331 =
    WITH_COMMANDS(fxl_display_ssd1331, ssd1331_commands, 96, 64, 96, 64, 0, 0x72, false);

static const uint8_t ssd1327_commands[] = {
    2, 0xFD, 0x12, /* unlock */
    1, 0xAE,       /* off */
    2, 0xAB, 0x01, /* its own voltage regulator on */
    2, 0x81, 0x80, /* contrast: the middle */
    2, 0xB1, 0x51, /* lengths of discharge and precharge */
    2, 0xB3, 0x01, /* clock, divided by 2 */
    1, 0xB9,       /* levels are linear */
    2, 0xBC, 0x08, /* voltage of the precharge */
    2, 0xBE, 0x07, /* voltage of a row at rest: the highest */
    2, 0xB6, 0x01, /* length of the second precharge */
    2, 0xD5, 0x62, /* which is on */
    0,
};
/* Bits 6, 4 and 0: odd and even rows on two sides, mounted upside down. */
const fxl_display_driver fxl_ssd1327 =
    WITH_COMMANDS(fxl_display_ssd1327, ssd1327_commands, 128, 128, 128, 128, 0, 0x51, false);

static const uint8_t ssd1322_commands[] = {
    2, 0xFD, 0x12,       /* unlock */
    1, 0xAE,             /* off */
    2, 0xB3, 0x91,       /* clock, divided by 2 */
    2, 0xAB, 0x01,       /* its own voltage regulator on */
    3, 0xB4, 0xA0, 0xFD, /* low voltage from outside, low levels enhanced */
    2, 0xC1, 0x9F,       /* contrast */
    2, 0xC7, 0x0F,       /* current: the highest */
    1, 0xB9,             /* levels are linear */
    2, 0xB1, 0xE2,       /* lengths of discharge and precharge */
    3, 0xD1, 0xA2, 0x20, /* no second enhancement */
    2, 0xBB, 0x1F,       /* voltage of the precharge */
    2, 0xB6, 0x08,       /* length of the second precharge */
    2, 0xBE, 0x07,       /* voltage of a row at rest: the highest */
    1, 0xA9,             /* all rows */
    0,
};
/* Bits 4 and 2: its first row at the bottom, the left one of two pixels in the upper bits. */
const fxl_display_driver fxl_ssd1322 =
    WITH_COMMANDS(fxl_display_ssd1322, ssd1322_commands, 480, 128, 256, 64, 112, 0x14, false);

/* --- controllers of pages -----------------------------------------------------------------------
 */

static const uint8_t sh1106_commands[] = {
    0xAD, 0x8B, /* its own voltage converter on */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a row at rest: as after reset */
};
/* The glass is joined to the middle 128 of 132 columns. */
const fxl_display_driver fxl_sh1106 =
    WITH_COMMANDS(fxl_display_pages, sh1106_commands, 132, 64, 128, 64, 2, 0x09, false);

static const uint8_t ssd1306_commands[] = {
    0x20, 0x02, /* page addressing */
    0x8D, 0x14, /* its own charge pump on */
    0xD9, 0xF1, /* lengths of precharge and discharge, for the charge pump */
    0xDB, 0x40, /* voltage of a row at rest */
};
const fxl_display_driver fxl_ssd1306 =
    WITH_COMMANDS(fxl_display_pages, ssd1306_commands, 128, 64, 128, 64, 0, 0x09, false);

static const uint8_t ssd1309_commands[] = {
    0xFD, 0x12, /* unlock */
    0x20, 0x02, /* page addressing */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x34, /* voltage of a row at rest: as after reset */
};
const fxl_display_driver fxl_ssd1309 =
    WITH_COMMANDS(fxl_display_pages, ssd1309_commands, 128, 64, 128, 64, 0, 0x09, false);
const fxl_display_driver fxl_ssd1309_132 =
    WITH_COMMANDS(fxl_display_pages, ssd1309_commands, 132, 64, 128, 64, 2, 0x09, false);

static const uint8_t sh1107_commands[] = {
    0x20,       /* page addressing */
    0xDC, 0x00, /* not scrolled */
    0xD5, 0x50, /* clock: as after reset */
    0xAD, 0x8A, /* its own voltage converter off: modules have another */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a column at rest: as after reset */
};
const fxl_display_driver fxl_sh1107 = {&fxl_display_sh1107,
                                       sh1107_commands,
                                       sizeof sh1107_commands,
                                       128,
                                       128,
                                       128,
                                       128,
                                       0,
                                       0x00,
                                       false,
                                       true};

static const uint8_t st7565_commands[] = {
    0xA2,       /* bias 1/9 */
    0x2F,       /* its own booster, regulator and follower on */
    0xF8, 0x00, /* booster: four times */
    0x27,       /* ratio of the regulator: the highest */
    0x81, 0x18, /* contrast */
};
/* Dark where a bit is set. The glass is joined to the first 128 of 132 columns, as they are counted
 * from the last one. */
const fxl_display_driver fxl_st7565 =
    WITH_COMMANDS(fxl_display_st7565, st7565_commands, 132, 64, 128, 64, 0, 0x01, true);

static const uint8_t pcd8544_commands[] = {
    0x21, /* the commands below */
    0x06, /* temperature coefficient 2 */
    0x13, /* bias of 48 rows */
    0xC0, /* voltage: the middle */
};
/* Dark where a bit is set. It mirrors neither columns nor rows. */
const fxl_display_driver fxl_pcd8544 =
    WITH_COMMANDS(fxl_display_pcd8544, pcd8544_commands, 84, 48, 84, 48, 0, 0x00, true);

/* --- memory LCDs --------------------------------------------------------------------------------
 */

const fxl_display_driver fxl_ls013b7dh03 =
    OF_COLOURS(fxl_display_memory_lcd, 128, 128, 128, 128, 0x00, false);
const fxl_display_driver fxl_ls027b7dh01 =
    OF_COLOURS(fxl_display_memory_lcd, 400, 240, 400, 240, 0x00, false);

/* --- modules ------------------------------------------------------------------------------------
 */

/* A module of windows or of whole rows. */
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
const fxl_display_module fxl_module_gc9107_128x128 =
    COLOURS(fxl_gc9107, 128, 128, 0, 32, 128, 160, 0x08, false);
const fxl_display_module fxl_module_ssd1351_128x128 =
    COLOURS(fxl_ssd1351, 128, 128, 0, 0, 128, 128, 0x74, false);
const fxl_display_module fxl_module_ssd1351_128x96 =
    COLOURS(fxl_ssd1351, 128, 96, 0, 0, 128, 96, 0x74, false);
const fxl_display_module fxl_module_ssd1331_96x64 =
    COLOURS(fxl_ssd1331, 96, 64, 0, 0, 96, 64, 0x72, false);
const fxl_display_module fxl_module_ssd1327_128x128 =
    COLOURS(fxl_ssd1327, 128, 128, 0, 0, 128, 128, 0x51, false);
const fxl_display_module fxl_module_ssd1327_96x96 = {&fxl_ssd1327, 96,    96, 16,   0, 128, 128,
                                                     0x51,         false, 0,  0x20, 0, NULL};
const fxl_display_module fxl_module_ssd1322_256x64 =
    COLOURS(fxl_ssd1322, 256, 64, 112, 0, 480, 128, 0x14, false);
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
const fxl_display_module fxl_module_st7565_128x64 =
    COLOURS(fxl_st7565, 128, 64, 0, 0, 132, 64, 0x01, true);
const fxl_display_module fxl_module_pcd8544_84x48 =
    COLOURS(fxl_pcd8544, 84, 48, 0, 0, 84, 48, 0x00, true);
const fxl_display_module fxl_module_ls013b7dh03_128x128 =
    COLOURS(fxl_ls013b7dh03, 128, 128, 0, 0, 128, 128, 0x00, false);
const fxl_display_module fxl_module_ls027b7dh01_400x240 =
    COLOURS(fxl_ls027b7dh01, 400, 240, 0, 0, 400, 240, 0x00, false);
