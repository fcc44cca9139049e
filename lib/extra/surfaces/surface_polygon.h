/* SPDX-License-Identifier: MIT */
/* A polygon of the screen that has a surface: its record in the display list, and its pixels.
 * Internal. */
#ifndef FXL_SURFACE_POLYGON_H
#define FXL_SURFACE_POLYGON_H

#include "fixel/extra/surfaces.h"
#include "gradients.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a polygon has beside its outline. */
typedef struct {
    fxl_gradients gradients;
    uint16_t surface; /* a number */
    uint8_t level;    /* of its texture; u and v are in texels of that level */
    uint8_t colour;   /* of the face */
} fxl_surface_polygon;

/* Appends a polygon that reaches the given rows of the screen to the display list. Returns false if
 * it does not fit: list untouched. */
bool fxl_surface_polygon_append(fxl_display_list *list, const fxl_screen_polygon *screen,
                                fxl_rows rows, const fxl_surface_polygon *polygon);

/* Reads a record of the kind FXL_POLYGON_SURFACE. Returns how many of its points are the
 * outline's. */
uint32_t fxl_surface_polygon_read(const fxl_display_list_record *record,
                                  fxl_surface_polygon *polygon);

/* Paints the pixels of a polygon in a band. */
void fxl_surface_polygon_paint(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                               const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                               fxl_scan *scan);

/* The surfaces of a renderer that has some. */
const fxl_surfaces *fxl_surfaces_of(const fxl_renderer *renderer);

/* Whether the renderer's visibility method draws polygons with surfaces. */
bool fxl_draws_surfaces(const fxl_renderer *renderer);

#ifdef __cplusplus
}
#endif

#endif
