/* SPDX-License-Identifier: MIT */
/* What is said when the core faults: the fault's name, the address, the
 * registers; and an exit code for each kind. Runs on the main stack. */
#include <stddef.h>

#include "contract/system.h"
#include "parts/armv7m.h"
#include "parts/semihosting.h"

/* Bits of CFSR: memory management 0..7, bus 8..15, usage 16..31. */
#define CFSR_IACCVIOL  (1u << 0)
#define CFSR_DACCVIOL  (1u << 1)
#define CFSR_MSTKERR   (1u << 4)
#define CFSR_MMARVALID (1u << 7)
#define CFSR_MEMORY    0x000000FFu
#define CFSR_STKERR    (1u << 12)
#define CFSR_BFARVALID (1u << 15)
#define CFSR_BUS       0x0000FF00u
#define CFSR_UNALIGNED (1u << 24)
#define CFSR_DIVBYZERO (1u << 25)

#define FIRST_SYSTEM_FAULT 3u
#define LAST_SYSTEM_FAULT  6u

/* What the core pushes, lowest address first. */
typedef struct {
    uint32_t r0, r1, r2, r3, r12, lr, pc, xpsr;
} frame;

typedef struct {
    uint32_t bit;
    const char *name;
} bit_name;

static const bit_name bit_names[] = {
    {1u << 0, "IACCVIOL: fetched an instruction from protected memory"},
    {1u << 1, "DACCVIOL: read or wrote protected memory"},
    {1u << 3, "MUNSTKERR: protected memory on return from an exception"},
    {1u << 4, "MSTKERR: protected memory on entry to an exception"},
    {1u << 8, "IBUSERR: fetched an instruction where nothing answers"},
    {1u << 9, "PRECISERR: read or wrote where nothing answers"},
    {1u << 10, "IMPRECISERR: wrote where nothing answers, some instructions ago"},
    {1u << 11, "UNSTKERR: nothing answers on return from an exception"},
    {1u << 12, "STKERR: nothing answers on entry to an exception"},
    {1u << 16, "UNDEFINSTR: undefined instruction"},
    {1u << 17, "INVSTATE: not Thumb code"},
    {1u << 18, "INVPC: invalid return from an exception"},
    {1u << 19, "NOCP: no such coprocessor"},
    {1u << 24, "UNALIGNED: misaligned address"},
    {1u << 25, "DIVBYZERO: division by zero"},
};

static void line(const char *label, uint32_t value)
{
    semihosting_text(label);
    semihosting_hexadecimal(value);
}

/* The address that faulted, or false where the core does not know it. */
static bool fault_address(uint32_t cfsr, uint32_t *address)
{
    if ((cfsr & CFSR_MMARVALID) != 0) {
        *address = SCB_MMFAR;
        return true;
    }
    if ((cfsr & CFSR_BFARVALID) != 0) {
        *address = SCB_BFAR;
        return true;
    }
    return false;
}

static bool is_stack(uint32_t cfsr, uintptr_t process_stack, bool known, uint32_t address)
{
    return (cfsr & (CFSR_MSTKERR | CFSR_STKERR)) != 0 ||
           process_stack < (uintptr_t)fxl_stack_limit ||
           (known && address >= (uintptr_t)fxl_stack_guard && address < (uintptr_t)fxl_stack_limit);
}

static int memory_code(uint32_t cfsr, bool known, uint32_t address)
{
    /* Flash is read-only, so data access to it that faults was a write. */
    const uint32_t flash_offset = address - (uint32_t)(uintptr_t)fxl_flash_base;

    if (known && address < ARMV7M_NULL_BYTES) {
        return SYSTEM_EXIT_NULL;
    }
    if (known && (cfsr & CFSR_DACCVIOL) != 0 &&
        flash_offset < (uint32_t)(uintptr_t)fxl_flash_size) {
        return SYSTEM_EXIT_FLASH;
    }
    return SYSTEM_EXIT_PROTECTION;
}

