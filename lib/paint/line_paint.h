/* SPDX-License-Identifier: MIT */
/* The pixels of lines and points over a band, with a depth or without. Internal. */
#ifndef FXL_LINE_PAINT_H
#define FXL_LINE_PAINT_H

#include "../math/arith.h"
#include "../raster/columns.h"
#include "depth_row.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a plane in words has more of a margin than it is, so that no octave but its own holds it. */
#define FXL_LINE_MARGIN_OF_WORDS ((uint32_t)1 << 30)

/* The depth of a face on which lines lie, and the octave of its codes that was found last. */
typedef struct {
    fxl_depth_plane plane;
    /* About the depth of a place on the screen, counted in 2^drop: that of its corner, and what 2^-16
     * of a column and of a row add. Words are the upper ones of 64 bits. `margin`: how far, in words,
     * pixels of a line may be from the straight line between its ends. */
    int64_t at;
    int32_t words[2];
    int32_t drop;
    uint32_t margin;
    /* Where the words of both ends of a line are some of those from low on, so many, the octave holds
     * all its pixels. held 0: nothing is known. */
    uint32_t low, held;
    /* A code of the octave is what `added` is to the upper word of start + x steps[0] + y steps[1],
     * shifted right by shift: 0, or to 2. */
    uint32_t shift, added;
    uint64_t start, steps[2];
    /* The octave, if fxl_line_find_other found it last, holds the depths whose word is one of those
     * from first on, so many. That of a plane in words is a code of 16 bits. span 0: it holds none. */
    uint32_t first, span;
} fxl_line_plane;

/* Codes of a plane in words, which are known modulo 2^32, times 2^16 and as signed numbers: the upper
 * word is the code of 16 bits. corner: a point of the face on the screen. Where all pixels are less
 * than 2^14 from it, they are below 2^63. */
void fxl_line_continue_words(fxl_depth_plane *plane, const fxl_screen_point *corner);

/* After `plane` was set. */
void fxl_line_plane_begin(fxl_line_plane *face);

/* A line or a point on the screen. */
typedef struct {
    fxl_screen_point ends[2];
    fxl_q18_46 distances[2]; /* of the ends along forward, above 0: of a line without planes */
    uint8_t colour, width;   /* 1..16 */
    bool is_point;           /* at the first end */
    uint8_t plane_count;     /* 0..2 */
    fxl_line_plane *planes[2];
} fxl_painted_line;

/* The band as a line goes through it: along its rows or its columns, and across them up or down. */
typedef struct {
    uint32_t upright;   /* 1: places along are rows, 0: they are columns */
    int32_t change;     /* of the pixel across, where it changes: -1 or 1 */
    int32_t first, end; /* places along that the band has, from first on */
    int32_t low, high;  /* pixels across that it has, from low on */
    int32_t inner;      /* those but the first and the last one: from inner on, so many */
    uint32_t inner_count;
    /* How far the cell and the pixel of a place are from those of the next place along, and from those
     * of the pixel across to which it changes: bytes. */
    int32_t cell_along, pixel_along, cell_across, pixel_across;
} fxl_line_axes;

/* What it is painted into: pixels from column 0 on, and, unless head is null, the cells behind it,
 * all of whose rows are those of the band. */
typedef struct {
    const fxl_band *band;
    const fxl_depth_head *head;
    fxl_real near_real; /* near_z of the lens, with a head */
    /* The end whose depth was found last, which the next line of a polyline begins at: its distance, or
     * 0, and near_z / distance = mantissa * 2^-one. */
    fxl_q18_46 distance;
    uint32_t mantissa;
    int32_t one;
    uint32_t format;         /* FXL_LINE_COLOURS and so on */
    fxl_line_axes axes[4];   /* by fxl_line_axes_of */
    uintptr_t cells, pixels; /* where those of the first pixel of the screen would be */
    uintptr_t apart;         /* FXL_LINE_NARROW: a pixel is so far from half its cell's address */
} fxl_line_canvas;

/* What cells and pixels are. */
enum {
    FXL_LINE_NARROW = 0,
    FXL_LINE_COLOURS = 1,
    FXL_LINE_WIDE = 2,
    FXL_LINE_PLAIN = 4, /* pixels alone */
    FXL_LINE_APART = 8  /* rows of pixels are not as long as those of cells */
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
