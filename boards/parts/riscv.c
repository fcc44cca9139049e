/* SPDX-License-Identifier: MIT */
/* Reset and traps of a RISC-V core of 32 bits, in machine mode. The memory map and its symbols are
 * those of every board (linker/sections.ld, parts/cortexm.h). */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/riscv.h"
#include "parts/semihosting.h"
#include "parts/stack.h"
#include "parts/watchdog.h"

#define TEXT_OF(macro) TEXT(macro)
#define TEXT(words)    #words

/* What a C library keeps for a thread; there is one thread. */
#define THREAD_BYTES 512
static _Alignas(16) uint8_t thread_memory[THREAD_BYTES];

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
__attribute__((naked, section(".vectors"), used)) void board_reset(void)
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

/* --- traps: what happened, where, and the exit code that says so ------------------------------ */

/* mcause, where its highest bit is 0. */
enum {
    FETCH_MISALIGNED = 0,
    FETCH_FAILED = 1,
    ILLEGAL = 2,
    LOAD_MISALIGNED = 4,
    LOAD_FAILED = 5,
    STORE_MISALIGNED = 6,
    STORE_FAILED = 7
};

typedef struct {
    const char *sentence;
    int status;
} verdict;

static verdict judge(uint32_t cause, uint32_t address)
{
    const bool is_null = address < CORTEXM_NULL_BYTES;

    if (watchdog_barked(cause)) {
        return (verdict){"the program hung: the watchdog was not fed", SYSTEM_EXIT_HANG};
    }
    if (stack_is_spent()) {
        return (verdict){"stack overflow", SYSTEM_EXIT_STACK};
    }
    switch (cause) {
    case FETCH_FAILED:
    case LOAD_FAILED:
    case STORE_FAILED:
        return is_null ? (verdict){"access through a null pointer", SYSTEM_EXIT_NULL}
                       : (verdict){"access to an address where nothing answers", SYSTEM_EXIT_BUS};
    case FETCH_MISALIGNED:
    case LOAD_MISALIGNED:
    case STORE_MISALIGNED:
        return (verdict){"access to a misaligned address", SYSTEM_EXIT_UNALIGNED};
    case ILLEGAL:
        return (verdict){"an instruction that the core cannot execute", SYSTEM_EXIT_USAGE};
    default:
        return (cause >> 31) != 0
                   ? (verdict){"an interrupt that nobody asked for", SYSTEM_EXIT_INTERRUPT}
                   : (verdict){"a trap of unknown cause", SYSTEM_EXIT_HARD};
    }
}

static void print_word(const char *name, uint32_t value)
{
    semihosting_text("\n  ");
    semihosting_text(name);
    semihosting_text(" ");
    semihosting_hexadecimal(value);
}

static __attribute__((used, noreturn)) void report(uint32_t cause, uint32_t pc, uint32_t address,
                                                   uint32_t from)
{
    const verdict found = judge(cause, address);

    semihosting_text("fault: ");
    semihosting_text(found.sentence);
    print_word("mcause", cause);
    print_word("address", address);
    print_word("pc ", pc);
    print_word("lr ", from);
    semihosting_text("\n");
    stack_print();
    semihosting_exit(found.status);
}

/* On the handlers' stack: that of the program may be spent. Does not return, so it saves nothing.
 */
__attribute__((naked, aligned(4))) void riscv_trap(void)
{
    __asm__ volatile(".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "la sp, fxl_handler_stack_top\n\t"
                     "csrr a0, mcause\n\t"
                     "csrr a1, mepc\n\t"
                     "csrr a2, mtval\n\t"
                     "mv a3, ra\n\t"
                     "tail report\n\t"
                     ".option pop");
}