static int fault_code(uint32_t exception, uint32_t cfsr, uintptr_t process_stack)
{
    uint32_t address = 0;
    const bool known = fault_address(cfsr, &address);

    if (exception < FIRST_SYSTEM_FAULT || exception > LAST_SYSTEM_FAULT) {
        return SYSTEM_EXIT_INTERRUPT;
    }
    if (is_stack(cfsr, process_stack, known, address)) {
        return SYSTEM_EXIT_STACK;
    }
    if ((cfsr & CFSR_DIVBYZERO) != 0) {
        return SYSTEM_EXIT_DIVIDE;
    }
    if ((cfsr & CFSR_UNALIGNED) != 0) {
        return SYSTEM_EXIT_UNALIGNED;
    }
    if ((cfsr & CFSR_MEMORY) != 0) {
        return memory_code(cfsr, known, address);
    }
    if ((cfsr & CFSR_BUS) != 0) {
        return SYSTEM_EXIT_BUS;
    }
    return cfsr != 0 ? SYSTEM_EXIT_USAGE : SYSTEM_EXIT_HARD;
}

static const char *fault_text(int code)
{
    switch (code) {
    case SYSTEM_EXIT_STACK:
        return "stack overflow";
    case SYSTEM_EXIT_DIVIDE:
        return "division by zero";
    case SYSTEM_EXIT_UNALIGNED:
        return "misaligned address";
    case SYSTEM_EXIT_FLASH:
        return "write to flash";
    case SYSTEM_EXIT_NULL:
        return "null pointer";
    case SYSTEM_EXIT_PROTECTION:
        return "protected memory";
    case SYSTEM_EXIT_BUS:
        return "nothing at this address";
    case SYSTEM_EXIT_USAGE:
        return "instruction that the core cannot execute";
    case SYSTEM_EXIT_INTERRUPT:
        return "unexpected interrupt";
    default:
        return "hard fault";
    }
}

static void print_causes(uint32_t cfsr)
{
    uint32_t address;
    size_t i;

    for (i = 0; i < sizeof bit_names / sizeof bit_names[0]; i++) {
        if ((cfsr & bit_names[i].bit) != 0) {
            semihosting_text("  ");
            semihosting_text(bit_names[i].name);
            semihosting_text("\n");
        }
    }
    if (fault_address(cfsr, &address)) {
        line("  address ", address);
        semihosting_text("\n");
    }
}

static void print_pushed(uint32_t cfsr, const frame *pushed)
{
    if ((cfsr & (CFSR_MSTKERR | CFSR_STKERR)) != 0) {
        semihosting_text("\n  pc and r0 to r3 are lost: there was no stack to save them on");
        return;
    }
    line("\n  pc  ", pushed->pc);
    line("  lr  ", pushed->lr);
    line("  xpsr ", pushed->xpsr);
    line("\n  r0  ", pushed->r0);
    line("  r1  ", pushed->r1);
    line("  r2  ", pushed->r2);
    line("  r3  ", pushed->r3);
    line("  r12 ", pushed->r12);
}

/* saved: r4 to r11 as they were. */
static void print_saved(const uint32_t *saved)
{
    line("\n  r4  ", saved[0]);
    line("  r5  ", saved[1]);
    line("  r6  ", saved[2]);
    line("  r7  ", saved[3]);
    line("\n  r8  ", saved[4]);
    line("  r9  ", saved[5]);
    line("  r10 ", saved[6]);
    line("  r11 ", saved[7]);
    semihosting_text("\n");
}

/* pushed: the core's frame, unless pushing it is what failed. */
__attribute__((used, noreturn)) static void report(const frame *pushed, const uint32_t *saved,
                                                   uint32_t exc_return)
{
    uint32_t exception;
    uintptr_t process_stack;
    const uint32_t cfsr = SCB_CFSR;
    int code;

    __asm__ volatile("mrs %0, ipsr" : "=r"(exception));
    __asm__ volatile("mrs %0, psp" : "=r"(process_stack));
    code = fault_code(exception, cfsr, process_stack);
    semihosting_text("fault: ");
    semihosting_text(fault_text(code));
    semihosting_text(" (exception ");
    semihosting_decimal(exception);
    semihosting_text(")\n");
    print_causes(cfsr);
    line("  cfsr ", cfsr);
    line("  hfsr ", SCB_HFSR);
    line("  psp ", (uint32_t)process_stack);
    line("  exc_return ", exc_return);
    print_pushed(cfsr, pushed);
    print_saved(saved);
    semihosting_exit(code);
}

/* Bit 2 of the link register says which stack the core pushed to. */
__attribute__((naked)) void armv7m_fault(void)
{
    __asm__ volatile("tst lr, #4\n\t"
                     "ite eq\n\t"
                     "mrseq r0, msp\n\t"
                     "mrsne r0, psp\n\t"
                     "push {r4-r11}\n\t"
                     "mov r1, sp\n\t"
                     "mov r2, lr\n\t"
                     "b report");
}
