/* SPDX-License-Identifier: MIT */
/* The registers of the Armv7-M system space that the parts use (Armv7-M
 * Architecture Reference Manual, B3), and what a board hands to them. */
#ifndef BOARD_ARMV7M_H
#define BOARD_ARMV7M_H

#include <stdint.h>

#define ARMV7M_REGISTER(address) (*(volatile uint32_t *)(address))

#define SYST_CSR        ARMV7M_REGISTER(0xE000E010u)
#define SYST_RVR        ARMV7M_REGISTER(0xE000E014u)
#define SYST_CVR        ARMV7M_REGISTER(0xE000E018u)
#define SCB_ICSR        ARMV7M_REGISTER(0xE000ED04u)
#define SCB_AIRCR       ARMV7M_REGISTER(0xE000ED0Cu)
#define SCB_CCR         ARMV7M_REGISTER(0xE000ED14u)
#define CCR_UNALIGN_TRP (1u << 3)
#define CCR_DIV_0_TRP   (1u << 4)
#define SCB_SHCSR       ARMV7M_REGISTER(0xE000ED24u)
#define SCB_CFSR        ARMV7M_REGISTER(0xE000ED28u)
#define SCB_HFSR        ARMV7M_REGISTER(0xE000ED2Cu)
#define SCB_MMFAR       ARMV7M_REGISTER(0xE000ED34u)
#define SCB_BFAR        ARMV7M_REGISTER(0xE000ED38u)
#define MPU_TYPE        ARMV7M_REGISTER(0xE000ED90u)
#define MPU_CTRL        ARMV7M_REGISTER(0xE000ED94u)
#define MPU_RBAR        ARMV7M_REGISTER(0xE000ED9Cu)
#define MPU_RASR        ARMV7M_REGISTER(0xE000EDA0u)

/* The lowest bytes of memory: the vector table, which the core reads
 * unprotected, and nothing else, so that a null pointer cannot pass. A page of
 * the emulator's: a smaller region would make it check every access to the rest
 * of the page, which QEMU 10 takes tens of times longer for. */
#define ARMV7M_NULL_BYTES 4096u

/* Places from linker/sections.ld and the board's memory.ld. Only their
 * addresses mean anything; of ..._size symbols the address is the size. */
extern uint32_t fxl_data_load[], fxl_data_start[], fxl_data_end[];
extern uint32_t fxl_bss_start[], fxl_bss_end[];
extern uint32_t fxl_stack_guard[], fxl_stack_limit[], fxl_stack_top[], fxl_handler_stack_top[];
extern uint8_t fxl_flash_base[], fxl_flash_size[], fxl_scene_base[], fxl_scene_size[];

/* Entry after reset: .data, .bss, stacks, traps, memory protection, then
 * board_start and main, which is not expected to come back. */
void armv7m_reset(void);

/* Entry of every fault and of every interrupt that nobody asked for: prints
 * what happened and ends the program with a code of system.h. */
void armv7m_fault(void);

/* Sets up and turns on the memory protection: flash read-only; the rest of the
 * code space, the lowest bytes of memory and the guard below the stack out of
 * bounds. Ends the program with SYSTEM_EXIT_BOARD on a core without it. */
void armv7m_protect(void);

/* The SysTick interrupt; parts/systick.c has one. */
void armv7m_systick(void);

/* What a board does once before main. Each board.c has one. */
void board_start(void);

int main(int argc, char **argv);

#endif
