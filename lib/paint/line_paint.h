/* SPDX-License-Identifier: MIT */
/* The pixels of lines and points over a band, with a depth or without. Internal. */
#ifndef FXL_LINE_PAINT_H
#define FXL_LINE_PAINT_H

#include "../raster/columns.h"
#include "depth_row.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The depth of a face on which lines lie, and the octave that was found last. It holds the depths
 * whose word is one of those from first on, so many: of a plane in words the lower one of 64 bits,
 * else the upper one. */
typedef struct {
    fxl_depth_plane plane;
    fxl_depth_octave octave;
    uint32_t first, span; /* span 0: it holds none */
    /* A code of the octave is what `added` is to the upper word of start + row y, and 2^shift
     * octave.step x more, shifted right by shift: 0, or to 2. */
    uint8_t shift;
    uint32_t added;
    uint64_t start, row;
    int32_t right, down; /* words of the gradient, rounded down: what a pixel adds to a word */
} fxl_line_plane;

/* A line or a point on the screen. */
typedef struct {
    fxl_screen_point ends[2];
    fxl_q18_46 distances[2]; /* of the ends along forward, above 0: of a line without planes */
    uint8_t colour, width;   /* 1..16 */
    bool is_point;           /* at the first end */
    uint8_t plane_count;     /* 0..2 */
    fxl_line_plane *planes[2];
} fxl_painted_line;

/* Pixels: first <= column < end, and so rows. */
typedef struct {
    int32_t first_column, end_column, first_row, end_row;
} fxl_pixel_box;

/* What it is painted into: pixels from column 0 on, and, unless head is null, the cells behind it,
 * all of whose rows are those of the band. */
typedef struct {
    const fxl_band *band;
    const fxl_depth_head *head;
    fxl_q16_16 near_z; /* of the lens */
    /* The end whose depth was found last, which the next line of a polyline begins at: its distance, or
     * 0, and near_z / distance = mantissa * 2^-one. */
    fxl_q18_46 distance;
    uint32_t mantissa;
    int32_t one;
    fxl_pixel_box box;           /* the pixels of the band */
    uint32_t format;             /* FXL_LINE_COLOURS and so on */
    uint32_t cell, pixel;        /* their bytes */
    int32_t cell_row, pixel_row; /* bytes of a row */
} fxl_line_canvas;

/* What cells and pixels are. */
enum {
    FXL_LINE_NARROW = 0,
    FXL_LINE_COLOURS = 1,
    FXL_LINE_WIDE = 2
};

/* A canvas; head: null without a depth buffer; wide: cells of 32 bits. */
void fxl_line_canvas_begin(fxl_line_canvas *canvas, const fxl_band *band,
                           const fxl_depth_head *head, fxl_q16_16 near_z, bool wide);

/* Paints the pixels of a line in the band; with a depth those whose code is not below the one that
 * is kept there, which it then replaces. Exact, given the line. Requires ends within
 * FXL_SCREEN_COORDINATE_MAX.
 * A pixel of a line with planes has the largest of their codes at its centre, as a face has it. A
 * line without planes has the same depth at all pixels of a column, or of a row if it is steep: the
 * one between those of its ends, off by less than 2^-25 of itself, and not beyond either. */
void fxl_paint_wide_line(fxl_line_canvas *canvas, const fxl_painted_line *line);

/* The rows of a screen that the pixels of a line may reach. */
fxl_rows fxl_rows_of_line(const fxl_painted_line *line, uint16_t height);

#ifdef __cplusplus
}
#endif

#endif
