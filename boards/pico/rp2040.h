/* SPDX-License-Identifier: MIT */
/* Registers of the RP2040 (its data sheet, chapters 2 and 4), and what the parts of this board
 * share. */
#ifndef BOARD_RP2040_H
#define BOARD_RP2040_H

#include <stdbool.h>
#include <stdint.h>

#define RP2040_REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define RP2040_CLEAR \
    0x3000u /* the alias of a register that clears the bits which are written as 1 */

#define RP2040_CLOCKS   0x40008000u
#define RP2040_RESETS   0x4000C000u
#define RP2040_IO_BANK0 0x40014000u
#define RP2040_XOSC     0x40024000u
#define RP2040_PLL_SYS  0x40028000u
#define RP2040_UART0    0x40034000u
#define RP2040_SPI0     0x4003C000u
#define RP2040_TIMER    0x40054000u
#define RP2040_WATCHDOG 0x40058000u
#define RP2040_DMA      0x50000000u
#define RP2040_SIO      0xD0000000u

/* The tools read these two in the program (board_note.c): digits alone. */
#define RP2040_HZ       125000000 /* of the core and the peripherals, after rp2040_start */
#define RP2040_UART_PIN 0

/* Functions of a pin. */
enum {
    RP2040_PIN_SPI = 1,
    RP2040_PIN_UART = 2,
    RP2040_PIN_SIO = 5
};

/* Takes the peripherals that this board uses out of reset, and sets the clocks: 125 MHz from the
 * crystal of 12 MHz. False where a clock or a peripheral does not start. */
bool rp2040_start(void);

/* Chooses what a pin is for. An output that rp2040_set_pin drives has RP2040_PIN_SIO. */
void rp2040_use_pin(uint32_t pin, uint32_t function);

/* Makes a pin an output of RP2040_PIN_SIO at this level. */
void rp2040_make_output(uint32_t pin, int is_high);
void rp2040_set_pin(uint32_t pin, int is_high);

/* Microseconds since the start, modulo 2^32. */
uint32_t rp2040_microseconds(void);

/* Sends text by UART0, on RP2040_UART_PIN, at 115,200 baud. Waits until there is room for each
 * byte; a byte for which there is none in 30 ms is lost. */
void rp2040_uart_text(const char *text);

#endif
