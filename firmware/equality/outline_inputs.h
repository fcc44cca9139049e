/* SPDX-License-Identifier: MIT */
/* The outlines, planes, cells, light and colours that depth_outlines.c gives to both sides, by chance. */
#ifndef OUTLINE_INPUTS_H
#define OUTLINE_INPUTS_H

#include "equality.h"
#include "paint/depth_rows.h"
#include "paint/smooth_outline.h"

#define AROUND 8u
#define ROW    80u
#define CELLS  4000u
#define COLOUR 0xA5C3u /* in 8 bits: the lower byte */

typedef struct {
    fxl_depth_head head;
    FXL_ALIGN_8 uint16_t cells[CELLS];
    FXL_ALIGN_8 uint16_t pixels[CELLS + 2 * AROUND];
} memory;

static memory by_core, by_portable;

typedef struct {
    fxl_depth_plane plane;
    fxl_screen_point points[6];
    uint32_t count;
    uint32_t pixel_bits;
    bool is_smooth, has_colours, has_texels;
    fxl_gradients gradients; /* of light, or of colours */
    fxl_paint paint;         /* of them */
} polygon;

static FXL_ALIGN_8 uint8_t ramp[64 * 256]; /* texels, too */
static uint16_t palette[256];

/* Within 0..end, on a centre or beside one every other time. */
static fxl_q16_16 any_place(uint32_t end)
{
    const uint32_t choice = any_32() >> 9 & 15u;
    int32_t place = (int32_t)((any_32() >> 2) % ((end << 16) + 1u));
    if (choice < 8) {
        place = (int32_t)(((uint32_t)place & 0xFFFF0000u) + 0x8000u) + (int32_t)(choice % 3u) - 1;
    } else if (choice == 8) {
        place = (int32_t)((any_32() & 1u) * (end << 16));
    }
    return place;
}

/* A number by the farthest depth of the last octave: a unit is one of its codes. Their sum with a
 * row's rounding may be below the first code. */
static int64_t any_farthest(fxl_depth_scale scale, int32_t one)
{
    const int32_t drop = one - scale.octaves - 16 - scale.mantissa;
    const uint32_t units = (any_32() >> 9) % 200u;
    return ((int64_t)1 << (one - scale.octaves)) + ((int64_t)units << (drop < 0 ? 0 : drop));
}

/* Values at three corners of the band: of any length, or near each other, or near a power of two,
 * or farthest. Below 2^62. */
static void any_plane(const fxl_band *band, fxl_depth_plane *plane)
{
    int64_t corners[3];
    const uint32_t length = any_32() >> 7 & 31u, drop = length < 16 ? 0 : length - 16;
    const int64_t first = (int64_t)(any_64() >> 3 >> drop);
    const int64_t power = (int64_t)1 << (61u - drop);
    const bool is_farthest = (any_32() & 0x700u) == 0;
    plane->one = 62 - (int32_t)((any_32() >> 9) % 14u);
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t kind = any_32() >> 9 & 7u;
        const int64_t off = (int64_t)(any_64() >> 3 >> (any_32() >> 9) % 36u);
        corners[i] = is_farthest ? any_farthest(by_core.head.scale, plane->one)
                     : kind < 3  ? first + off / 16
                     : kind < 5  ? power + off / 64 - off / 128
                     : kind < 7  ? off
                                 : -off;
    }
    plane->gradient.along = (corners[1] - corners[0]) / band->width;
    plane->gradient.down = (corners[2] - corners[0]) / band->rows;
    plane->gradient.at = corners[0] - plane->gradient.down * band->first_row;
}

/* Words: codes of the band that are near each other, or any; no sum of them wraps. Every other time
 * they have a border, which may be among them. */
static void any_linear_plane(const fxl_band *band, fxl_depth_plane *plane)
{
    const uint32_t drop = 2u + (any_32() >> 9) % 20u;
    const int32_t number = (int32_t)((any_32() >> 9) % by_core.head.scale.octaves);
    plane->one = (any_32() & 0x200u) != 0 ? FXL_DEPTH_IS_BENT + number : FXL_DEPTH_IS_LINEAR;
    plane->gradient.along = ((int32_t)any_32() >> drop) / band->width;
    plane->gradient.down = ((int32_t)any_32() >> drop) / band->rows;
    uint32_t middle = (1u << 31) + (uint32_t)((int32_t)any_32() >> 2);
    if (plane->one != FXL_DEPTH_IS_LINEAR) {
        const uint32_t border = fxl_depth_border(by_core.head.scale, plane);
        const uint32_t near_it = border + (uint32_t)((int32_t)any_32() >> (drop + 1u));
        middle = border - (3u << 29) < 1u << 30 ? near_it : middle;
    }
    plane->gradient.at = (int32_t)(middle - (uint32_t)plane->gradient.down * band->first_row);
}

/* Cells of which nothing is drawn, or that are near the plane, or any: those of the band and of two
 * rows below it. The others keep what both sides have. */
