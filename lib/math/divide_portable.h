/* SPDX-License-Identifier: MIT */
/* Divisions of 32 bits. Internal; one file for each family of cores. */
#ifndef FXL_DIVIDE_H
#define FXL_DIVIDE_H

#include <stdint.h>

/* floor(numerator / denominator); *rest becomes the remainder. Requires denominator > 0. */
static inline uint32_t fxl_divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *rest)
{
    uint32_t quotient = numerator / denominator;
    *rest = numerator - quotient * denominator;
    return quotient;
}

/* floor(numerator / denominator). Requires 2^15 <= denominator <= 2^16. */
static inline uint32_t fxl_divide_half(uint32_t numerator, uint32_t denominator)
{
    return numerator / denominator;
}

#endif
