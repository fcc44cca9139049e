/* SPDX-License-Identifier: MIT */
/* Lists that grow. */
#ifndef REF_GROW_H
#define REF_GROW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

/* Makes space for one entry more behind count entries of so many bytes: the capacity becomes twice
 * what it was, or first. Returns the entries, which may have moved; null where memory is short:
 * then nothing has changed. */
static inline void *ref_grown(void *entries, size_t count, size_t *capacity, size_t first,
                              size_t size)
{
    if (count < *capacity) {
        return entries;
    }
    const size_t more = *capacity ? 2 * *capacity : first;
    void *moved = realloc(entries, more * size);
    *capacity = moved ? more : *capacity;
    return moved;
}

#endif
