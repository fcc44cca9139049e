/* SPDX-License-Identifier: MIT */
#include "paint/corner_colours.c"
#include "paint/colour_run.c"
#include "paint/smooth_outline.h"
#include "proof.h"

/* The most by which corners differ, in 7.25, and the most of a coefficient. */
#define DIFFERENCE_MAX (INT32_MAX - (1 << 23) + 1)

#define APART_MAX ((3 << 15) + 3) /* of two weights of shorten */

/* Any weights of a face whose least one has at least 26 bits. */
static fxl_corner_planes any_weights(void)
{
    fxl_corner_planes planes;
    ASSUME(planes.weight_most >= 1u << 26 && planes.weight_most < 1u << 30);
    ASSUME(planes.weight_range < planes.weight_most - planes.weight_most / 4);
    for (int i = 0; i < 3; i++) {
        ASSUME(planes.weights[i] >= (int32_t)(planes.weight_most - planes.weight_range) &&
               planes.weights[i] <= (int32_t)planes.weight_most);
    }
    return planes;
}

/* [[row]]
 * function = "shorten"
 * property = "the least weight has 15 bits, no two are more than three times that apart, and nothing overflows"
 * checks = 42
 * unwind = 4
 */
void prove_shorten(void)
{
    const fxl_corner_planes planes = any_weights();
    const short_weights weights = shorten(&planes);
    ASSERT("15 bits", weights.least >> 14 == 1);
    ASSERT("differences", WITHIN(weights.d1, APART_MAX) && WITHIN(weights.d2, APART_MAX));
    ASSERT("of the other two", WITHIN(weights.d2 - weights.d1, APART_MAX));
    PROOF_ENDS();
}

/* [[row]]
 * function = "bend_of"
 * property = "no product overflows, for all levels from 1/16 to 63 15/16 and all weights of shorten"
 * checks = 64
 */
void prove_bend_of(void)
{
    const int32_t values[3] = {nondet_s32(), nondet_s32(), nondet_s32()};
    const short_weights weights = {nondet_s32(), nondet_s32(), nondet_s32()};
    for (int i = 0; i < 3; i++) {
        ASSUME(values[i] >= 1 << 12 && values[i] <= (1 << 22) - (1 << 12));
    }
    ASSUME(WITHIN(weights.d1, APART_MAX) && WITHIN(weights.d2, APART_MAX));
    ASSUME(WITHIN(weights.d2 - weights.d1, APART_MAX));
    const channel_bend bend = bend_of(values, &weights);
    ASSERT("nothing is taken off a corner", bend.least <= 0 && bend.most >= 0);
    ASSERT("the end has a negative", bend.least > INT32_MIN);
    PROOF_ENDS();
}

/* [[row]]
 * function = "mean_of"
 * property = "within 0.3 of a level of both ends of a bend within 0.6, and nothing overflows"
 * checks = 36
 */
void prove_mean_of(void)
{
    const channel_bend bend = {nondet_s32(), nondet_s32(), nondet_u32()};
    const int32_t least = nondet_s32();
    ASSUME(least >> 14 == 1 && bend.least <= 0 && bend.most >= 0);
    ASSUME(WITHIN(bend.least, BEND_BOTH * least) && WITHIN(bend.most, BEND_BOTH * least));
    ASSUME(bend.most - bend.least <= BEND_BOTH * least);
    ASSERT("at most 0.3 of a level", WITHIN(mean_of(&bend, least), 19661));
    PROOF_ENDS();
}

/* [[row]]
 * function = "hold_mean"
 * property = "a mean that keeps all corners 1/16 away from both ends, or none, and nothing overflows"
 * checks = 187
 */
