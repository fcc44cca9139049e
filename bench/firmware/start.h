/* SPDX-License-Identifier: MIT */
/* First call of every program of the bench: takes the arguments, lets no
 * interrupt in, and turns the core's floating-point unit on where the program
 * was compiled for one. */
#ifndef BENCH_START_H
#define BENCH_START_H

void bench_start(int argc, char **argv);

#endif
