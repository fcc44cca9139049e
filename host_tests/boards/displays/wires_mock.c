/* SPDX-License-Identifier: MIT */
/* The wires of docs/displays.md and docs/hello.md with a file at their other end: for each stretch
 * of bytes "D" or "C" (the D/C line), their number in four bytes, and the bytes; for a pause "P".
 * DMA is as unkind as the contract allows: as LATE says, it reads all of the bytes at the last
 * moment, or at the first. */
#include "wires_mock.h"

#include <stdio.h>
#include <stdlib.h>

#include "fixel/display.h"

#ifndef LATE
#define LATE 1
#endif

extern const fxl_display_port wires;
bool wires_open(void);

static FILE *file;
static const uint8_t *under_way;
static size_t under_way_size;

static void demand(bool what, const char *sentence)
{
    if (!what) {
        fprintf(stderr, "wires: %s\n", sentence);
        abort();
    }
}

static void put(char kind, const uint8_t *bytes, size_t size)
{
    const uint8_t head[5] = {(uint8_t)kind, (uint8_t)size, (uint8_t)(size >> 8),
                             (uint8_t)(size >> 16), (uint8_t)(size >> 24)};

    demand(file != NULL, "used before they were opened");
    demand(fwrite(head, 1, sizeof head, file) == sizeof head &&
               fwrite(bytes, 1, size, file) == size,
           "cannot write");
}

bool wires_open(void)
{
    file = fopen("wires.bin", "wb");
    return file != NULL;
}

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    demand(under_way == NULL, "used while DMA sends");
    put(is_data ? 'D' : 'C', bytes, size);
    return true;
}

static bool start(void *user, const uint8_t *bytes, size_t size)
{
    (void)user;
    demand(under_way == NULL, "a second DMA while the first sends");
    under_way = bytes;
    under_way_size = size;
    if (!LATE) {
        put('D', bytes, size);
    }
    return true;
}

static bool wait(void *user)
{
    (void)user;
    if (under_way != NULL && LATE) {
        put('D', under_way, under_way_size);
    }
    under_way = NULL;
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    const uint8_t bytes[4] = {(uint8_t)milliseconds, (uint8_t)(milliseconds >> 8)};

    (void)user;
    put('P', bytes, sizeof bytes);
}

const fxl_display_port wires = {NULL, send, start, wait, pause};

void wires_mock_end(void)
{
    demand(under_way == NULL, "DMA still sends after close");
    demand(file == NULL || fclose(file) == 0, "cannot write");
}
