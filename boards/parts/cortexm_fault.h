/* SPDX-License-Identifier: MIT */
/* What cortexm_fault.c, which reports faults, asks of the file for the core's
 * architecture, which tells what they are. */
#ifndef BOARD_CORTEXM_FAULT_H
#define BOARD_CORTEXM_FAULT_H

#include <stdbool.h>
#include <stdint.h>

#include "parts/thumb.h"

#define EXCEPTION_NMI        2u
#define EXCEPTION_HARD       3u
#define EXCEPTION_LAST_FAULT 7u

/* What is known of a fault. Registers as the program had them; r0 to r3, r12,
 * lr, pc and xpsr only where the core could push them (is_pushed). */
typedef struct {
    uint32_t registers[16];
    uint32_t xpsr;
    uint32_t process_stack;
    uint32_t exception;
    uint32_t exc_return;
    bool is_pushed;
    bool is_run_time; /* the compiler's run-time was to divide by zero */
    bool is_decoded;  /* the instruction at pc is a load or store: access */
    thumb_access access;
} cortexm_fault_state;

/* A code of system.h, and the address, where there is one. */
typedef struct {
    int code;
    bool is_address_known;
    uint32_t address;
} cortexm_diagnosis;

/* Whether the core could not push its registers to where its stack pointer is
 * now, pushed. Of eight words, the last two would be pc and xpsr. */
bool cortexm_push_failed(const uint32_t *pushed);

/* Names the fault. Called for the core's own faults only. */
cortexm_diagnosis cortexm_diagnose(const cortexm_fault_state *state);

/* Prints what the core's fault registers say, a line each. */
void cortexm_print_causes(const cortexm_fault_state *state);

/* Where the compiler's run-time ends when it shall divide by zero, instead of
 * in libgcc's own functions, which go on with a made-up quotient. lr is whoever
 * wanted the quotient; the instruction here is undefined. */
void cortexm_division_by_zero(void);

/* For cortexm_diagnose: the code for an access that failed, by where it went.
 * otherwise: where the address is neither null, flash, nor below the stack. */
int cortexm_access_code(uint32_t address, bool is_write, int otherwise);

#endif
