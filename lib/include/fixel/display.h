/* SPDX-License-Identifier: MIT */
/* Drivers for displays: ST7789, ILI9341, ST7735, ST7796, GC9A01 and SSD1351 in 16 bits a pixel,
 * ILI9488 in 18; SSD1306, SSD1309, SH1106 and SH1107 in black and white. The caller gives the
 * functions that reach the wires of his chip. A display is where a pump sends its bands
 * (fixel/pump.h). docs/displays.md shows a whole program.
 */
#ifndef FXL_DISPLAY_H
#define FXL_DISPLAY_H

#include "fixel/pump.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The wires to a display: functions of the caller's. Each returns false where it failed. The caller
 * sets the pins and the clock up, and resets the display, before fxl_display_open. */
typedef struct {
    void *user; /* handed to all functions */

    /* Sends bytes, and returns when they are sent. SPI, mode 0, or mode 3 for a module without a CS
     * pin: with the D/C line low for a command and high for data. I2C: in one message, after a byte
     * 0x00 for commands or 0x40 for data. */
    bool (*send)(void *user, bool is_data, const uint8_t *bytes, size_t size);

    /* Begins to send data as send does, by DMA say, and returns at once. May be null: then send is
     * used. The bytes stay as they are until wait has returned. */
    bool (*start)(void *user, const uint8_t *bytes, size_t size);

    /* Returns when nothing is being sent. Null where start is. */
    bool (*wait)(void *user);

    /* Returns after so many milliseconds, or later. */
    void (*pause)(void *user, uint32_t milliseconds);
} fxl_display_port;

/* A controller: one of the constant records below, or one of the caller's
 * (fixel/driver.h). A program links those that it names. */
typedef struct fxl_display_driver fxl_display_driver;

/* place driver: its declaration, the table of memories, names of controllers */
extern const fxl_display_driver fxl_st7789;      /* 240 x 320, RGB565 */
extern const fxl_display_driver fxl_ili9341;     /* 240 x 320, RGB565 */
extern const fxl_display_driver fxl_st7735;      /* 128 x 160, RGB565 */
extern const fxl_display_driver fxl_st7796;      /* 320 x 480, RGB565 */
extern const fxl_display_driver fxl_ili9488;     /* 320 x 480, three bytes a pixel */
extern const fxl_display_driver fxl_gc9a01;      /* 240 x 240, RGB565 */
extern const fxl_display_driver fxl_ssd1351;     /* 128 x 128, RGB565 */
extern const fxl_display_driver fxl_ssd1306;     /* 128 x 64, black and white */
extern const fxl_display_driver fxl_ssd1309;     /* 128 x 64, black and white */
extern const fxl_display_driver fxl_ssd1309_132; /* the same with a memory of 132 columns */
extern const fxl_display_driver fxl_sh1106;      /* 128 x 64, black and white */
extern const fxl_display_driver fxl_sh1107;      /* 128 x 128, black and white */

/* A module as it is sold: its glass, given once. fxl_display_config_turned computes the rest for
 * each turn. fixel/modules.h has records of common modules. */
typedef struct {
    const fxl_display_driver *driver;
    uint16_t width, height; /* of the glass, at turn 0 */
    uint16_t left, top;     /* where the glass begins in the controller's memory, at turn 0 */
    uint16_t columns, rows; /* of the controller's memory in the mode that the module is wired for;
                               at most those of the driver */
    uint8_t access;         /* at turn 0, which exchanges no rows and columns; see
                               fxl_display_config */
    bool is_inverted;

    /* Of a controller of pages; 0 for those of colours. */
    uint8_t com_pins;       /* argument of command 0xDA; 0: 0x12 of more than 32 rows, else 0x02. An
                               SH1107 has none */
    uint8_t display_offset; /* argument of command 0xD3 at turn 0; at turn 2 the rows of the memory,
                               64 or 128, minus that */
    /* Argument of command 0xAD: the reference current of an SSD1306, the voltage converter of an
     * SH1106; 0: as the driver has it. Others have no such command. */
    uint8_t current_reference;

    /* Commands of the caller's, after those of the driver and before the glass is turned on: for
     * each of them the number of its bytes, the command, and its arguments; a 0 ends them. They
     * stay the caller's. Null for none. */
    const uint8_t *extra_commands;
} fxl_display_module;

/* How a program talks to a module at one turn. fxl_display_config_turned and
 * fxl_display_config_default make one. The glass must lie in the controller's memory:
 * left + width <= columns and top + height <= rows. An access that exchanges rows and columns
 * exchanges these limits too.
 *
 *   columns x rows   ST7789, ILI9341   240 x 320
 *                    ST7735            132 x 162
 *                    ST7796, ILI9488   320 x 480
 *                    GC9A01            240 x 240
 *                    SSD1351           128 x 128
 *                    SSD1306, SSD1309  128 x 64
 *                    SH1106            132 x 64, and fxl_ssd1309_132
 *                    SH1107            128 x 128
 *
 * Of those of pages top and height are multiples of 8. */
