/* SPDX-License-Identifier: MIT */
/* The interface of the clippers: from a face of an instance to a polygon of the
 * screen, because some clippers project before they have cut every side. A renderer
 * has its clipper as a field. The linker drops a clipper that the program does not
 * name. */
#ifndef FXL_CLIPPER_H
#define FXL_CLIPPER_H

#include "fixel/stage/clip_view.h"
#include "fixel/stage/model_view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The workspace of fxl_clip_world_to_frustum (study/clip_world.h). The caller
 * owns it. It keeps nothing from one call to the next. */
typedef struct {
    fxl_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_world_work;

/* A scratch area for any clipper: 16 bytes, and 56 bytes a vertex of the capacity. */
typedef union {
    fxl_clip_view_work by_view;
    fxl_clip_world_work by_world;
} fxl_clipper_work;

/* A clipper. Its functions require a model view of an instance of a checked scene, or of a
 * polygon. model_view->planes may omit a plane that all vertices are inside of.
 * work keeps nothing from one call to the next. A clipper keeps what must last in
 * model_view->clipper_workspace, which is zeroed when the clipper is set.
 * model_view->view->frame differs from one frame to the next, and is never 0. */
typedef struct {
    /* Clips a face of the instance and projects it. *screen is the result for
     * FXL_CLIP_INSIDE, FXL_CLIP_CUT and FXL_CLIP_BETWEEN; otherwise its points have no meaning. */
    fxl_clip_result (*clip)(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen);
    /* Null if a face gives at most one polygon. Otherwise the renderer calls it after clip
     * returned FXL_CLIP_INSIDE or FXL_CLIP_CUT, and again while it returns one of these two: then
     * *screen is the face's next polygon. Any other result means that the face has no more
     * polygons. After FXL_CLIP_CAPACITY or FXL_CLIP_RANGE the face is counted as refused, even if
     * some of it is drawn. */
    fxl_clip_result (*next)(const fxl_model_view *model_view, fxl_clipper_work *work,
                            fxl_screen_polygon *screen);
    uint32_t workspace_size; /* bytes of the caller's memory that it needs, aligned to 8 */
    /* Sets up what the clipper needs of a frame, once the view has its pose. Null: nothing. */
    void (*begin)(fxl_view *view);
    /* clip answers FXL_CLIP_OUTSIDE for each face whose vertices, as fxl_fetch_vertex gives them,
     * all have the clip flag of one plane. Then the renderer may leave such faces out. */
    bool by_clip_flags;
    /* clip works from the points of the world, and not from vertices that fxl_fetch_vertex gives.
     * Then the points of turned instances are rounded in the world (SPEC.md, section 8.5). */
    bool by_points;
} fxl_clipper;

/* fxl_clip_by_view: the default. It needs no workspace. If the caller gives it an fxl_clip_stats,
 * and its size, as its workspace, it counts in it. */
extern const fxl_clipper fxl_clipper_view;

/* The function clip of fxl_clipper_view. It transforms the face's vertices, then clips in the view
 * on exact sums, then projects.
 * Error: the outline on the screen is within 1.25/65536 pixel of the exact one, with the exceptions
 * of docs/accuracy.md, section 3. Source: A12. */
fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);

#ifdef __cplusplus
}
#endif

#endif
