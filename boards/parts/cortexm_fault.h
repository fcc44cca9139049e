/* SPDX-License-Identifier: MIT */
/* The functions that cortexm_fault.c, which reports faults, needs from the file of the core's
 * architecture, which tells their kinds. */
#ifndef BOARD_CORTEXM_FAULT_H
#define BOARD_CORTEXM_FAULT_H

#include <stdbool.h>
#include <stdint.h>

#include "parts/thumb.h"

#define EXCEPTION_NMI        2u
#define EXCEPTION_HARD       3u
#define EXCEPTION_LAST_FAULT 7u

/* The data of a fault. The registers are those of the program; r0 to r3, r12, lr, pc and xpsr
 * are valid only if the core could push them (is_pushed). */
typedef struct {
    uint32_t registers[16];
    uint32_t xpsr;
    uint32_t process_stack;
    uint32_t exception;
    uint32_t exc_return;
    bool is_pushed;
    bool is_run_time; /* the compiler's run-time was asked to divide by zero */
    bool is_decoded;  /* the instruction at pc is a load or store; access describes it */
    thumb_access access;
} cortexm_fault_state;

/* An exit code of system.h, and the address, where there is one. */
typedef struct {
    int code;
    bool is_address_known;
    uint32_t address;
} cortexm_diagnosis;

/* Tells whether the core could not push its registers to `pushed`, where its stack pointer is
 * now. Of the eight words, the last two would be pc and xpsr. */
bool cortexm_push_failed(const uint32_t *pushed);

/* Classifies a fault. Called only for the core's own faults. */
cortexm_diagnosis cortexm_diagnose(const cortexm_fault_state *state);

/* Prints the core's fault registers, a line each. */
void cortexm_print_causes(const cortexm_fault_state *state);

/* The compiler's run-time ends here when it must divide by zero. libgcc's own functions would
 * continue with an invented quotient. lr is the caller that needs the quotient; the instruction
 * here is undefined. */
void cortexm_division_by_zero(void);

/* For cortexm_diagnose: returns the code for a failed access by its address. otherwise: the code
 * where the address is neither null, nor flash, nor below the stack. */
int cortexm_access_code(uint32_t address, bool is_write, int otherwise);

#endif
