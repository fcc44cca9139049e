/* SPDX-License-Identifier: MIT */
/* What Clang calls on Arm in place of memcpy and memset. */
#include <stddef.h>

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

#define COPY(name) \
    void name(void *to, const void *from, size_t size); \
    void name(void *to, const void *from, size_t size) \
    { \
        (void)memcpy(to, from, size); \
    }
#define CLEAR(name) \
    void name(void *to, size_t size); \
    void name(void *to, size_t size) \
    { \
        (void)memset(to, 0, size); \
    }
#define SET(name) \
    void name(void *to, size_t size, int byte); \
    void name(void *to, size_t size, int byte) \
    { \
        (void)memset(to, byte, size); \
    }

COPY(__aeabi_memcpy)
COPY(__aeabi_memcpy4)
COPY(__aeabi_memcpy8)
CLEAR(__aeabi_memclr)
CLEAR(__aeabi_memclr4)
CLEAR(__aeabi_memclr8)
SET(__aeabi_memset)
SET(__aeabi_memset4)
SET(__aeabi_memset8)
