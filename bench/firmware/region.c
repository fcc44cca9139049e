/* SPDX-License-Identifier: MIT */
#include "region.h"

/* Functions of their own, which no compiler may inline, merge or leave out:
 * each is one instruction, the return. */
__attribute__((naked, noinline)) void bench_begin(void)
{
    __asm__ volatile("bx lr");
}

__attribute__((naked, noinline)) void bench_end(void)
{
    __asm__ volatile("bx lr");
}
