/* SPDX-License-Identifier: MIT */
/* Divisions of 64 bits, built from those of 32 bits that every family of cores has. Internal. */
#ifndef FXL_DIVIDE_WIDE_H
#define FXL_DIVIDE_WIDE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* floor(numerator / denominator); *rest becomes the remainder. Requires a quotient below
 * 2^32, that is, numerator / 2^32 < denominator. */
uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *rest);

/* floor(2^64 part / whole). Requires part < whole < 2^63. */
uint64_t fxl_fraction(uint64_t part, uint64_t whole);

#ifdef __cplusplus
}
#endif

#endif
