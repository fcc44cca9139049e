/* SPDX-License-Identifier: MIT */
/* The record of a driver, for programs that bring their own: the functions of a family of
 * controllers, and the constants of one of them. docs/displays.md, "A driver of your own", has an
 * example. Programs that use the library's drivers need display.h only. */
#ifndef FXL_DRIVER_H
#define FXL_DRIVER_H

#include "fixel/display.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Functions that the controllers of a family share. */
typedef struct {
    const fxl_pixel_format *format;

    /* From reset to a display that is set up as `config` says, and still off. */
    bool (*set_up)(const fxl_display *display, const fxl_display_config *config);

    /* Sends converted rows to columns left.. and rows top.. of the controller's memory, `width`
     * columns wide. Columns and rows are counted as the viewer sees them, in display->access: on a
     * mirrored axis from its other end, and exchanged if the access says so. With pages, top is the
     * first row of one. left is the first column of an
     * address. Nothing is on its way when it is called.
     * The last piece of the rows may still be when it returns. */
    bool (*send_rows)(const fxl_display *display, uint16_t left, uint16_t top, uint16_t width,
                      uint16_t rows, const uint8_t *bytes, size_t size);

    /* Sends a command with its arguments, `size` bytes in all. */
    bool (*send_command)(const fxl_display *display, const uint8_t *command, size_t size);

    const uint8_t *turn_on; /* a list for fxl_display_send_commands, sent last */

    /* Bits of a configuration's access. Pages cannot exchange rows and columns: 0. A controller
     * that mirrors neither axis has 0 in all, and turns by 0 only. */
    uint8_t exchanges, mirrors_columns, mirrors_rows;

    uint8_t columns_less_1; /* of those that an address of the memory has, where windows begin: 1,
                               2, 4 or 8 */
    bool takes_whole_rows;  /* send_rows sends what is beside the columns as black */
} fxl_display_family;

struct fxl_display_driver {
    const fxl_display_family *family;
    /* Beyond what the family sends. Of colours: a list for fxl_display_send_commands, sent when the
     * controller is awake and before its format and access are set, and of OLEDs of windows. Of
     * pages: `commands_size` bytes, sent as they are. Null for none. */
    const uint8_t *commands;
    uint8_t commands_size;
    uint16_t memory_columns, memory_rows; /* of the controller, by its data sheet; not turned */
    uint16_t width, height;               /* of the glass, not turned */
    uint16_t left;                        /* columns of the memory before the glass at turn 0; of
                                             colours on each side of it */

    uint8_t access; /* of a common module at turn 0 */
    bool is_inverted;
    /* Of pages, what a half turn mirrors: the columns of the glass and the rows of the memory, or,
     * if false, the rows of the glass and the columns of the memory. */
    bool scans_columns;
};

extern const fxl_display_family fxl_display_colour;     /* commands of MIPI DCS, RGB565 */
extern const fxl_display_family fxl_display_colour_18;  /* the same with three bytes a pixel */
extern const fxl_display_family fxl_display_pages;      /* those of an SSD1306 */
extern const fxl_display_family fxl_display_sh1107;     /* pages too, whose columns are scanned */
extern const fxl_display_family fxl_display_st7565;     /* pages too, of an LCD */
extern const fxl_display_family fxl_display_pcd8544;    /* the same, with other commands */
extern const fxl_display_family fxl_display_ssd1351;    /* windows, RGB565 */
extern const fxl_display_family fxl_display_ssd1331;    /* the same, with arguments as commands */
extern const fxl_display_family fxl_display_ssd1327;    /* the same, with 16 greys */
extern const fxl_display_family fxl_display_ssd1322;    /* 16 greys, four pixels an address */
extern const fxl_display_family fxl_display_memory_lcd; /* whole rows, with the number of each */

/* Sends a command, and bytes of data that belong to it. */
bool fxl_display_command(const fxl_display *display, uint8_t code, const uint8_t *data,
                         size_t size);

/* Sends a list of commands by the family's send_command: for each the number of its bytes, the
 * command, and its arguments; a 0 ends the list. False as soon as one fails. */
bool fxl_display_send_commands(const fxl_display *display, const uint8_t *commands);

/* Begins to send data, or sends it where the port cannot do that. */
bool fxl_display_start_data(const fxl_display *display, const uint8_t *bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
