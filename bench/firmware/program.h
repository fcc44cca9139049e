/* SPDX-License-Identifier: MIT */
/* What every program of the bench has: its first call, the measured region, and lines for the tool
 * that runs it. */
#ifndef BENCH_PROGRAM_H
#define BENCH_PROGRAM_H

#include <stdint.h>

/* The first call. Reads the arguments, disables interrupts, and turns the core's floating-point
 * unit on where the program was compiled for one. */
void bench_start(int argc, char **argv);

/* The measured region: everything between these two calls. The counting plugin finds them by
 * name. Without the plugin they do nothing. */
void bench_begin(void);
void bench_end(void);

/* Prints a line: before, name, between, and a number in decimal. */
void text_with_number(const char *before, const char *name, const char *between, uint32_t number);

#endif
