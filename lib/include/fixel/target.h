/* SPDX-License-Identifier: MIT */
/* Targets: what a renderer draws into. A target is a pixel format, and a depth buffer or none. Each
 * is one constant record, and a program links only those that it names. */
#ifndef FXL_TARGET_H
#define FXL_TARGET_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fxl_renderer fxl_renderer;
struct fxl_workspace; /* fixel/render.h */
struct fxl_config;    /* fixel/render.h */
struct fxl_traversal; /* lib/draw/submit.h, which is internal */

/* What a target has beside that flat faces do not need. */
typedef struct fxl_target_extras {
    /* With a depth buffer: fxl_renderer.draw_display_list of a renderer that draws into it. */
    bool (*draw_display_list)(const struct fxl_traversal *traversal);
    /* With a depth buffer: draws a record of the display list that has a depth and no surface. */
    void (*flat)(struct fxl_workspace *workspace, const fxl_screen_polygon *record,
                 const fxl_band *band);
    /* With a depth buffer: the last shader of the renderer. It takes faces and pieces that no
     * attachment has drawn. Else null. */
    const struct fxl_shader *last;
    /* With outlines: the target that this one is a copy of. Its painters draw into this one. */
    const struct fxl_target *outlined;
    /* With outlines: draws the edges of a polygon that a painter has drawn. Else null. */
    void (*outline)(struct fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                    const fxl_band *band);
} fxl_target_extras;

/* place pixel-format: pixel_bits, and the records of the targets */
/* A target. Members are internal. By itself it draws faces of one colour. */
typedef struct fxl_target {
    uint8_t pixel_bits; /* 8: a palette index; 16: RGB565 */
    uint8_t depth_bits; /* of a pixel in the depth buffer: 0, 16 or 32 */
    /* Whether `flat` only scans and fills, over what is there: then a face may go from the clipper
     * straight to it, whether or not it reaches a row. */
    bool draws_over : 1;
    bool near_first : 1;  /* faces are submitted near to far, unless surfaces are blended */
    bool has_palette : 1; /* a pixel is a colour of RGB565: config.palette has that of each entry */
    bool is_mixed : 1; /* light and blends mix colours; else tables have the entry of a mixture */
    /* Sets every pixel of a band to a colour of the palette. */
    void (*fill)(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);
    /* Gives a renderer the target. Null: the target needs neither memory, a palette nor a shader.
     */
    fxl_status (*choose)(fxl_renderer *renderer, const struct fxl_config *config);
    /* The least size of a workspace's memory for the target, in bytes. Null: it needs none. */
    uint32_t (*memory_size)(const fxl_lens *lens);
    /* Draws a band of this screen, whose pixels are those from column 0 on, in parts if the memory
     * is too small for the whole. Returns FXL_OK, or a status that it has counted in refused_calls,
     * with the band untouched. */
    fxl_status (*draw_band)(const fxl_renderer *renderer, struct fxl_workspace *workspace,
                            const fxl_band *band);
    /* Draws a polygon of one colour that reaches rows of the screen; the band may hold none of
     * them. Returns false if the memory is full: then some of it may have been drawn. With
     * draws_over it returns instead whether the polygon reaches a row of the band, or, with
     * FXL_SMALL, true. */
    bool (*flat)(struct fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                 const fxl_band *band);
    const struct fxl_target_extras *extras; /* null: only flat faces */
} fxl_target;

/* A palette index of 8 bits a pixel: fxl_render draws into bytes. */
extern const fxl_target fxl_palette;          /* a later polygon covers an earlier one */
extern const fxl_target fxl_palette_depth_16; /* at each pixel the nearest face */
extern const fxl_target fxl_palette_depth_32;

/* RGB565, 16 bits a pixel: docs/extras/rgb565.md. */
extern const fxl_target fxl_rgb565;
extern const fxl_target fxl_rgb565_depth_16;
extern const fxl_target fxl_rgb565_depth_32;

/* Bytes of a depth buffer for so many rows of so many pixels, of 16 or 32 bits each, and for what
 * the buffer keeps beside them. A band with more rows than the buffer is drawn in parts, each of
 * which counts in split_bands; the pixels are the same. docs/extras/depth.md says which faces are
 * told apart. */
#define FXL_DEPTH_BYTES(width, rows, bits) \
    (8u + (((uint32_t)(width) * (uint32_t)(rows) * ((bits) / 8u) + 7u) & ~7u))

/* A pixel of RGB565: five bits of red above six of green above five of blue. The value of a colour
 * of three bytes, as docs/extras/pixels.md defines it. A constant expression. */
#define FXL_RGB565(red, green, blue) \
    FXL_CAST(uint16_t, ((red) / 8u) << 11 | ((green) / 4u) << 5 | (blue) / 8u)

/* Sets every pixel of a band of palette indices; of a band that has some columns alone, only
 * theirs. The bytes between width and stride are untouched. Exact. fxl_frame_fill (fixel/render.h)
 * does it in the renderer's format.
 * Requires a band that is not null, has at least one row, and has pixels of palette indices: it
 * writes one byte a pixel. */
void fxl_fill_band(const fxl_band *band, uint8_t colour);

#ifdef __cplusplus
}
#endif

#endif
