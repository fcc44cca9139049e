/* SPDX-License-Identifier: MIT */
/* An outline of one colour in a depth buffer of 16 bits, near to far: survey, edges, depth test
 * and pixels in one call. A library for size has none of this: the rows of depth_row.h do the same. Nor
 * has a core that divides 64 bits: it is a host, where make predict counts those rows. Internal. */
#ifndef FXL_DEPTH_OUTLINE_H
#define FXL_DEPTH_OUTLINE_H

#include "fixel/records.h"
#include "../math/family.h"
#include "../raster/scan.h"
#include "depth_row.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_DRAWS_DEPTH_OUTLINES  (!FXL_IS_COMPACT && !FXL_HAS_LONG_DIVIDER)
#define FXL_DRAWS_SMOOTH_OUTLINES (FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT)
#define FXL_DRAWS_SMOOTH_WORDS    (FXL_DRAWS_DEPTH_OUTLINES && !FXL_KERNELS_ARMV7M) /* in C */

/* What the kernel needs of a polygon, and what it keeps from row to row. Cells are counted from the
 * first one of the band. An octave here is the number of leading zeros of the gradient's upper
 * word. In assembly, plane.gradient.at becomes the value in column 0 of the next row, and the words
 * from plane.one on the number of that row's first cell and of cells a row. Of an outline that has
 * one octave the members from `one` on are overwritten: 64 bits, whose upper word is the code of
 * cell 0 in the next row, their change a row, and the step. */
typedef struct {
    FXL_ALIGN_8 fxl_depth_plane plane;
    uint32_t zeros; /* of the octave that is known; above 32: of none; 0: the outline has one */
    int32_t drop;   /* of it, as of fxl_depth_octave; so the next two */
    uint32_t bias;
    uint32_t step;
    uint16_t *cells;   /* of the band */
    uintptr_t pixels;  /* a cell's address, divided by 2 where pixels have 8 bits, plus this is its
                          pixel's */
    uint32_t filling;  /* the colour in each pixel of four bytes */
    int32_t one;       /* of the plane */
    uint32_t octaves;  /* of the scale */
    uint32_t mantissa; /* of the scale */
    uint32_t rest[6];  /* of a row that has several octaves: the kernel's own */
    fxl_scan *scan;    /* workspace of the text in C; kernels in assembly do not read it */
} fxl_depth_outline;

/* What became of an outline. */
typedef enum {
    FXL_DEPTH_NOT_DRAWN =
        0, /* it is not scanned between two chains: survey in scan.c. In C also one
                              * whose box has several octaves */
    FXL_DEPTH_DRAWN = 1,
    FXL_DEPTH_NO_ROW = 2,   /* it reaches no row of the band */
    FXL_DEPTH_NOT_CLEAR = 3 /* a smooth one: it reaches a row whose cells are not cleared */
} fxl_depth_drawn;

#if FXL_DRAWS_DEPTH_OUTLINES

/* Draws an outline of count points. Requires fxl_depth_outline_begin and what fxl_scan_begin
 * requires of outline and band. By the number of a pixel's bits; both write what
 * fxl_depth_paint_row writes. */
fxl_depth_drawn fxl_draw_depth_outline_8(const fxl_screen_point *points, uint32_t count,
                                         const fxl_band *band, fxl_depth_outline *outline);
fxl_depth_drawn fxl_draw_depth_outline_16(const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band, fxl_depth_outline *outline);

#if FXL_KERNELS_ARMV6M

/* The codes of an outline that has one octave, and what its rows share. Cells are counted from address 0,
 * in pairs of bytes. */
typedef struct {
    uint64_t line;    /* its upper word is the code of cell 0 in the first row, modulo 2^32 */
    uint32_t filling; /* as of fxl_depth_outline; so pixels */
    uint32_t step;    /* of a code a pixel */
    uintptr_t pixels;
    uint32_t first; /* the cell of column 0 in the first row, less 8 */
    uint64_t down;  /* the change of `line` a row */
    uint32_t width; /* cells a row */
} fxl_depth_sheet;

/* Paints the rows of a scan between two chains that reaches a row, was begun, and has not been read.
 * The scan has no row left then. */
void fxl_paint_depth_sheet_8(const fxl_depth_sheet *sheet, fxl_scan *scan);
void fxl_paint_depth_sheet_16(const fxl_depth_sheet *sheet, fxl_scan *scan);

#endif
#endif

