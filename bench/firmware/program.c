/* SPDX-License-Identifier: MIT */
#include "program.h"

#include "contract/system.h"

/* Armv7-M Architecture Reference Manual, B3.2.20: full access to coprocessors
 * 10 and 11, which are the floating-point unit and the vector extension. */
#define CPACR       (*(volatile uint32_t *)0xE000ED88u)
#define CPACR_FLOAT (0xFu << 20)

void bench_start(int argc, char **argv)
{
    system_start(argc, argv);
#ifdef __arm__
    __asm__ volatile("cpsid i");
#endif
#ifdef __ARM_FP
    CPACR |= CPACR_FLOAT;
    __asm__ volatile("dsb\n\tisb");
#endif
}

#ifdef __arm__
#define RETURN "bx lr"
#else
#define RETURN "ret"
#endif

/* Functions of their own, which no compiler may inline, merge or leave out:
 * each is one instruction, the return. */
__attribute__((naked, noinline)) void bench_begin(void)
{
    __asm__ volatile(RETURN);
}

__attribute__((naked, noinline)) void bench_end(void)
{
    __asm__ volatile(RETURN);
}

void text_with_number(const char *before, const char *name, const char *between, uint32_t number)
{
    char digits[12]; /* 4294967295, the line's end and the 0 */
    char *first = &digits[sizeof digits - 1];

    *first-- = '\0';
    *first = '\n';
    do {
        first--;
        *first = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    system_text(before);
    system_text(name);
    system_text(between);
    system_text(first);
}
