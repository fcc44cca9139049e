/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_COLOUR_RUNS_H
#define EQUALITY_COLOUR_RUNS_H

#include <stdint.h>

void test_colour_runs(uint32_t rounds);

#endif
