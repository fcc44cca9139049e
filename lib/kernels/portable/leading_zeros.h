/* SPDX-License-Identifier: MIT */
/* Internal; one file for each family of cores. */
#ifndef FXL_LEADING_ZEROS_H
#define FXL_LEADING_ZEROS_H

#include <stdint.h>

/* How many bits of value, not 0, are 0 before its highest 1. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    return (unsigned)__builtin_clz(value);
}

#endif
