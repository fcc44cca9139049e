/* SPDX-License-Identifier: MIT */
/* Registers: Application Note AN385, "Two-wire serial control". */
#include "parts/sbcon.h"

#define REGISTER(base, offset) (*(volatile uint32_t *)((base) + (offset)))
#define LINES(base)            REGISTER(base, 0u) /* read: the state of the lines */
#define LET_RISE(base)         REGISTER(base, 0u) /* write: lines to release */
#define PULL_LOW(base)         REGISTER(base, 4u)

#define CLOCK 1u
#define DATA  2u

/* Reads of the port between two edges. Each read takes the core and the bus several cycles at 25
 * MHz. Together they are longer than the 1.3 microseconds that I2C at 400 kHz requires. */
#define EDGE_LOOKS 8u

static void set_line(uintptr_t base, uint32_t line, bool high)
{
    uint32_t looks;

    if (high) {
        LET_RISE(base) = line;
    } else {
        PULL_LOW(base) = line;
    }
    for (looks = 0; looks < EDGE_LOOKS; looks++) {
        (void)LINES(base);
    }
}

/* Starts from any state: the lines go up, then data falls while the clock is high. */
static void start(uintptr_t base)
{
    set_line(base, DATA, true);
    set_line(base, CLOCK, true);
    set_line(base, DATA, false);
    set_line(base, CLOCK, false);
}

static void stop(uintptr_t base)
{
    set_line(base, DATA, false);
    set_line(base, CLOCK, true);
    set_line(base, DATA, true);
}

/* Highest bit first; in the ninth clock the device pulls data low. */
static bool send_byte(uintptr_t base, uint32_t byte)
{
    uint32_t bit;
    bool acknowledged;

    for (bit = 0x80u; bit != 0; bit >>= 1) {
        set_line(base, DATA, (byte & bit) != 0);
        set_line(base, CLOCK, true);
        set_line(base, CLOCK, false);
    }
    set_line(base, DATA, true);
    set_line(base, CLOCK, true);
    acknowledged = (LINES(base) & DATA) == 0;
    set_line(base, CLOCK, false);
    return acknowledged;
}

bool sbcon_send(uintptr_t base, uint32_t address, const uint8_t *bytes, size_t size)
{
    size_t i;
    bool good;

    start(base);
    good = send_byte(base, address << 1); /* bit 0: to write */
    for (i = 0; i < size && good; i++) {
        good = send_byte(base, bytes[i]);
    }
    stop(base);
    return good;
}
