/* SPDX-License-Identifier: MIT */
/* Reset and the vector table of a Cortex-M core, from Armv6-M to Armv8.1-M.
 *
 * The program runs on the process stack and handlers on the main stack, so the fault report
 * still has a stack when the program's has overflowed. */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/stack.h"

#define INTERRUPTS 32 /* in addition to the 16 of the core */

#define TEXT_OF(macro) TEXT(macro)
#define TEXT(words)    #words

#define EIGHT(entry) entry, entry, entry, entry, entry, entry, entry, entry

static bool is_protected;

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
    cortexm_trap();
    is_protected = cortexm_protect();
    board_start();
    system_exit(main(0, 0));
    for (;;) {
    }
}

bool cortexm_protected(void)
{
    return is_protected;
}

/* Both stacks are painted (they lie side by side), then SPSEL (bit 1 of
 * CONTROL) chooses the process stack: C needs a stack first. The main stack is
 * set, too: a debugger may come here without a reset. */
__attribute__((naked)) void board_reset(void)
{
    __asm__ volatile("ldr r0, =fxl_handler_stack_top\n\t"
                     "msr msp, r0\n\t"
                     "ldr r1, =fxl_stack_limit\n\t"
                     "ldr r2, =" TEXT_OF(STACK_PAINT) "\n\t"
                                                      "1: str r2, [r1]\n\t"
                                                      "adds r1, #4\n\t"
                                                      "cmp r1, r0\n\t"
                                                      "bcc 1b\n\t"
                                                      "ldr r0, =fxl_stack_top\n\t"
                                                      "msr psp, r0\n\t"
                                                      "movs r0, #2\n\t"
                                                      "msr control, r0\n\t"
                                                      "isb\n\t"
                                                      "ldr r0, =start\n\t"
                                                      "bx r0\n\t"
                                                      ".ltorg");
}

/* Word 0 is the main stack's first value; 7 to 10 and 13 are reserved. */
__attribute__((section(".vectors"), used)) const cortexm_vector cortexm_vectors[16 + INTERRUPTS] = {
    (cortexm_vector)(uintptr_t)fxl_handler_stack_top,
    board_reset,
    cortexm_fault, /* NMI */
    cortexm_fault, /* hard fault */
    cortexm_fault, /* memory management */
    cortexm_fault, /* bus fault */
    cortexm_fault, /* usage fault */
    cortexm_fault, /* secure fault */
    cortexm_fault,
    cortexm_fault,
    cortexm_fault,
    cortexm_fault, /* SVCall */
    cortexm_fault, /* debug monitor */
    cortexm_fault,
    cortexm_fault, /* PendSV */
    cortexm_systick,
    EIGHT(cortexm_fault),
    EIGHT(cortexm_fault),
    EIGHT(cortexm_fault),
    EIGHT(cortexm_fault),
};
