/* SPDX-License-Identifier: MIT */
#include "oracle/random.h"

#include <math.h>

/* SplitMix64 (Steele, Lea, Flood 2014). */
uint64_t oracle_random_next(oracle_random *random)
{
    uint64_t z = random->state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

oracle_random oracle_random_start(const char *claim, uint64_t seed, uint64_t shard)
{
    oracle_random random = {seed};
    for (; *claim; claim++) {
        random.state = oracle_random_next(&random) + (unsigned char)*claim;
    }
    random.state = oracle_random_next(&random) + shard;
    random.state = oracle_random_next(&random);
    return random;
}

uint32_t oracle_below(oracle_random *random, uint32_t limit)
{
    return (uint32_t)((oracle_random_next(random) >> 32) * limit >> 32);
}

int64_t oracle_between(oracle_random *random, int64_t low, int64_t high)
{
    return low + (int64_t)oracle_below(random, (uint32_t)(high - low + 1));
}

double oracle_uniform(oracle_random *random, double low, double high)
{
    return low + (high - low) * ((double)(oracle_random_next(random) >> 11) * 0x1p-53);
}

double oracle_spread(oracle_random *random, double low, double high)
{
    return low * pow(high / low, oracle_uniform(random, 0, 1));
}

double oracle_signed_spread(oracle_random *random, double low, double high)
{
    double size = oracle_spread(random, low, high);
    return oracle_below(random, 2) ? size : -size;
}

void oracle_direction(oracle_random *random, double least_square, double direction[3])
{
    double square;
    do {
        square = 0;
        for (int i = 0; i < 3; i++) {
            direction[i] = oracle_uniform(random, -1, 1);
            square += direction[i] * direction[i];
        }
    } while (square > 1 || square < least_square);
    double length = sqrt(square);
    for (int i = 0; i < 3; i++) {
        direction[i] /= length;
    }
}
