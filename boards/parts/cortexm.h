/* SPDX-License-Identifier: MIT */
/* The registers of the system space that Armv6-M, Armv7-M and Armv8-M cores share (their
 * Architecture Reference Manuals, part B); what a board passes to the parts; and what the parts
 * of a core pass to each other. */
#ifndef BOARD_CORTEXM_H
#define BOARD_CORTEXM_H

#include <stdbool.h>
#include <stdint.h>

#define CORTEXM_REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

#define SYST_CSR        CORTEXM_REGISTER(0xE000E010u)
#define SYST_RVR        CORTEXM_REGISTER(0xE000E014u)
#define SYST_CVR        CORTEXM_REGISTER(0xE000E018u)
#define NVIC_ISER       CORTEXM_REGISTER(0xE000E100u)
#define SCB_ICSR        CORTEXM_REGISTER(0xE000ED04u)
#define SCB_VTOR        CORTEXM_REGISTER(0xE000ED08u)
#define SCB_AIRCR       CORTEXM_REGISTER(0xE000ED0Cu)
#define SCB_CCR         CORTEXM_REGISTER(0xE000ED14u)
#define CCR_UNALIGN_TRP (1u << 3)
#define CCR_DIV_0_TRP   (1u << 4)
#define SCB_SHCSR       CORTEXM_REGISTER(0xE000ED24u)
#define SCB_CFSR        CORTEXM_REGISTER(0xE000ED28u)
#define SCB_HFSR        CORTEXM_REGISTER(0xE000ED2Cu)
#define SCB_MMFAR       CORTEXM_REGISTER(0xE000ED34u)
#define SCB_BFAR        CORTEXM_REGISTER(0xE000ED38u)
#define MPU_TYPE        CORTEXM_REGISTER(0xE000ED90u)
#define MPU_CTRL        CORTEXM_REGISTER(0xE000ED94u)

/* The lowest bytes of memory, which the protection makes inaccessible so that access through a
 * null pointer faults. Where flash lies there, they hold only the vector table, which the core
 * reads unprotected. The size is a page of the emulator: with a smaller region the emulator
 * checks every access to the rest of the page, which takes QEMU 10 tens of times longer. */
#define CORTEXM_NULL_BYTES 4096u

/* The architecture's code space. Some boards give no fault there where they have nothing, or
 * show their flash again. A program needs nothing there except its flash. */
#define CORTEXM_CODE_BASE 0x00000000u
#define CORTEXM_CODE_SIZE 0x20000000u

/* Symbols of linker/sections.ld and of BOARD_MEMORY in board.mk. Only their addresses have a
 * meaning; the address of a ..._size symbol is the size. */
extern uint32_t fxl_data_load[], fxl_data_start[], fxl_data_end[];
extern uint32_t fxl_bss_start[], fxl_bss_end[];
extern uint32_t fxl_stack_guard[], fxl_stack_limit[], fxl_stack_top[];
extern uint32_t fxl_handler_stack_top[];
extern uint8_t fxl_flash_base[], fxl_flash_size[], fxl_scene_base[], fxl_scene_size[];
/* Of a second flash; size 0: there is none. Weak, as the compiler takes no other address for 0. */
extern __attribute__((weak)) uint8_t fxl_scene_flash_base[], fxl_scene_flash_size[];

typedef void (*cortexm_vector)(void);

/* The core's vector table, at the start of flash. */
extern const cortexm_vector cortexm_vectors[];

/* Entry after reset. Paints the stacks, fills .data and .bss, turns on traps and memory
 * protection, then calls board_start and main, which is not expected to return. */
void board_reset(void);

/* Entry of every fault and of every unexpected interrupt. Prints what happened and ends the
 * program with a code of system.h. */
void cortexm_fault(void);

/* Makes the core fault at a division by zero and at a misaligned address, where the core has
 * that choice, and report the kinds of faults separately. In armv..._fault.c. */
void cortexm_trap(void);

/* Sets up and turns on the memory protection: flash is read-only; the rest of the code space,
 * the lowest bytes of memory and the guard below the stack are inaccessible. Returns whether the
 * core has a protection. */
bool cortexm_protect(void);

/* Tells whether cortexm_protect turned the protection on. */
bool cortexm_protected(void);

/* The SysTick interrupt; parts/systick.c has one. */
void cortexm_systick(void);

/* The initialisation of a board, before main. parts/defaults.c has one that starts SysTick. */
void board_start(void);

int main(int argc, char **argv);

#endif
