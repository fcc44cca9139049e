/* SPDX-License-Identifier: MIT */
#include "attribute.h"
#include "paint.h"
#include "segments.h"

/* Which pixels of a square of 4 x 4 an opacity draws: those whose number is below it. Neighbours in
 * number are far apart, so the pattern is even at every opacity. */
static const uint8_t stipple[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

/* --- texels --------------------------------------------------------------------------------- */

static inline uint32_t limited(int32_t coordinate, uint32_t last)
{
    return coordinate < 0 ? 0 : (uint32_t)coordinate > last ? last : (uint32_t)coordinate;
}

/* The texel in column i and row j, repeated or clamped. */
static inline uint8_t texel(const fxl_texture_level *level, int32_t i, int32_t j)
{
    uint32_t column = (uint32_t)i & level->columns_less_1, row = (uint32_t)j & level->rows_less_1;
    if (level->flags & FXL_TEXTURE_CLAMP) {
        column = limited(i, level->columns_less_1);
        row = limited(j, level->rows_less_1);
    }
    const uint32_t place = (row << level->log_width) + column;
    if (level->colours != NULL) {
        return level->colours[level->texels[place >> 1] >> (4u * (place & 1u)) & 15u];
    }
    return level->texels[place];
}

/* --- pixels --------------------------------------------------------------------------------- */

static inline uint8_t blended(const fxl_paint *paint, uint8_t colour, uint8_t beneath)
{
    const uint32_t number = (uint8_t)(colour - paint->blend_first);
    return number < paint->blend_count ? paint->blend[256u * number + beneath] : colour;
}

/* A pixel whose attributes are known. */
static inline void paint_pixel(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                               const int32_t values[FXL_ATTRIBUTES])
{
    uint8_t colour = paint->colour;
    if (paint->opacity < 16 && stipple[4 * (row->y & 3) + (x & 3)] >= paint->opacity) {
        return;
    }
    if (paint->level.texels != NULL) {
        colour = texel(&paint->level, values[FXL_ATTRIBUTE_U] >> 16, values[FXL_ATTRIBUTE_V] >> 16);
        if ((paint->level.flags & FXL_TEXTURE_KEYED) && colour == paint->level.key) {
            return;
        }
    }
    if (paint->ramp != NULL) {
        const int32_t light = values[paint->gradients->count - 1];
        const uint32_t level = limited(light >> 16, paint->levels_less_1); /* bug: light-limit */
        colour = paint->ramp[256u * level + colour];
    }
    row->pixels[x] = paint->blend == NULL ? colour : blended(paint, colour, row->pixels[x]);
}

/* The first number's upper word, x pixels on. */
static inline int32_t value_at(int64_t first, const fxl_gradient *gradient, int32_t x)
{
    return (int32_t)((first + gradient->along * x) >> 32);
}

static void divide_at(const fxl_paint *paint, const fxl_paint_row *row, int32_t x, uint32_t weight,
                      int32_t values[FXL_ATTRIBUTES])
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(weight);
    for (uint32_t i = 0; i < gradients->count; i++) {
        values[i] = fxl_attribute_of(value_at(row->attributes[i], &gradients->attributes[i], x),
                                     &reciprocal, gradients->shifts[i]);
    }
}

static uint32_t weight_at(const fxl_paint *paint, const fxl_paint_row *row, int32_t x)
{
    const int32_t weight = value_at(row->weight, &paint->gradients->weight, x);
    return weight < 1 ? 1 : (uint32_t)weight;
}

static void divide_each(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    int32_t values[FXL_ATTRIBUTES];
    for (int32_t x = x0; x < x1; x++) {
        divide_at(paint, row, x, weight_at(paint, row, x), values);
        paint_pixel(paint, row, x, values);
    }
}

/* --- segments ------------------------------------------------------------------------------- */

/* The columns first..first + 2^log - 1, divided at both ends. False where that is not exact enough:
 * nothing is painted. A step is rounded down by less than a unit, so the last pixel is off by less
 * than 16 units of 1/65536. */
