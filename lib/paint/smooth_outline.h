/* SPDX-License-Identifier: MIT */
/* An outline of one colour whose light and depth codes are linear on the screen, in a depth buffer
 * of 16 bits, front to back: survey, edges, depth test, light and pixels in one call. Only Armv7-M
 * has this, as depth_outline.h says. Internal. */
#ifndef FXL_SMOOTH_OUTLINE_H
#define FXL_SMOOTH_OUTLINE_H

#include "depth_outline.h"
#include "light_row.h"
#include "rgb565_colour.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place light: RGB565: the part of a colour that light leaves of a lit surface */
/* What the kernel needs of a polygon, and what it keeps from row to row. Cells are counted from the
 * first one of the band. The code and the light of a pixel are those of cell 0 in its row, and a
 * step for each cell. For pixels of 16 bits light is less the half level, and has half a part of
 * 256 more; between -1 part and 0 it is not held, since no part of it is left. */
typedef struct {
    uint32_t code;      /* of row 0, less its change a row; then of a row: the kernel's own */
    uint32_t code_down; /* from row to row, a row of cells less */
    uint32_t down;      /* of light */
    uint32_t light;     /* as code */
    uint32_t along;     /* of light */
    union {
        const uint8_t *ramp;    /* pixels of 8 bits: the entry of the face's colour in level 0 */
        uint32_t part_of_level; /* of 16 */
    } by;
    fxl_mixture_565 mixture; /* of 16 bits */
    uint16_t *cells;         /* of the band */
    uintptr_t pixels; /* as of fxl_depth_outline; of 16 bits: of the cell after the pixel's */
    uint32_t code_along;
    uint32_t limit;  /* light from here on is not of the ramp; 0: codes have a border */
    uint32_t last;   /* pixels of 8 bits: the last level; of 16: the most light of the ramp */
    uint32_t border; /* as of fxl_depth_border */
    uint32_t rows;   /* the kernel's own */
} fxl_smooth_outline;

#if FXL_DRAWS_DEPTH_OUTLINES

/* Draws an outline of count points. Requires fxl_smooth_outline_begin and what fxl_scan_begin
 * requires of outline and band. By the number of a pixel's bits; both write what
 * fxl_depth_paint_row and fxl_paint_pixels, or fxl_paint_pixels_565, write. */
fxl_depth_drawn fxl_draw_smooth_outline_8(const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band, fxl_smooth_outline *smooth);
fxl_depth_drawn fxl_draw_smooth_outline_16(const fxl_screen_point *points, uint32_t count,
                                           const fxl_band *band, fxl_smooth_outline *smooth);

#endif

/* Prepares a polygon whose pixels have `pixel_bytes` bytes, and whose plane is in words. Requires
 * light in words, and fxl_depth_outline_can_draw. */
static inline void fxl_smooth_outline_set(const fxl_depth_head *head, const fxl_depth_plane *plane,
                                          const fxl_paint *paint, const fxl_band *band,
                                          uint32_t pixel_bytes, fxl_smooth_outline *smooth)
{
    const uint32_t code_row = band->width * (uint32_t)plane->gradient.along;
    smooth->cells = (uint16_t *)(uintptr_t)(head + 1);
    smooth->pixels = fxl_depth_outline_pixels(head, band, pixel_bytes);
    smooth->code_along = (uint32_t)plane->gradient.along;
    smooth->code_down = (uint32_t)plane->gradient.down - code_row;
    smooth->code = (uint32_t)plane->gradient.at + band->first_row * code_row - smooth->code_down;
    const fxl_light_plane light = fxl_light_plane_of(paint->gradients);
    const uint32_t row_along = band->width * light.along;
    smooth->along = light.along;
    smooth->down = light.down - row_along;
    smooth->light = light.at + band->first_row * row_along - smooth->down;
    const uint32_t most = (uint32_t)paint->levels_less_1 << 24;
    const uint32_t border = fxl_depth_border(head->scale, plane);
    smooth->border = border;
    if (pixel_bytes == 1) {
        smooth->limit = border != 0 ? 0 : most + (1u << 24);
        smooth->last = paint->levels_less_1;
        smooth->by.ramp = paint->ramp + paint->colour;
    } else {
        const fxl_paint_565 *of = &paint->of_565;
        const uint32_t half_part = fxl_half_part_565(paint->levels_less_1);
        smooth->limit = border != 0 ? 0 : most + half_part + 1u;
        smooth->last = most + half_part;
        smooth->light += half_part - (1u << 23);
        smooth->pixels -= pixel_bytes;
        smooth->by.part_of_level = of->part_of_level;
        smooth->mixture = fxl_mixture_of_565(of->palette[paint->colour], of->dark);
    }
}

/* The same for any polygon. Returns false if the kernel cannot draw it: *smooth is undefined then.
 * Requires paint->is_light_linear. */
static inline bool fxl_smooth_outline_begin(const void *memory, const fxl_depth_plane *plane,
                                            const fxl_paint *paint, const fxl_band *band,
                                            uint32_t pixel_bytes, fxl_smooth_outline *smooth)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    if (!fxl_depth_is_in_words(plane) || !fxl_depth_outline_can_draw(head, band, pixel_bytes)) {
        return false;
    }
    fxl_smooth_outline_set(head, plane, paint, band, pixel_bytes, smooth);
    return true;
}

#ifdef __cplusplus
}
#endif

#endif
