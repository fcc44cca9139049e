/* SPDX-License-Identifier: MIT */
/* oracle: judges the library in exact rational arithmetic.
 *   oracle CLAIM --samples N --seed S --shard I [--shards K]   one shard, as JSON
 *          [--kind N]                                          of one kind only, from 0
 *          [--clipper NAME]                                    outlines and gaps by another clipper
 *          [--own-integers]                                    given the clipper's own integers
 *   oracle CLAIM --input "NUMBERS"                             one sample, in words
 *   oracle coverage --grid [--shard I --shards K]              all small triangles
 *   oracle --list                                              claims and units
 * A shard's samples depend on claim, seed and shard alone. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/clip.h"
#include "oracle/claim.h"

/* place claim: the list of claims */
static const oracle_claim *const claims[] = {
    &oracle_matrix_entry,
    &oracle_matrix_entry_instance,
    &oracle_orientation_angles,
    &oracle_orientation_axis,
    &oracle_orientation_look_at,
    &oracle_orientation_product,
    &oracle_orientation_quaternion,
    &oracle_quaternion,
    &oracle_orientation_parents,
    &oracle_sine_cosine,
    &oracle_vertex_unclipped,
    &oracle_outline_clipped,
    &oracle_outline_near_parallel,
    &oracle_coverage,
    &oracle_watertight,
    &oracle_texel_divided,
    &oracle_texel_every_16,
    &oracle_texel_every_8,
    &oracle_texel_affine,
    &oracle_light_level,
    &oracle_corner_colour,
    &oracle_vertex_turned,
    &oracle_depth_16,
    &oracle_depth_32,
    &oracle_horizon,
    &oracle_orthographic_vertex,
    &oracle_orthographic_texel,
    &oracle_orthographic_depth,
};

enum {
    CLAIMS = sizeof claims / sizeof claims[0]
};

typedef struct {
    uint64_t samples, seed, shard, shards, kind;
    const char *input;
    int grid;
} choices;

static int fail(const char *sentence, const char *what)
{
    fprintf(stderr, "oracle: %s: %s\n", what, sentence);
    return 2;
}

static int list(void)
{
    for (int i = 0; i < CLAIMS; i++) {
        printf("%s: %s; input: %s\n", claims[i]->id, claims[i]->unit, claims[i]->numbers);
    }
    return 0;
}

static int read_number(const char *text, uint64_t *number)
{
    char *end;
    errno = 0;
    *number = strtoull(text, &end, 10);
    return errno == 0 && end != text && *end == '\0' && *text != '-';
}

static int read_options(int argc, char **argv, choices *options)
{
    for (int i = 2; i < argc; i++) {
        if (strcmp(argv[i], "--grid") == 0) {
            options->grid = 1;
            continue;
        }
        if (strcmp(argv[i], "--own-integers") == 0) {
            oracle_clipper_own_integers();
            continue;
        }
        if (strcmp(argv[i], "--clipper") == 0 && i + 1 < argc) {
            if (!oracle_clipper_choose(argv[++i])) {
                return fail("no clipper has that name", argv[i]);
            }
            continue;
        }
        uint64_t *number = strcmp(argv[i], "--samples") == 0  ? &options->samples
                           : strcmp(argv[i], "--seed") == 0   ? &options->seed
                           : strcmp(argv[i], "--shard") == 0  ? &options->shard
                           : strcmp(argv[i], "--shards") == 0 ? &options->shards
                           : strcmp(argv[i], "--kind") == 0   ? &options->kind
                                                              : NULL;
        if (i + 1 == argc || (!number && strcmp(argv[i], "--input") != 0)) {
            return fail(number ? "needs a value" : "unknown option or missing value", argv[i]);
        }
        i++;
        if (!number) {
            options->input = argv[i];
        } else if (!read_number(argv[i], number)) {
            return fail("not a whole number", argv[i]);
        }
    }
    if (options->shards == 0) {
        options->shards = options->shard + 1;
    }
    return options->shard < options->shards ? 0 : fail("must be below --shards", "--shard");
}

static int run_input(const oracle_claim *claim, const char *text)
{
    oracle_input input = {.variant = claim->variant};
    while (*text) {
        char *end;
        int64_t number = strtoll(text, &end, 10);
        if (end == text) {
            return fail("not whole numbers with blanks between them", text);
        }
        if (input.count == ORACLE_NUMBERS_MAX) {
            return fail("too many numbers", "--input");
        }
        oracle_put(&input, number);
        text = end + strspn(end, " \n");
    }
    oracle_verdict verdict = {0};
    oracle_outcome outcome = claim->judge(&input, stdout, &verdict);
    if (outcome == ORACLE_UNUSABLE) {
        return fail(claim->numbers, "--input must be");
    }
    if (outcome == ORACLE_SKIPPED) {
        printf("nothing to judge: out of sight, in exact arithmetic and for the library\n");
        return 0;
    }
    printf("%s: %.9g (%s)\n", claim->id, verdict.value, claim->unit);
    for (int i = 0; i < ORACLE_EXTRAS_MAX && claim->extras[i]; i++) {
        printf("%s: %" PRIu64 "\n", claim->extras[i], verdict.extras[i]);
    }
    return 0;
}

static int run_shard(const oracle_claim *claim, const choices *options)
{
    static oracle_tally tally;
    oracle_random random = oracle_random_start(claim->id, options->seed, options->shard);
    for (uint64_t index = 0; tally.samples < options->samples; index++) {
        if (tally.skipped > 1000 * options->samples + 100000) {
            return fail("hardly any sample can be judged", claim->id);
        }
        oracle_input input = {.variant = claim->variant, .index = index};
        oracle_verdict verdict = {0};
        claim->generate(&random, &input);
        if (options->kind < ORACLE_KINDS_MAX && (uint64_t)input.kind != options->kind) {
            tally.skipped++;
            continue;
        }
        if (claim->judge(&input, NULL, &verdict) == ORACLE_COUNTED) {
            oracle_tally_count(&tally, &input, &verdict);
        } else {
            tally.skipped++;
        }
    }
    oracle_tally_print(&tally, claim);
    return 0;
}

static int run_grid(const choices *options)
{
    static oracle_tally tally;
    oracle_grid(options->shard, options->shards, &tally);
    oracle_tally_print(&tally, &oracle_coverage);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        return fail("give a claim's id, or --list", "nothing to do");
    }
    if (strcmp(argv[1], "--list") == 0) {
        return list();
    }
    choices options = {.samples = 100000, .seed = 1, .kind = ORACLE_KINDS_MAX};
    int status = read_options(argc, argv, &options);
    if (status != 0) {
        return status;
    }
    for (int i = 0; i < CLAIMS; i++) {
        if (strcmp(argv[1], claims[i]->id) == 0) {
            if (options.grid && claims[i] != &oracle_coverage) {
                return fail("only the claim coverage has a grid", argv[1]);
            }
            return options.input  ? run_input(claims[i], options.input)
                   : options.grid ? run_grid(&options)
                                  : run_shard(claims[i], &options);
        }
    }
    return fail("no such claim; oracle --list names them", argv[1]);
}
