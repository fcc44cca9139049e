/* SPDX-License-Identifier: MIT */
/* The first call of every program of the bench. Reads the arguments, disables interrupts, and
 * turns the core's floating-point unit on where the program was compiled for one. */
#ifndef BENCH_START_H
#define BENCH_START_H

void bench_start(int argc, char **argv);

#endif
