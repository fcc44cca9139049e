/* SPDX-License-Identifier: MIT */
#include "designs/random.h"

#include <math.h>

/* SplitMix64 (Steele, Lea, Flood 2014). */
uint64_t designs_random_bits(designs_random *random)
{
    uint64_t z = random->state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

/* FNV-1a. */
static uint64_t hash(const char *text)
{
    uint64_t value = UINT64_C(0xCBF29CE484222325);
    for (; *text; text++) {
        value = (value ^ (uint8_t)*text) * UINT64_C(0x100000001B3);
    }
    return value;
}

designs_random designs_random_start(uint64_t seed, const char *kind, uint64_t point, uint64_t shard)
{
    designs_random random = {seed};
    random.state = designs_random_bits(&random) ^ hash(kind);
    random.state = designs_random_bits(&random) + point;
    random.state = designs_random_bits(&random) + shard;
    random.state = designs_random_bits(&random);
    return random;
}

uint32_t designs_random_below(designs_random *random, uint32_t limit)
{
    return (uint32_t)((designs_random_bits(random) >> 32) * limit >> 32);
}

double designs_random_uniform(designs_random *random, double low, double high)
{
    return low + (high - low) * ((double)(designs_random_bits(random) >> 11) * 0x1p-53);
}

double designs_random_spread(designs_random *random, double low, double high)
{
    uint32_t octaves = 1;
    for (double end = 2 * low; end < high; end *= 2) {
        octaves++;
    }
    double from = low;
    for (uint32_t i = designs_random_below(random, octaves); i > 0; i--) {
        from *= 2;
    }
    return designs_random_uniform(random, from, 2 * from < high ? 2 * from : high);
}

void designs_random_direction(designs_random *random, double direction[3])
{
    double square;
    do {
        square = 0;
        for (int i = 0; i < 3; i++) {
            direction[i] = designs_random_uniform(random, -1, 1);
            square += direction[i] * direction[i];
        }
    } while (square > 1 || square < 0x1p-20);
    double length = sqrt(square);
    for (int i = 0; i < 3; i++) {
        direction[i] /= length;
    }
}
