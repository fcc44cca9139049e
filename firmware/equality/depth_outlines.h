/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_DEPTH_OUTLINES_H
#define EQUALITY_DEPTH_OUTLINES_H

#include <stdint.h>

void test_depth_outlines(uint32_t rounds);
void test_smooth_outlines(uint32_t rounds);
void test_depth_runs(uint32_t rounds);

#endif
