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

void fxl_corner_colours(const fxl_mapped_face *mapped, int32_t (*values)[3])
{
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t colour = (uint32_t)mapped->texels[i].u;
        values[0][i] = channel_of(colour, 16, RED_AND_BLUE_SHIFT);
        values[1][i] = channel_of(colour, 8, GREEN_SHIFT);
        values[2][i] = channel_of(colour, 0, RED_AND_BLUE_SHIFT);
    }
}

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

static inline uint32_t range_of_channel(const int32_t values[3])
{
    const int32_t low = values[0] < values[1] ? values[0] : values[1];
    const int32_t high = values[0] < values[1] ? values[1] : values[0];
    return (uint32_t)((values[2] > high ? values[2] : high) - (values[2] < low ? values[2] : low));
}

/* Whether a constant weight is near enough for all channels. Ranges are below 2^22, so it is where
 * the weights differ by at most 2^-7 of the least one. */
static bool is_near(const fxl_corner_planes *planes, int32_t (*values)[3])
{
    const uint32_t least = planes->weight_most - planes->weight_range;
    FXL_STATIC_ASSERT(4u * FXL_AFFINE_ERROR_LIGHT == 1u << 15, "2^22 2^-7");
    if (planes->weight_range <= least >> 7) {
        return true;
    }
    uint32_t most = 0;
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t range = range_of_channel(values[k]);
        most = range > most ? range : most;
    }
    return fxl_product_unsigned(most, planes->weight_range) <=
           fxl_product_unsigned(least, 4u * FXL_AFFINE_ERROR_LIGHT);
}

/* The channel of corner 0, in 8.24, in row 0 of a column, and what a column and a row add. */
typedef struct {
    uint32_t at;
    int32_t along, down;
} channel_words;

/* The lower word of a sum / 2^drop, rounded down, for 0 < drop < 32. */
static inline int32_t step_of(int64_t sum, unsigned drop)
{
    return (int32_t)((uint32_t)sum >> drop | (uint32_t)((uint64_t)sum >> 32) << (32u - drop));
}

/* The upper word of a magnitude, but for a unit of the lowest bit. */
static inline uint32_t upper_size(int64_t sum)
{
    const int32_t high = (int32_t)((uint64_t)sum >> 32);
    return (uint32_t)(high ^ (high >> 31));
}

/* Differences are below 2^22 and coefficients at most 2^30, so sums are below 2^53; a value in 8.24
 * is their upper bits. A step that is below 2^31 times a place below 2^27 is below 2^58. x: of
 * corner 0 from the centre of the column. Returns the bits of both steps above what is dropped. */
static inline uint32_t find_channel(const fxl_corner_planes *planes, const int32_t values[3],
                                    int32_t x, unsigned drop, channel_words *channel)
{
    const int32_t d1 = values[1] - values[0], d2 = values[2] - values[0];
    const int64_t along = fxl_product(d1, planes->along[0]) + fxl_product(d2, planes->along[1]);
    const int64_t down = fxl_product(d1, planes->down[0]) + fxl_product(d2, planes->down[1]);
    channel->along = step_of(along, drop);
    channel->down = step_of(down, drop);
    const int64_t off = fxl_product(channel->along, x) + fxl_product(channel->down, planes->y);
    channel->at = ((uint32_t)values[0] << 8) - (uint32_t)((uint64_t)off >> 16);
    return upper_size(along) | upper_size(down);
}

bool fxl_corner_colours_linear(const fxl_corner_planes *planes, int32_t (*values)[3],
                               bool is_affine, fxl_gradients *gradients)
{
    static const fxl_gradient constant = {FXL_CONSTANT_WEIGHT, 0, 0};
    const int32_t column = planes->corners->points[0].x >> 16;
    const int32_t x = planes->x - column * 65536;
    const unsigned drop = (unsigned)planes->exponent - 8u; /* 12 to 28 */
    channel_words channels[3];
    if (!planes->is_triangle || !(is_affine || is_near(planes, values))) {
        return false;
    }
    const uint32_t sizes = find_channel(planes, values[0], x, drop, &channels[0]) |
                           find_channel(planes, values[1], x, drop, &channels[1]) |
                           find_channel(planes, values[2], x, drop, &channels[2]);
    if (sizes >> (drop - 1u) != 0) {
        return false;
    }
    fxl_gradient *attributes = gradients->attributes;
    for (uint32_t k = 0; k < 3; k++) {
        attributes[k].at = (int64_t)channels[k].at;
        attributes[k].down = channels[k].down;
        gradients->shifts[k] = FXL_SHIFT_OF_WORDS;
    }
    attributes[0].at |= (int64_t)((uint64_t)(uint32_t)column << 32);
    attributes[0].along = (int64_t)fxl_colours_both(channels[0].along, channels[2].along);
    attributes[1].along = (int64_t)((uint32_t)channels[1].along << 2);
    attributes[2].along = 0;
    gradients->count = 3;
    gradients->weight = constant;
    gradients->weight_min[0] = gradients->weight_min[1] = 1;
    return true;
}
