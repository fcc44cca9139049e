/* SPDX-License-Identifier: MIT */
/* Drawing an outline: scan and fill in one call, for what draws over the pixels that are there.
 * Internal. */
#ifndef FXL_DRAW_OUTLINE_H
#define FXL_DRAW_OUTLINE_H

#include "fixel/records.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Fills the pixels of a band that the outline of a polygon covers with a colour of the palette; the
 * polygon's own colour is not read. Returns whether the outline reaches a row of the band; with
 * FXL_SMALL it is always true. Requires what fxl_scan_begin requires of outline and band; scan is
 * workspace. It is a kernel: each family of cores may have its own, and all write the same pixels.
 * Exact. */
bool fxl_draw_outline(fxl_scan *scan, const fxl_screen_polygon *polygon, const fxl_band *band,
                      uint32_t colour);

/* The same with a colour of RGB565, for a band of such pixels, whose address is even. */
bool fxl_draw_outline_rgb565(fxl_scan *scan, const fxl_screen_polygon *polygon,
                             const fxl_band *band, uint32_t colour);

/* The same two by active edges, for an outline that is not scanned between two chains, or with
 * FXL_SMALL. A kernel calls them. */
bool fxl_draw_by_active_edges(fxl_scan *scan, const fxl_screen_polygon *polygon,
                              const fxl_band *band, uint32_t colour);
bool fxl_draw_by_active_edges_rgb565(fxl_scan *scan, const fxl_screen_polygon *polygon,
                                     const fxl_band *band, uint32_t colour);

/* fxl_scan_rows of count points. */
fxl_rows fxl_rows_of_points(const fxl_screen_point *points, uint32_t count, uint16_t height);

/* Whether fxl_scan_rows finds a row. */
bool fxl_outline_has_rows(const fxl_screen_polygon *polygon, uint16_t height);

/* A line on its way along its major axis: that of its longer side. */
typedef struct {
    int32_t across; /* the pixel across the major axis */
    int64_t left;   /* what the line is beyond the first edge of that pixel: 0 <= left < pixel */
    int64_t pixel;  /* a pixel, in the same unit; below 2^61 */
    int64_t step;   /* change of the line across a pixel along; |step| <= pixel */
    bool upright;   /* the major axis is y */
} fxl_line_pixels;

/* The places along the major axis that a line has: first <= place < end. Where first is not below
 * end there are none. */
typedef struct {
    int32_t begin;      /* the first of the whole line, within the band or before it */
    int32_t first, end; /* those within the band along that axis */
} fxl_line_extent;

/* The pixels of a line, of which *pixels is at extent.first where there are any: by the rule of
 * docs/extras/wire.md, section 2. Exact, so a line has the same pixels in either direction.
 * Requires points within FXL_SCREEN_COORDINATE_MAX and 8 pixels, and a band of a screen of at most
 * FXL_SCREEN_MAX by FXL_SCREEN_MAX pixels. */
fxl_line_extent fxl_find_line_pixels(const fxl_screen_point *start, const fxl_screen_point *end,
                                     const fxl_band *band, fxl_line_pixels *pixels);

/* The line at the next place along its major axis. */
/* wire 2.2, 2.3 */
static inline void fxl_step_line_pixels(fxl_line_pixels *line)
{
    line->left += line->step;
    if (line->left >= line->pixel) {
        line->left -= line->pixel;
        line->across++;
    } else if (line->left < 0) {
        line->left += line->pixel;
        line->across--;
    }
}

/* Sets the pixels from place `first` (included) to `end` (not included) along the major axis. The
 * line is at `first`. Both must lie within the band along that axis. */
void fxl_draw_line_pixels(fxl_line_pixels *line, int32_t first, int32_t end, uint8_t colour,
                          const fxl_band *band);

#ifdef __cplusplus
}
#endif

#endif
