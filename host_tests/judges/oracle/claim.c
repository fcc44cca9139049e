/* SPDX-License-Identifier: MIT */
#include "oracle/claim.h"

#include <inttypes.h>
#include <math.h>

/* The bins: 0; 2^-8..2^-5; sixteenths up to 1.5; 2, 4, 8 ... 2^30. The last bin takes everything
 * larger. */
static double upper_bound(int bin)
{
    if (bin == 0) {
        return 0;
    }
    if (bin <= 4) {
        return ldexp(1, bin - 9);
    }
    if (bin <= 28) {
        return (bin - 4) / 16.0;
    }
    return ldexp(1, bin - 28);
}

enum {
    LAST_BIN = 28 + 30
};

void oracle_tally_count(oracle_tally *tally, const oracle_input *input,
                        const oracle_verdict *verdict)
{
    double value = verdict->value;
    int bin = 0;
    while (bin < LAST_BIN && value > upper_bound(bin)) {
        bin++;
    }
    tally->bins[bin]++;
    tally->sum += value;
    tally->squares += value * value;
    if (tally->samples == 0 || value > tally->max) {
        tally->max = value;
        tally->worst = *input;
    }
    tally->samples++;
    for (int i = 0; i < ORACLE_EXTRAS_MAX; i++) {
        tally->extras[i] += verdict->extras[i];
    }
    if (tally->kinds[input->kind].samples++ == 0 || value > tally->kinds[input->kind].max) {
        tally->kinds[input->kind].max = value;
        tally->kinds[input->kind].worst = *input;
    }
}

static void print_input(const oracle_input *input)
{
    for (int i = 0; i < input->count; i++) {
        printf("%s%" PRId64, i ? " " : "", input->numbers[i]);
    }
}

static void print_kinds(const oracle_tally *tally, const oracle_claim *claim)
{
    printf(", \"kinds\": [");
    for (int i = 0; i < ORACLE_KINDS_MAX && claim->kinds[i]; i++) {
        printf("%s{\"kind\": \"%s\", \"samples\": %" PRIu64 ", \"max\": %.9g, \"worst_input\": \"",
               i ? ", " : "", claim->kinds[i], tally->kinds[i].samples, tally->kinds[i].max);
        print_input(&tally->kinds[i].worst);
        printf("\"}");
    }
    printf("]");
}

void oracle_tally_print(const oracle_tally *tally, const oracle_claim *claim)
{
    double count = tally->samples ? (double)tally->samples : 1;
    printf("{\"id\": \"%s\", \"samples\": %" PRIu64 ", \"skipped\": %" PRIu64
           ", \"max\": %.9g, \"mean\": %.9g, \"rms\": %.9g, \"unit\": \"%s\", \"worst_input\": \"",
           claim->id, tally->samples, tally->skipped, tally->max, tally->sum / count,
           sqrt(tally->squares / count), claim->unit);
    print_input(&tally->worst);
    printf("\", \"sum\": %.17g, \"sum_of_squares\": %.17g", tally->sum, tally->squares);
    for (int i = 0; i < ORACLE_EXTRAS_MAX && claim->extras[i]; i++) {
        printf(", \"%s\": %" PRIu64, claim->extras[i], tally->extras[i]);
    }
    print_kinds(tally, claim);
    printf(", \"histogram\": [");
    for (int bin = 0; bin <= LAST_BIN; bin++) {
        printf("%s{\"upto\": %.9g, \"count\": %" PRIu64 "}", bin ? ", " : "", upper_bound(bin),
               tally->bins[bin]);
    }
    printf("]}\n");
}
