/* SPDX-License-Identifier: MIT */
/* Code whose executed instructions can be counted by hand, to test the counting itself. Prints a
 * line for each region: its name and its number of instructions, without the call of the end
 * marker. It is assembly, so the compiler does not affect it. It uses only instructions of
 * Armv6-M, except where it tests those that a core may lack. */
#include "contract/system.h"
#include "program.h"

#define REGION(body) \
    ".syntax unified\n\tpush {r4, lr}\n\tbl bench_begin\n\t" body \
    "\n\tbl bench_end\n\tpop {r4, pc}\n\t"
#define NAKED __attribute__((naked, noinline)) static

/* Nothing at all. */
NAKED void empty(void)
{
    __asm__ volatile(REGION(""));
}

/* 1 + 2 * 100: a branch taken 99 times and not taken once. */
NAKED void loop(void)
{
    __asm__ volatile(REGION("movs r0, #100\n"
                            "1:\tsubs r0, #1\n\t"
                            "bne 1b"));
}

/* (ldr) 1 + 2 * 1000003: far more than a slice of the emulator's time. */
NAKED void long_loop(void)
{
    __asm__ volatile(REGION("ldr r0, 2f\n"
                            "1:\tsubs r0, #1\n\t"
                            "bne 1b\n\t"
                            "b 3f\n\t"
                            ".align 2\n"
                            "2:\t.word 1000003\n"
                            "3:"));
}

/* 1 + 10 * (call, multiply, return, subtract, branch). */
NAKED void calls(void)
{
    __asm__ volatile(REGION("movs r4, #10\n"
                            "1:\tbl 2f\n\t"
                            "subs r4, #1\n\t"
                            "bne 1b\n\t"
                            "b 3f\n"
                            "2:\tmuls r0, r4\n\t"
                            "bx lr\n"
                            "3:"));
}

/* Push and pop three registers, store and load one. */
NAKED void memory(void)
{
    __asm__ volatile(REGION("push {r0, r1, r2}\n\t"
                            "str r0, [sp]\n\t"
                            "ldr r1, [sp]\n\t"
                            "pop {r0, r1, r2}"));
}

static void report(const char *name, uint32_t instructions)
{
    text_with_number("bench: calibration ", name, " ", instructions);
}

int main(int argc, char **argv)
{
    bench_start(argc, argv);
    empty();
    report("empty", 0);
    loop();
    report("loop", 1 + 2 * 100);
    long_loop();
    report("long-loop", 1 + 2 * 1000003 + 1);
    calls();
    report("calls", 1 + 10 * 5 + 1);
    memory();
    report("memory", 4);
    system_exit(SYSTEM_EXIT_DONE);
    return SYSTEM_EXIT_DONE; /* not reached */
}
