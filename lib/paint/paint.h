/* SPDX-License-Identifier: MIT */
/* Painting the pixels of a face that has a surface: row by row, in segments of the screen's
 * columns. Internal. */
#ifndef FXL_PAINT_H
#define FXL_PAINT_H

#include "fixel/surfaces.h"
#include "gradients.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place sampling: the masks of a level */
/* One level of a texture, ready to be looked up. */
typedef struct {
    const uint8_t *texels;
    const uint8_t *colours; /* FXL_TEXTURE_4; else null */
    uint32_t columns_less_1, rows_less_1;
    uint8_t log_width;
    uint8_t flags; /* of the texture */
    uint8_t key;
} fxl_texture_level;

/* place light: RGB565: the part of a colour that light leaves of a lit surface */
/* place pixel-format: fxl_paint_565 and fxl_paint_pixels_565: the pixels of a surface */
/* What pixels of 16 bits depend on beside that. */
typedef struct {
    const uint16_t *palette;
    uint32_t part_of_level; /* 2^16 / (levels - 1), rounded; 0: unlit */
    uint16_t dark;
    uint16_t key;       /* of a texture that is FXL_TEXTURE_565 */
    uint8_t sixteenths; /* that a pixel shows of its own colour; 0: it is not blended */
    bool adds;
} fxl_paint_565;

/* What paints a face with colours at its corners: corner_colours.h. */
typedef struct fxl_colours_code fxl_colours_code;

/* All that a face's pixels depend on. */
typedef struct {
    const fxl_gradients *gradients;
    fxl_texture_level level; /* texels null: the face's own colour */
    const uint8_t *ramp;     /* ramp[256 * level + colour], by the last attribute; null: unlit */
    const uint8_t *table;    /* table[texel]: what a texel becomes before that, of light that is the
                                same everywhere or of a beam; null: it stays as it is */
    const uint8_t *in_beam; /* in_beam[colour]: what the ramp has made, in a beam; null: in none, or
                               `ramp` is that of a beam, of one level */
    const uint8_t *blend;   /* as of fxl_surface_set; null: no colour is blended */
    uint32_t blend_count;
    uint8_t blend_first;
    uint8_t levels_less_1; /* of the ramp */
    uint8_t colour;        /* of the face */
    uint8_t division;      /* FXL_DIVIDE_16, FXL_DIVIDE_8, FXL_DIVIDE_1 */
    uint8_t opacity;       /* 1..16 */
    uint16_t light;        /* where is_evenly_lit: 1/256 level, and a half level */
    bool is_evenly_lit;    /* light is no attribute: it is the same everywhere */
    bool is_replaced;      /* in_beam or blend is not null */
    bool has_beams;        /* a part of its face may be in a beam */
    bool has_light_rows;   /* opaque pixels of one colour, lit, in no beam: light_row.h */
    bool is_light_linear;  /* and the weight is constant; also where colours is not null */
    const fxl_colours_code *colours; /* at its corners: corner_colours.h; null: none */
    fxl_paint_565 of_565;  /* where pixels have 16 bits; `blend` is not used there */
} fxl_paint;

/* What the kernel of segments needs of a face: segments.h. */
typedef struct fxl_segment_face fxl_segment_face;

/* The row that is being painted: the gradients at the centre of its pixel 0. The upper words are
 * the values. */
typedef struct {
    int64_t weight;
    int64_t attributes[FXL_ATTRIBUTES];
    uint8_t *pixels; /* of column 0 */
    int32_t y;
    const fxl_segment_face *segments; /* null: the kernel cannot paint this face */
} fxl_paint_row;

/* The first number's upper word, x pixels on. */
static inline int32_t fxl_row_value_at(int64_t first, const fxl_gradient *gradient, int32_t x)
{
    return (int32_t)((first + gradient->along * x) >> 32);
}

/* Of a number of 64 bits; at least 1. */
static inline uint32_t fxl_upper_weight(int64_t number)
{
    const int32_t weight = (int32_t)(number >> 32);
    return weight < 1 ? 1 : (uint32_t)weight;
}

static inline uint32_t fxl_row_weight_at(const fxl_paint *paint, const fxl_paint_row *row,
                                         int32_t x)
{
    return fxl_upper_weight(row->weight + paint->gradients->weight.along * x);
}

/* The attributes of a pixel, divided. */
void fxl_divide_row_at(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                       int32_t values[FXL_ATTRIBUTES]);

/* Paints the pixels x0 <= x < x1 of a row. Safe for any gradients: no texel is read that is not of
 * the level, and no other pixel is written. Requires x0 < x1 within the band. */
void fxl_paint_pixels(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1);

/* The same where pixels have 16 bits: row->pixels is the address of a uint16_t. */
void fxl_paint_pixels_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1);

#ifdef __cplusplus
}
#endif

#endif
