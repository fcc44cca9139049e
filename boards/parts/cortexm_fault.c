/* SPDX-License-Identifier: MIT */
/* Reports a fault of the core: its name, the address, the registers; and an exit code for each
 * kind. Runs on the main stack. */
#include "parts/cortexm_fault.h"

#include <stddef.h>

#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/stack.h"
#include "parts/watchdog.h"

#define FRAME_WORDS    8u
#define XPSR_REALIGNED (1u << 9) /* the core pushed one more word, for alignment */
#define BRANCH_BYTES   4u        /* of BL */

enum {
    LR = 14
};

static bool is_in(uint32_t address, const uint8_t *base, const uint8_t *size)
{
    return address - (uint32_t)(uintptr_t)base < (uint32_t)(uintptr_t)size;
}

int cortexm_access_code(uint32_t address, bool is_write, int otherwise)
{
    if (address >= (uint32_t)(uintptr_t)fxl_stack_guard &&
        address < (uint32_t)(uintptr_t)fxl_stack_limit) {
        return SYSTEM_EXIT_STACK;
    }
    if (address < CORTEXM_NULL_BYTES) {
        return SYSTEM_EXIT_NULL;
    }
    if (is_write && (is_in(address, fxl_flash_base, fxl_flash_size) ||
                     is_in(address, fxl_scene_flash_base, fxl_scene_flash_size))) {
        return SYSTEM_EXIT_FLASH;
    }
    return otherwise;
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
    case SYSTEM_EXIT_HANG:
        return "the program hung: the watchdog was not fed";
    default:
        return "hard fault";
    }
}

static bool is_code(uint32_t address)
{
    const uint32_t base = (uint32_t)(uintptr_t)fxl_flash_base;

    return address >= base + (address < CORTEXM_NULL_BYTES ? CORTEXM_NULL_BYTES : 0) &&
           address < (uint32_t)(uintptr_t)fxl_scene_base &&
           is_in(address, fxl_flash_base, fxl_flash_size);
}

/* Returns the lowest word of the stack that is a return address: odd, into the code, behind a
 * branch with link. That call overflowed the stack. Returns 0 where there is none. */
static uint32_t find_return_address(void)
{
    const uint32_t *word;

    for (word = fxl_stack_limit; word < fxl_stack_top; word++) {
        const uint32_t before = (*word & ~1u) - BRANCH_BYTES;

        if ((*word & 1u) != 0 && is_code(before)) {
            const uint16_t *code = (const uint16_t *)(uintptr_t)before;

            if ((code[0] & 0xF800u) == 0xF000u && (code[1] & 0xD000u) == 0xD000u) {
                return *word;
            }
        }
    }
    return 0;
}

/* pushed: the core's frame; saved: r4 to r11. */
static void collect(cortexm_fault_state *state, const uint32_t *pushed, const uint32_t *saved)
{
    static const uint8_t places[FRAME_WORDS - 1u] = {0, 1, 2, 3, 12, LR, THUMB_PC};
    uint32_t i;

    for (i = 0; i < 8; i++) {
        state->registers[4 + i] = saved[i];
    }
    state->is_pushed = !cortexm_push_failed(pushed);
    state->registers[THUMB_SP] = (uint32_t)(uintptr_t)pushed;
    state->is_run_time = false;
    state->is_decoded = false;
    if (!state->is_pushed) {
        state->registers[LR] = find_return_address();
        return;
    }
    for (i = 0; i < sizeof places; i++) {
        state->registers[places[i]] = pushed[i];
    }
    state->xpsr = pushed[FRAME_WORDS - 1u];
    state->registers[THUMB_SP] += FRAME_WORDS * 4u + ((state->xpsr & XPSR_REALIGNED) != 0 ? 4u : 0);
    state->is_run_time =
        state->registers[THUMB_PC] == ((uint32_t)(uintptr_t)cortexm_division_by_zero & ~1u);
    if (is_code(state->registers[THUMB_PC])) {
        const uint16_t *code = (const uint16_t *)(uintptr_t)state->registers[THUMB_PC];

        state->is_decoded = thumb_decode(code, state->registers, &state->access);
    }
}

