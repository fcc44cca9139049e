/* SPDX-License-Identifier: MIT */
/* EK-LM3S6965: the OLED on SSI0, five keys. The core runs at
 * 12.5 MHz, as after reset.
 *
 *   SSI0  PA2 clock, PA3 the OLED's select, PA5 data
 *   PC7   the OLED's data/command; PC6 its 15 volts
 *   PD0   the memory card's select, which the card must see high; QEMU's OLED
 *         listens only then
 *   PE0-3 the keys up, down, left, right; PF1 select (Ctrl under QEMU): low
 *         while they are down */
#include <stddef.h>

#include "contract/input.h"
#include "contract/panel.h"
#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/keys.h"
#include "parts/pl022.h"
#include "parts/ssd0323.h"
#include "parts/systick.h"

#define REGISTER(address) CORTEXM_REGISTER(address)

#define RCGC0          REGISTER(0x400FE100u) /* clocks of ports */
#define RCGC0_WATCHDOG (1u << 3)
#define RCGC1          REGISTER(0x400FE104u)
#define RCGC1_SSI0     (1u << 4)
#define RCGC2          REGISTER(0x400FE108u)
#define RCGC2_PORTS    (1u << 0 | 1u << 2 | 1u << 3 | 1u << 4 | 1u << 5) /* A, C, D, E, F */

/* Pins: a port's registers; of the data only the bits in the address change. */
#define PORT_A             0x40004000u
#define PORT_C             0x40006000u
#define PORT_D             0x40007000u
#define PORT_E             0x40024000u
#define PORT_F             0x40025000u
#define PINS(port, bits)   REGISTER((port) + ((bits) << 2))
#define PIN_OUTPUT(port)   REGISTER((port) + 0x400u)
#define PIN_FUNCTION(port) REGISTER((port) + 0x420u)
#define PIN_PULL_UP(port)  REGISTER((port) + 0x510u)
#define PIN_DIGITAL(port)  REGISTER((port) + 0x51Cu)
#define PA_SSI             (1u << 2 | 1u << 3 | 1u << 5)
#define PC_SUPPLY          (1u << 6)
#define PC_DATA            (1u << 7)
#define PD_CARD            (1u << 0)
#define PE_ARROWS          (KEYS_UP | KEYS_DOWN | KEYS_LEFT | KEYS_RIGHT) /* bit for bit */
#define PF_SELECT          (1u << 1)

#define TICKS_PER_MILLISECOND 12500u

#define SSI0         0x40008000u
#define SSI0_DIVIDER 6u /* of 12.5 MHz: 2 Mbit/s, within what the controller takes */

static void make_inputs(uint32_t port, uint32_t pins)
{
    PIN_PULL_UP(port) |= pins;
    PIN_DIGITAL(port) |= pins;
}

void board_start(void)
{
    RCGC0 |= RCGC0_WATCHDOG;
    RCGC1 |= RCGC1_SSI0;
    RCGC2 |= RCGC2_PORTS;
    (void)RCGC2; /* three cycles until they answer */
    (void)RCGC2;
    make_inputs(PORT_E, PE_ARROWS);
    make_inputs(PORT_F, PF_SELECT);
    systick_start(SYSTICK_RELOAD_MAX);
}

static void make_outputs(uint32_t port, uint32_t pins)
{
    PIN_OUTPUT(port) |= pins;
    PIN_DIGITAL(port) |= pins;
}

bool ssd0323_wires_open(void)
{
    PIN_FUNCTION(PORT_A) |= PA_SSI;
    PIN_DIGITAL(PORT_A) |= PA_SSI;
    make_outputs(PORT_D, PD_CARD);
    PINS(PORT_D, PD_CARD) = PD_CARD;
    make_outputs(PORT_C, PC_SUPPLY | PC_DATA);
    pl022_open(SSI0, SSI0_DIVIDER);
    PINS(PORT_C, PC_SUPPLY) = PC_SUPPLY;
    return true;
}

bool ssd0323_send(ssd0323_kind kind, const uint8_t *bytes, size_t size)
{
    PINS(PORT_C, PC_DATA) = kind == SSD0323_DATA ? PC_DATA : 0;
    return pl022_send(SSI0, bytes, size);
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, &ssd0323_panel, NULL};

    return panels;
}

static uint32_t pressed(void)
{
    const uint32_t arrows = ~PINS(PORT_E, PE_ARROWS) & PE_ARROWS;
    const uint32_t select = ~PINS(PORT_F, PF_SELECT) & PF_SELECT;

    return arrows | (select != 0 ? KEYS_SELECT : 0);
}

/* The quotient's lower 32 bits, digit by digit of 16 bits: the board has no room for a long division. */
static uint32_t milliseconds_of(uint64_t ticks)
{
    uint32_t quotient = 0, rest = 0; /* rest < TICKS_PER_MILLISECOND < 2^16 */
    uint32_t shift;

    for (shift = 64; shift > 0; shift -= 16u) {
        rest = rest << 16 | ((uint32_t)(ticks >> (shift - 16u)) & 0xFFFFu);
        quotient = quotient << 16 | rest / TICKS_PER_MILLISECOND;
        rest %= TICKS_PER_MILLISECOND;
    }
    return quotient;
}

uint32_t input_keys(void)
{
    static keys_debouncer keys;

    return keys_meaning(keys_debounce(&keys, pressed(), milliseconds_of(systick_ticks())));
}
