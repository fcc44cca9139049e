/* SPDX-License-Identifier: MIT */
/* A part of a whole, in 2^-64. Internal. */
#ifndef FXL_FRACTION_H
#define FXL_FRACTION_H

#include <stdint.h>

/* floor(2^64 part / whole), part < whole < 2^63. Exact. */
uint64_t fxl_fraction(uint64_t part, uint64_t whole);

#endif
