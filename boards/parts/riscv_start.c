/* SPDX-License-Identifier: MIT */
/* Reset of a RISC-V core of 32 bits, in machine mode. The memory map and its symbols are those of
 * every board (linker/sections.ld, parts/cortexm.h). */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/riscv.h"
#include "parts/stack.h"

#define TEXT_OF(macro) TEXT(macro)
#define TEXT(words)    #words

/* What a C library keeps for a thread; there is one thread. */
#define THREAD_BYTES 512
static _Alignas(16) uint8_t thread_memory[THREAD_BYTES];

void riscv_reset(void);

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
    __asm__ volatile("mv tp, %0" ::"r"(thread_memory));
    board_start();
    system_exit(main(0, 0));
    for (;;) {
    }
}

/* The core has protection of physical memory, which nothing here turns on. */
bool cortexm_protected(void)
{
    return false;
}

uint64_t riscv_instructions(void)
{
    uint32_t high, low, again;

    do {
        __asm__ volatile(".option push\n\t"
                         ".option arch, +zicsr\n\t"
                         "csrr %0, minstreth\n\t"
                         "csrr %1, minstret\n\t"
                         "csrr %2, minstreth\n\t"
                         ".option pop"
                         : "=&r"(high), "=&r"(low), "=&r"(again));
    } while (high != again);
    return (uint64_t)high << 32 | low;
}

/* Bit 7 of mie is the machine timer's, bit 3 of mstatus lets interrupts in. */
void riscv_enable_timer(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "csrs mie, %0\n\t"
                     "csrs mstatus, %1\n\t"
                     ".option pop" ::"r"(1u << 7),
                     "r"(1u << 3));
}

/* The first instruction of flash. Both stacks are painted (they lie side by side). */
__attribute__((naked, section(".vectors"), used)) void riscv_reset(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "la t0, riscv_trap\n\t"
                     "csrw mtvec, t0\n\t"
                     "la t0, fxl_stack_limit\n\t"
                     "la t1, fxl_handler_stack_top\n\t"
                     "li t2, " TEXT_OF(STACK_PAINT) "\n\t"
                                                    "1: sw t2, 0(t0)\n\t"
                                                    "addi t0, t0, 4\n\t"
                                                    "bltu t0, t1, 1b\n\t"
                                                    "la sp, fxl_stack_top\n\t"
                                                    "tail start\n\t"
                                                    ".option pop");
}
