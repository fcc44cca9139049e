/* SPDX-License-Identifier: MIT */
#include "corner_colours.h"

#include "../math/product.h"
#include "colour_run.h"
#include "light_row.h"

/* 2^(16 + bits - 8) for a channel of so many bits, as a shift. */
#define GREEN_SHIFT        14
#define RED_AND_BLUE_SHIFT 13

/* SPEC 9.8 */
static inline int32_t channel_of(uint32_t colour, uint32_t at, uint32_t shift)
{
    return (int32_t)((colour >> at & 255u) << shift) + (1 << (shift - 1u));
}

void fxl_corner_colours(const fxl_corner *const corners[3], int32_t (*values)[3])
{
    FXL_EACH_CORNER
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t colour = fxl_bits_32(corners[i]->texel.u);
        values[0][i] = channel_of(colour, 16, RED_AND_BLUE_SHIFT);
        values[1][i] = channel_of(colour, 8, GREEN_SHIFT);
        values[2][i] = channel_of(colour, 0, RED_AND_BLUE_SHIFT);
    }
}

/* place light: what light leaves of colours at corners */
/* Light less the half is at most 63 2^16, and a part of a level at most 2^26: their product is
 * below 2^48, and 2^42 (1 + 2^-20) at most. A channel differs by less than 2^22 from the middle, so
 * 64 times that is below 2^28. Errors: of the part 2^-20 of it and 2^-26, so 2^-14 of a level; of
 * the product, less than 2^-16. */
/* SPEC 9.8 */
void fxl_corner_colours_light(const fxl_light_settings *settings, const int32_t light[3],
                              int32_t (*values)[3])
{
    const uint32_t levels = settings->levels - 1u, dark = settings->dark;
    const uint32_t part_of_level = ((1u << 26) + levels / 2) / levels;
    const uint32_t middles[3] = {dark >> 11 << 16 | 32768u, (dark >> 5 & 63u) << 16 | 32768u,
                                 (dark & 31u) << 16 | 32768u};
    int32_t parts[3];
    for (uint32_t i = 0; i < 3; i++) {
        parts[i] =
            (int32_t)(fxl_product_unsigned((uint32_t)light[i] - 32768u, part_of_level) >> 16);
    }
    for (uint32_t k = 0; k < 3; k++) {
        const int32_t middle = (int32_t)middles[k];
        for (uint32_t i = 0; i < 3; i++) {
            values[k][i] = middle + fxl_upper_product((values[k][i] - middle) * 64, parts[i]);
        }
    }
}

/* Whether a constant weight is near enough for any channels: weights differ by at most 2^-7 of the
 * least one, and ranges are below 2^22. */
static inline bool is_near(const fxl_corner_planes *planes)
{
    FXL_STATIC_ASSERT(4u * FXL_AFFINE_ERROR_LIGHT == 1u << 15, "2^22 2^-7");
    return planes->weight_range <= (planes->weight_most - planes->weight_range) >> 7;
}

/* Weights at the corners, of which the least has 15 bits: they are rounded down. */
typedef struct {
    int32_t least, d1, d2; /* the differences of corners 1 and 2 from corner 0: at most 3 2^15 + 3 */
} short_weights;

static inline short_weights shorten(const fxl_corner_planes *planes)
{
    const uint32_t least = planes->weight_most - planes->weight_range;
    const unsigned drop = 17u - fxl_leading_zeros(least);
    const int32_t first = planes->weights[0] >> drop;
    const short_weights weights = {(int32_t)(least >> drop), (planes->weights[1] >> drop) - first,
                                   (planes->weights[2] >> drop) - first};
    return weights;
}

/* What a constant weight takes off a channel, times the weight of the pixel: from a quarter of
 * `least` to a quarter of `most`, in 2^-8 level. With L the corners' shares of a place it is the
 * sum of L_i L_j d_ij e_ij over the pairs of corners, where d are the differences of the channel
 * and e those of weights. It is largest, and least, half-way between two corners; its mean over the
 * triangle is a twelfth of `sum`. */
typedef struct {
    int32_t least, most;
    uint32_t sum; /* modulo 2^32 */
} channel_bend;

/* The largest weight is below four times the least. So differences are at most 3 2^15 + 3 and below 2^14, and
 * products below 2^31. Roundings: of a channel 2^-8, and of a weight 2^-14 of the least one, so a
 * product over that is off by less than 1/64 level. */
