/* SPDX-License-Identifier: MIT */
/* Registers: ARM PrimeCell Synchronous Serial Port (PL022) manual, chapter 3. */
#include "parts/pl022.h"

#define REGISTER(base, offset) (*(volatile uint32_t *)((base) + (offset)))
#define CR0(base)              REGISTER(base, 0x00u)
#define CR1(base)              REGISTER(base, 0x04u)
#define DR(base)               REGISTER(base, 0x08u)
#define SR(base)               REGISTER(base, 0x0Cu)
#define CPSR(base)             REGISTER(base, 0x10u)

#define CR0_EIGHT_BITS 7u
#define CR0_MODE_3     (3u << 6)
#define CR1_ENABLE     2u
#define SR_HAS_ROOM    2u /* to send */
#define SR_RECEIVED    4u

/* Reads of the status before it gives up. A byte at the slowest clock takes far fewer. */
#define PATIENCE 1000000u

static bool wait_for(uintptr_t base, uint32_t status)
{
    uint32_t looks;

    for (looks = 0; looks < PATIENCE; looks++) {
        if ((SR(base) & status) != 0) {
            return true;
        }
    }
    return false;
}

void pl022_open(uintptr_t base, uint32_t divider)
{
    CR1(base) = 0;
    CR0(base) = CR0_EIGHT_BITS | CR0_MODE_3;
    CPSR(base) = divider;
    CR1(base) = CR1_ENABLE;
    while ((SR(base) & SR_RECEIVED) != 0) {
        (void)DR(base);
    }
}

/* A byte comes in for each byte sent, and must be read. An incoming byte shows that its own byte
 * was sent; and QEMU stops sending when eight bytes are unread. */
bool pl022_send(uintptr_t base, const uint8_t *bytes, size_t size)
{
    size_t i;

    for (i = 0; i < size; i++) {
        if (!wait_for(base, SR_HAS_ROOM)) {
            return false;
        }
        DR(base) = bytes[i];
        if (!wait_for(base, SR_RECEIVED)) {
            return false;
        }
        (void)DR(base);
    }
    return true;
}
