/* SPDX-License-Identifier: MIT */
/* Random samples that are the same on every machine: integers and the four operations of IEEE
 * double only, and square roots. */
#ifndef DESIGNS_RANDOM_H
#define DESIGNS_RANDOM_H

#include "oracle/random.h"

/* The stream of one shard of one kind of samples. */
oracle_random designs_random_start(uint64_t seed, const char *kind, uint64_t point, uint64_t shard);

/* Evenly by magnitude: each octave of low..high is equally likely, and so is
 * every part of an octave. 0 < low <= high. */
double designs_random_spread(oracle_random *random, double low, double high);

#endif