static inline channel_bend bend_of(const int32_t values[3], const short_weights *weights)
{
    const int32_t d1 = (values[1] - values[0]) >> 8, d2 = (values[2] - values[0]) >> 8;
    const int32_t a = d1 * weights->d1, b = d2 * weights->d2;
    const int32_t c = (d2 - d1) * (weights->d2 - weights->d1);
    const int32_t least = a < b ? a : b, most = a > b ? a : b;
    const int32_t low = c < least ? c : least, high = c > most ? c : most;
    const channel_bend bend = {low < 0 ? low : 0, high > 0 ? high : 0,
                               fxl_bits_32(a) + fxl_bits_32(b) + fxl_bits_32(c)};
    return bend;
}

/* Limits of a bend beside those of the header: 0.3 to each side and 0.6 from one end to the other, in 2^-10
 * level, less 1/256 a side, which its rounding may be. */
#define BEND_SIDE 303
#define BEND_BOTH 606

/* The mean of a bend, or what is nearest to it and leaves 0.3 of a level to each side; in 16.16. Of
 * a bend within BEND_BOTH: so numbers are below 3 2^25, and times 16 below 2^31. */
static inline int32_t mean_of(const channel_bend *bend, int32_t least)
{
    const int32_t from = 3 * (bend->most - BEND_SIDE * least);
    const int32_t to = 3 * (bend->least + BEND_SIDE * least);
    const int32_t sum = fxl_signed_32(bend->sum);
    return (sum < from ? from : sum > to ? to : sum) * 16 / least * 4 / 3;
}

/* Whether a channel that begins `more` above its values, 16.16, is off by at most BEND_SIDE to each side. Of a bend
 * within BEND_BOTH and up to 0.3 of a level numbers are below 2^31. */
static inline bool is_balanced(const channel_bend *bend, int32_t more, int32_t least)
{
    return 64 * bend->most <= (64 * BEND_SIDE + more) * least &&
           64 * bend->least >= (more - 64 * BEND_SIDE) * least;
}

/* A mean, or of one that would bring the channel of a corner nearer than 1/16 to what no pixel shows nothing, or
 * what is nearest to it and does not. False: that leaves too much. */
/* SPEC 9.1.1 */
static bool hold_mean(const int32_t values[3], const channel_bend *bend, int32_t least, int32_t end,
                      int32_t *mean)
{
    const int32_t nearer = values[0] < values[1] ? values[0] : values[1];
    const int32_t farther = values[0] > values[1] ? values[0] : values[1];
    const int32_t from = 4096 - (nearer < values[2] ? nearer : values[2]);
    const int32_t to = end - 4096 - (farther > values[2] ? farther : values[2]);
    if (*mean >= from && *mean <= to) {
        return true;
    }
    const int32_t held = *mean < from ? from : *mean;
    *mean = is_balanced(bend, 0, least) ? 0 : held > to ? to : held;
    return is_balanced(bend, *mean, least);
}

/* What is added to each channel, where a constant weight may be asked for: what it takes off in the
 * mean. False: it changes a channel too much. Limits are below 2^25. */
/* SPEC 9.1.1 */
static bool find_means(const fxl_corner_planes *planes, int32_t (*values)[3], bool is_coarse,
                       int32_t means[3])
{
    const short_weights weights = shorten(planes);
    const int32_t least = weights.least;
    const int32_t none = (is_coarse ? FXL_BEND_NONE : FXL_BEND_FINE) * least;
    for (uint32_t k = 0; k < 3; k++) {
        const channel_bend bend = bend_of(values[k], &weights);
        const int32_t side = bend.most > -bend.least ? bend.most : -bend.least;
        const int32_t end = k == 1 ? 64 << 16 : 32 << 16;
        means[k] = 0;
        if (side <= none) {
            continue;
        }
        if (!is_coarse || side > BEND_BOTH * least || bend.most - bend.least > BEND_BOTH * least) {
            return false;
        }
        int32_t mean = mean_of(&bend, least);
        if (!hold_mean(values[k], &bend, least, end, &mean)) {
            return false;
        }
        means[k] = mean;
    }
    return true;
}

/* What all channels of a face share: how much of a difference between corners a pixel along and a
 * pixel down adds, times 2^(29 - less); and where corner 0 is, from the centre of the pixel in `row`
 * and the column, times 2^32: less than half a pixel away. */
