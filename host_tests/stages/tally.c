/* SPDX-License-Identifier: MIT */
#include "stages/measure.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

void stages_count(stages_tally *tally, double difference, int within_bound)
{
    int bin = 0;
    while (bin < TALLY_BINS - 1 && difference > ldexp(1, bin + TALLY_FIRST_POWER)) {
        bin++;
    }
    tally->bins[bin]++;
    tally->samples++;
    tally->sum += difference;
    tally->max = fmax(tally->max, difference);
    tally->beyond_bound += !within_bound;
}

void stages_extra(stages_tally *tally, int which, double difference)
{
    tally->extras[which] = fmax(tally->extras[which], difference);
}

static void print_histogram(const stages_tally *tally)
{
    int first = 0, last = TALLY_BINS - 1;
    while (first < last && tally->bins[first] == 0) {
        first++;
    }
    while (last > first && tally->bins[last] == 0) {
        last--;
    }
    printf("     \"histogram\": [");
    for (int bin = first; bin <= last && tally->samples > 0; bin++) {
        printf("%s{\"upto\": %.9g, \"count\": %" PRIu64 "}", bin > first ? ", " : "",
               ldexp(1, bin + TALLY_FIRST_POWER), tally->bins[bin]);
    }
    printf("]");
}

void stages_print(const stages_tally *tally)
{
    printf("    {\"stage\": \"%s\", \"input\": \"%s\", \"samples\": %" PRIu64
           ", \"max\": %.9g, \"mean\": %.9g,\n",
           tally->stage, tally->input, tally->samples, tally->max,
           tally->samples ? tally->sum / (double)tally->samples : 0);
    printf("     \"unit\": \"%s\",\n     \"measure\": \"%s\",\n     \"bound\": \"%s\",\n",
           tally->unit, tally->measure, tally->bound);
    printf("     \"beyond_bound\": %" PRIu64 ", \"mismatched\": %" PRIu64, tally->beyond_bound,
           tally->mismatched);
    for (int i = 0; i < TALLY_EXTRAS && tally->extra_names[i]; i++) {
        printf(", \"%s\": %.9g", tally->extra_names[i], tally->extras[i]);
    }
    printf(",\n");
    print_histogram(tally);
    printf("}");
}
