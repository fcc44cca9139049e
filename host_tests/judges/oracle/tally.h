/* SPDX-License-Identifier: MIT */
/* The largest, the mean, the root mean square and a histogram of a claim's samples. The bounds
 * of the histogram are fixed, so shards can be added up. */
#ifndef ORACLE_TALLY_H
#define ORACLE_TALLY_H

#include "oracle/claim.h"

enum {
    ORACLE_BINS = 64
};

typedef struct {
    uint64_t samples, skipped;
    double max, sum, squares;
    oracle_input worst; /* the first sample that reached the largest */
    uint64_t bins[ORACLE_BINS];
    uint64_t extras[ORACLE_EXTRAS_MAX];
    struct {
        uint64_t samples;
        double max;
        oracle_input worst;
    } kinds[ORACLE_KINDS_MAX];
} oracle_tally;

void oracle_tally_count(oracle_tally *tally, const oracle_input *input,
                        const oracle_verdict *verdict);

/* Prints the tally as one JSON object on stdout. */
void oracle_tally_print(const oracle_tally *tally, const oracle_claim *claim);

#endif
