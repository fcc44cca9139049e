/* SPDX-License-Identifier: MIT */
/* The four functions that a compiler may call on its own, also where there is no C library. They
 * follow the C standard, and copy words where both sides are aligned. They are compiled so that
 * their loops do not become calls of themselves. */
#include <stddef.h>
#include <stdint.h>

typedef uint32_t __attribute__((may_alias)) word;

#define IS_WORD(address) (((uintptr_t)(address)&3u) == 0)

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int value, size_t size);
int memcmp(const void *a, const void *b, size_t size);

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    uint8_t *target = to;
    const uint8_t *source = from;

    if (IS_WORD(target) && IS_WORD(source)) {
        for (; size >= 4; size -= 4) {
            *(word *)(void *)target = *(const word *)(const void *)source;
            target += 4;
            source += 4;
        }
    }
    for (; size > 0; size--) {
        *target++ = *source++;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t size)
{
    uint8_t *target = to;
    const uint8_t *source = from;

    if ((uintptr_t)target <= (uintptr_t)source) {
        for (; size > 0; size--) {
            *target++ = *source++;
        }
    } else {
        for (; size > 0; size--) {
            target[size - 1] = source[size - 1];
        }
    }
    return to;
}

void *memset(void *to, int value, size_t size)
{
    uint8_t *target = to;
    const uint8_t byte = (uint8_t)value;
    const uint32_t four = byte * 0x01010101u;

    for (; size > 0 && !IS_WORD(target); size--) {
        *target++ = byte;
    }
    for (; size >= 16; size -= 16) {
        word *words = (word *)(void *)target;

        words[0] = four;
        words[1] = four;
        words[2] = four;
        words[3] = four;
        target += 16;
    }
    for (; size > 0; size--) {
        *target++ = byte;
    }
    return to;
}

int memcmp(const void *a, const void *b, size_t size)
{
    const uint8_t *left = a;
    const uint8_t *right = b;

    for (; size > 0; size--, left++, right++) {
        if (*left != *right) {
            return *left < *right ? -1 : 1;
        }
    }
    return 0;
}
