/* SPDX-License-Identifier: MIT */
#include "designs/random.h"

/* FNV-1a. */
static uint64_t hash(const char *text)
{
    uint64_t value = UINT64_C(0xCBF29CE484222325);
    for (; *text; text++) {
        value = (value ^ (uint8_t)*text) * UINT64_C(0x100000001B3);
    }
    return value;
}

oracle_random designs_random_start(uint64_t seed, const char *kind, uint64_t point, uint64_t shard)
{
    oracle_random random = {seed};
    random.state = oracle_random_next(&random) ^ hash(kind);
    random.state = oracle_random_next(&random) + point;
    random.state = oracle_random_next(&random) + shard;
    random.state = oracle_random_next(&random);
    return random;
}

double designs_random_spread(oracle_random *random, double low, double high)
{
    uint32_t octaves = 1;
    for (double end = 2 * low; end < high; end *= 2) {
        octaves++;
    }
    double from = low;
    for (uint32_t i = oracle_below(random, octaves); i > 0; i--) {
        from *= 2;
    }
    return oracle_uniform(random, from, 2 * from < high ? 2 * from : high);
}
