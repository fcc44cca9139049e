/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "oracle/surface_sample.h"

/* texel_divided, texel_every_16, texel_every_8, texel_affine and light_level: one pixel of a
 * triangle as the library draws it, against the exact coordinates and the exact light there. A
 * pixel shows the texel, or the level, that holds its coordinate; how far the exact coordinate is
 * from it is the error that is seen. */

/* Where docs/accuracy.md, section 5.1, allows more, a sample is not judged. */
#define JUDGED_BOUND (1.0 / 256)

/* --- textures ------------------------------------------------------------------------------- */

/* Whether the coordinate changes so much in 16 columns that what v repeats takes more than 1/64
 * texel (docs/accuracy.md, section 5.2). */
static int is_steep(const surface_sample *sample, int attribute, int64_t exact)
{
    surface_sample beside = *sample;
    double bound;
    beside.x += 16;
    return fabs(ldexp((double)(surface_sample_exact(&beside, attribute, &bound) - exact), -32)) >=
           1024;
}

/* place sampling: the claims of texels */
/* accuracy 5.3 */
oracle_outcome surface_judge_texel(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    const uint8_t division = (uint8_t)input->variant;
    surface_sample sample;
    if (input->count != SURFACE_NUMBERS + 1 || input->numbers[SURFACE_NUMBERS] < 1 ||
        input->numbers[SURFACE_NUMBERS] > 7) {
        return ORACLE_UNUSABLE;
    }
    if (!surface_sample_read(input, &sample)) {
        return ORACLE_SKIPPED;
    }
    if (oracle_setup_is_orthographic(input)) {
        if (!surface_sample_make_orthographic(&sample)) {
            return ORACLE_SKIPPED;
        }
    } else if (division == FXL_AFFINE && !surface_sample_make_affine(&sample)) {
        return ORACLE_SKIPPED; /* drawn as texel_every_16 has it */
    }
    const int log = (int)input->numbers[SURFACE_NUMBERS];
    int judged = 0;
    for (int attribute = 0; attribute < 2; attribute++) {
        double bound;
        const int64_t exact = surface_sample_exact(&sample, attribute, &bound);
        if (!(bound < JUDGED_BOUND) || (sample.is_affine && is_steep(&sample, attribute, exact))) {
            verdict->extras[1]++;
            continue;
        }
        const int shown = surface_sample_texel(&sample, attribute, log, division);
        if (shown < 0) {
            return ORACLE_SKIPPED;
        }
        const double error = surface_texel_distance(exact, shown, log);
        judged = 1;
        verdict->value = fmax(verdict->value, error);
        verdict->extras[0] += division == FXL_DIVIDE_1 && error > bound;
        if (words) {
            fprintf(words, "%c: exact %.12g, shown %d of %d, off by %.9g texel, bound %.9g\n",
                    "uv"[attribute], ldexp((double)exact, -32), shown, 1 << log, error, bound);
        }
    }
    return judged ? ORACLE_COUNTED : ORACLE_SKIPPED;
}

static void generate_texel(oracle_random *random, oracle_input *input)
{
    surface_sample_generate(random, input);
    oracle_put(input, oracle_between(random, 1, 7));
}

/* --- light ---------------------------------------------------------------------------------- */

static void generate_light(oracle_random *random, oracle_input *input)
{
    surface_sample_generate(random, input);
    surface_sample_put_light(random, input);
}

static oracle_outcome judge_light(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    fxl_light_settings settings;
    fxl_direction normals[3];
    surface_sample sample;
    if (input->count != SURFACE_LIGHT_NUMBERS) {
        return ORACLE_UNUSABLE;
    }
    if (!surface_sample_read(input, &sample)) {
        return ORACLE_SKIPPED;
    }
    surface_sample_light(input, &sample, normals, &settings);
    double bound;
    const double exact = surface_sample_exact_level(&sample, &bound);
    if (!(bound < JUDGED_BOUND)) {
        return ORACLE_SKIPPED;
    }
    const int shown = surface_sample_level(&sample, normals, &settings);
    if (shown < 0) {
        return ORACLE_SKIPPED;
    }
    verdict->value = surface_level_distance(exact, shown);
    verdict->extras[0] = verdict->value > bound + 2.0 / 65536;
    if (words) {
        fprintf(words, "exact level %.9g, shown %d, off by %.9g, bound %.9g\n", exact, shown,
                verdict->value, bound);
    }
    return ORACLE_COUNTED;
}

/* --- claims --------------------------------------------------------------------------------- */

#define TEXEL_CLAIM(name, division, kind) \
    const oracle_claim oracle_texel_##name = { \
        .id = "texel_" #name, \
        .unit = "texel", \
        .numbers = SURFACE_TEXT ", log2 of the texture's side", \
        .kinds = {kind}, \
        .extras = {"beyond_own_bound", "not_judged"}, \
        .variant = division, \
        .generate = generate_texel, \
        .judge = surface_judge_texel, \
    }

TEXEL_CLAIM(divided, FXL_DIVIDE_1, "anywhere in sight");
TEXEL_CLAIM(every_16, FXL_DIVIDE_16, "anywhere in sight");
TEXEL_CLAIM(every_8, FXL_DIVIDE_8, "anywhere in sight");
TEXEL_CLAIM(affine, FXL_AFFINE, "all corners on the screen");

/* place light: the claim light_level: pixels of lit surfaces */
const oracle_claim oracle_light_level = {
    .id = "light_level",
    .unit = "level",
    .numbers = SURFACE_TEXT ", three normals, direction, ambient, strength, lamp x y z, range, fog",
    .kinds = {"anywhere in sight"},
    .extras = {"beyond_own_bound"},
    .generate = generate_light,
    .judge = judge_light,
};

/* --- colours at corners ------------------------------------------------------------------------
 */

/* corner_colour: one pixel of a triangle with colours at its corners, as the library draws it in
 * RGB565, against the exact channels there (SPEC.md, section 9.8). */

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

static void generate_colours(oracle_random *random, oracle_input *input)
{
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

static oracle_outcome judge_colours(const oracle_input *input, FILE *words, oracle_verdict *verdict)
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
    .generate = generate_colours,
    .judge = judge_colours,
};
