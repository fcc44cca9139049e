/* SPDX-License-Identifier: MIT */
/* Faults of Armv7-M and of Armv8-M Mainline: the core reports their kinds. */
#include <stddef.h>

#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/cortexm_fault.h"
#include "parts/semihosting.h"

#define SHCSR_FAULTS_ENABLED (7u << 16) /* memory management, bus, usage */

/* Bits of CFSR: memory management 0..7, bus 8..15, usage 16..31. */
#define CFSR_IACCVIOL  (1u << 0)
#define CFSR_DACCVIOL  (1u << 1)
#define CFSR_MSTKERR   (1u << 4)
#define CFSR_MMARVALID (1u << 7)
#define CFSR_MEMORY    0x000000FFu
#define CFSR_IBUSERR   (1u << 8)
#define CFSR_STKERR    (1u << 12)
#define CFSR_BFARVALID (1u << 15)
#define CFSR_BUS       0x0000FF00u
#define CFSR_STKOF     (1u << 20)
#define CFSR_UNALIGNED (1u << 24)
#define CFSR_DIVBYZERO (1u << 25)

#define XPSR_THUMB (1u << 24)

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
    {1u << 20, "STKOF: the stack pointer went below its limit"},
    {1u << 24, "UNALIGNED: misaligned address"},
    {1u << 25, "DIVBYZERO: division by zero"},
};

void cortexm_trap(void)
{
    SCB_VTOR = (uint32_t)(uintptr_t)cortexm_vectors;
    SCB_SHCSR |= SHCSR_FAULTS_ENABLED;
    SCB_CCR |= CCR_DIV_0_TRP | CCR_UNALIGN_TRP;
}

/* At a stack limit (Armv8-M) the core moves the stack pointer to the limit and pushes nothing.
 * No bit of its own reports that. The memory there then holds paint, or what was there before. */
bool cortexm_push_failed(const uint32_t *pushed)
{
    const uint32_t cfsr = SCB_CFSR;

    if ((cfsr & CFSR_STKOF) != 0 && pushed == fxl_stack_limit) {
        return (pushed[7] & XPSR_THUMB) == 0;
    }
    return (cfsr & (CFSR_MSTKERR | CFSR_STKERR)) != 0;
}

/* On these cores the run-time divides only 64-bit numbers. It jumps here, with the caller's lr. */
__attribute__((naked, used)) void cortexm_division_by_zero(void)
{
    __asm__ volatile(".global __aeabi_idiv0, __aeabi_ldiv0\n\t"
                     ".thumb_func\n\t"
                     "__aeabi_idiv0:\n\t"
                     ".thumb_func\n\t"
                     "__aeabi_ldiv0:\n\t"
                     "udf #0");
}

static void find_address(uint32_t cfsr, const cortexm_fault_state *state, cortexm_diagnosis *result)
{
    result->is_address_known = true;
    if ((cfsr & CFSR_MMARVALID) != 0) {
        result->address = SCB_MMFAR;
    } else if ((cfsr & CFSR_BFARVALID) != 0) {
        result->address = SCB_BFAR;
    } else if ((cfsr & CFSR_UNALIGNED) != 0 && state->is_decoded) {
        result->address = state->access.address;
    } else if ((cfsr & (CFSR_IACCVIOL | CFSR_IBUSERR)) != 0 && state->is_pushed) {
        result->address = state->registers[THUMB_PC];
    } else {
        result->is_address_known = false;
    }
}

static int find_code(uint32_t cfsr, const cortexm_diagnosis *found)
{
    if ((cfsr & (CFSR_STKOF | CFSR_MSTKERR | CFSR_STKERR)) != 0) {
        return SYSTEM_EXIT_STACK;
    }
    if ((cfsr & CFSR_DIVBYZERO) != 0) {
        return SYSTEM_EXIT_DIVIDE;
    }
    if ((cfsr & CFSR_UNALIGNED) != 0) {
        return SYSTEM_EXIT_UNALIGNED;
    }
    if ((cfsr & (CFSR_MEMORY | CFSR_BUS)) != 0) {
        const int otherwise = (cfsr & CFSR_MEMORY) != 0 ? SYSTEM_EXIT_PROTECTION : SYSTEM_EXIT_BUS;

        /* Flash is read-only, so a data access to flash that faults was a write. */
        return found->is_address_known
                   ? cortexm_access_code(found->address, (cfsr & CFSR_DACCVIOL) != 0, otherwise)
                   : otherwise;
    }
    return cfsr != 0 ? SYSTEM_EXIT_USAGE : SYSTEM_EXIT_HARD;
}

cortexm_diagnosis cortexm_diagnose(const cortexm_fault_state *state)
{
    const uint32_t cfsr = SCB_CFSR;
    cortexm_diagnosis result = {SYSTEM_EXIT_HARD, false, 0};

    find_address(cfsr, state, &result);
    result.code = find_code(cfsr, &result);
    return result;
}

void cortexm_print_causes(const cortexm_fault_state *state)
{
    const uint32_t cfsr = SCB_CFSR;
    size_t i;

    (void)state;
    for (i = 0; i < sizeof bit_names / sizeof bit_names[0]; i++) {
        if ((cfsr & bit_names[i].bit) != 0) {
            semihosting_text("  ");
            semihosting_text(bit_names[i].name);
            semihosting_text("\n");
        }
    }
    semihosting_text("  cfsr ");
    semihosting_hexadecimal(cfsr);
    semihosting_text("  hfsr ");
    semihosting_hexadecimal(SCB_HFSR);
    semihosting_text("\n");
}
