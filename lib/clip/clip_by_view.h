/* SPDX-License-Identifier: MIT */
/* The default clipper, and the parts that its kernel and the rest of it share. Internal. */
#ifndef FXL_CLIP_BY_VIEW_H
#define FXL_CLIP_BY_VIEW_H

#include "../math/arith.h"
#include "../math/family.h"
#include "../math/pixel_centre.h"
#include "../scene/lens.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "clip_view.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The function clip of fxl_clipper_view. It transforms the face's vertices, then clips in the view
 * on exact sums, then projects.
 * Error: the outline on the screen is within 1.25/65536 pixel of the exact one, with the exceptions
 * of docs/accuracy.md, section 3. Source: A12. */
fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);

/* Assembles a face, cuts it by the planes that a vertex is outside of, and projects it. It serves
 * the faces with a vertex that is outside a plane, but not all with the same one. */
fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The first pixel centre of a vertex, in clip_flags, for a vertex that is inside all planes and
 * projected: the first column whose centre is not left of the vertex, and the first row whose
 * centre is not above it. If all vertices of a polygon have the same row, or the same column, the
 * polygon covers no centre. Inside all planes both are 0..FXL_SCREEN_MAX: 12 bits each. */
#define FXL_VERTEX_COLUMN 0x000FFF00u
#define FXL_VERTEX_ROW    0xFFF00000u

/* place fill-rule: the first centres of a vertex */
static inline uint32_t fxl_vertex_place_flags(const fxl_screen_point *screen)
{
    uint32_t column = (uint32_t)fxl_first_centre_from(screen->x);
    uint32_t row = (uint32_t)fxl_first_centre_from(screen->y);
    FXL_ASSERT(column <= FXL_SCREEN_MAX && row <= FXL_SCREEN_MAX);
    return row << 20 | column << 8;
}

/* fxl_fetch_vertex, by fxl_transform_and_project where there is one: its clip flags may be its place. */
static inline __attribute__((always_inline)) fxl_cached_vertex *
fxl_fetch_placed(const fxl_model_view *model_view, uint32_t number)
{
#if FXL_TRANSFORMS_AND_PROJECTS
    const uint32_t tag = model_view->tag + number;
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    if (entry->tag != tag &&
        fxl_transform_and_project(model_view, number, entry, tag) == FXL_OK) {
        entry->clip_flags = fxl_vertex_place_flags(&entry->screen);
    }
    return entry;
#else
    return fxl_fetch_vertex(model_view, number);
#endif
}

FXL_STATIC_ASSERT((FXL_PLANES_ALL & FXL_VERTEX_UNPROJECTED) == 0 &&
                      (FXL_PLANES_ALL | FXL_VERTEX_UNPROJECTED) <= FXL_VERTEX_OUTSIDE,
                  "planes and the flag share a byte");

/* fxl_clip_assembled, or another. */
typedef fxl_clip_result fxl_face_clipper(const fxl_model_view *model_view, const fxl_face *face,
                                         fxl_clipper_work *work, fxl_screen_polygon *screen);

/* fxl_clip_by_view by a projector. Usually all vertices are inside. Then their places on the screen are the result. */
/* SPEC 4.7 */
static inline __attribute__((always_inline)) fxl_clip_result
fxl_clip_by(const fxl_model_view *model_view, const fxl_face *face, fxl_clipper_work *work,
            fxl_screen_polygon *screen, fxl_projector *project, fxl_face_clipper *assembled)
{
    const uint16_t *index = fxl_face_indices(model_view->indices, face);
    fxl_screen_point *point = screen->points;
    uint32_t of_any = 0, of_all = UINT32_MAX;
    for (const uint16_t *end = index + face->count; index < end; index++, point++) {
        fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, *index);
        uint32_t state = vertex->clip_flags;
        if ((state & FXL_VERTEX_OUTSIDE) != 0) {
            if (state != FXL_VERTEX_UNPROJECTED) {
                /* If no vertex was inside before. */
                return of_all == UINT32_MAX && fxl_face_is_outside(model_view, face)
                           ? FXL_CLIP_OUTSIDE
                           : assembled(model_view, face, work, screen);
            }
            if (project(model_view->view, &vertex->position, &vertex->screen) != FXL_OK) {
                return FXL_CLIP_RANGE;
            }
            state = fxl_vertex_place_flags(&vertex->screen);
            vertex->clip_flags = state;
        }
        of_any |= state;
        of_all &= state;
        *point = vertex->screen;
    }
    screen->colour = face->material;
    screen->count = face->count;
    /* SPEC 7.2 */
    uint32_t differing = of_any ^ of_all;
    return (differing & FXL_VERTEX_COLUMN) == 0 || (differing & FXL_VERTEX_ROW) == 0
               ? FXL_CLIP_BETWEEN
               : FXL_CLIP_INSIDE;
}

/* Gives the place of a face's corner in the view, and its clip flags. */
typedef uint32_t fxl_corner_taker(const fxl_model_view *model_view, uint32_t number,
                                  const fxl_cached_vertex *vertex, fxl_view_point *place);

/* fxl_clip_assembled by what gives corners, and by a projector. */
static inline __attribute__((always_inline)) fxl_clip_result
fxl_clip_assembled_by(const fxl_model_view *model_view, const fxl_face *face,
                      fxl_clipper_work *workspace, fxl_screen_polygon *screen,
                      fxl_corner_taker *take, fxl_projector *project)
{
    fxl_clip_view_work *work = &workspace->by_view;
    const uint16_t *indices = fxl_face_indices(model_view->indices, face);
    const fxl_view *view = model_view->view;
    fxl_view_polygon *assembled = &work->polygons[0];
    const fxl_view_polygon *clipped;
    unsigned of_any = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = fxl_fetch_vertex(model_view, indices[i]);
        of_any |= take(model_view, indices[i], vertex, &assembled->vertices[i].position);
    }
    assembled->colour = face->material;
    assembled->count = face->count;
    fxl_clip_result result = fxl_clip_view_by_planes(
        assembled, &view->view_frustum, (fxl_planes)(of_any & FXL_PLANES_ALL), work,
        (fxl_clip_stats *)model_view->clipper_workspace, &clipped);
    if (clipped == NULL) {
        return result;
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (project(view, &clipped->vertices[i].position, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return result;
}

#ifdef __cplusplus
}
#endif

#endif
