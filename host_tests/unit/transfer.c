/* SPDX-License-Identifier: MIT */
#include "transfer.h"

#include "unit.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#define POISON(bytes, size)   __asan_poison_memory_region(bytes, size)
#define UNPOISON(bytes, size) __asan_unpoison_memory_region(bytes, size)
#else
#define POISON(bytes, size)   (void)0
#define UNPOISON(bytes, size) (void)0
#endif

void transfer_start(transfer *of, const uint8_t *bytes, size_t size)
{
    TEST_ASSERT_NULL_MESSAGE(of->bytes, "a second transfer while the first is under way");
    TEST_ASSERT_NOT_NULL(bytes);
    TEST_ASSERT_GREATER_THAN(0, size);
    of->bytes = bytes;
    of->size = size;
    of->crc = unit_crc32(bytes, (uint32_t)size);
    of->count += 1;
    POISON(bytes, size);
}

void transfer_wait(transfer *of)
{
    if (of->bytes == NULL) {
        return;
    }
    UNPOISON(of->bytes, of->size);
    TEST_ASSERT_EQUAL_HEX32_MESSAGE(of->crc, unit_crc32(of->bytes, (uint32_t)of->size),
                                    "bytes were changed while they were sent");
    of->take(of->user, of->bytes, of->size);
    of->bytes = NULL;
}
