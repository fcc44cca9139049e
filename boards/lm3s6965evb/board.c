/* SPDX-License-Identifier: MIT */
/* EK-LM3S6965: the OLED on SSI0, five keys; under QEMU with -icount shift=0,
 * where one instruction takes one nanosecond.
 *
 *   SSI0  PA2 clock, PA3 the OLED's select, PA5 data
 *   PC7   the OLED's data/command; PC6 its 15 volts
 *   PD0   the memory card's select, which the card must see high; QEMU's OLED
 *         listens only then */
#include <stddef.h>

#include "contract/input.h"
#include "contract/panel.h"
#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/pl022.h"
#include "parts/ssd0323.h"
#include "parts/systick.h"

#define REGISTER(address) (*(volatile uint32_t *)(address))

#define RCGC0      REGISTER(0x400FE100u) /* clocks of parts */
#define RCGC0_WDT  (1u << 3)
#define RCGC1      REGISTER(0x400FE104u)
#define RCGC1_SSI0 (1u << 4)
#define RCGC2      REGISTER(0x400FE108u)
#define RCGC2_A    (1u << 0)
#define RCGC2_C    (1u << 2)
#define RCGC2_D    (1u << 3)

/* Pins: a port's registers; of the data only the bits in the address change. */
#define PORT_A             0x40004000u
#define PORT_C             0x40006000u
#define PORT_D             0x40007000u
#define PINS(port, bits)   REGISTER((port) + ((bits) << 2))
#define PIN_OUTPUT(port)   REGISTER((port) + 0x400u)
#define PIN_FUNCTION(port) REGISTER((port) + 0x420u)
#define PIN_DIGITAL(port)  REGISTER((port) + 0x51Cu)
#define PA_SSI             (1u << 2 | 1u << 3 | 1u << 5)
#define PC_SUPPLY          (1u << 6)
#define PC_DATA            (1u << 7)
#define PD_CARD            (1u << 0)

#define SSI0         0x40008000u
#define SSI0_DIVIDER 6u /* of 12.5 MHz: 2 Mbit/s, within what the controller takes */

void board_start(void)
{
    RCGC0 |= RCGC0_WDT;
    systick_start(SYSTICK_RELOAD_MAX);
}

static void make_outputs(uint32_t port, uint32_t pins)
{
    PIN_OUTPUT(port) |= pins;
    PIN_DIGITAL(port) |= pins;
}

bool ssd0323_wires_open(void)
{
    RCGC1 |= RCGC1_SSI0;
    RCGC2 |= RCGC2_A | RCGC2_C | RCGC2_D;
    (void)RCGC2; /* three cycles until the ports answer */
    (void)RCGC2;
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

uint32_t input_keys(void)
{
    return 0;
}
