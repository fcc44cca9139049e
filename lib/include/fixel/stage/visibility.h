/* SPDX-License-Identifier: MIT */
/* The interface of the visibility methods. Each is one constant record in a file of its own, so a
 * program links only the methods that it names. A method has two parts: a submit function,
 * which gives the faces in an order, and a raster backend, which decides about a pixel that was
 * drawn already. Any submit function goes with any raster backend of the same order. */
#ifndef FXL_VISIBILITY_H
#define FXL_VISIBILITY_H

#include "fixel/scene.h"
#include "fixel/stage/scan.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fxl_renderer fxl_renderer;
struct fxl_workspace;                       /* fixel/render.h */
typedef struct fxl_traversal fxl_traversal; /* lib/draw/submit.h, which is internal */

/* A raster backend: it draws the polygons of a band. */
typedef struct {
    /* The least size of its workspace, in bytes. Null: it needs none. */
    uint32_t (*workspace_size)(const fxl_lens *lens);
    /* Draws a band, in parts if the workspace is too small for the whole. Returns FXL_OK, or a
     * status that it has counted in refused_calls, with the band untouched. Null: the renderer
     * draws the band at once. */
    fxl_status (*draw_band)(const fxl_renderer *renderer, struct fxl_workspace *workspace,
                            const fxl_band *band);
    /* Begins a band of which nothing was drawn. Null: there is nothing to begin. */
    void (*begin_band)(const fxl_renderer *renderer, struct fxl_workspace *workspace,
                       const fxl_band *band);
    /* Draws an outline that reaches rows of the screen; the band may hold none of them. Returns
     * false if the workspace is full: then some of the outline may have been drawn. */
    bool (*draw_polygon)(struct fxl_workspace *workspace, const fxl_screen_point *points,
                         uint32_t count, uint8_t colour, const fxl_band *band);
    /* Whether draw_polygon only scans and fills, over what is there: then a face may go from the
     * clipper straight to scan. */
    bool draws_over;
    /* Whether polygons keep their surfaces. Then the record is the first member of a longer one,
     * which is internal. */
    bool draws_surfaces;
} fxl_raster_backend;

/* A visibility method. */
typedef struct {
    bool front_to_back; /* if false, a later polygon covers an earlier one */
    /* Submits every face from the traversal's resume point on, in the order of drawing, or, if
     * front_to_back, in its exact reverse. Returns false if it was stopped: the resume point is
     * then the face for which there was no space. */
    bool (*submit)(const fxl_traversal *on);
    /* Size of the workspace of submit, in bytes. Null: it needs none. */
    uint32_t (*submit_workspace_size)(const fxl_scene *scene);
    const fxl_raster_backend *backend;
} fxl_visibility;

/* The painter's algorithm: a later polygon covers an earlier one. For back to front. */
extern const fxl_raster_backend fxl_raster_over;

/* The default: instances by layer and distance, the faces of a sorted model by distance, far to
 * near; a later polygon covers an earlier one. */
extern const fxl_visibility fxl_visibility_sorted;

#ifdef __cplusplus
}
#endif

#endif
