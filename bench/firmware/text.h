/* SPDX-License-Identifier: MIT */
/* Lines for the tool that runs the bench. */
#ifndef BENCH_TEXT_H
#define BENCH_TEXT_H

#include <stdint.h>

/* Prints a line: before, name, between, and a number in decimal. */
void text_with_number(const char *before, const char *name, const char *between, uint32_t number);

#endif
