/* SPDX-License-Identifier: MIT */
/* spi.h of docs/displays.md with a file at the other end of the wires: for each
 * stretch of bytes "D" or "C" (the D/C line), their number in four bytes, and
 * the bytes. DMA is as unkind as the contract allows: as LATE says, it reads all
 * of the bytes at the last moment, or at the first. */
#include "spi.h"

#include <stdio.h>
#include <stdlib.h>

#include "spi_mock.h"

#ifndef LATE
#define LATE 1
#endif

static FILE *wires;
static bool is_data, is_sending;
static const uint8_t *under_way;
static size_t under_way_size;

static void demand(bool what, const char *sentence)
{
    if (!what) {
        fprintf(stderr, "spi: %s\n", sentence);
        abort();
    }
}

static void put(char kind, const uint8_t *bytes, size_t size)
{
    const uint8_t head[5] = {(uint8_t)kind, (uint8_t)size, (uint8_t)(size >> 8),
                             (uint8_t)(size >> 16), (uint8_t)(size >> 24)};

    demand(wires != NULL, "used before it was opened");
    demand(fwrite(head, 1, sizeof head, wires) == sizeof head &&
               fwrite(bytes, 1, size, wires) == size,
           "cannot write");
}

void spi_open(void)
{
    wires = fopen("wires.bin", "wb");
}

void spi_data(bool data)
{
    demand(!is_sending, "D/C changed while DMA sends");
    is_data = data;
}

void spi_send(const uint8_t *bytes, size_t size)
{
    demand(!is_sending, "used while DMA sends");
    put(is_data ? 'D' : 'C', bytes, size);
}

void spi_send_start(const uint8_t *bytes, size_t size)
{
    demand(!is_sending, "a second DMA while the first sends");
    is_sending = true;
    under_way = bytes;
    under_way_size = size;
    if (!LATE) {
        put(is_data ? 'D' : 'C', bytes, size);
    }
}

void spi_send_wait(void)
{
    if (is_sending && LATE) {
        put(is_data ? 'D' : 'C', under_way, under_way_size);
    }
    is_sending = false;
}

void spi_pause(uint32_t milliseconds)
{
    const uint8_t bytes[4] = {(uint8_t)milliseconds, (uint8_t)(milliseconds >> 8)};

    put('P', bytes, sizeof bytes);
}

void spi_mock_end(void)
{
    demand(!is_sending, "DMA still sends after close");
    demand(wires == NULL || fclose(wires) == 0, "cannot write");
}
