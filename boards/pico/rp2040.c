/* SPDX-License-Identifier: MIT */
#include "pico/rp2040.h"

/* Bits of RESETS. */
#define WANTED \
    (1u << 2 /* DMA */ | 1u << 5 /* IO_BANK0 */ | 1u << 8 /* PADS_BANK0 */ | \
     1u << 12 /* PLL_SYS */ | 1u << 16 /* SPI0 */ | 1u << 21 /* TIMER */ | 1u << 22 /* UART0 */)

#define CLK_REF_CTRL     RP2040_REGISTER(RP2040_CLOCKS + 0x30u)
#define CLK_REF_SELECTED RP2040_REGISTER(RP2040_CLOCKS + 0x38u)
#define CLK_SYS_CTRL     RP2040_REGISTER(RP2040_CLOCKS + 0x3Cu)
#define CLK_SYS_SELECTED RP2040_REGISTER(RP2040_CLOCKS + 0x44u)
#define CLK_PERI_CTRL    RP2040_REGISTER(RP2040_CLOCKS + 0x48u)
#define XOSC_CTRL        RP2040_REGISTER(RP2040_XOSC)
#define XOSC_STATUS      RP2040_REGISTER(RP2040_XOSC + 4u)
#define XOSC_STARTUP     RP2040_REGISTER(RP2040_XOSC + 0xCu)
#define PLL_CS           RP2040_REGISTER(RP2040_PLL_SYS)
#define PLL_POWER        RP2040_REGISTER(RP2040_PLL_SYS + 4u + RP2040_CLEAR) /* 1: switches on */
#define PLL_MULTIPLIER   RP2040_REGISTER(RP2040_PLL_SYS + 8u)
#define PLL_DIVISORS     RP2040_REGISTER(RP2040_PLL_SYS + 0xCu)
#define WATCHDOG_TICK    RP2040_REGISTER(RP2040_WATCHDOG + 0x2Cu)
#define UART_DATA        RP2040_REGISTER(RP2040_UART0)
#define UART_FLAGS       RP2040_REGISTER(RP2040_UART0 + 0x18u)
#define UART_IBRD        RP2040_REGISTER(RP2040_UART0 + 0x24u)
#define UART_FBRD        RP2040_REGISTER(RP2040_UART0 + 0x28u)
#define UART_LCR         RP2040_REGISTER(RP2040_UART0 + 0x2Cu)
#define UART_CR          RP2040_REGISTER(RP2040_UART0 + 0x30u)
#define TIME_LOW         RP2040_REGISTER(RP2040_TIMER + 0x28u)

#define LOCKED     (1u << 31)
#define LOOKS_MOST 1000000u

/* Waits until bits of a register have a value; false where they never get it. No clock counts yet,
 * so looks do, of at least 4 cycles each: LOOKS_MOST of them are at least 30 ms at the highest
 * clock, 133 MHz. What is waited for takes 2 ms at most. */
static bool wait_for(const volatile uint32_t *status, uint32_t bits, uint32_t value)
{
    uint32_t looks = 0;

    while ((*status & bits) != value && looks < LOOKS_MOST) {
        looks++;
    }
    return looks < LOOKS_MOST;
}

static bool start_crystal(void)
{
    XOSC_STARTUP = 47u;      /* times 256 cycles of 12 MHz: 1 ms */
    XOSC_CTRL = 0x00FABAA0u; /* 1 to 15 MHz; on */
    if (!wait_for(&XOSC_STATUS, LOCKED, LOCKED)) {
        return false;
    }
    CLK_SYS_CTRL = 0; /* from the reference clock, while the PLL changes */
    if (!wait_for(&CLK_SYS_SELECTED, 3u, 1u)) {
        return false;
    }
    CLK_REF_CTRL = 2u; /* from the crystal */
    return wait_for(&CLK_REF_SELECTED, 7u, 1u << 2);
}

static bool start_pll(void)
{
    PLL_CS = 1u;
    PLL_MULTIPLIER = 125u; /* 1,500 MHz */
    PLL_POWER = 1u << 5 | 1u;
    if (!wait_for(&PLL_CS, LOCKED, LOCKED)) {
        return false;
    }
    PLL_DIVISORS = 6u << 16 | 2u << 12; /* 125 MHz */
    PLL_POWER = 1u << 3;
    CLK_SYS_CTRL = 1u; /* from its auxiliary source, the PLL */
    return wait_for(&CLK_SYS_SELECTED, 3u, 1u << 1);
}

/* False where the timer, by which every later wait ends, does not count. */
static bool start_timer(void)
{
    WATCHDOG_TICK = 1u << 9 | 12u; /* the timer's microsecond: 12 cycles of the crystal */
    return wait_for(&TIME_LOW, 4u, ~TIME_LOW & 4u); /* within 4 microseconds */
}

bool rp2040_start(void)
{
    RP2040_REGISTER(RP2040_RESETS + RP2040_CLEAR) = WANTED;
    if (!wait_for(&RP2040_REGISTER(RP2040_RESETS + 8u), WANTED, WANTED) || !start_crystal() ||
        !start_pll() || !start_timer()) {
        return false;
    }
    CLK_PERI_CTRL = 1u << 11; /* on, from the system's clock */
    UART_IBRD = 67u;          /* 125 MHz / 16 / 115,200 = 67 + 52 / 64 */
    UART_FBRD = 52u;
    UART_LCR = 0x70u; /* 8 bits, queues */
    UART_CR = 0x101u; /* on, sends */
    rp2040_use_pin(RP2040_UART_PIN, RP2040_PIN_UART);
    return true;
}

void rp2040_use_pin(uint32_t pin, uint32_t function)
{
    RP2040_REGISTER(RP2040_IO_BANK0 + 8u * pin + 4u) = function;
}

void rp2040_set_pin(uint32_t pin, int is_high)
{
    RP2040_REGISTER(RP2040_SIO + (is_high ? 0x14u : 0x18u)) = 1u << pin;
}

void rp2040_make_output(uint32_t pin, int is_high)
{
    rp2040_set_pin(pin, is_high);
    RP2040_REGISTER(RP2040_SIO + 0x24u) = 1u << pin;
    rp2040_use_pin(pin, RP2040_PIN_SIO);
}

uint32_t rp2040_microseconds(void)
{
    return TIME_LOW;
}

void rp2040_uart_text(const char *text)
{
    for (; *text != '\0'; text++) {
        (void)wait_for(&UART_FLAGS, 1u << 5, 0); /* its queue is full */
        UART_DATA = (uint8_t)*text;
    }
}
