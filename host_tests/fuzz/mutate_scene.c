/* SPDX-License-Identifier: MIT */
/* Mutations of scene images. Nearly all get a size and a checksum that match,
 * so that what follows them in the loader is reached. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "fixel/crc.h"

enum {
    HEADER_SIZE = 92,
    AT_SECTION_COUNT = 6,
    AT_SIZE = 8,
    AT_CRC = 12,
    ENTRY = 12, /* of the table of sections: kind, needed, offset, count */
    PIECE = 16  /* bytes of a section that change at once */
};

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *a, size_t a_size, const uint8_t *b, size_t b_size,
                                 uint8_t *out, size_t max_size, unsigned seed);

static uint32_t get32(const uint8_t *at)
{
    uint32_t value;
    memcpy(&value, at, sizeof value);
    return value;
}

static void put32(uint8_t *at, uint32_t value)
{
    memcpy(at, &value, sizeof value);
}

/* One in 64 stays as it is, one in eight of the others keeps its stated size. */
static size_t mend(uint8_t *data, size_t size, unsigned seed)
{
    if (size < HEADER_SIZE || (seed >> 8) % 64 == 0) {
        return size;
    }
    if ((seed >> 16) % 8 != 0) {
        put32(data + AT_SIZE, (uint32_t)size & ~3u);
    }
    uint32_t stated = get32(data + AT_SIZE);
    if (stated >= HEADER_SIZE && stated <= size) {
        put32(data + AT_CRC, fxl_crc(FXL_CRC_START, data + 16, stated - 16));
    }
    return size;
}

/* The entry of a section in the table; null if the table is not there. */
static uint8_t *entry_of(uint8_t *data, size_t size, unsigned seed)
{
    const unsigned count = data[AT_SECTION_COUNT];
    const size_t at = HEADER_SIZE + (size_t)ENTRY * (count == 0 ? 0 : seed % count);
    return count == 0 || at + ENTRY > size ? NULL : data + at;
}

/* A few bytes, somewhere in a section. */
static void mutate_section(uint8_t *data, size_t size, unsigned seed)
{
    const uint8_t *entry = entry_of(data, size, seed);
    if (entry == NULL) {
        return;
    }
    const size_t offset = get32(entry + 4);
    if (offset >= size) {
        return;
    }
    const size_t at = offset + seed / 64 % (size - offset);
    const size_t piece = size - at < PIECE ? size - at : PIECE;
    LLVMFuzzerMutate(data + at, piece, piece);
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
    unsigned kind = seed % 8;
    unsigned where = seed >> 3;
    if (size < HEADER_SIZE || kind < 2) {
        size = LLVMFuzzerMutate(data, size, max_size);
    } else if (kind < 4) {
        size_t field = 4 * (where % (HEADER_SIZE / 4));
        LLVMFuzzerMutate(data + field, 4, 4);
    } else if (kind < 5) {
        uint8_t *entry = entry_of(data, size, where);
        if (entry != NULL) {
            LLVMFuzzerMutate(entry, ENTRY, ENTRY);
        }
    } else {
        mutate_section(data, size, where);
    }
    return mend(data, size, seed * 2654435761u);
}

/* The head of one, the rest of the other. */
size_t LLVMFuzzerCustomCrossOver(const uint8_t *a, size_t a_size, const uint8_t *b, size_t b_size,
                                 uint8_t *out, size_t max_size, unsigned seed)
{
    size_t cut = seed % (a_size + 1);
    size_t size = b_size > cut ? b_size : cut;
    size = size > max_size ? max_size : size;
    cut = cut > size ? size : cut;
    memcpy(out, a, cut);
    if (size > cut) {
        memcpy(out + cut, b + cut, size - cut);
    }
    return mend(out, size, seed * 2654435761u);
}
