/* SPDX-License-Identifier: MIT */
/* The least that a Cortex-M needs to run main: a vector table, calls of the debugger, and what Clang calls on Arm in place of
 * memcpy and memset. */
#include "put_text.h"

#include <stddef.h>
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

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

#define COPY(name) \
    void name(void *to, const void *from, size_t size); \
    void name(void *to, const void *from, size_t size) \
    { \
        (void)memcpy(to, from, size); \
    }
#define CLEAR(name) \
    void name(void *to, size_t size); \
    void name(void *to, size_t size) \
    { \
        (void)memset(to, 0, size); \
    }
#define SET(name) \
    void name(void *to, size_t size, int byte); \
    void name(void *to, size_t size, int byte) \
    { \
        (void)memset(to, byte, size); \
    }

COPY(__aeabi_memcpy)
COPY(__aeabi_memcpy4)
COPY(__aeabi_memcpy8)
CLEAR(__aeabi_memclr)
CLEAR(__aeabi_memclr4)
CLEAR(__aeabi_memclr8)
SET(__aeabi_memset)
SET(__aeabi_memset4)
SET(__aeabi_memset8)
