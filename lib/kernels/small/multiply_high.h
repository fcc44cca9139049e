/* SPDX-License-Identifier: MIT */
#ifndef FXL_MULTIPLY_HIGH_H
#define FXL_MULTIPLY_HIGH_H

#include <stdint.h>

/* floor(a * b / 2^64): divide_wide.c. */
uint64_t fxl_multiply_high(uint64_t a, uint64_t b);

#endif
