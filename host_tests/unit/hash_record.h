/* SPDX-License-Identifier: MIT */
/* Hashes on record of kinds of frames with surfaces. */
#ifndef HASH_RECORD_H
#define HASH_RECORD_H

#include "unit.h"

typedef struct {
    uint8_t division; /* FXL_DIVIDE_..., FXL_AFFINE */
    uint8_t with;     /* bits of the test's own: what the kind has */
    uint32_t hash;
} hash_record;

/* Tells each hash that is not the one on record; there must be none. */
static inline void expect_record(const hash_record *record, size_t count,
                                 uint32_t (*hash_of)(uint8_t division, uint32_t with))
{
    uint32_t wrong = 0;
    for (size_t i = 0; i < count; i++) {
        wrong += unit_tell_hash(hash_of(record[i].division, record[i].with), record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}

#endif
