/* SPDX-License-Identifier: MIT */
/* corner_colour: one pixel of a triangle with colours at its corners, as the library draws it in
 * RGB565, against the exact channels there (SPEC.md, section 9.8). */
/* place pixel-format: the claim of colours at corners */
#include <math.h>

#include "oracle/surface_sample.h"

/* Where docs/accuracy.md, section 5.1, allows more, a sample is not judged. */
#define JUDGED_BOUND (1.0 / 256)

enum {
    CHANNELS = 3
};

static const int bits_of[CHANNELS] = {5, 6, 5};

/* A colour whose channels are often the least or the largest ones. */
static int64_t any_colour(oracle_random *random)
{
    int64_t colour = 0;
    for (int k = 0; k < CHANNELS; k++) {
        const int64_t channel = oracle_between(random, -40, 295);
        colour = colour << 8 | (channel < 0 ? 0 : channel > 255 ? 255 : channel);
    }
    return colour;
}

static void generate(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    surface_sample_generate(random, input);
    for (int i = 0; i < 3; i++) {
        oracle_put(input, any_colour(random));
    }
}

/* Makes the channels at the corners the sample's values, in 16.16 levels. */
static int read_colours(const oracle_input *input, surface_sample *sample, uint32_t colours[3])
{
    for (int i = 0; i < 3; i++) {
        const int64_t colour = input->numbers[SURFACE_NUMBERS + i];
        if (colour < 0 || colour > 0xFFFFFF) {
            return 0;
        }
        colours[i] = (uint32_t)colour;
        for (int k = 0; k < CHANNELS; k++) {
            const int64_t channel = colour >> (16 - 8 * k) & 255;
            sample->values[i][k] = (2 * channel + 1) << (bits_of[k] + 7);
        }
    }
    return 1;
}

/* How far an exact channel, in 2^-32 level, is from the level that a pixel shows. */
static double distance(int64_t exact, int level, int bits)
{
    const double held = fmax(0, fmin(ldexp((double)exact, -32), 1 << bits));
    return fmax(0, fmax(level - held, held - level - 1));
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    surface_sample sample;
    uint32_t colours[3];
    if (input->count != SURFACE_NUMBERS + 3) {
        return ORACLE_UNUSABLE;
    }
    if (!surface_sample_read(input, &sample)) {
        return ORACLE_SKIPPED;
    }
    if (!read_colours(input, &sample, colours)) {
        return ORACLE_UNUSABLE;
    }
    const int shown = surface_sample_draw_colours(&sample, colours);
    if (shown < 0) {
        return ORACLE_SKIPPED;
    }
    const int levels[CHANNELS] = {shown >> 11, shown >> 5 & 63, shown & 31};
    int judged = 0;
    for (int k = 0; k < CHANNELS; k++) {
        double bound;
        const int64_t exact = surface_sample_exact(&sample, k, &bound);
        if (!(bound < JUDGED_BOUND)) {
            verdict->extras[0]++;
            continue;
        }
        const double error = distance(exact, levels[k], bits_of[k]);
        judged = 1;
        verdict->value = fmax(verdict->value, error);
        if (words) {
            fprintf(words, "%s: exact %.12g, shown %d, off by %.9g level\n",
                    k == 0   ? "red"
                    : k == 1 ? "green"
                             : "blue",
                    ldexp((double)exact, -32), levels[k], error);
        }
    }
    return judged ? ORACLE_COUNTED : ORACLE_SKIPPED;
}

const oracle_claim oracle_corner_colour = {
    .id = "corner_colour",
    .unit = "level",
    .numbers = SURFACE_TEXT ", three colours 65536 red + 256 green + blue",
    .kinds = {"anywhere in sight"},
    .extras = {"not_judged"},
    .generate = generate,
    .judge = judge,
};
