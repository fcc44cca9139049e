/* SPDX-License-Identifier: MIT */
/* Mutations of scene images. Nearly all get a size and a checksum that match,
 * so that what follows them in the loader is reached. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "../../lib/scene/crc.h"

enum {
    HEADER_SIZE = 160,
    AT_SIZE = 8,
    AT_CRC = 12,
    AT_TABLES = 80,
    TABLES =
        11, /* the last four, of keys, nodes, beams and clusters, stand behind the frame count */
    AT_KEYS = 140,
    AT_BEAMS = 160,   /* in the larger header alone: else what comes there is no table */
    AT_CLUSTERS = 176 /* in the largest header alone */
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
        put32(data + AT_CRC, fxl_crc32(data + 16, stated - 16));
    }
    return size;
}

/* Bytes of one entry or so, somewhere in a table. */
static void mutate_table(uint8_t *data, size_t size, unsigned seed)
{
    unsigned number = seed % TABLES;
    const uint8_t *table =
        data + (number >= 7 ? AT_KEYS + 8 * (number - 7) : AT_TABLES + 8 * number);
    if (number >= TABLES - 2) {
        table = data + (number == TABLES - 1 ? AT_CLUSTERS : AT_BEAMS);
    }
    if (size < AT_CLUSTERS + 8) {
        return;
    }
    size_t offset = get32(table), count = get32(table + 4);
    if (offset >= size || count == 0) {
        return;
    }
    static const uint8_t entry_sizes[TABLES] = {3, 12, 2, 20, 28, 16, 4, 20, 48, 176, 48};
    size_t at = offset + (seed / TABLES % count) * entry_sizes[seed % TABLES];
    size_t workspace = at < size ? size - at : 0;
    size_t piece = entry_sizes[seed % TABLES] < workspace ? entry_sizes[seed % TABLES] : workspace;
    if (piece > 0) {
        LLVMFuzzerMutate(data + at, piece, piece);
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
    unsigned kind = seed % 8;
    unsigned where = seed >> 3;
    if (size < HEADER_SIZE || kind < 2) {
        size = LLVMFuzzerMutate(data, size, max_size);
    } else if (kind < 5) {
        size_t field = 4 * (where % (HEADER_SIZE / 4));
        LLVMFuzzerMutate(data + field, 4, 4);
    } else {
        mutate_table(data, size, where);
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
