/* SPDX-License-Identifier: MIT */
/* show WIDTH HEIGHT ROWS BITS < palette and frames: shows frames of BITS bits a pixel on the board's
 * display, ROWS rows at a time, and draws over what it lent as soon as it has it
 * back. Exit: 0 shown, 1 refused, 2 not what was asked for. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contract/display.h"
#include "contract/journal.h"
#include "wires_mock.h"

static uint8_t palette[768], lent[2 * 1024 * 1024];

static bool show_frame(uint32_t number, uint16_t width, uint16_t height, uint16_t rows, uint8_t bits)
{
    static const fxl_pose pose;
    static const fxl_counters counters;
    uint16_t y;

    if (!journal_begin(number, &pose)) {
        return false;
    }
    for (y = 0; y < height; y = (uint16_t)(y + rows)) {
        const uint16_t count = rows < height - y ? rows : (uint16_t)(height - y);
        const size_t size = (size_t)width * count * bits / 8u;

        if (fread(lent, 1, size, stdin) != size || !display_flush(0, y, width, count, lent)) {
            return false;
        }
        memset(lent, 0xEE, size);
    }
    return journal_end(&counters, 0, 0);
}

int main(int argc, char **argv)
{
    const uint16_t width = (uint16_t)(argc == 5 ? atoi(argv[1]) : 0);
    const uint16_t height = (uint16_t)(argc == 5 ? atoi(argv[2]) : 0);
    const uint16_t rows = (uint16_t)(argc == 5 ? atoi(argv[3]) : 0);
    const uint8_t bits = (uint8_t)(argc == 5 ? atoi(argv[4]) : 0);
    bool good;

    if (width == 0 || height == 0 || rows == 0 ||
        fread(palette, 1, sizeof palette, stdin) != sizeof palette) {
        return 2;
    }
    if (!journal_open(2) || !display_open(width, height, bits, palette)) {
        return 1;
    }
    good = show_frame(0, width, height, rows, bits) && show_frame(1, width, height, rows, bits);
    good = display_close() && good;
    wires_mock_end();
    return good ? 0 : 1;
}
