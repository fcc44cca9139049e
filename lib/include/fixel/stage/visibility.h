/* SPDX-License-Identifier: MIT */
/* What hides what. A visibility method is a constant record in a file of its own, so a program
 * links only the methods that it names. A method decides two things: the order in which faces
 * are submitted, and, by its raster backend, what becomes of a pixel that is drawn already. Any
 * order goes with any backend made for it. */
#ifndef FXL_VISIBILITY_H
#define FXL_VISIBILITY_H

#include "fixel/scene.h"
#include "fixel/stage/scan.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fxl_renderer fxl_renderer;
struct fxl_workspace;                       /* fixel/render.h */
typedef struct fxl_traversal fxl_traversal; /* lib/src/draw/submit.h, which is internal */

/* How a polygon's pixels get into a band. */
typedef struct {
    /* The least bytes of the caller's memory that it works in. Null: none. */
    uint32_t (*workspace_size)(const fxl_lens *lens);
    /* Draws a band, and deals with a workspace that is full. Null: the band is drawn once. */
    void (*draw_band)(const fxl_renderer *renderer, struct fxl_workspace *workspace,
                      const fxl_band *band);
    /* A band begins, of which nothing is drawn. Null where nothing need be done. */
    void (*begin_band)(const fxl_renderer *renderer, struct fxl_workspace *workspace,
                       const fxl_band *band);
    /* Draws an outline that reaches rows of the screen, which the band need not hold.
     * False where the workspace is full: then some of it may have been drawn. */
    bool (*draw_polygon)(struct fxl_workspace *workspace, const fxl_screen_point *points,
                         uint32_t count, uint8_t colour, const fxl_band *band);
    /* Each polygon is scanned and filled over what is there, and nothing else: a face may then
     * go from the clipper straight to scan. */
    bool draws_over;
} fxl_raster_backend;

typedef struct {
    bool front_to_back; /* else what comes later covers what came before */
    /* Submits every face from the traversal's resume point on, in the order of drawing or, front
     * to back, in the exact reverse. False where the traversal was stopped: the resume point is
     * then the face that found no room. */
    bool (*submit)(const fxl_traversal *on);
    /* Bytes of the caller's memory that submitting wants. Null: none. */
    uint32_t (*submit_workspace_size)(const fxl_scene *scene);
    const fxl_raster_backend *backend;
} fxl_visibility;

/* One over another: for back to front. */
extern const fxl_raster_backend fxl_raster_over;

/* Objects by layer and distance, the faces of a sorted model by distance, far to
 * near, one over another: what a renderer uses unless told otherwise. */
extern const fxl_visibility fxl_visibility_sorted;

/* The same, but every pixel of a polygon's bounding box is tested (scan_box.h): the same
 * pixels, without edges. */
extern const fxl_raster_backend fxl_raster_box;
extern const fxl_visibility fxl_visibility_box;

/* Front to back into a span buffer (span_buffer.h): each pixel is drawn once, by the first
 * that covers it, so the picture is that of the order turned round. Room:
 * FXL_SPAN_BUFFER_BYTES_LEAST of the screen at least. A band whose intervals are more than
 * the pool holds is drawn again in halves and so on, each time counted in split_bands: the
 * picture never depends on the pool. The least pool is enough for any one row. */
extern const fxl_raster_backend fxl_raster_spans;
extern const fxl_visibility fxl_visibility_spans;

/* The same by the pixels of each polygon's bounding box (scan_box.h). */
extern const fxl_raster_backend fxl_raster_spans_box;
extern const fxl_visibility fxl_visibility_spans_box;

#ifdef __cplusplus
}
#endif

#endif
