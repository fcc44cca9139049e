/* SPDX-License-Identifier: MIT */
/* depth_16 and depth_32: two triangles seen through one pixel, drawn with a depth buffer. Which one
 * shows, against the exact distances of both. */
#include <math.h>

#include "oracle/depth_sample.h"

enum {
    WIDE_BITS = 5 /* what 32 bits resolve more (SPEC.md, section 10.6) */
};

/* --- samples -------------------------------------------------------------------------------- */

/* m of SPEC.md, section 10.3. */
static int mantissa_of(const fxl_lens *lens)
{
    const int64_t most = (int64_t)lens->far_z * 257 / 256 + 1;
    int e = 1, m = 15;
    while ((int64_t)lens->near_z << e < most) {
        e++;
    }
    while (e << m >= 65536) {
        m--;
    }
    return m;
}

/* The distances differ by 2^-20 to 2^-9 of themselves, or by 2^-5 of that with 32 bits. */
static void generate_gap(oracle_random *random, int wide, oracle_input *input)
{
    oracle_setup_generate(random, FXL_SCREEN_MAX, input);
    const int64_t *n = input->numbers;
    const double near = (double)(n[3] + 2 * n[5] + 2) / 65536;
    const double far = fmin((double)(n[4] - n[5]) / 65536, 8000);
    for (int tries = 0; tries < 64; tries++) {
        const double z = far > near ? oracle_spread(random, near, far) : near;
        const double gap = ldexp(oracle_spread(random, 0x1p-20, 0x1p-9), wide ? -WIDE_BITS : 0);
        const int flat = oracle_below(random, 2) == 0; /* as large as few pixels */
        const double depths[DEPTH_FACES] = {z, z * (1 + gap)};
        input->count = ORACLE_SETUP_NUMBERS;
        if (depth_sample_put(random, depths, flat ? 0.5 : 20, input)) {
            return;
        }
    }
}

static void generate_16(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    generate_gap(random, 0, input);
}

static void generate_32(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    generate_gap(random, 1, input);
}

/* --- the claims ----------------------------------------------------------------------------- */

/* accuracy 5.4 */
static oracle_outcome judge_depth(const oracle_input *input, FILE *words, oracle_verdict *verdict,
                                  int wide)
{
    static depth_sample sample;
    double gap, slack;
    if (input->count != DEPTH_NUMBERS) {
        return ORACLE_UNUSABLE;
    }
    if (!depth_sample_read(input, &sample) || !depth_sample_gap(&sample, &gap, &slack)) {
        return ORACLE_SKIPPED;
    }
    const int m = mantissa_of(&sample.setup.view.lens) + (wide ? WIDE_BITS : 0);
    const double allowed = (1 + 1.0 / 32) * ldexp(1, -m) + slack;
    const int nearer = gap > 0 ? 0 : 1, shown = depth_sample_drawn(&sample, wide);
    if (shown < 0 || !depth_sample_covers(&sample, nearer)) {
        return ORACLE_SKIPPED;
    }
    verdict->value = shown != nearer ? fabs(gap) / allowed : 0;
    verdict->extras[0] = shown != nearer;
    if (words) {
        fprintf(words,
                "the %s face is nearer, by %.9g of the distance; the %s one shows; "
                "the resolution is %.9g\n",
                nearer ? "second" : "first", fabs(gap), shown ? "second" : "first", allowed);
    }
    return ORACLE_COUNTED;
}

static oracle_outcome judge_16(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    return judge_depth(input, words, verdict, 0);
}

static oracle_outcome judge_32(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    return judge_depth(input, words, verdict, 1);
}

const oracle_claim oracle_depth_16 = {
    .id = "depth_16",
    .unit = "of its bound",
    .numbers = DEPTH_TEXT,
    .kinds = {"two faces through a pixel"},
    .extras = {"farther_one_shown"},
    .generate = generate_16,
    .judge = judge_16,
};

const oracle_claim oracle_depth_32 = {
    .id = "depth_32",
    .unit = "of its bound",
    .numbers = DEPTH_TEXT,
    .kinds = {"two faces through a pixel"},
    .extras = {"farther_one_shown"},
    .generate = generate_32,
    .judge = judge_32,
};
