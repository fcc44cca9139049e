/* SPDX-License-Identifier: MIT */
#include "designs/tally.h"

#include <inttypes.h>
#include <math.h>

void designs_count(designs_tally *tally, double error, const designs_input *input)
{
    if (tally->samples == 0 || error > tally->max) {
        tally->max = error;
        tally->worst = *input;
    }
    tally->samples++;
    tally->sum += error;
    tally->sum_of_squares += error * error;
    int power = DESIGNS_BIN_FIRST, bin = 0;
    if (error > 0) {
        double fraction = frexp(error, &power); /* fraction of 1/2 is 2^(power - 1) itself */
        power -= fraction == 0.5;
    }
    bin = power - DESIGNS_BIN_FIRST;
    tally->bins[bin < 0 ? 0 : bin >= DESIGNS_BINS ? DESIGNS_BINS - 1 : bin]++;
}

void designs_write_tally(FILE *file, const char *design, enum designs_stage stage,
                         const designs_tally *tally)
{
    char text[DESIGNS_TEXT_MAX];
    designs_write_input(stage, &tally->worst, text);
    fprintf(file, "{\"design\": \"%s\", \"samples\": %" PRIu64 ", \"max\": %.17g, ", design,
            tally->samples, tally->max);
    fprintf(file, "\"sum\": %.17g, \"sum_of_squares\": %.17g, \"worst_input\": \"%s\", ",
            tally->sum, tally->sum_of_squares, text);
    fprintf(file, "\"histogram\": [");
    const char *comma = "";
    for (int i = 0; i < DESIGNS_BINS; i++) {
        if (tally->bins[i]) {
            fprintf(file, "%s{\"upto\": %.17g, \"count\": %" PRIu64 "}", comma,
                    ldexp(1, i + DESIGNS_BIN_FIRST), tally->bins[i]);
            comma = ", ";
        }
    }
    fprintf(file, "]}");
}
