/* SPDX-License-Identifier: MIT */
/* The least that a Cortex-M needs to run main: a vector table, and calls of the debugger. */
#include "put_text.h"

#include <stdint.h>

enum {
    SYS_WRITE0 = 0x04,
    SYS_EXIT = 0x18,
    APPLICATION_EXIT = 0x20026,
    RUNTIME_ERROR = 0x20023
};

#define CPACR      (*(volatile uint32_t *)0xE000ED88u)
#define STACK_END  0x20004000u /* the RAM of the smallest board, 16 KB */
#define CPACR_FULL (0xFu << 20)

int main(void);
void start(void);
extern void (*const vectors[])(void);

static void call(uint32_t operation, uintptr_t parameter)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = parameter;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void put_text(const char *text)
{
    call(SYS_WRITE0, (uintptr_t)text);
}

void start(void)
{
#ifdef __ARM_FEATURE_MVE
    CPACR |= CPACR_FULL;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    call(SYS_EXIT, main() == 0 ? APPLICATION_EXIT : RUNTIME_ERROR);
    for (;;) {
    }
}

__attribute__((section(".vectors"))) void (*const vectors[])(void) = {(void (*)(void))STACK_END,
                                                                      start, start, start};
