/* SPDX-License-Identifier: MIT */
/* wires.h by SPI0 and channel 0 of the DMA. GPIO 22 changes its level at the end of each frame, for
 * a logic analyser; the emulator's runner numbers frames by it. The module is selected for each
 * command and for each run of data. */
#include <stddef.h>

#include "parts/wires.h"
#include "pico/rp2040.h"

#define SPI_CONTROL0 RP2040_REGISTER(RP2040_SPI0)
#define SPI_CONTROL1 RP2040_REGISTER(RP2040_SPI0 + 4u)
#define SPI_DATA     RP2040_REGISTER(RP2040_SPI0 + 8u)
#define SPI_STATUS   RP2040_REGISTER(RP2040_SPI0 + 0xCu)
#define SPI_PRESCALE RP2040_REGISTER(RP2040_SPI0 + 0x10u)
#define SPI_DMA      RP2040_REGISTER(RP2040_SPI0 + 0x24u)
#define SPI_HAS_ROOM (1u << 1)
#define SPI_IS_BUSY  (1u << 4)
#define SPI_QUEUE    9u /* bytes that have not left: 8 in the queue, one on the wire */

#define DMA_READ    RP2040_REGISTER(RP2040_DMA)
#define DMA_WRITE   RP2040_REGISTER(RP2040_DMA + 4u)
#define DMA_COUNT   RP2040_REGISTER(RP2040_DMA + 8u)
#define DMA_CONTROL RP2040_REGISTER(RP2040_DMA + 0xCu) /* written: starts */
#define DMA_IS_BUSY (1u << 24)
/* Bytes, from addresses that increase, when SPI0 has room (DREQ 16); on. No channel follows:
 * chained to itself. */
#define DMA_TO_SPI (16u << 15 | 1u << 4 | 1u)

/* GPIO numbers, and by what the clock of the peripherals is divided: digits alone, for the note. */
#define SELECT       17
#define CLOCK        18
#define DATA_OUT     19
#define DATA_COMMAND 20
#define RESET        21
#define FRAME        22
#define DIVISOR      2 /* 62.5 MHz */

#define TEXT_OF(macro) TEXT(macro)
#define TEXT(words)    #words

/* What make flash prints of the wiring: more of the lines of board_note.c. */
__attribute__((section(".fxl_board"), used)) static const char wires_note[] =
    "wires=CLK:" TEXT_OF(CLOCK) ",DIN:" TEXT_OF(DATA_OUT) ",CS:" TEXT_OF(SELECT) ",D/C:" TEXT_OF(DATA_COMMAND) ",RESET:" TEXT_OF(
        RESET) "\nclock=" TEXT_OF(RP2040_HZ) "\nspi_divisor=" TEXT_OF(DIVISOR) "\nuart=" TEXT_OF(RP2040_UART_PIN) "\n";

static bool is_sending;
static uint32_t begun,
    patience; /* microseconds: when what is waited for began; how long it may take */

/* Bytes begin: they may take twice their time, 128 ns each, and 2 microseconds more for what the
 * clock rounds. */
static void begin(size_t size)
{
    patience = (uint32_t)size * 32u / 125u + 2u;
    begun = rp2040_microseconds();
}

/* Waits until bits of a register are clear or set; false where that takes too long. The time is
 * read first, so an interrupt behind it makes nothing late that has ended. */
static bool wait_for(const volatile uint32_t *status, uint32_t bits, uint32_t value)
{
    uint32_t now = rp2040_microseconds();

    while ((*status & bits) != value) {
        if (now - begun > patience) {
            return false;
        }
        now = rp2040_microseconds();
    }
    return true;
}

/* False: the bytes may still be read. */
static bool wait(void *user)
{
    (void)user;
    if (is_sending) {
        if (!wait_for(&DMA_CONTROL, DMA_IS_BUSY, 0) || !wait_for(&SPI_STATUS, SPI_IS_BUSY, 0)) {
            return false;
        }
        rp2040_set_pin(SELECT, 1);
        is_sending = false;
    }
    return true;
}

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    bool is_sent = true;
    size_t i;

    if (!wait(user)) {
        return false;
    }
    rp2040_set_pin(DATA_COMMAND, is_data);
    rp2040_set_pin(SELECT, 0);
    for (i = 0; i < size && is_sent; i++) {
        begin(1);
        is_sent = wait_for(&SPI_STATUS, SPI_HAS_ROOM, SPI_HAS_ROOM);
        SPI_DATA = bytes[i]; /* ignored where there is no room */
    }
    begin(SPI_QUEUE);
    is_sent = wait_for(&SPI_STATUS, SPI_IS_BUSY, 0) && is_sent;
    rp2040_set_pin(SELECT, 1);
    return is_sent;
}

static bool start(void *user, const uint8_t *bytes, size_t size)
{
    if (!wait(user)) {
        return false;
    }
    rp2040_set_pin(DATA_COMMAND, 1);
    rp2040_set_pin(SELECT, 0);
    is_sending = true;
    DMA_READ = (uint32_t)(uintptr_t)bytes;
    DMA_WRITE = RP2040_SPI0 + 8u;
    DMA_COUNT = (uint32_t)size;
    begin(size);
    __asm__ volatile("" : : : "memory"); /* the bytes are written before they are sent */
    DMA_CONTROL = DMA_TO_SPI;
    return true;
}

static void pause(void *user, uint32_t milliseconds)
{
    const uint32_t since = rp2040_microseconds();

    (void)user;
    while (rp2040_microseconds() - since < milliseconds * 1000u) {
    }
}

const fxl_display_port wires_port = {NULL, send, start, wait, pause};

bool wires_open(void)
{
    is_sending = false;
    rp2040_make_output(SELECT, 1);
    rp2040_make_output(DATA_COMMAND, 1);
    rp2040_make_output(FRAME, 0);
    rp2040_use_pin(CLOCK, RP2040_PIN_SPI);
    rp2040_use_pin(DATA_OUT, RP2040_PIN_SPI);
    SPI_CONTROL1 = 0;
    SPI_PRESCALE = DIVISOR;
    SPI_CONTROL0 = 7u; /* 8 bits, mode 0 */
    SPI_DMA = 1u << 1; /* for what is sent */
    SPI_CONTROL1 = 1u << 1;
    rp2040_make_output(RESET, 0);
    pause(NULL, 1);
    rp2040_set_pin(RESET, 1);
    pause(NULL, 120);
    return true;
}

bool wires_end_frame(uint32_t number)
{
    rp2040_set_pin(FRAME, (number & 1u) == 0);
    return true;
}

bool wires_close(void)
{
    return wait(NULL);
}
