/* SPDX-License-Identifier: MIT */
/* Runs the first program (examples/cube/main.c, or that of docs/hello.md) and hands out its
 * picture: the pixels on the host's stdout, or on a board their CRC-32 as text. EXAMPLE is the
 * program's file. The linker's --wrap=main puts this file's function between the start and the
 * program's main. With EXAMPLE_PALETTE the program has a palette of its own, which comes first:
 * EXAMPLE_PALETTE is its name. With EXAMPLE_FRAMES it shows so many frames, of which the last is its picture; with
 * EXAMPLE_BANDED it shows them by display_rows, to its own end; with EXAMPLE_BOXES it draws boxes of frames of SIDE x SIDE, with
 * --wrap for fxl_frame_begin and fxl_frame_draw; with EXAMPLE_PUMPED it sends such frames by its pump, with --wrap for
 * fxl_pump_send. EXAMPLE_PIXEL is the type of its pixels, if that is not a byte. */
#include EXAMPLE

#ifdef __cplusplus
extern "C" {
#endif
int __real_main(void);
int __wrap_main(int argc, char **argv);
#ifdef __cplusplus
}
#endif

#ifndef EXAMPLE_PIXEL
#define EXAMPLE_PIXEL uint8_t
#endif

#ifdef EXAMPLE_BANDED
#include <string.h>

static uint8_t frame[HEIGHT][WIDTH];

void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *shown)
{
    static int begun;
    begun += first_row == 0;
    if (begun == EXAMPLE_FRAMES) {
        memcpy(frame[first_row], shown, (size_t)rows * WIDTH);
    }
}

#define EXAMPLE_PICTURE frame
#elif defined(EXAMPLE_BOXES)
#include "../../../firmware/own/no_wires.c"

static uint8_t frame[SIDE][SIDE];
static int begun;

fxl_status __real_fxl_frame_begin(fxl_renderer *of, const fxl_pose *eye);
fxl_status __wrap_fxl_frame_begin(fxl_renderer *of, const fxl_pose *eye);
fxl_status __real_fxl_frame_draw(fxl_renderer *of, const fxl_band *band);
fxl_status __wrap_fxl_frame_draw(fxl_renderer *of, const fxl_band *band);

fxl_status __wrap_fxl_frame_begin(fxl_renderer *of, const fxl_pose *eye)
{
    begun++;
    return __real_fxl_frame_begin(of, eye);
}

fxl_status __wrap_fxl_frame_draw(fxl_renderer *of, const fxl_band *band)
{
    const fxl_status status = __real_fxl_frame_draw(of, band);
    const uint32_t columns = band->columns != 0 ? band->columns : band->width;

    for (uint32_t row = 0; row < band->rows && begun <= EXAMPLE_FRAMES; row++) {
        for (uint32_t column = 0; column < columns; column++) {
            frame[band->first_row + row][band->first_column + column] =
                band->pixels[row * band->stride + column];
        }
    }
    return status;
}

#define EXAMPLE_PICTURE frame
#elif defined(EXAMPLE_PUMPED)
#include <string.h>

#include "../../../firmware/own/no_wires.c"

static uint8_t frame[SIDE][SIDE];

fxl_status __real_fxl_pump_send(fxl_pump *of);
fxl_status __wrap_fxl_pump_send(fxl_pump *of);

fxl_status __wrap_fxl_pump_send(fxl_pump *of)
{
    static int begun;
    const fxl_band *band = fxl_pump_band(of);

    begun += band->first_row == 0;
    if (begun == EXAMPLE_FRAMES) {
        memcpy(frame[band->first_row], band->pixels, (size_t)band->rows * SIDE);
    }
    return __real_fxl_pump_send(of);
}

#define EXAMPLE_PICTURE frame
#elif defined(EXAMPLE_FRAMES)
int show(const EXAMPLE_PIXEL *shown_frame)
{
    static int shown;
    (void)shown_frame;
    return ++shown == EXAMPLE_FRAMES;
}
#endif

#ifndef EXAMPLE_PICTURE
#define EXAMPLE_PICTURE pixels
#endif

#ifdef EXAMPLE_ON_BOARD
#include "contract/system.h"

/* IEEE 802.3, as zlib's crc32. */
static uint32_t crc32_of(const uint8_t *bytes, uint32_t size)
{
    uint32_t crc = 0xFFFFFFFFu;

    for (uint32_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1u)));
        }
    }
    return ~crc;
}

int __wrap_main(int argc, char **argv)
{
    char text[] = "crc 00000000\n";

    system_start(argc, argv);
    if (__real_main() != 0) {
        system_exit(SYSTEM_EXIT_RENDER);
    }
    uint32_t crc = crc32_of((const uint8_t *)EXAMPLE_PICTURE[0], sizeof EXAMPLE_PICTURE);
    for (int digit = 11; digit >= 4; digit--, crc >>= 4) {
        text[digit] = "0123456789abcdef"[crc & 15u];
    }
    system_text(text);
    system_exit(SYSTEM_EXIT_DONE);
    return 0; /* not reached */
}
#else
#include <stdio.h>

int __wrap_main(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    if (__real_main() != 0) {
        return 1;
    }
#ifdef EXAMPLE_PALETTE
    if (fwrite(EXAMPLE_PALETTE, 1, sizeof EXAMPLE_PALETTE, stdout) != sizeof EXAMPLE_PALETTE) {
        return 2;
    }
#endif
    return fwrite(EXAMPLE_PICTURE, 1, sizeof EXAMPLE_PICTURE, stdout) == sizeof EXAMPLE_PICTURE ? 0
                                                                                                : 2;
}
#endif
