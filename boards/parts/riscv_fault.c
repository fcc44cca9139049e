/* SPDX-License-Identifier: MIT */
/* Traps of a RISC-V core: what happened, where, and the exit code that says so. */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/riscv.h"
#include "parts/semihosting.h"
#include "parts/stack.h"
#include "parts/watchdog.h"

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
