/* SPDX-License-Identifier: MIT */
/* The pictures of a program of your own (make run PROGRAM=my.c). The program draws as it would in
 * your firmware and names nothing of this. The linker's --wrap puts the functions of own.c between
 * it and the library, and between the start of the board and its main. Internal. */
#ifndef OWN_H
#define OWN_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/render.h"

/* Whether the program has display_rows of show_rows.c. Null where it has not: the linker takes
 * show_rows.c only for a program that calls display_rows and does not define it. */
extern const bool own_has_display_rows __attribute__((weak));

/* 256 x red, green, blue: greys. The program that make flash writes has the palette of its exported scene
 * here (firmware.mk); in other programs the tools find that. */
extern const uint8_t own_colours[768] __attribute__((weak));

/* Shows rows of the frame that is drawn. A frame begins with row 0, its rows go downward, and it
 * ends with the last row of the lens. The format is that of the band that was drawn last. Ends the
 * program where the rows do not go downward, where they come before anything was drawn, and where
 * the dump cannot be written. */
void own_show(uint16_t first_row, uint16_t rows, const void *pixels, uint16_t stride);

/* Pixels of a row of the band that was drawn last. */
uint16_t own_width(void);

/* For a program that is watched, on this machine alone: watched.c. Null on other boards. */

/* Takes the viewer's argument, if there is one. Returns how many are left for the board. */
int own_arguments(int argc, char **argv) __attribute__((weak));

/* The last rows of a frame are drawn: keeps the frame for questions about its pixels until another
 * one is kept. The program may change renderer and scene meanwhile. */
void own_keep(fxl_renderer *renderer) __attribute__((weak));

/* A frame is shown: answers questions about it until the viewer wants the next frame. Ends the
 * program where the viewer has ended. */
void own_wait(void) __attribute__((weak));

#endif