static void any_cells(const fxl_band *band, const fxl_depth_plane *plane)
{
    const uint32_t kind = any_32() >> 8 & 7u;
    const uint32_t count = (uint32_t)band->width * (band->rows + 2u);
    fxl_depth_octave octave;
    for (uint32_t i = 0; i < CELLS && i < count; i++) {
        uint16_t cell = 0;
        if (kind >= 5 && (kind == 7 || (any_32() & 0x300u) == 0)) {
            const int32_t x = (int32_t)(i % band->width), y = (int32_t)(i / band->width);
            const int64_t depth =
                (int64_t)((uint64_t)plane->gradient.at +
                          (uint64_t)plane->gradient.down * (uint64_t)(y + band->first_row));
            const int64_t value =
                (int64_t)((uint64_t)depth + (uint64_t)plane->gradient.along * (uint64_t)x);
            if (fxl_depth_is_in_words(plane)) {
                fxl_depth_octave_of_word(by_core.head.scale, plane, (uint32_t)value, &octave);
            } else {
                fxl_depth_octave_of(by_core.head.scale, plane, value, &octave);
            }
            const uint32_t code = octave.is_constant
                                      ? octave.bias
                                      : octave.bias + fxl_depth_shifted(depth, octave.drop) +
                                            octave.step * (uint32_t)x;
            cell = (uint16_t)((code >> 16) + (any_32() >> 9 & 3u) - 2u);
        } else if (kind >= 3) {
            cell = (uint16_t)(any_32() >> (16u + (any_32() >> 9 & 15u)));
        }
        by_core.cells[i] = by_portable.cells[i] = cell;
    }
}

/* Light at three corners of the band: of the ramp, or also a quarter of it beside it. In the whole
 * band it is from -128 to 128, as light_row.h says of a face. */
static void any_light(const fxl_band *band, polygon *of)
{
    fxl_gradient *light = &of->gradients.attributes[0];
    const uint32_t beside = any_32() >> 9 & 1u;
    const uint32_t levels = 2u + (any_32() >> 9) % (beside ? 39u : 63u);
    const uint32_t exponent = 8u + (any_32() >> 9) % 21u; /* of 16.16 levels */
    const uint32_t range = (levels - 1u) << 16, quarter = beside * (range >> 2);
    int64_t corners[3];
    for (uint32_t i = 0; i < 3; i++) {
        const int32_t value =
            (int32_t)((any_32() >> 1) % (range + 2u * quarter) + 32768u) - (int32_t)quarter;
        corners[i] = (int64_t)((uint64_t)(int64_t)value << exponent);
    }
    light->along = (corners[1] - corners[0]) / band->width;
    light->down = (corners[2] - corners[0]) / band->rows;
    light->at = corners[0] - light->down * band->first_row;
    of->gradients.count = 1;
    of->gradients.shifts[0] = (int8_t)(61 - (int32_t)exponent);
    const uint8_t colour = (uint8_t)any_32();
    const uint16_t dark = (uint16_t)(any_32() >> 9);
    of->paint = (fxl_paint){
        .gradients = &of->gradients,
        .ramp = ramp,
        .levels_less_1 = (uint8_t)(levels - 1u),
        .colour = colour,
        .has_light_rows = true,
        .is_light_linear = true,
        .of_565 = {.palette = palette,
                   .part_of_level = (65536u + (levels - 1u) / 2u) / (levels - 1u),
                   .dark = dark},
    };
    palette[colour] = (uint16_t)(any_32() >> 9);
}

/* Any words: sums wrap. The face's column is one of the band. */
static void any_colours(const fxl_band *band, polygon *of)
{
    fxl_gradient *attributes = of->gradients.attributes;
    for (uint32_t i = 0; i < 2; i++) {
        attributes[i].at = (int64_t)any_64();
        attributes[i].along = (int64_t)any_64();
        attributes[i].down = (int64_t)any_64();
    }
    const uint32_t column = (any_32() >> 9) % band->width;
    attributes[0].at = (int64_t)((uint64_t)column << 32 | any_32());
    of->gradients.count = FXL_GRADIENTS_OF_WORDS;
    of->gradients.shifts[0] = FXL_SHIFT_OF_WORDS;
    of->paint = (fxl_paint){.gradients = &of->gradients, .opacity = 16};
}

/* Any words, and light, which is held nowhere; texels of 8 and of 16 bits. */
static void any_texels(polygon *of)
{
    const uint32_t kind = any_32() >> 9, columns = kind >> 4 & 7u;
    const uint32_t any = kind >> 8 & 7u, rows = columns + any > 13u ? 13u - columns : any;
    const uint16_t dark = kind & 8u ? (uint16_t)(any_32() >> 9) : 0;
    fxl_gradient *attributes = of->gradients.attributes;
    for (uint32_t i = 0; i < FXL_ATTRIBUTES; i++) {
        attributes[i].at = (int32_t)any_32();
        attributes[i].along = (int32_t)any_32() >> (any_32() >> 9 & 15u);
        attributes[i].down = (int32_t)any_32() >> (any_32() >> 9 & 15u);
        of->gradients.shifts[i] = (int8_t)(FXL_SHIFT_OF_TEXELS - (any_32() >> 9 & 7u));
    }
    of->gradients.count = kind & 1u ? 3 : 2;
    of->paint = (fxl_paint){
        .gradients = &of->gradients,
        .level = {.texels = ramp,
                  .columns_less_1 = (1u << columns) - 1u,
                  .rows_less_1 = (1u << rows) - 1u,
                  .log_width = (uint8_t)columns,
                  .flags = kind & 2u ? 0x80u : 0}, /* FXL_LEVEL_565 */
        .levels_less_1 = 31,
        .is_evenly_lit = (kind & 1u) == 0,
        .light = (uint16_t)(any_32() >> 9),
        .of_565 = {.palette = palette,
                   /* with black any light is a part, of at most 256 */
                   .part_of_level = (kind & 4u) == 0 ? 0
                                    : dark == 0      ? 257u
                                                     : 65536u / 31u,
                   .dark = dark},
    };
    palette[any_32() >> 9 & 255u] = (uint16_t)(any_32() >> 9);
}

#endif
