/* SPDX-License-Identifier: MIT */
/* designs STAGE|sweep:NAME [--samples N] [--seed S] [--shard I]
 * designs STAGE --input "NUMBERS"
 * designs --list
 *
 * One shard of a comparison as JSON, or one input again in words, or what there
 * is to compare. The samples depend on the stage or sweep, the seed and the
 * shard's number, and on nothing else. Exit: 0, or 2 for a bad command line. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "designs/exact.h"
#include "designs/input.h"
#include "designs/stage.h"
#include "frames/input.h"

#define SWEEP_PREFIX "sweep:"

enum {
    DEPTH_FIRST = -9, /* of a vertex: the first bin is from 2^-9 to 2^-8 world units */
    DEPTHS = 24
};

/* What is kept of a design's errors. */
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

static void designs_count(designs_tally *tally, double error, const designs_input *input)
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

/* The members of a JSON object, without its braces. */
static void designs_write_tally(FILE *file, const char *design, enum designs_stage stage,
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

/* Errors of vertices by depth: bin n is from 2^(n + first) to twice that. */
typedef struct {
    uint64_t samples[DEPTHS];
    double max[DEPTHS][DESIGNS_COUNT];
} depth_bins;

typedef struct {
    const char *what, *input;
    uint64_t samples, seed, shard;
} options;

static void count_depth(depth_bins *depths, const designs_input *input, const double *errors)
{
    fxl_view_point view = exact_view_point(input, 0);
    int power;
    (void)frexp((double)view.z * 0x1p-46, &power); /* of a fraction from 1/2 to 1 */
    int bin = power - 1 - DEPTH_FIRST;
    bin = bin < 0 ? 0 : bin >= DEPTHS ? DEPTHS - 1 : bin;
    depths->samples[bin]++;
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        depths->max[bin][i] = fmax(depths->max[bin][i], errors[i]);
    }
}

static void write_depths(const depth_bins *depths)
{
    const char *comma = "";
    printf(", \"depths\": [");
    for (int bin = 0; bin < DEPTHS; bin++) {
        if (depths->samples[bin] == 0) {
            continue;
        }
        printf("%s\n  {\"value\": %.17g, \"samples\": %" PRIu64 ", \"max\": {", comma,
               ldexp(1, bin + DEPTH_FIRST), depths->samples[bin]);
        for (int i = 0; i < DESIGNS_COUNT; i++) {
            printf("%s\"%s\": %.17g", i ? ", " : "", designs_all[i]->name, depths->max[bin][i]);
        }
        printf("}}");
        comma = ",";
    }
    printf("]");
}

/* depths may be null; else the stage is that of vertices. */
static void measure(enum designs_stage stage, const designs_plan *plan, oracle_random random,
                    uint64_t samples, designs_tally tallies[DESIGNS_COUNT], depth_bins *depths)
{
    designs_input input;
    double errors[DESIGNS_COUNT];
    memset(tallies, 0, DESIGNS_COUNT * sizeof *tallies);
    for (uint64_t n = 0; n < samples; n++) {
        designs_sample(stage, plan, &random, &input);
        designs_errors(stage, &input, errors);
        for (int i = 0; i < DESIGNS_COUNT; i++) {
            designs_count(&tallies[i], errors[i], &input);
        }
        if (depths) {
            count_depth(depths, &input, errors);
        }
    }
}

static void write_tallies(enum designs_stage stage, const designs_tally tallies[DESIGNS_COUNT])
{
    printf("\"designs\": [");
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        printf("%s\n  ", i ? "," : "");
        designs_write_tally(stdout, designs_all[i]->name, stage, &tallies[i]);
    }
    printf("]");
}

static int run_stage(const options *wanted, enum designs_stage stage)
{
    static designs_tally tallies[DESIGNS_COUNT];
    const char *name = designs_stage_names[stage];
    oracle_random random = designs_random_start(wanted->seed, name, 0, wanted->shard);
    static depth_bins depths;
    bool by_depth = stage == DESIGNS_VERTEX;
    measure(stage, &designs_whole, random, wanted->samples, tallies, by_depth ? &depths : NULL);
    printf("{\"stage\": \"%s\", ", name);
    write_tallies(stage, tallies);
    if (by_depth) {
        write_depths(&depths);
    }
    printf("}\n");
    return 0;
}

static int run_sweep(const options *wanted, const designs_sweep *sweep)
{
    static designs_tally tallies[DESIGNS_COUNT];
    printf("{\"parameter\": \"%s\", \"points\": [", sweep->name);
    for (int point = 0; point < sweep->count; point++) {
        designs_plan plan = designs_whole;
        oracle_random random =
            designs_random_start(wanted->seed, sweep->name, (uint64_t)point + 1, wanted->shard);
        sweep->set(&plan, sweep->values[point]);
        measure(sweep->stage, &plan, random, wanted->samples, tallies, NULL);
        printf("%s\n {\"value\": %.17g, ", point ? "," : "", sweep->values[point]);
        write_tallies(sweep->stage, tallies);
        printf("}");
    }
    printf("]}\n");
    return 0;
}

static int list(void)
{
    printf("{\"stages\": [");
    for (int i = 0; i < DESIGNS_STAGES; i++) {
        printf("%s\n  {\"stage\": \"%s\", \"unit\": \"%s\", \"measure\": \"%s\"}", i ? "," : "",
               designs_stage_names[i], designs_stage_units[i], designs_stage_measures[i]);
    }
    printf("],\n \"sweeps\": [");
    for (int i = 0; i < DESIGNS_SWEEPS; i++) {
        const designs_sweep *sweep = &designs_sweeps[i];
        printf("%s\n  {\"parameter\": \"%s\", \"label\": \"%s\", \"stage\": \"%s\", "
               "\"unit\": \"%s\"}",
               i ? "," : "", sweep->name, sweep->label, designs_stage_names[sweep->stage],
               designs_stage_units[sweep->stage]);
    }
    printf("]}\n");
    return 0;
}

static int run(const options *wanted)
{
    for (int i = 0; i < DESIGNS_STAGES; i++) {
        if (strcmp(wanted->what, designs_stage_names[i]) != 0) {
            continue;
        }
        designs_input input;
        if (!wanted->input) {
            return run_stage(wanted, (enum designs_stage)i);
        }
        if (!designs_read_input((enum designs_stage)i, wanted->input, &input)) {
            return fail("designs: this is no input of stage", wanted->what);
        }
        designs_explain((enum designs_stage)i, &input);
        return 0;
    }
    size_t prefix = strlen(SWEEP_PREFIX);
    for (int i = 0; i < DESIGNS_SWEEPS && strncmp(wanted->what, SWEEP_PREFIX, prefix) == 0; i++) {
        if (strcmp(wanted->what + prefix, designs_sweeps[i].name) == 0) {
            return run_sweep(wanted, &designs_sweeps[i]);
        }
    }
    return fail("designs: there is no such stage or sweep", wanted->what);
}

int main(int count, char **arguments)
{
    options wanted = {.samples = 10000, .seed = 1};
    const argument known[] = {{"--samples", take_count, &wanted.samples},
                                {"--seed", take_count, &wanted.seed},
                                {"--shard", take_count, &wanted.shard},
                                {"--input", take_text, &wanted.input}};
    if (count == 2 && strcmp(arguments[1], "--list") == 0) {
        return list();
    }
    if (!read_arguments(count, arguments, known, 4, &wanted.what, 1)) {
        return fail("designs: usage", "designs STAGE|sweep:NAME [--samples N] [--seed S] [--shard I], "
                             "designs STAGE --input NUMBERS, designs --list");
    }
    return run(&wanted);
}
