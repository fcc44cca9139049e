/* SPDX-License-Identifier: MIT */
/* Random numbers that are the same on every machine: integers and the four
 * operations of IEEE double only, no function of a mathematical library. */
#ifndef DESIGNS_RANDOM_H
#define DESIGNS_RANDOM_H

#include <stdint.h>

typedef struct {
    uint64_t state;
} designs_random;

/* The stream of one shard of one kind of samples. */
designs_random designs_random_start(uint64_t seed, const char *kind, uint64_t point,
                                    uint64_t shard);

uint64_t designs_random_bits(designs_random *random);

/* 0 <= n < limit */
uint32_t designs_random_below(designs_random *random, uint32_t limit);

/* low <= x < high */
double designs_random_uniform(designs_random *random, double low, double high);

/* Evenly by magnitude: each octave of low..high is equally likely, and so is
 * every part of an octave. 0 < low <= high. */
double designs_random_spread(designs_random *random, double low, double high);

/* A direction of unit length, evenly over the sphere. */
void designs_random_direction(designs_random *random, double direction[3]);

#endif