/* What became of a triangle. The second and third are those of fxl_depth_drawn. */
typedef enum {
    FXL_DEPTH_FACE_IS_OTHER = 0, /* a vertex is outside a plane, out of range or no longer in the
                                    cache, or the kernel cannot draw the plane or the outline */
    FXL_DEPTH_FACE_IS_DRAWN = 1,
    FXL_DEPTH_FACE_HAS_NO_ROW = 2, /* in the band */
    FXL_DEPTH_FACE_IS_BETWEEN = 3  /* FXL_CLIP_BETWEEN */
} fxl_depth_face;

#if FXL_DRAWS_SMOOTH_OUTLINES

/* Draws a triangle of a model view in pixels of 16 bits: fxl_clip_by_view, fxl_find_depth_plane, and
 * fxl_draw_depth_outline_16. Unless it is FXL_DEPTH_FACE_IS_OTHER, screen->points are its. Requires
 * fxl_depth_outline_of_band, the filling, and what fxl_draw_depth_outline_16 requires of the band.
 * Changes the rest of *outline. */
fxl_depth_face fxl_draw_depth_face_16(const fxl_model_view *model_view, const fxl_face *face,
                                      fxl_depth_outline *outline, const fxl_band *band,
                                      fxl_screen_polygon *screen);

#endif

/* Whether the kernels can draw there, whatever is drawn: all columns of a band without gaps, whose
 * first pixel is where two can be stored at once. */
static inline bool fxl_depth_outline_can_draw(const fxl_depth_head *head, const fxl_band *band,
                                              uint32_t pixel_bytes)
{
    return !head->or_equal && band->columns == 0 && band->stride == band->width &&
           ((uintptr_t)band->pixels & (2 * pixel_bytes - 1)) == 0;
}

/* fxl_depth_outline.pixels. */
static inline uintptr_t fxl_depth_outline_pixels(const fxl_depth_head *head, const fxl_band *band,
                                                 uint32_t pixel_bytes)
{
    const uintptr_t cells = (uintptr_t)(head + 1), pixels = (uintptr_t)band->pixels;
    return pixel_bytes == 1 ? pixels - cells / 2 : pixels - cells;
}

/* Sets what all polygons of a band share whose pixels have `pixel_bytes` bytes. */
static inline void fxl_depth_outline_of_band(const fxl_depth_head *head, const fxl_band *band,
                                             uint32_t pixel_bytes, fxl_depth_outline *outline)
{
    outline->cells = (uint16_t *)(uintptr_t)(head + 1);
    outline->pixels = fxl_depth_outline_pixels(head, band, pixel_bytes);
}

/* Sets what follows from the plane, which *outline has. Returns false if the kernel cannot draw it: it
 * draws planes of which a value whose upper word is not above 0 is beyond the last octave. */
static inline bool fxl_depth_outline_of_plane(const fxl_depth_head *head,
                                              fxl_depth_outline *outline)
{
    if (outline->plane.one < 32 + head->scale.octaves) {
        return false;
    }
    outline->zeros = UINT32_MAX;
    outline->one = outline->plane.one;
    outline->octaves = head->scale.octaves;
    outline->mantissa = head->scale.mantissa;
    return true;
}

/* Prepares a polygon whose pixels have `pixel_bytes` bytes, and whose plane *outline has. Returns
 * false as fxl_depth_outline_of_plane does. Requires fxl_depth_outline_can_draw. */
static inline bool fxl_depth_outline_begin(const void *memory, const fxl_band *band,
                                           uint32_t pixel_bytes, fxl_depth_outline *outline)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    fxl_depth_outline_of_band(head, band, pixel_bytes, outline);
    return fxl_depth_outline_of_plane(head, outline);
}

/* --- triangles of few pixels -------------------------------------------------- */

/* Whether a triangle of few centres is drawn by the pixels that fxl_tiny_cover finds. */
#define FXL_DRAWS_DEPTH_TINY (FXL_DRAWS_DEPTH_OUTLINES && FXL_HAS_TINY && !FXL_KERNELS_ARMV7M)

/* The codes of a box of centres whose values have one octave, as of fxl_depth_octave. */
typedef struct {
    int64_t value; /* in column 0 of the first row */
    int32_t drop;  /* 1 to 31 */
    uint32_t bias, step;
} fxl_tiny_codes;

/* Finds them. The octave is one, if the first value of the box, less all that the others change along
 * both sides, has that of their sum. Upper words: a change is rounded up. Values on the screen are
 * below 2^62, so both changes are below 2^30 + 8, and their sum is below 2^30 by the comparison. */
