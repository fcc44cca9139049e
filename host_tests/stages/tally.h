/* SPDX-License-Identifier: MIT */
/* The largest, the mean and a histogram of differences. */
#ifndef STAGES_TALLY_H
#define STAGES_TALLY_H

#include <stdint.h>

/* Bin k counts differences <= 2^(k + TALLY_FIRST_POWER). The first bin also counts 0, the last
 * everything larger. */
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
    uint64_t beyond_bound; /* samples beyond the bound of docs/accuracy.md */
    uint64_t mismatched;   /* the two sides gave results of different kinds */
    uint64_t bins[TALLY_BINS];
    const char *extra_names[TALLY_EXTRAS]; /* more maxima; null where there are none */
    double extras[TALLY_EXTRAS];
} stages_tally;

void stages_count(stages_tally *tally, double difference, int within_bound);
void stages_extra(stages_tally *tally, int which, double difference);

/* Prints the tally as one JSON object on stdout. */
void stages_print(const stages_tally *tally);

#endif
