/* SPDX-License-Identifier: MIT */
/* display_rows of docs/hello.md, for a program that leaves it to whoever runs it: then the rows are
 * as the program shows them, with all that it drew over the band. */
#include "own.h"

const bool own_has_display_rows = true;

void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *pixels);

void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *pixels)
{
    own_show(first_row, rows, pixels, own_width());
}