typedef struct {
    int32_t along[2], down[2], x, y, row;
    unsigned less;
} shared_planes;

#define LESS_MAX 4u

static inline int32_t shifted_up(int32_t value, unsigned shift)
{
    return fxl_signed_32(fxl_bits_32(value) << shift);
}

/* Exponents are from 17 to 40. What is cut off a coefficient changes a channel by less than 64
 * 2^-29 level a pixel. False: a coefficient is 4 2^LESS_MAX or more, so a side of the face is
 * short. The largest coefficient is at least 2^28. */
static __attribute__((noinline)) bool share(const fxl_corner_planes *planes, int32_t column, shared_planes *shared)
{
    const int32_t *along = planes->along, *down = planes->down;
    const int cut = planes->exponent - 29;
    shared->row = (planes->y + 32768) >> 16;
    shared->x = fxl_signed_32(fxl_bits_32(planes->x - column * 65536) << 16);
    shared->y = fxl_signed_32(fxl_bits_32(planes->y) << 16);
    shared->less = 0;
    if (cut < 0) {
        const int32_t bits = (along[0] ^ (along[0] >> 31)) | (along[1] ^ (along[1] >> 31)) |
                             (down[0] ^ (down[0] >> 31)) | (down[1] ^ (down[1] >> 31));
        const unsigned room = fxl_leading_zeros((uint32_t)bits) - 1u;
        const unsigned shift = (unsigned)-cut < room ? (unsigned)-cut : room;
        shared->less = (unsigned)-cut - shift;
        shared->along[0] = shifted_up(along[0], shift);
        shared->along[1] = shifted_up(along[1], shift);
        shared->down[0] = shifted_up(down[0], shift);
        shared->down[1] = shifted_up(down[1], shift);
        return shared->less <= LESS_MAX;
    }
    shared->along[0] = along[0] >> cut;
    shared->along[1] = along[1] >> cut;
    shared->down[0] = down[0] >> cut;
    shared->down[1] = down[1] >> cut;
    return true;
}

/* Whether the differences of all channels, in 7.(25 + less), are below 2^31 - 2^23: those of corners
 * are at most 2^22 - 2^14. */
static inline bool differences_fit(int32_t (*values)[3], unsigned less)
{
    uint32_t bits = 0;
    for (uint32_t k = 0; k < 3; k++) {
        const int32_t d1 = values[k][1] - values[k][0], d2 = values[k][2] - values[k][0];
        bits |= (uint32_t)((d1 ^ (d1 >> 31)) | (d2 ^ (d2 >> 31)));
    }
    return (bits + (1u << 14)) >> (22u - less) == 0;
}

/* A channel in 10.22, modulo 2^32, in row 0 of a column, and what a column and a row add. */
typedef struct {
    uint32_t at;
    int32_t along, down;
} channel_words;

/* first: at corner 0, in 10.22. d1, d2: the differences of the others, in 7.(25 + less), at most
 * 2^31 - 2^23. So sums of two products are at most 2^63 - 2^55, and a step is at most 2^31 - 2^23; two
 * products of steps are at most 2^63 - 2^55 too. Roundings: a step's, 2^-22 a pixel. */
static FXL_ONE_COPY channel_words find_channel(const shared_planes *shared, uint32_t first,
                                               int32_t d1, int32_t d2)
{
    const int64_t along = fxl_product(d1, shared->along[0]) + fxl_product(d2, shared->along[1]);
    const int64_t down = fxl_product(d1, shared->down[0]) + fxl_product(d2, shared->down[1]);
    channel_words channel;
    channel.along = fxl_signed_32((uint32_t)(fxl_bits_64(along) >> 32));
    channel.down = fxl_signed_32((uint32_t)(fxl_bits_64(down) >> 32));
    const int64_t off =
        fxl_product(channel.along, shared->x) + fxl_product(channel.down, shared->y);
    channel.at = first - (uint32_t)(fxl_bits_64(off) >> 32) -
                 fxl_bits_32(shared->row) * fxl_bits_32(channel.down);
    return channel;
}

static inline int64_t two_words(uint32_t low, uint32_t high)
{
    return fxl_signed_64((uint64_t)high << 32 | low);
}

