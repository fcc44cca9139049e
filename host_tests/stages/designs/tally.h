/* SPDX-License-Identifier: MIT */
/* What is kept of a design's errors. */
#ifndef DESIGNS_TALLY_H
#define DESIGNS_TALLY_H

#include <stdio.h>

#include "designs/input.h"

enum {
    /* bin n holds errors above 2^(n + first - 1) up to 2^(n + first); the first
     * also what is smaller, and 0 */
    DESIGNS_BIN_FIRST = -10,
    DESIGNS_BINS = 64
};

typedef struct {
    uint64_t samples, bins[DESIGNS_BINS];
    double max, sum, sum_of_squares;
    designs_input worst;
} designs_tally;

void designs_count(designs_tally *tally, double error, const designs_input *input);

/* The members of a JSON object, without its braces. */
void designs_write_tally(FILE *file, const char *design, enum designs_stage stage,
                         const designs_tally *tally);

#endif