void prove_hold_mean(void)
{
    const channel_bend bend = {nondet_s32(), nondet_s32(), nondet_u32()};
    const int32_t least = nondet_s32(), end = nondet_u8() != 0 ? 64 << 16 : 32 << 16;
    const int32_t values[3] = {nondet_s32(), nondet_s32(), nondet_s32()};
    int32_t mean = nondet_s32();
    bool stays = true;
    ASSUME(least >> 14 == 1 && bend.least <= 0 && bend.most >= 0 && WITHIN(mean, 19661));
    ASSUME(WITHIN(bend.least, BEND_BOTH * least) && WITHIN(bend.most, BEND_BOTH * least));
    for (int i = 0; i < 3; i++) {
        ASSUME(values[i] >= 4096 && values[i] <= end - 4096);
    }
    if (hold_mean(values, &bend, least, end, &mean)) {
        for (int i = 0; i < 3; i++) {
            stays &= values[i] + mean >= 4096 && values[i] + mean <= end - 4096;
        }
        ASSERT("stays within", stays);
        ASSERT("at most 0.3 of a level", WITHIN(mean, 19661));
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/corner_planes.h:fxl_corner_planes_mean"
 * property = "nothing overflows, for all weights of a face and values that differ by at most 2^22"
 * checks = 71
 * unwind = 4
 */
void prove_corner_planes_mean(void)
{
    fxl_corner_planes planes;
    const int32_t d1 = nondet_s32(), d2 = nondet_s32();
    ASSUME(WITHIN(d1, 1 << 22) && WITHIN(d2, 1 << 22));
    ASSUME(planes.weight_most >= 1u << 26 && planes.weight_most < 1u << 30);
    ASSUME(planes.weight_range < planes.weight_most);
    for (int i = 0; i < 3; i++) {
        ASSUME(planes.weights[i] >= (int32_t)(planes.weight_most - planes.weight_range) &&
               planes.weights[i] <= (int32_t)planes.weight_most);
    }
    (void)fxl_corner_planes_mean(&planes, d1, d2);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/smooth_outline.h:fxl_colour_outline_set"
 * property = "nothing is undefined, for any words"
 * checks = 268
 */
void prove_colour_outline_set(void)
{
    static FXL_ALIGN_8 uint8_t memory[sizeof(fxl_depth_head) + 8];
    fxl_depth_head *head = (fxl_depth_head *)(void *)memory;
    fxl_depth_plane plane;
    fxl_gradients gradients;
    fxl_band band;
    fxl_colour_outline outline;
    uint8_t pixel[2];
    band.pixels = pixel;
    ASSUME(band.width <= 1024 && band.first_row < 1024);
    ASSUME(head->scale.octaves >= 1 && head->scale.octaves <= 24);
    ASSUME(head->scale.mantissa >= 11 && head->scale.mantissa <= 15);
    ASSUME(fxl_depth_is_in_words(&plane));
    ASSUME(plane.one < FXL_DEPTH_IS_BENT + head->scale.octaves);
    fxl_colour_outline_set(head, &plane, &gradients, &band, &outline);
    PROOF_ENDS();
}

/* [[row]]
 * function = "is_near"
 * property = "exactly where weights differ by at most 1/128 of the least one"
 * checks = 13
 */
void prove_is_near(void)
{
    fxl_corner_planes planes;
    ASSUME(planes.weight_range <= planes.weight_most);
    const uint64_t least = planes.weight_most - planes.weight_range;
    ASSERT("at most 1/128", is_near(&planes) == ((uint64_t)planes.weight_range * 128 <= least));
    PROOF_ENDS();
}

/* [[row]]
 * function = "differences_fit"
 * property = "true only where all differences are below 2^31 - 2^23 when shifted"
 * checks = 40
 * unwind = 10
 */
void prove_differences_fit(void)
{
    int32_t values[3][3];
    const uint32_t less = nondet_u32(), k = nondet_u32(), i = nondet_u32();
    ASSUME(less >= 1 && less <= LESS_MAX && k < 3 && i >= 1 && i < 3);
    for (int j = 0; j < 9; j++) {
        ASSUME(values[j / 3][j % 3] >= 0 && values[j / 3][j % 3] <= 1 << 22);
    }
    if (differences_fit(values, less)) {
        const int64_t apart = (int64_t)values[k][i] - values[k][0];
        ASSERT("below", WITHIN(apart * (512 << less), DIFFERENCE_MAX - 1));
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "share"
 * property = "nothing overflows, and the place of a corner is that of its pixel and less than half of one"
 * checks = 287
 */
void prove_share(void)
{
    fxl_corner_planes planes;
    shared_planes shared;
    const int32_t corner = nondet_s32();
    ASSUME(WITHIN(corner, 1 << 27) && planes.x == corner - 32768 && WITHIN(planes.y, 1 << 27));
    ASSUME(planes.exponent >= 17 && planes.exponent <= 40);
    ASSUME(WITHIN(planes.along[0], 1 << 30) && WITHIN(planes.along[1], 1 << 30));
    ASSUME(WITHIN(planes.down[0], 1 << 30) && WITHIN(planes.down[1], 1 << 30));
    ASSUME(planes.along[0] >= 1 << 28 || planes.along[0] < -(1 << 28));
    if (share(&planes, corner >> 16, &shared)) {
        ASSERT("less than half a pixel away", shared.row * 65536 + (shared.y >> 16) == planes.y);
        ASSERT("in x too", (corner >> 16) * 65536 + (shared.x >> 16) == planes.x);
    }
    PROOF_ENDS();
}

static shared_planes any_shared(void)
{
    const shared_planes shared = {{nondet_s32(), nondet_s32()},
                                  {nondet_s32(), nondet_s32()},
                                  nondet_s32(),
                                  nondet_s32(),
                                  nondet_s32(),
                                  nondet_u32()};
    ASSUME(WITHIN(shared.row, 2048) && shared.less <= LESS_MAX);
    return shared;
}

/* [[row]]
 * function = "find_channel"
 * property = "sums of two products do not overflow"
 * checks = 53
 */
void prove_find_channel(void)
{
    const shared_planes shared = any_shared();
    const int32_t d1 = nondet_s32(), d2 = nondet_s32();
    ASSUME(WITHIN(d1, DIFFERENCE_MAX) && WITHIN(d2, DIFFERENCE_MAX));
    (void)find_channel(&shared, nondet_u32(), d1, d2);
    PROOF_ENDS();
}

/* [[row]]
 * function = "two_words"
 * property = "both words, exactly"
 * checks = 3
 */
void prove_two_words(void)
{
    const uint32_t low = nondet_u32(), high = nondet_u32();
    const int64_t both = two_words(low, high);
    ASSERT("the lower word", fxl_low_32(fxl_bits_64(both)) == low);
    ASSERT("the upper word", (uint32_t)(fxl_bits_64(both) >> 32) == high);
    PROOF_ENDS();
}

/* [[row]]
 * function = "channel_of_colours"
 * property = "differences that find_channel takes, for all colours"
 * checks = 52
 */
void prove_channel_of_colours(void)
{
    const int32_t colours[3] = {nondet_s32(), nondet_s32(), nondet_s32()};
    const channel_corners of[3] = {channel_of_colours(colours, 0xFF0000, 3, 1u << 18),
                                   channel_of_colours(colours, 0xFF00, 12, 1u << 19),
                                   channel_of_colours(colours, 0xFF, 19, 1u << 18)};
    for (int i = 0; i < 3; i++) {
        ASSERT("in 7.25", WITHIN(of[i].d1, DIFFERENCE_MAX) && WITHIN(of[i].d2, DIFFERENCE_MAX));
    }
    PROOF_ENDS();
}

/* [[row]]
 * function = "channel_of_values"
 * property = "differences that find_channel takes, for all levels from 1/16 to 63 15/16"
 * checks = 82
 * unwind = 4
 */
void prove_channel_of_values(void)
{
    const unsigned less = nondet_u32();
    const int32_t values[3] = {nondet_s32(), nondet_s32(), nondet_s32()};
    ASSUME(less <= LESS_MAX);
    for (int i = 0; i < 3; i++) {
        ASSUME(values[i] >= 1 << 12 && values[i] <= (1 << 22) - (1 << 12));
    }
    int32_t more = nondet_s32(); /* hold_mean */
    ASSUME(more >= (1 << 12) - values[0] && more <= (1 << 22) - (1 << 12) - values[0]);
    for (int i = 1; i < 3; i++) { /* differences_fit */
        const int64_t apart = (int64_t)values[i] - values[0];
        ASSUME(WITHIN(apart * (512 << less), DIFFERENCE_MAX - 1));
    }
    const channel_corners of = channel_of_values(values, more, less);
    ASSERT("in 7.25", WITHIN(of.d1, DIFFERENCE_MAX) && WITHIN(of.d2, DIFFERENCE_MAX));
    PROOF_ENDS();
}

/* [[row]]
 * function = "set_words"
 * property = "nothing is undefined, for any values of corners"
 * checks = 263
 * unwind = 4
 */
void prove_set_words(void)
{
    const shared_planes shared = any_shared();
    channel_corners channels[3];
    fxl_gradients gradients;
    for (int i = 0; i < 3; i++) { /* channel_of_colours, channel_of_values */
        ASSUME(WITHIN(channels[i].d1, DIFFERENCE_MAX) && WITHIN(channels[i].d2, DIFFERENCE_MAX));
    }
    /* find_channel: the largest difference is that of two corners */
    set_words(&shared, nondet_s32(), channels, &gradients);
    ASSERT("two records of words", fxl_has_colour_words(&gradients) && gradients.count == 2);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_corner_colours"
 * property = "any colours of corners: each channel is a level of it"
 * checks = 70
 */
void prove_corner_colours(void)
{
    fxl_corner any[3];
    const fxl_corner *const corners[3] = {&any[0], &any[1], &any[2]};
    int32_t values[3][3];
    const uint32_t k = nondet_u32(), i = nondet_u32();
    ASSUME(k < 3 && i < 3);
    fxl_corner_colours(corners, values);
    ASSERT("a channel's level", values[k][i] > 0 && values[k][i] < (k == 1 ? 64 : 32) * 65536);
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_corner_colours_light"
 * property = "any light of a ramp and any channels: nothing overflows"
 * checks = 81
 */
void prove_corner_colours_light(void)
{
    fxl_light_settings settings;
    int32_t light[3], values[3][3];
    ASSUME(settings.levels >= FXL_LIGHT_LEVELS_MIN && settings.levels <= FXL_LIGHT_LEVELS_MAX);
    for (int i = 0; i < 3; i++) {
        ASSUME(light[i] >= 32768 && (uint32_t)light[i] - 32768u <= (settings.levels - 1u) << 16);
        for (int k = 0; k < 3; k++) {
            ASSUME(values[k][i] > 0 && values[k][i] < (k == 1 ? 64 : 32) * 65536);
        }
    }
    fxl_corner_colours_light(&settings, light, values);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/paint/colour_run.c:fxl_paint_colour_run"
 * property = "any words: no other pixel is written, and the first one has the levels of the words; runs of up to 4 pixels"
 * checks = 50
 */
void prove_paint_colour_run(void)
{
    uint16_t pixels[5];
    fxl_colour_words words;
    const uint32_t count = nondet_u32();
    ASSUME(count <= 4);
    const uint16_t behind = pixels[count];
    fxl_paint_colour_run(&words, pixels, count);
    ASSERT("no pixel behind the last one", pixels[count] == behind);
    ASSERT("the first one's levels",
           count == 0 || pixels[0] == (uint16_t)((words.both >> 11 & 31u) << 11 |
                                                 words.green >> 26 << 5 | words.both >> 27));
    PROOF_ENDS();
}
