/* SPDX-License-Identifier: MIT */
/* The two functions of the C library that sources of lib/ call. A compiler demands them of every
 * program, also where there is no C library and so no string.h. Internal. */
#ifndef FXL_MEMORY_H
#define FXL_MEMORY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

#ifdef __cplusplus
}
#endif

#endif