/* A channel of the corners: of corner 0 in 10.22, and the differences of the others, as find_channel has them. */
typedef struct {
    uint32_t first;
    int32_t d1, d2;
} channel_corners;

/* Not inline: each of two functions would have three of find_channel. */
static __attribute__((noinline)) void set_words(const shared_planes *shared, int32_t column,
                                                const channel_corners of[3],
                                                fxl_gradients *gradients)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    fxl_gradient *attributes = gradients->attributes;
    const channel_words red = find_channel(shared, of[0].first, of[0].d1, of[0].d2);
    const channel_words green = find_channel(shared, of[1].first, of[1].d1, of[1].d2);
    const channel_words blue = find_channel(shared, of[2].first, of[2].d1, of[2].d2);
    /* Runs have 11 bits of red and blue, which half a unit rounds to nearest. Steps are at most
     * 2^31 - 2^23 + 2^10. */
    attributes[0].at = two_words(red.at + 1024u, fxl_bits_32(column));
    attributes[0].along = two_words(fxl_colours_both(red.along + 1024, blue.along + 1024),
                                    fxl_bits_32(green.along) << 4);
    attributes[0].down = two_words(fxl_bits_32(red.down), fxl_bits_32(green.down));
    attributes[1].at = two_words(green.at, blue.at + 1024u);
    attributes[1].along = two_words(fxl_bits_32(red.along), fxl_bits_32(blue.along));
    attributes[1].down = blue.down;
    gradients->shifts[0] = gradients->shifts[1] = gradients->shifts[2] = FXL_SHIFT_OF_WORDS;
    gradients->count = FXL_GRADIENTS_OF_WORDS;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
}

/* A channel of a face that is not lit. mask: its bits of a colour; shift: what moves these to
 * 10.22. A level of 8 bits is 2^19 there, and of green 2^20. */
static inline channel_corners channel_of_colours(const int32_t colours[3], int32_t mask,
                                                 unsigned shift, uint32_t half)
{
    const int32_t first = colours[0] & mask;
    const channel_corners channel = {
        ((uint32_t)first << shift) + half,
        fxl_signed_32(fxl_bits_32((colours[1] & mask) - first) << (shift + 3u)),
        fxl_signed_32(fxl_bits_32((colours[2] & mask) - first) << (shift + 3u))};
    return channel;
}

bool fxl_corner_colours_unlit(const fxl_corner *const corners[3], const fxl_corner_planes *planes,
                              bool is_affine, fxl_gradients *gradients)
{
    const int32_t column = planes->corners->points[0].x >> 16;
    const int32_t colours[3] = {corners[0]->texel.u, corners[1]->texel.u, corners[2]->texel.u};
    shared_planes shared;
    if (!planes->is_triangle || !(is_affine || is_near(planes)) ||
        !share(planes, column, &shared) || shared.less != 0) {
        return false;
    }
    const channel_corners channels[3] = {channel_of_colours(colours, 0xFF0000, 3, 1u << 18),
                                         channel_of_colours(colours, 0xFF00, 12, 1u << 19),
                                         channel_of_colours(colours, 0xFF, 19, 1u << 18)};
    set_words(&shared, column, channels, gradients);
    return true;
}

static inline channel_corners channel_of_values(const int32_t values[3], int32_t more,
                                                unsigned less)
{
    const channel_corners channel = {fxl_bits_32(values[0] + more) << 6,
                                     shifted_up(values[1] - values[0], 9u + less),
                                     shifted_up(values[2] - values[0], 9u + less)};
    return channel;
}

bool fxl_corner_colours_linear(const fxl_corner_planes *planes, int32_t (*values)[3],
                               bool is_affine, bool is_coarse, fxl_gradients *gradients)
{
    const int32_t column = planes->corners->points[0].x >> 16;
    shared_planes shared;
    int32_t means[3] = {0, 0, 0};
    if (!planes->is_triangle ||
        !(is_affine || is_near(planes) || find_means(planes, values, is_coarse, means)) ||
        !share(planes, column, &shared) || (shared.less != 0 && !differences_fit(values, shared.less))) {
        return false;
    }
    const channel_corners channels[3] = {channel_of_values(values[0], means[0], shared.less),
                                         channel_of_values(values[1], means[1], shared.less),
                                         channel_of_values(values[2], means[2], shared.less)};
    set_words(&shared, column, channels, gradients);
    return true;
}
