/* SPDX-License-Identifier: MIT */
#ifndef DIVISIONS_H
#define DIVISIONS_H

#include <stdint.h>

void test_divide(uint32_t rounds);
void test_divide_half(uint32_t rounds);
void test_divide_wide(uint32_t rounds);
void test_fraction(uint32_t rounds);

#endif