typedef struct {
    const fxl_display_driver *driver;
    uint16_t width, height; /* of the glass, as the viewer sees it; at least 1 */
    uint16_t left, top;     /* where the glass begins in the controller's memory, as seen */
    uint8_t access;         /* which way rows and columns run, in the controller's own bits: the
                               argument of command 0x36; of 0xA0 for SSD1351; of pages bit 0 is
                               that of 0xA0 and bit 3 that of 0xC0, which mirror the two axes */
    bool is_inverted;       /* the glass shows true colours only when it is inverted */

    /* Of a controller of pages; 0 for those of colours. */
    uint8_t com_pins;       /* argument of command 0xDA; 0: 0x12 of more than 32 rows, else 0x02. An
                               SH1107 has none */
    uint8_t display_offset; /* argument of command 0xD3 */
    /* Argument of command 0xAD: the reference current of an SSD1306, the voltage converter of an
     * SH1106; 0: as the driver has it. Others have no such command. */
    uint8_t current_reference;

    /* Commands of the caller's, after those of the driver and before the glass is turned on: for
     * each of them the number of its bytes, the command, and its arguments; a 0 ends them. They
     * stay the caller's. Null for none. */
    const uint8_t *extra_commands;
} fxl_display_config;

/* An open display, which the caller owns. It may not be moved: sink and pixels are used in place.
 * Members are for reading only.
 *
 * A pump of this sink must have the width of the frame and the display's pixels, and at most the
 * height of the frame. sink.start sends nothing and returns false if the rows are none or not all
 * within the frame, if `size` is not fxl_pixels_size(pixels.format, frame_width, rows), or if the
 * first row is not the first one of a page. The pump then answers FXL_E_DISPLAY. */
typedef struct fxl_display {
    const fxl_display_driver *driver;
    const fxl_display_port *port;
    uint16_t glass_width, glass_height, glass_left, glass_top; /* as the configuration has them */
    uint16_t left, top;   /* the frame's place in the controller's memory */
    uint16_t frame_width; /* pixels that a row of a frame has */
    uint16_t frame_height;
    uint8_t access;     /* as the configuration has it */
    fxl_pump_sink sink; /* sends to this display; see below */
    fxl_pixels pixels;  /* the palette in the display's format; last, so that the rest is near */
} fxl_display;

/* The configuration of a module whose picture is turned clockwise on the glass by 0 to 3 quarter
 * turns. The picture is upright for a viewer who turns the module counter-clockwise by as many.
 * On an axis that runs the other way than at turn 0, the glass begins at
 * memory - size - offset. A driver of pages turns by 0 and 2 only. All is 0, driver too, if the
 * module has no such turn, has no driver, has a glass outside its memory, or exchanges rows and
 * columns at turn 0, and if the memory is larger than the driver's. fxl_display_open refuses that
 * configuration. */
fxl_display_config fxl_display_config_turned(const fxl_display_module *module,
                                             uint32_t quarter_turns);

/* The same for a common module of a controller. A square ST7789, for example, is not this module:
 * see fixel/modules.h. */
fxl_display_config fxl_display_config_default(const fxl_display_driver *driver,
                                              uint32_t quarter_turns);

/* Wakes the controller up, sets it up, makes the glass black and turns it on. palette is 256 x red,
 * green, blue, a byte each, and is only read. The display keeps the pointer to the port. The frame
 * fills the glass. Takes some 300 ms.
 * FXL_E_ARGUMENT: a null pointer; a port without send or pause, or with start and no wait.
 * FXL_E_RANGE: no driver, or the glass is not in the controller's memory: fxl_display_config.
 * With each of these statuses: nothing was sent, *display untouched.
 * FXL_E_DISPLAY: a send failed; the display cannot be used until it is opened. */
fxl_status fxl_display_open(fxl_display *display, const fxl_display_config *config,
                            const fxl_display_port *port, const uint8_t *palette);

/* Puts a frame that is smaller than the glass into its middle; with pages, to a multiple of eight
 * rows above the middle. What is around it stays black. width and height are those of the frame, in
 * pixels, as the viewer sees it.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: width or height is 0, or larger than that of the glass.
 * With each of these statuses: *display untouched. */
fxl_status fxl_display_place(fxl_display *display, uint16_t width, uint16_t height);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_display_reasons[];

#ifdef __cplusplus
}
#endif

#endif