static bool paint_segment(const fxl_paint *paint, const fxl_paint_row *row, int32_t first,
                          unsigned log, int32_t x0, int32_t x1)
{
    const fxl_gradients *gradients = paint->gradients;
    const int32_t last = first + (1 << log);
    const uint32_t weight_0 = weight_at(paint, row, first), weight_1 = weight_at(paint, row, last);
    const uint32_t least = gradients->weight_min[log == 4 ? 0 : 1];
    int32_t values[FXL_ATTRIBUTES], ends[FXL_ATTRIBUTES], steps[FXL_ATTRIBUTES];
    if (weight_0 < least || weight_1 < least) {
        return false;
    }
    divide_at(paint, row, first, weight_0, values);
    divide_at(paint, row, last, weight_1, ends);
    for (uint32_t i = 0; i < gradients->count; i++) {
        steps[i] = (int32_t)((uint32_t)ends[i] - (uint32_t)values[i]) >> log;
    }
    for (int32_t x = first; x < x1; x++) {
        if (x >= x0) {
            paint_pixel(paint, row, x, values);
        }
        for (uint32_t i = 0; i < gradients->count; i++) {
            values[i] = (int32_t)((uint32_t)values[i] + (uint32_t)steps[i]);
        }
    }
    return true;
}

static inline int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* At most eight columns, of one segment of eight. */
static void paint_eight(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (paint->division == FXL_DIVIDE_1 || !paint_segment(paint, row, x0 & ~7, 3, x0, x1)) {
        divide_each(paint, row, x0, x1);
    }
}

/* Columns of one segment of 16, at most. */
static void paint_sixteen(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (paint->division == FXL_DIVIDE_16 && paint_segment(paint, row, x0 & ~15, 4, x0, x1)) {
        return;
    }
    const int32_t middle = smaller((x0 & ~7) + 8, x1);
    paint_eight(paint, row, x0, middle);
    if (middle < x1) {
        paint_eight(paint, row, middle, x1);
    }
}

/* --- the kernel ----------------------------------------------------------------------------- */

/* The column before which the kernel may paint from x0 on: x0, the end of a segment, or x1. */
static int32_t kernel_end(const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    const fxl_segment_face *face = row->segments;
    if (face == NULL || fxl_segment_weight(face, row, (uint32_t)x0 >> 4) < face->weight_min) {
        return x0;
    }
    if (fxl_segments_suffice(face, row, x0, x1)) {
        return x1;
    }
    uint32_t segment = (uint32_t)x0 >> 4;
    while (fxl_segment_weight(face, row, segment + 1u) >= face->weight_min) {
        segment++; /* less than the last one of the row, where the weight is too small */
    }
    return (int32_t)(16u * segment) > x0 ? (int32_t)(16u * segment) : x0;
}

/* Whether the light at the end of a segment is a level of the ramp. Only close to the ramp's ends
 * this takes a division. */
static inline bool level_is_in_ramp(const fxl_paint *paint, const fxl_paint_row *row, int32_t x)
{
    const fxl_gradients *gradients = paint->gradients;
    if (fxl_segment_light_suffices(row->segments, row, (uint32_t)x >> 4)) {
        return true;
    }
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(weight_at(paint, row, x));
    const int32_t light = fxl_attribute_of(
        value_at(row->attributes[FXL_SEGMENT_LIGHT], &gradients->attributes[FXL_SEGMENT_LIGHT], x),
        &reciprocal, gradients->shifts[FXL_SEGMENT_LIGHT]);
    return light >= 0 && light >> 16 <= paint->levels_less_1;
}

/* The same for light. The kernel holds the light at both ends of a segment within the ramp. An end
 * may lie outside of the face, where light is beyond the ramp: then the light between the ends
 * would be wrong, and the segment is not for the kernel. Along a row light rises or falls, so
 * between two ends where it is within the ramp it is so at all ends. */
static int32_t kernel_end_of_light(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                                   int32_t end)
{
    int32_t segment_end = (x0 & ~15) + 16;
    if (!level_is_in_ramp(paint, row, x0 & ~15)) {
        return x0;
    }
    if (level_is_in_ramp(paint, row, (end + 15) & ~15)) {
        return end;
    }
    while (level_is_in_ramp(paint, row, segment_end)) {
        segment_end += 16; /* less than end + 15, where it is beyond */
    }
    return segment_end - 16 > x0 ? segment_end - 16 : x0;
}

void fxl_paint_pixels(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    while (x0 < x1) {
        int32_t end = kernel_end(row, x0, x1);
        if (end > x0 && paint->ramp != NULL) {
            end = kernel_end_of_light(paint, row, x0, end);
        }
        if (end > x0) {
            fxl_paint_segments(row->segments, row, x0, end);
        } else {
            end = smaller((x0 & ~15) + 16, x1);
            paint_sixteen(paint, row, x0, end);
        }
        x0 = end;
    }
}
