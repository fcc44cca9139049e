/* SPDX-License-Identifier: MIT */
/* wires.h where no real display hangs on the board: all that is sent goes into a record. */
#include <stddef.h>

#include "parts/wires.h"

/* The kinds of docs/formats.md, section 5. */
enum {
    COMMAND = 'C',
    DATA = 'D',
    PAUSE = 'P',
    FRAME_END = 'F'
};

static struct {
    const uint8_t *bytes; /* null: nothing is being sent */
    size_t size;
} transfer;
static bool pause_is_noted;

static void put_u32(uint8_t to[4], uint32_t value)
{
    to[0] = (uint8_t)value;
    to[1] = (uint8_t)(value >> 8);
    to[2] = (uint8_t)(value >> 16);
    to[3] = (uint8_t)(value >> 24);
}

static bool put(uint8_t kind, const uint8_t *bytes, size_t size)
{
    uint8_t head[5] = {kind, 0, 0, 0, 0};

    put_u32(head + 1, (uint32_t)size);
    return record_write(head, sizeof head) && record_write(bytes, size);
}

static bool put_number(uint8_t kind, uint32_t number)
{
    uint8_t bytes[4];

    put_u32(bytes, number);
    return put(kind, bytes, sizeof bytes);
}

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user;
    return transfer.bytes == NULL && put(is_data ? DATA : COMMAND, bytes, size);
}

/* As unkind as DMA may be: it reads every byte at the last moment, in wait. */
static bool start(void *user, const uint8_t *bytes, size_t size)
{
    const bool is_free = transfer.bytes == NULL;

    (void)user;
    transfer.bytes = bytes;
    transfer.size = size;
    return is_free;
}

static bool wait(void *user)
{
    const uint8_t *bytes = transfer.bytes;

    (void)user;
    transfer.bytes = NULL;
    return bytes == NULL || put(DATA, bytes, transfer.size);
}

static void pause(void *user, uint32_t milliseconds)
{
    (void)user;
    pause_is_noted = put_number(PAUSE, milliseconds) && pause_is_noted;
}

const fxl_display_port wires_port = {NULL, send, start, wait, pause};

bool wires_open(void)
{
    transfer.bytes = NULL;
    pause_is_noted = true;
    return record_open();
}

bool wires_end_frame(uint32_t number)
{
    return pause_is_noted && put_number(FRAME_END, number);
}

bool wires_close(void)
{
    return record_close() && pause_is_noted;
}
