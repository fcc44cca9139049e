/* SPDX-License-Identifier: MIT */
/* Random numbers. They are the same on every machine for the same claim, seed and shard. */
#ifndef ORACLE_RANDOM_H
#define ORACLE_RANDOM_H

#include <stdint.h>

typedef struct {
    uint64_t state;
} oracle_random;

oracle_random oracle_random_start(const char *claim, uint64_t seed, uint64_t shard);

uint64_t oracle_random_next(oracle_random *random);

/* Returns 0 <= n < limit. */
uint32_t oracle_below(oracle_random *random, uint32_t limit);

/* Returns low <= n <= high. */
int64_t oracle_between(oracle_random *random, int64_t low, int64_t high);

/* Returns low <= x < high. */
double oracle_uniform(oracle_random *random, double low, double high);

/* Returns low <= x < high, distributed evenly by magnitude; requires low > 0. */
double oracle_spread(oracle_random *random, double low, double high);

/* The same, of either sign. */
double oracle_signed_spread(oracle_random *random, double low, double high);

/* A direction of unit length, distributed evenly over the sphere: of points in the unit ball, those
 * at least so far from its centre, squared. */
void oracle_direction(oracle_random *random, double least_square, double direction[3]);

#endif
