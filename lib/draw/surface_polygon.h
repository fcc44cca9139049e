/* SPDX-License-Identifier: MIT */
/* A polygon of the screen that has a surface, or a depth: its record in the display list, and its
 * pixels. Internal. */
#ifndef FXL_SURFACE_POLYGON_H
#define FXL_SURFACE_POLYGON_H

#include "submit.h"
#include "fixel/surfaces.h"
#include "../paint/depth_code.h"
#include "../paint/paint.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_NO_SURFACE UINT16_MAX
FXL_STATIC_ASSERT(FXL_SURFACES_MAX <= FXL_NO_SURFACE, "no surface has this number");

/* What a polygon has beside its outline. */
typedef struct {
    fxl_gradients gradients; /* where it has a surface */
    fxl_depth_plane depth;   /* where it has one */
    uint16_t surface;        /* a number; FXL_NO_SURFACE: the face's own colour */
    uint8_t level;           /* of its texture; u and v are in texels of that level */
    uint8_t colour;          /* of the face */
    bool has_depth;
} fxl_surface_polygon;

/* A raster backend that draws surfaces. */
typedef struct {
    fxl_raster_backend backend; /* draws_surfaces */
    /* Finds the depth of a face. Null: the method keeps none. */
    void (*find_depth)(const fxl_model_view *model_view, const fxl_face *face,
                       const fxl_traversal *on, fxl_depth_plane *plane);
    /* Paints the pixels of a polygon in a band. */
    void (*paint)(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                  uint32_t count, const fxl_band *band);
    /* With find_depth: the same method far to near. */
    const fxl_visibility *far_to_near;
    uint8_t depth_bits; /* with find_depth: 16 or 32 a pixel */
    bool draws_565;     /* bands have 16 bits a pixel */
} fxl_surface_backend;

static inline const fxl_surface_backend *fxl_surface_backend_of(const fxl_renderer *renderer)
{
    return (const fxl_surface_backend *)(const void *)renderer->visibility->backend;
}

/* Finds what a face's polygons have beside their outlines; what: the finder's own. */
typedef void fxl_surface_finder(const void *what, const fxl_model_view *model_view,
                                const fxl_face *face, const fxl_traversal *on,
                                fxl_surface_polygon *polygon);

/* All polygons of a face, to the display list or into the band: fxl_submit_polygons with surfaces.
 * Once one of them is left, it is found what they have. Requires a backend that draws surfaces. */
fxl_outcome fxl_submit_surface_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                        const fxl_traversal *on, fxl_surface_finder *find,
                                        const void *what);

/* Draws the polygons of the display list that reach the band, by the backend, which draws
 * surfaces. Returns true. */
bool fxl_surface_draw_list(const fxl_traversal *on);

/* A corner of a face in the view, by the matrix of its instance. A clipper by clip flags keeps the
 * same positions in the cache. */
void fxl_find_corner(const fxl_model_view *model_view, uint32_t number, const fxl_traversal *on,
                     fxl_view_point *corner);

/* Appends a polygon that reaches the given rows of the screen to the display list. Returns false if
 * it does not fit: list untouched. */
bool fxl_surface_polygon_append(fxl_display_list *list, const fxl_screen_polygon *screen,
                                fxl_rows rows, const fxl_surface_polygon *polygon);

/* Reads a record of the kind FXL_POLYGON_SURFACE. Returns how many of its points are the
 * outline's. */
uint32_t fxl_surface_polygon_read(const fxl_display_list_record *record,
                                  fxl_surface_polygon *polygon);

/* How a polygon that has a surface is painted. */
void fxl_surface_paint_of(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                          fxl_paint *paint);

/* What paints surfaces. A method that draws faces without them too finds it at the surfaces, so
 * that a program without surfaces does not link it. */
typedef struct fxl_surface_painter {
    void (*paint_of)(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                     fxl_paint *paint);
    void (*polygon)(const fxl_paint *paint, const fxl_screen_point *points, uint32_t count,
                    const fxl_band *band, fxl_scan *scan, fxl_row_painter *paint_row, void *with);
    void (*pixels)(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1);
} fxl_surface_painter;

/* fxl_surfaces_check, or fxl_surfaces_check_rgb565. */
typedef fxl_status fxl_surfaces_checker(const fxl_surface_set *set, const fxl_scene *scene,
                                        fxl_scene_fault *fault);

/* fxl_renderer_set_surfaces without its visibility method. painter: null if the surfaces are for
 * frames of 16 bits a pixel alone. */
fxl_status fxl_surfaces_attach(fxl_renderer *renderer, fxl_surfaces *surfaces,
                               const fxl_surface_set *set, fxl_surfaces_checker *check,
                               const fxl_surface_painter *painter);

/* The surfaces of a renderer that has some; or null. */
const fxl_surfaces *fxl_surfaces_of(const fxl_renderer *renderer);

#ifdef __cplusplus
}
#endif

#endif
