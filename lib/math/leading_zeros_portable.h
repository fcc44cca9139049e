/* SPDX-License-Identifier: MIT */
/* The count of leading zeros. Internal; each family of cores has its own file. */
#ifndef FXL_LEADING_ZEROS_H
#define FXL_LEADING_ZEROS_H

#include <stdint.h>

/* The number of 0 bits above the highest 1 of value. Requires value > 0. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    return (unsigned)__builtin_clz(value);
}

#endif