static cortexm_diagnosis diagnose(cortexm_fault_state *state)
{
    cortexm_diagnosis result = {SYSTEM_EXIT_INTERRUPT, false, 0};

    if (watchdog_barked(state->exception)) {
        result.code = SYSTEM_EXIT_HANG;
        return result;
    }
    if (state->exception < EXCEPTION_HARD || state->exception > EXCEPTION_LAST_FAULT) {
        return result;
    }
    if (state->is_run_time) {
        /* The address to report is that of the caller of the division. */
        state->registers[THUMB_PC] = (state->registers[LR] & ~1u) - BRANCH_BYTES;
        result.code = SYSTEM_EXIT_DIVIDE;
        return result;
    }
    result = cortexm_diagnose(state);
    if (state->is_pushed && state->registers[THUMB_PC] < CORTEXM_NULL_BYTES) {
        result.code = SYSTEM_EXIT_NULL; /* a call: there is no code */
        result.is_address_known = true;
        result.address = state->registers[THUMB_PC];
    }
    if (state->process_stack < (uint32_t)(uintptr_t)fxl_stack_limit) {
        result.code = SYSTEM_EXIT_STACK;
    }
    if (result.code == SYSTEM_EXIT_STACK && !result.is_address_known) {
        result.is_address_known = true;
        result.address = state->process_stack;
    }
    return result;
}

static void print_register(const char *label, uint32_t value)
{
    semihosting_text(label);
    semihosting_hexadecimal(value);
}

static void print_pushed(const cortexm_fault_state *state)
{
    if (!state->is_pushed) {
        semihosting_text("\n  pc and r0 to r3 are lost: there was no stack to save them on");
        if (state->registers[LR] != 0) {
            semihosting_text("; the last call seen on it came");
            print_register("\n  from ", state->registers[LR]);
        }
        return;
    }
    print_register("\n  pc  ", state->registers[THUMB_PC]);
    print_register("  lr  ", state->registers[LR]);
    print_register("  xpsr ", state->xpsr);
    print_register("\n  r0  ", state->registers[0]);
    print_register("  r1  ", state->registers[1]);
    print_register("  r2  ", state->registers[2]);
    print_register("  r3  ", state->registers[3]);
    print_register("  r12 ", state->registers[12]);
}

static void print_saved(const cortexm_fault_state *state)
{
    print_register("\n  r4  ", state->registers[4]);
    print_register("  r5  ", state->registers[5]);
    print_register("  r6  ", state->registers[6]);
    print_register("  r7  ", state->registers[7]);
    print_register("\n  r8  ", state->registers[8]);
    print_register("  r9  ", state->registers[9]);
    print_register("  r10 ", state->registers[10]);
    print_register("  r11 ", state->registers[11]);
    semihosting_text("\n");
}

/* saved: r4 to r11. */
__attribute__((used, noreturn)) static void report(const uint32_t *pushed, const uint32_t *saved,
                                                   uint32_t exc_return)
{
    cortexm_fault_state state = {.exc_return = exc_return};
    cortexm_diagnosis found;

    __asm__ volatile("mrs %0, ipsr" : "=r"(state.exception));
    __asm__ volatile("mrs %0, psp" : "=r"(state.process_stack));
    collect(&state, pushed, saved);
    found = diagnose(&state);
    semihosting_text("fault: ");
    semihosting_text(fault_text(found.code));
    semihosting_text(" (exception ");
    semihosting_decimal(state.exception);
    semihosting_text(")\n");
    if (state.is_run_time) {
        semihosting_text("  in the compiler's run-time, called from pc\n");
    } else {
        cortexm_print_causes(&state);
    }
    if (found.is_address_known) {
        print_register("  address ", found.address);
        semihosting_text("\n");
    }
    print_register("  psp ", state.process_stack);
    print_register("  exc_return ", state.exc_return);
    print_pushed(&state);
    print_saved(&state);
    stack_print();
    semihosting_exit(found.code);
}

/* Uses only instructions that every core has. Bit 2 of the link register says to which stack the
 * core pushed. */
__attribute__((naked)) void cortexm_fault(void)
{
    __asm__ volatile("mov r2, lr\n\t"
                     "movs r0, #4\n\t"
                     "tst r0, r2\n\t"
                     "beq 1f\n\t"
                     "mrs r0, psp\n\t"
                     "b 2f\n\t"
                     "1: mrs r0, msp\n\t"
                     "2: mov r1, r11\n\t"
                     "mov r3, r10\n\t"
                     "push {r1}\n\t"
                     "push {r3}\n\t"
                     "mov r1, r9\n\t"
                     "mov r3, r8\n\t"
                     "push {r1}\n\t"
                     "push {r3}\n\t"
                     "push {r4-r7}\n\t"
                     "mov r1, sp\n\t"
                     "ldr r3, =report\n\t"
                     "bx r3\n\t"
                     ".ltorg");
}
