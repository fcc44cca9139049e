/* SPDX-License-Identifier: MIT */
/* The benchmark on the machine that builds. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <time.h>

#include "benchmark.h"

static uint32_t microseconds(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)((uint64_t)now.tv_sec * 1000000u + (uint64_t)now.tv_nsec / 1000u);
}

static void print(const char *line)
{
    (void)fputs(line, stdout);
}

int main(void)
{
    static const benchmark_port port = {"host", 0, microseconds, print};

    return benchmark_run(&port) ? 0 : 1;
}
