/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_SMALL_STAGES_H
#define EQUALITY_SMALL_STAGES_H

#include <stdint.h>

void test_order(uint32_t rounds);
void test_outlines(uint32_t rounds);

#endif
