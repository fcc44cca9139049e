/* SPDX-License-Identifier: MIT */
/* Divisions of 64 bits, built from those of 32 bits that every family of cores has. Internal. */
#ifndef FXL_DIVIDE_WIDE_H
#define FXL_DIVIDE_WIDE_H

#include <stdint.h>

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* floor(numerator / denominator); *rest becomes the remainder. Requires a quotient below
 * 2^32, that is, numerator / 2^32 < denominator. */
uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *remainder);

/* floor(2^64 part / whole). Requires part < whole < 2^63. */
uint64_t fxl_fraction(uint64_t part, uint64_t whole);

/* factor * side / depth, rounded to the nearest unit of factor. Returns false if its
 * magnitude is above limit: quotient untouched.
 * Requires 0 < factor < 2^29, |side| < 2^61, 0 < depth < 2^61, 0 < limit < 2^29.
 * Error: 0.5 + 2^-30 unit + 2^-31 of the quotient. */
bool fxl_ratio(fxl_q16_16 factor, fxl_q18_46 side, fxl_q18_46 depth, int32_t limit,
               int32_t *quotient);

#ifdef __cplusplus
}
#endif

#endif
