/* SPDX-License-Identifier: MIT */
/* Products of 64 bits, for files with many of them, and their upper words. On a core without long
 * products these are calls: in place, those of a file take 1 to 2 KB more. Internal. */
#ifndef FXL_PRODUCT_H
#define FXL_PRODUCT_H

#include "arith.h"
#include "family.h"

#ifdef __cplusplus
extern "C" {
#endif

#if FXL_ESTIMATES
#define FXL_PRODUCT static __attribute__((noinline, unused))
#else
#define FXL_PRODUCT static inline
#endif

FXL_PRODUCT int64_t fxl_product(int32_t a, int32_t b)
{
    return fxl_multiply_s32(a, b);
}

FXL_PRODUCT uint64_t fxl_product_unsigned(uint32_t a, uint32_t b)
{
    return fxl_multiply_u32(a, b);
}

/* Requires a product that fits. */
FXL_PRODUCT int64_t fxl_product_wide(int64_t a, int32_t b)
{
    return fxl_multiply_s64(a, b);
}

/* The upper word of a product, rounded down. */
static inline int32_t fxl_upper_product(int32_t a, int32_t b)
{
    return fxl_signed_32((uint32_t)(fxl_bits_64(fxl_product(a, b)) >> 32));
}

static inline uint32_t fxl_upper_product_unsigned(uint32_t a, uint32_t b)
{
    return (uint32_t)(fxl_product_unsigned(a, b) >> 32);
}

#ifdef __cplusplus
}
#endif

#endif
