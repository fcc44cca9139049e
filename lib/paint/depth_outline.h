/* SPDX-License-Identifier: MIT */
/* An outline of one colour in a depth buffer of 16 bits, front to back: survey, edges, depth test
 * and pixels in one call. A library for size has none of this: the rows of depth_row.h do the same. Nor
 * has a core that divides 64 bits: it is a host, where make predict counts those rows. Internal. */
#ifndef FXL_DEPTH_OUTLINE_H
#define FXL_DEPTH_OUTLINE_H

#include "fixel/records.h"
#include "../math/family.h"
#include "depth_row.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_DRAWS_DEPTH_OUTLINES (!FXL_IS_COMPACT && !FXL_HAS_LONG_DIVIDER)
#define FXL_DRAWS_SMOOTH_OUTLINES (FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT)

/* What the kernel needs of a polygon, and what it keeps from row to row. Cells are counted from the
 * first one of the band. An octave here is the number of leading zeros of the gradient's upper
 * word. In assembly, plane.gradient.at becomes the value in column 0 of the next row, and the words
 * from plane.one on the number of that row's first cell and of cells a row. Of an outline that has
 * one octave the members from `one` on are overwritten: 64 bits, whose upper word is the code of
 * cell 0 in the next row, their change a row, and the step. */
typedef struct {
    FXL_ALIGN_8 fxl_depth_plane plane;
    uint32_t zeros;     /* of the octave that is known; above 32: of none; 0: the outline has one */
    int32_t drop;       /* of it, as of fxl_depth_octave; so the next two */
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
    FXL_DEPTH_NOT_DRAWN = 0, /* it is not scanned between two chains: survey in scan.c. In C also one
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

#ifdef __cplusplus
}
#endif

#endif
