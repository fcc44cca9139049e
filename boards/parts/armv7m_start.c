/* SPDX-License-Identifier: MIT */
/* Reset and the vector table of an Armv7-M core.
 *
 * The program runs on the process stack and handlers on the main stack, so
 * that the fault report still has a stack when the program's has overflowed.
 */
#include "parts/armv7m.h"

#include "contract/system.h"

#define INTERRUPTS 32 /* beyond the 16 of the core; nobody asks for any */

#define SHCSR_FAULTS_ENABLED (7u << 16) /* memory management, bus, usage */

#define EIGHT(entry) entry, entry, entry, entry, entry, entry, entry, entry

typedef void (*vector)(void);

static __attribute__((used, noreturn)) void start(void)
{
    const uint32_t *from = fxl_data_load;
    uint32_t *to;

    for (to = fxl_data_start; to < fxl_data_end; to++) {
        *to = *from;
        from++;
    }
    for (to = fxl_bss_start; to < fxl_bss_end; to++) {
        *to = 0;
    }
    SCB_SHCSR |= SHCSR_FAULTS_ENABLED;
    SCB_CCR |= CCR_DIV_0_TRP | CCR_UNALIGN_TRP;
    armv7m_protect();
    board_start();
    system_exit(main(0, 0));
    for (;;) {
    }
}

/* SPSEL (bit 1 of CONTROL) chooses the process stack; C needs a stack first. */
__attribute__((naked)) void armv7m_reset(void)
{
    __asm__ volatile("ldr r0, =fxl_stack_top\n\t"
                     "msr psp, r0\n\t"
                     "movs r0, #2\n\t"
                     "msr control, r0\n\t"
                     "isb\n\t"
                     "b start\n\t"
                     ".ltorg");
}

/* Word 0 is the main stack's first value; 7 to 10 and 13 are reserved. */
__attribute__((section(".vectors"), used)) static const vector vectors[16 + INTERRUPTS] = {
    (vector)(uintptr_t)fxl_handler_stack_top,
    armv7m_reset,
    armv7m_fault, /* NMI */
    armv7m_fault, /* hard fault */
    armv7m_fault, /* memory management */
    armv7m_fault, /* bus fault */
    armv7m_fault, /* usage fault */
    armv7m_fault,
    armv7m_fault,
    armv7m_fault,
    armv7m_fault,
    armv7m_fault, /* SVCall */
    armv7m_fault, /* debug monitor */
    armv7m_fault,
    armv7m_fault, /* PendSV */
    armv7m_systick,
    EIGHT(armv7m_fault),
    EIGHT(armv7m_fault),
    EIGHT(armv7m_fault),
    EIGHT(armv7m_fault),
};
