/* SPDX-License-Identifier: MIT */
#include "start.h"

#include "contract/system.h"

/* Armv7-M Architecture Reference Manual, B3.2.20: full access to coprocessors
 * 10 and 11, which are the floating-point unit and the vector extension. */
#define CPACR       (*(volatile uint32_t *)0xE000ED88u)
#define CPACR_FLOAT (0xFu << 20)

void bench_start(int argc, char **argv)
{
    system_start(argc, argv);
    __asm__ volatile("cpsid i");
#ifdef __ARM_FP
    CPACR |= CPACR_FLOAT;
    __asm__ volatile("dsb\n\tisb");
#endif
}
