/* SPDX-License-Identifier: MIT */
/* Claims, and the tally of their samples. */
#ifndef ORACLE_CLAIM_H
#define ORACLE_CLAIM_H

#include <stdio.h>

#include "oracle/random.h"

/* A claim: how its samples are made and how one is judged. A sample is a list of integers, so
 * any sample can be printed and run again. */

enum {
    ORACLE_NUMBERS_MAX = 98,
    ORACLE_KINDS_MAX = 16,
    ORACLE_EXTRAS_MAX = 8
};

/* The value, in the unit of any claim, of a library call that failed and should not have. */
#define ORACLE_REFUSED 1e9

typedef struct {
    int kind;       /* which of the claim's kinds of sample; not part of the input */
    int variant;    /* the claim's */
    uint64_t index; /* of the sample in its shard */
    int count;
    int64_t numbers[ORACLE_NUMBERS_MAX];
} oracle_input;

typedef struct {
    double value;                       /* in the claim's unit */
    uint64_t extras[ORACLE_EXTRAS_MAX]; /* further counts */
} oracle_verdict;

typedef enum {
    ORACLE_COUNTED,
    ORACLE_SKIPPED, /* nothing to judge: not visible, for example */
    ORACLE_UNUSABLE /* not an input of this claim; words say why */
} oracle_outcome;

typedef struct {
    const char *id, *unit;
    const char *numbers; /* the meaning of an input's numbers */
    const char *kinds[ORACLE_KINDS_MAX + 1];
    const char *extras[ORACLE_EXTRAS_MAX + 1];
    int variant; /* which of the claims with these functions */
    void (*generate)(oracle_random *random, oracle_input *input);
    /* Judges a sample. words, where not null, receives the sample in words. */
    oracle_outcome (*judge)(const oracle_input *input, FILE *words, oracle_verdict *verdict);
} oracle_claim;

/* place claim: the claim's record */
extern const oracle_claim oracle_matrix_entry, oracle_matrix_entry_instance, oracle_sine_cosine,
    oracle_orientation_angles, oracle_orientation_axis, oracle_orientation_look_at,
    oracle_orientation_product, oracle_orientation_quaternion, oracle_quaternion,
    oracle_orientation_parents, oracle_vertex_unclipped, oracle_outline_clipped,
    oracle_outline_near_parallel, oracle_coverage, oracle_watertight, oracle_texel_divided,
    oracle_texel_every_16, oracle_texel_every_8, oracle_texel_affine, oracle_light_level,
    oracle_corner_colour, oracle_vertex_turned, oracle_depth_16, oracle_depth_32, oracle_horizon,
    oracle_orthographic_vertex, oracle_orthographic_texel, oracle_orthographic_depth;

static inline void oracle_put(oracle_input *input, int64_t number)
{
    input->numbers[input->count++] = number;
}

/* The largest, the mean, the root mean square and a histogram of a claim's samples. The bounds
 * of the histogram are fixed, so shards can be added up. */

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

/* Coverage of every triangle whose vertices are quarter pixels of a screen of 4 x 4 pixels, in
 * both windings, with repeated vertices. The first vertex of a closed outline has no effect, so
 * it is not varied. Shards divide the first vertices among them. */
/* place fill-rule: what the two claims count */

void oracle_grid(uint64_t shard, uint64_t shards, oracle_tally *tally);

#endif
