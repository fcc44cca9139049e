/* SPDX-License-Identifier: MIT */
/* What hides what: one constant record a method, in a file of its own, so that
 * one which is not named is not linked. A method is two matters: the order in
 * which faces come (a walk), and what becomes of one where something was drawn
 * already (a painter). Any walk goes with any painter of its order. */
#ifndef FXL_VISIBILITY_H
#define FXL_VISIBILITY_H

#include "fixel/stage/scan.h"
#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fxl_renderer fxl_renderer;
typedef struct fxl_traversal fxl_traversal; /* walk.h, which is internal */

/* How a polygon's pixels get into a band. A depth buffer would be one more; it
 * wants each vertex's depth in fxl_screen_polygon and in the list. */
typedef struct {
    /* The least bytes of the caller's memory that it works in. Null: none. */
    uint32_t (*workspace_size)(const fxl_lens *lens);
    /* Draws a band, and sees to what the room does not hold. Null: at one go. */
    void (*draw_band)(fxl_renderer *renderer, const fxl_band *band);
    /* Nothing of a band was painted. Null where nothing need be done. */
    void (*begin_band)(fxl_renderer *renderer, const fxl_band *band);
    /* An outline that reaches rows of the screen, which the band need not hold.
     * False where the room is full: then some of it may have been painted. */
    bool (*draw_polygon)(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                         uint8_t colour, const fxl_band *band);
} fxl_raster_backend;

typedef struct {
    bool front_to_back; /* else what comes later covers what came before */
    /* Gives every face from the walk's place on, in the order of drawing or, front
     * to back, in the opposite one exactly. False where it was stopped: the place
     * is then that of the face that found no room. */
    bool (*submit)(const fxl_traversal *on);
    /* Bytes of the caller's memory that the walk wants. Null: none. */
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
