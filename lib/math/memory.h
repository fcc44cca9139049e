/* SPDX-License-Identifier: MIT */
/* The two functions of the C library that sources of lib/ call. A compiler demands them of every
 * program, also where there is no C library and so no string.h. Internal. */
#ifndef FXL_MEMORY_H
#define FXL_MEMORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

/* What the records of tables are aligned to: none has a member that is wider. */
#define FXL_WORD    sizeof(uint32_t)
#define FXL_POINTER sizeof(void *)

/* Whether an address is a multiple of `bytes`, a power of two. Null is. */
static inline bool fxl_is_aligned(const void *address, size_t bytes)
{
    return ((uintptr_t)address & (bytes - 1)) == 0;
}

#ifdef __cplusplus
}
#endif

#endif
