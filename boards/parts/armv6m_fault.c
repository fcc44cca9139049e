/* SPDX-License-Identifier: MIT */
/* Faults of Armv6-M. The core has only one, the hard fault, and does not report its cause. The
 * cause is found from the instruction and the registers. */
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/cortexm_fault.h"
#include "parts/semihosting.h"

#define XPSR_THUMB (1u << 24)

/* Misaligned access always faults here, and there is no division to trap. */
void cortexm_trap(void)
{
}

/* The core does not report it. But it pushes below the program's stack pointer, and the stack is
 * the lowest memory. */
bool cortexm_push_failed(const uint32_t *pushed)
{
    return pushed < fxl_stack_limit;
}

/* libgcc calls the one for 32 bits after pushing r0 and its caller's lr, and
 * jumps to the one for 64 bits with its caller's lr. */
__attribute__((naked, used)) void cortexm_division_by_zero(void)
{
    __asm__ volatile(".global __aeabi_idiv0, __aeabi_ldiv0\n\t"
                     ".thumb_func\n\t"
                     "__aeabi_ldiv0:\n\t"
                     "udf #0\n\t"
                     ".thumb_func\n\t"
                     "__aeabi_idiv0:\n\t"
                     "ldr r1, [sp, #4]\n\t"
                     "mov lr, r1\n\t"
                     "b __aeabi_ldiv0");
}

static cortexm_diagnosis at(int code, uint32_t address)
{
    const cortexm_diagnosis result = {code, true, address};

    return result;
}

static bool is_in_flash(uint32_t address)
{
    return address - (uint32_t)(uintptr_t)fxl_flash_base < (uint32_t)(uintptr_t)fxl_flash_size;
}

cortexm_diagnosis cortexm_diagnose(const cortexm_fault_state *state)
{
    static const cortexm_diagnosis undefined = {SYSTEM_EXIT_USAGE, false, 0};
    const uint32_t pc = state->registers[THUMB_PC];

    if (!state->is_pushed) {
        return at(SYSTEM_EXIT_STACK, state->process_stack);
    }
    if ((state->xpsr & XPSR_THUMB) == 0) {
        return undefined; /* not Thumb code */
    }
    if (!is_in_flash(pc)) {
        return at(SYSTEM_EXIT_BUS, pc); /* a jump to where no code is */
    }
    if (!state->is_decoded) {
        return undefined;
    }
    if ((state->access.address & (state->access.alignment - 1u)) != 0) {
        return at(SYSTEM_EXIT_UNALIGNED, state->access.address);
    }
    return at(cortexm_access_code(state->access.address, state->access.is_write, SYSTEM_EXIT_BUS),
              state->access.address);
}

void cortexm_print_causes(const cortexm_fault_state *state)
{
    if (state->exception != EXCEPTION_HARD) {
        return;
    }
    semihosting_text("  this core does not tell the cause: it follows from the instruction\n");
}
