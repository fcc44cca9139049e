/* SPDX-License-Identifier: MIT */
/* Largest, mean and histogram of differences. */
#ifndef STAGES_TALLY_H
#define STAGES_TALLY_H

#include <stdint.h>

/* Bin k counts differences <= 2^(k + TALLY_FIRST_POWER); the first also takes
 * 0, the last everything larger. */
enum {
    TALLY_BINS = 56,
    TALLY_FIRST_POWER = -36
};

enum {
    TALLY_EXTRAS = 3
};

typedef struct {
    const char *stage, *input; /* "clip", "scene" and so on */
    const char *unit, *measure, *bound;
    uint64_t samples;
    double max, sum;
    uint64_t beyond_bound; /* samples that docs/accuracy.md does not allow */
    uint64_t mismatched;   /* the two sides gave results of another kind */
    uint64_t bins[TALLY_BINS];
    const char *extra_names[TALLY_EXTRAS]; /* further maxima; null where none */
    double extras[TALLY_EXTRAS];
} stages_tally;

void stages_count(stages_tally *tally, double difference, int within_bound);
void stages_extra(stages_tally *tally, int which, double difference);

/* As one JSON object on stdout. */
void stages_print(const stages_tally *tally);

#endif
