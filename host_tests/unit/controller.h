/* SPDX-License-Identifier: MIT */
/* Display controllers at the other end of the wires, after their data sheets: they take commands
 * and data, and say what the glass shows. Each byte that a controller does not know, or that comes
 * too early, fails the test. Data in the background is a transfer (transfer.h). */
#ifndef CONTROLLER_H
#define CONTROLLER_H

#include "fixel/display.h"
#include "transfer.h"

/* place driver: the list of drivers, and of controllers */
/* Every driver, in the order in which the fuzzer's inputs number them: a new one comes last. */
#define EVERY_DRIVER \
    { \
        &fxl_st7789, &fxl_ili9341, &fxl_st7735, &fxl_ssd1306, &fxl_sh1106, &fxl_st7796, \
            &fxl_gc9a01, &fxl_ssd1351, &fxl_ssd1309, &fxl_sh1107, &fxl_ssd1309_132, &fxl_ili9488, \
            &fxl_ssd1327, &fxl_st7565, &fxl_pcd8544, &fxl_ls013b7dh03, &fxl_ls027b7dh01, \
            &fxl_ssd1331, &fxl_gc9107, &fxl_ssd1322 \
    }

enum {
    CONTROLLER_ST7789,
    CONTROLLER_ILI9341,
    CONTROLLER_ST7735,
    CONTROLLER_ST7796,
    CONTROLLER_ILI9488,
    CONTROLLER_GC9A01,
    CONTROLLER_GC9107,
    CONTROLLER_SSD1306,
    CONTROLLER_SSD1309,
    CONTROLLER_SSD1309_132,
    CONTROLLER_SH1106,
    CONTROLLER_SH1107,
    CONTROLLER_ST7565,
    CONTROLLER_PCD8544,
    CONTROLLER_SSD1351,
    CONTROLLER_SSD1331,
    CONTROLLER_SSD1327,
    CONTROLLER_SSD1322,
    CONTROLLER_LS013B7DH03,
    CONTROLLER_LS027B7DH01,
    CONTROLLERS
};

/* What a model plays: the commands of MIPI, pages, or none: windows and rows have other tests. */
enum {
    PLAYS_MIPI = 1,
    PLAYS_PAGES,
    PLAYS_NONE
};

/* What the data sheet says of a controller, and how the glass of its common module is joined to it.
 */
typedef struct {
    const fxl_display_driver *driver;
    uint8_t plays;
    uint8_t page, address;  /* rows, and columns, that begin together */
    uint16_t columns, rows; /* of its memory */
    uint16_t width, height; /* of the glass */
    uint16_t left;          /* where the glass begins at turn 0 */
    uint8_t joined;         /* how: a sum of these */
} controller_facts;

enum {
    MIRRORS_X = 1,
    MIRRORS_Y = 2,
    MIRRORS_XY = 3,
    INVERTED = 4,
    BLUE_FIRST = 8
};

extern const controller_facts controllers[CONTROLLERS];

/* Bytes of memory that a model needs: the pixels of a part of the controller's memory, seen from
 * its first column and row on. */
#define CONTROLLER_MEMORY 6000

typedef struct {
    int kind;
    bool is_colour;
    uint16_t columns, rows; /* of the controller's memory */
    uint16_t kept_columns;  /* of these and of kept_rows the model keeps the pixels: */
    uint16_t kept_rows;     /* the memory of a small board holds no more */
    uint16_t first_column, first_row;
    bool has_reset, is_awake, is_on, is_inverted, is_charged;
    uint32_t paused; /* ms since it last changed between sleep and being awake */
    uint8_t command; /* the last one, whose arguments come */
    uint8_t arguments[10];
    uint32_t argument_count;
    uint8_t access, format;
    uint16_t range[2][2]; /* columns, rows: first, last */
    uint16_t x, y;        /* where the next pixel goes */
    uint32_t part;        /* 0, or 1 and behind it the first bytes of a pixel */
    uint8_t unlocks;      /* how many of FE and EF a GC9A01 got, in order */
    bool is_told_scan;    /* by B6 */
    uint32_t undescribed; /* bit 0: it got register 66; bit 1: 67 */
    uint8_t multiplex, wires, mode, reference;
    uint8_t function, bias, voltage;            /* of a PCD8544 */
    uint8_t offset, start_row, clock, contrast; /* of the glass; as somebody else left them */
    bool is_all_on;                             /* every pixel, whatever the memory has */
    uint8_t memory[CONTROLLER_MEMORY];
    transfer wire;
    uint32_t sends, refused; /* calls of send and start so far; the one that fails */
} controller;

/* Power comes: the memory holds noise. The model keeps a window of the glass. The memory of a
 * controller of colours is that of its common glass: straps have chosen it. */
void controller_start(controller *of, int kind, uint16_t first_column, uint16_t first_row,
                      uint16_t columns, uint16_t rows);

/* The module's straps choose a smaller memory, right after controller_start. */
void controller_strap(controller *of, uint16_t columns, uint16_t rows);

/* The functions of a port, with the controller as the user. */
bool controller_send(void *user, bool is_data, const uint8_t *bytes, size_t size);
bool controller_begin(void *user, const uint8_t *bytes, size_t size);
bool controller_wait(void *user);
void controller_pause(void *user, uint32_t milliseconds);

/* What the memory has in a column and row of the controller's own: 16 bits, or 0 and 1. */
uint32_t controller_pixel(const controller *of, uint16_t column, uint16_t row);

#endif