FXL_ONCE bool fxl_tiny_codes_find(const fxl_depth_plane *plane, const fxl_tiny *tiny,
                                       fxl_depth_scale scale, fxl_tiny_codes *codes)
    FXL_REQUIRES(FXL_OBJECT(plane) && FXL_OBJECT(tiny) && FXL_OBJECT(codes))
        FXL_REQUIRES(FXL_BELOW(plane->gradient.at, (int64_t)1 << 60) &&
                     FXL_BELOW(plane->gradient.along, (int64_t)1 << 50) &&
                     FXL_BELOW(plane->gradient.down, (int64_t)1 << 50) &&
                     FXL_BELOW(plane->one, 200))
            FXL_REQUIRES(tiny->row >= 0 && tiny->row < 1024 && tiny->rows > 0 && tiny->rows <= 8)
                FXL_REQUIRES(tiny->column >= 0 && tiny->column < 1024 && tiny->columns > 0 &&
                             tiny->columns <= 8)
                    FXL_REQUIRES(scale.octaves >= 1 && scale.octaves <= 24 &&
                                 scale.mantissa >= 11 && scale.mantissa <= 15) FXL_ASSIGNS(*codes)
                        FXL_ENSURES(!FXL_RESULT || (codes->drop >= 1 && codes->drop <= 31 &&
                                                    FXL_BELOW(codes->value, (int64_t)1 << 61)))
{
    const fxl_gradient *gradient = &plane->gradient;
    codes->value = gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)tiny->row);
    const int32_t upper =
        (int32_t)((codes->value + fxl_multiply_s64_u16(gradient->along, (uint32_t)tiny->column)) >>
                  32);
    const int32_t along = (int32_t)(gradient->along >> 32), down = (int32_t)(gradient->down >> 32);
    const uint32_t change =
        (fxl_bits_32(along ^ along >> 31) + 1u) * (uint32_t)(tiny->columns - 1) +
        (fxl_bits_32(down ^ down >> 31) + 1u) * (uint32_t)(tiny->rows - 1);
    if (change >> 30 != 0 || upper <= (int32_t)change) {
        return false;
    }
    const uint32_t least = (uint32_t)upper - change, most = (uint32_t)upper + change;
    if ((least ^ most) > least) {
        return false;
    }
    const int32_t length = 64 - (int32_t)fxl_leading_zeros(least);
    const uint32_t number = fxl_bits_32(plane->one - length);
    codes->drop = length - 17 - scale.mantissa;
    if (number >= scale.octaves || fxl_bits_32(codes->drop) - 1u > 30u) {
        return false;
    }
    codes->bias = ((scale.octaves - 2u - number) << (scale.mantissa + 16)) + 65536u;
    codes->step = fxl_depth_shifted(gradient->along, codes->drop);
    return true;
}

/* Draws pixels of a triangle, of which there is one at least, in one colour: all in the band, which has
 * all columns. False: the codes of its box have several octaves, and nothing is drawn. It writes what
 * fxl_depth_paint_row writes, near to far. */
static inline __attribute__((always_inline)) bool
fxl_depth_tiny_draw(const fxl_depth_plane *plane, const fxl_tiny *tiny, const fxl_depth_head *head,
                    const fxl_band *band, uint32_t filling, uint32_t bits)
{
    const uint32_t width = band->width, columns = (uint32_t)tiny->columns, bytes = bits / 8u;
    const uint32_t gap = width - columns;
    const size_t place =
        (size_t)(uint32_t)(tiny->row - band->first_row) * width + (uint32_t)tiny->column;
    fxl_tiny_codes codes;
    if (!fxl_tiny_codes_find(plane, tiny, head->scale, &codes)) {
        return false;
    }
    uint16_t *cell = (uint16_t *)(uintptr_t)(head + 1) + place;
    uint8_t *pixel = band->pixels + place * bytes;
    uint32_t pixels = tiny->pixels;
    codes.bias += codes.step * (uint32_t)tiny->column;
    for (;;) {
        uint32_t code = codes.bias + fxl_depth_shifted(codes.value, codes.drop);
        for (uint32_t left = columns; left > 0; left--) {
            if (pixels >> 31 != 0 && code >> 16 > *cell) {
                *cell = (uint16_t)(code >> 16);
                if (bits == 16) {
                    *(uint16_t *)(void *)pixel = (uint16_t)filling;
                } else {
                    *pixel = (uint8_t)filling;
                }
            }
            pixels <<= 1;
            code += codes.step;
            cell++;
            pixel += bytes;
        }
        if (pixels == 0) {
            return true;
        }
        codes.value += plane->gradient.down;
        cell += gap;
        pixel += gap * bytes;
    }
}

#ifdef __cplusplus
}
#endif

#endif
