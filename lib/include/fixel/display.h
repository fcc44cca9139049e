/* SPDX-License-Identifier: MIT */
/* Drivers for displays of colours, of greys and of black and white. The caller gives the functions
 * that reach the wires of his chip. A display is where a pump sends its bands
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

/* A controller: one of the constant records at the end of this header, or one of the caller's
 * (fixel/driver.h). A program links those that it names. */
typedef struct fxl_display_driver fxl_display_driver;

/* A module as it is sold: its glass, given once. fxl_display_config_turned computes the rest for
 * each turn. Records of common modules are at the end of this header. */
typedef struct {
    const fxl_display_driver *driver;
    uint16_t width, height; /* of the glass, at turn 0 */
    uint16_t left, top;     /* where the glass begins in the controller's memory, at turn 0 */
    uint16_t columns, rows; /* of the controller's memory in the mode that the module is wired for;
                               at most those of the driver */
    uint8_t access;         /* at turn 0, which exchanges no rows and columns; see
                               fxl_display_config */
    bool is_inverted;

    /* Of an OLED; 0 for others. */
    uint8_t com_pins;       /* argument of command 0xDA; 0: 0x12 of more than 32 rows, else 0x02. An
                               SH1107 has none */
    uint8_t display_offset; /* argument of command 0xD3 at turn 0, of 0xA2 of an OLED of windows; at
                               turn 2 the rows of the memory, 64 or 128, minus that */
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
 *   columns x rows   of the controller's memory: see the end of this header
 *
 * Of those of pages top and height are multiples of 8. Of greys left and width are multiples of the
 * pixels that an address has: 2 of an SSD1327, 4 of an SSD1322. */
typedef struct {
    const fxl_display_driver *driver;
    uint16_t width, height; /* of the glass, as the viewer sees it; at least 1 */
    uint16_t left, top;     /* where the glass begins in the controller's memory, as seen */
    uint8_t access;         /* which way rows and columns run, in the controller's own bits: the
                               argument of command 0x36; of 0xA0 for an OLED of windows; of pages
                               bit 0 is that of 0xA0 and bit 3 that of 0xC0, which mirror the two
                               axes; 0 of a PCD8544 and of a memory LCD, which mirror none */
    bool is_inverted;       /* the glass shows true colours only when it is inverted */

    /* Of an OLED; 0 for others. */
    uint8_t com_pins;       /* argument of command 0xDA; 0: 0x12 of more than 32 rows, else 0x02. An
                               SH1107 has none */
    uint8_t display_offset; /* argument of command 0xD3, of 0xA2 of an OLED of windows */
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
 * height of the frame. sink.start and start_box send nothing and return false if the rows are none,
 * if rows or columns are not all within the frame, if `size` is not fxl_pixels_size of them, if the
 * first row is not the first one of a page, or if columns do not begin and end with an address. The
 * pump then answers FXL_E_DISPLAY. A memory LCD has no start_box. */
typedef struct fxl_display {
    const fxl_display_driver *driver;
    const fxl_display_port *port;
    uint16_t glass_width, glass_height, glass_left, glass_top; /* as the configuration has them */
    uint16_t left, top;   /* the frame's place in the controller's memory */
    uint16_t frame_width; /* pixels that a row of a frame has */
    uint16_t frame_height;
    uint8_t access;     /* as the configuration has it */
    uint8_t frame;      /* how many frames began, modulo 256: a memory LCD alternates so */
    fxl_pump_sink sink; /* sends to this display; see below */
    fxl_pixels pixels;  /* the palette in the display's format; last, so that the rest is near */
} fxl_display;

/* The configuration of a module whose picture is turned clockwise on the glass by 0 to 3 quarter
 * turns. The picture is upright for a viewer who turns the module counter-clockwise by as many.
 * On an axis that runs the other way than at turn 0, the glass begins at
 * memory - size - offset. A driver of pages or of greys turns by 0 and 2 only, a PCD8544 and a
 * memory LCD by 0 only. All is 0, driver too, if the
 * module has no such turn, has no driver, has a glass outside its memory, or exchanges rows and
 * columns at turn 0, and if the memory is larger than the driver's. fxl_display_open refuses that
 * configuration. */
fxl_display_config fxl_display_config_turned(const fxl_display_module *module,
                                             uint32_t quarter_turns);

/* The same for a common module of a controller. A square ST7789, for example, is not this module.
 */
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
 * rows above the middle; with greys, to a multiple of an address's pixels left of it. What is
 * around it stays black. width and height are those of the frame, in pixels, as the viewer sees it.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: width or height is 0, or larger than that of the glass.
 * With each of these statuses: *display untouched. */
fxl_status fxl_display_place(fxl_display *display, uint16_t width, uint16_t height);

/* Alternates the voltage of a memory LCD's glass, which must change once a second: a program that
 * sends boxes alone calls it, since only a frame that is sent from row 0 on alternates it. Waits
 * until nothing is being sent. The display is open.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: no memory LCD.
 * With each of these statuses: nothing is sent, *display untouched.
 * FXL_E_DISPLAY: a send failed. */
fxl_status fxl_display_alternate(fxl_display *display);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_display_reasons[];

/* --- controllers, and modules as they are sold --------------------------------------------------
 *
 * Constant records: a program links those that it names. None was tried on glass.
 * docs/displays.md, "Modules as they are sold", has a table of them: colours, SPI mode, clock, and
 * where the pins are at turn 0. */

/* place driver: its declaration, and those of its modules */
/* Of each controller the glass of its common module, the columns and rows of its memory, and the
 * pixels that it is sent. make run DRIVER= reads these lines. */
extern const fxl_display_driver fxl_st7789;      /* 240 x 320 of 240 x 320, RGB565 */
extern const fxl_display_driver fxl_ili9341;     /* 240 x 320 of 240 x 320, RGB565 */
extern const fxl_display_driver fxl_st7735;      /* 128 x 160 of 132 x 162, RGB565 */
extern const fxl_display_driver fxl_st7796;      /* 320 x 480 of 320 x 480, RGB565 */
extern const fxl_display_driver fxl_ili9488;     /* 320 x 480 of 320 x 480, three bytes a pixel */
extern const fxl_display_driver fxl_gc9a01;      /* 240 x 240 of 240 x 240, RGB565 */
extern const fxl_display_driver fxl_gc9107;      /* 128 x 160 of 128 x 160, RGB565 */
extern const fxl_display_driver fxl_ssd1351;     /* 128 x 128 of 128 x 128, RGB565 */
extern const fxl_display_driver fxl_ssd1331;     /* 96 x 64 of 96 x 64, RGB565 */
extern const fxl_display_driver fxl_ssd1327;     /* 128 x 128 of 128 x 128, 16 greys */
extern const fxl_display_driver fxl_ssd1322;     /* 256 x 64 of 480 x 128, 16 greys */
extern const fxl_display_driver fxl_ssd1306;     /* 128 x 64 of 128 x 64, pages of one bit */
extern const fxl_display_driver fxl_ssd1309;     /* 128 x 64 of 128 x 64, pages of one bit */
extern const fxl_display_driver fxl_ssd1309_132; /* 128 x 64 of 132 x 64, pages of one bit */
extern const fxl_display_driver fxl_sh1106;      /* 128 x 64 of 132 x 64, pages of one bit */
extern const fxl_display_driver fxl_sh1107;      /* 128 x 128 of 128 x 128, pages of one bit */
extern const fxl_display_driver fxl_st7565;      /* 128 x 64 of 132 x 64, pages of one bit */
extern const fxl_display_driver fxl_pcd8544;     /* 84 x 48 of 84 x 48, pages of one bit */
extern const fxl_display_driver fxl_ls013b7dh03; /* 128 x 128 of 128 x 128, rows of one bit */
extern const fxl_display_driver fxl_ls027b7dh01; /* 400 x 240 of 400 x 240, rows of one bit */

/* What fxl_display_config_turned takes. */
extern const fxl_display_module fxl_module_ili9341_240x320;          /* 2.4", 2.8" */
extern const fxl_display_module fxl_module_st7789_240x320;           /* 2.0" */
extern const fxl_display_module fxl_module_st7789_240x240;           /* 1.3", 1.54" */
extern const fxl_display_module fxl_module_st7789_135x240;           /* 1.14" */
extern const fxl_display_module fxl_module_st7789_172x320;           /* 1.47" */
extern const fxl_display_module fxl_module_st7789_170x320;           /* 1.9" */
extern const fxl_display_module fxl_module_st7789_240x280;           /* 1.69" */
extern const fxl_display_module fxl_module_st7735_128x160;           /* 1.8", black tab */
extern const fxl_display_module fxl_module_st7735_128x160_green;     /* 1.8", green tab */
extern const fxl_display_module fxl_module_st7735_128x128;           /* 1.44" */
extern const fxl_display_module fxl_module_st7735_128x128_row_32;    /* 1.44", another */
extern const fxl_display_module fxl_module_st7735_80x160;            /* 0.96" */
extern const fxl_display_module fxl_module_st7735_80x160_column_24;  /* 0.96", older */
extern const fxl_display_module fxl_module_st7796_320x480;           /* 3.5" */
extern const fxl_display_module fxl_module_st7796_222x480;           /* 2.33" */
extern const fxl_display_module fxl_module_ili9488_320x480;          /* 3.5" */
extern const fxl_display_module fxl_module_gc9a01_240x240;           /* 1.28", round */
extern const fxl_display_module fxl_module_gc9107_128x128;           /* 0.85" */
extern const fxl_display_module fxl_module_ssd1351_128x128;          /* 1.5" */
extern const fxl_display_module fxl_module_ssd1351_128x96;           /* 1.27" */
extern const fxl_display_module fxl_module_ssd1331_96x64;            /* 0.95" */
extern const fxl_display_module fxl_module_ssd1327_128x128;          /* 1.5" */
extern const fxl_display_module fxl_module_ssd1327_96x96;            /* 1.12" */
extern const fxl_display_module fxl_module_ssd1322_256x64;           /* 2.8", 3.12" */
extern const fxl_display_module fxl_module_ssd1306_128x64;           /* 0.96" */
extern const fxl_display_module fxl_module_ssd1306_128x64_com_02;    /* 0.96", another */
extern const fxl_display_module fxl_module_ssd1306_128x32;           /* 0.91" */
extern const fxl_display_module fxl_module_ssd1306_64x48;            /* 0.66" */
extern const fxl_display_module fxl_module_ssd1306_64x32;            /* 0.49" */
extern const fxl_display_module fxl_module_ssd1306_72x40;            /* 0.42" */
extern const fxl_display_module fxl_module_ssd1309_128x64;           /* 2.42" */
extern const fxl_display_module fxl_module_ssd1309_128x64_column_2;  /* 2.42", another */
extern const fxl_display_module fxl_module_sh1106_128x64;            /* 1.3" */
extern const fxl_display_module fxl_module_sh1106_72x40;             /* 0.42" */
extern const fxl_display_module fxl_module_sh1107_128x128;           /* 1.12" */
extern const fxl_display_module fxl_module_sh1107_128x128_column_96; /* 1.12", another */
extern const fxl_display_module fxl_module_sh1107_64x128;            /* 1.3", upright */
extern const fxl_display_module fxl_module_sh1107_80x128;            /* 0.78", upright */
extern const fxl_display_module fxl_module_st7565_128x64;            /* 2.2" to 3.2", LCD */
extern const fxl_display_module fxl_module_pcd8544_84x48;            /* 1.6", LCD */
extern const fxl_display_module fxl_module_ls013b7dh03_128x128;      /* 1.28", memory LCD */
extern const fxl_display_module fxl_module_ls027b7dh01_400x240;      /* 2.7", memory LCD */

#ifdef __cplusplus
}
#endif

#endif
