/* SPDX-License-Identifier: MIT */
/* Whether the caller's memory lies where its records may. Internal. */
#ifndef FXL_ALIGNED_H
#define FXL_ALIGNED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What the records of tables are aligned to: none has a member that is wider. */
#define FXL_WORD    sizeof(uint32_t)
#define FXL_POINTER sizeof(void *)

/* Whether an address is a multiple of `bytes`, a power of two. Null is. */
static inline bool fxl_is_aligned(const void *address, size_t bytes)
{
    return ((uintptr_t)address & (bytes - 1)) == 0;
}

#endif
