/* SPDX-License-Identifier: MIT */
/* Draws a face as a fan of triangles about its first vertex, and clips each triangle by itself.
 * An edge between two vertices is cut from its inside end, whichever triangle it belongs to, so
 * neighbours of the fan share every vertex. */
#include "../clip/volume.h"
#include "../math/arith.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "clip_common.h"

static fxl_fan_workspace *workspace_of(const fxl_model_view *model_view)
{
    return (fxl_fan_workspace *)model_view->clipper_workspace;
}

/* Fetches a vertex as the default clipper does. A vertex that is inside comes with its position
 * on the screen. */
static const fxl_cached_vertex *fetch_corner(const fxl_model_view *model_view, const fxl_face *face,
                                             uint32_t corner)
{
    fxl_cached_vertex *vertex =
        fxl_fetch_vertex(model_view, fxl_face_indices(model_view->indices, face)[corner]);
    if (vertex->clip_flags == FXL_VERTEX_UNPROJECTED &&
        fxl_project_visible(&model_view->view->projection, &vertex->position, &vertex->screen) ==
            FXL_OK) {
        vertex->clip_flags = 0;
    }
    return vertex;
}

/* Tells whether a vertex needs no test against the borders. A vertex inside the frustum may
 * still be rounded off the screen. */
static bool is_on_screen(const fxl_lens *lens, const fxl_cached_vertex *vertex)
{
    return vertex->clip_flags == 0 && (uint32_t)vertex->screen.x <= lens->width * 65536u &&
           (uint32_t)vertex->screen.y <= lens->height * 65536u;
}

/* Differences are below 2^27, so each product is below 2^54. */
/* clippers 4.4 */
static bool has_area(const fxl_screen_point *a, const fxl_screen_point *b,
                     const fxl_screen_point *c)
{
    return (int64_t)(b->x - a->x) * (c->y - a->y) != (int64_t)(c->x - a->x) * (b->y - a->y);
}

/* Writes the next part of the current triangle to screen. Returns false where there is none. The
 * guard band keeps all parts in range. */
static bool next_piece(const fxl_model_view *model_view, fxl_fan_workspace *workspace,
                       fxl_screen_polygon *screen)
{
    fxl_status status;
    const fxl_lens lens = fxl_view_drawn_lens(model_view->view);
    const fxl_screen_triangle *piece =
        fxl_triangle_next(&workspace->volume, &lens, &workspace->clip, &status);
    FXL_ASSERT(status == FXL_OK);
    if (piece == NULL) {
        return false;
    }
    screen->count = 3;
    for (int i = 0; i < 3; i++) {
        screen->points[i] = piece->corners[i].at;
    }
    return true;
}

/* Begins the next triangle of the fan. A triangle that lies wholly on the screen is written to
 * screen at once; then the result is true. */
/* clippers 4.4 */
static bool begin_triangle(const fxl_model_view *model_view, fxl_fan_workspace *workspace,
                           fxl_screen_polygon *screen)
{
    const fxl_lens *lens = &model_view->view->lens;
    const fxl_cached_vertex *corners[] = {
        &workspace->first, &workspace->before,
        fetch_corner(model_view, workspace->face, workspace->corner++)};
    const fxl_cached_vertex last = *corners[2];
    corners[2] = &last;
    unsigned all = FXL_PLANES_DEPTH; /* the face was tested against the sides: they are inset */
    bool whole = true;
    for (int i = 0; i < 3; i++) {
        all &= corners[i]->clip_flags;
        whole = whole && is_on_screen(lens, corners[i]);
    }
    if (whole) {
        screen->count = 3;
        for (int i = 0; i < 3; i++) {
            screen->points[i] = corners[i]->screen;
        }
    } else if (all == 0) {
        fxl_clip_triangle *triangle = &workspace->clip.solids[0];
        for (int i = 0; i < 3; i++) {
            triangle->corners[i].position = corners[i]->position;
        }
        fxl_triangle_begin(triangle, 0, &workspace->volume, &workspace->clip);
    }
    workspace->before = last;
    return whole && has_area(&screen->points[0], &screen->points[1], &screen->points[2]);
}

/* Writes the next polygon of the face to screen. Returns false where there is none. */
static bool next_of_fan(const fxl_model_view *model_view, fxl_screen_polygon *screen)
{
    fxl_fan_workspace *workspace = workspace_of(model_view);
    screen->colour = workspace->face->material;
    for (;;) {
        if (next_piece(model_view, workspace, screen)) {
            return true;
        }
        if (workspace->corner == workspace->face->count) {
            return false;
        }
        if (begin_triangle(model_view, workspace, screen)) {
            return true;
        }
    }
}

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const fxl_view *view = model_view->view;
    fxl_fan_workspace *workspace = workspace_of(model_view);
    unsigned any = 0, all = FXL_PLANES_ALL;
    (void)work;
    if (workspace->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, fxl_view_drawn_focal(view), FXL_PLANES_DEPTH,
                              &workspace->volume);
        workspace->frame = view->frame;
    }
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_cached_vertex *vertex = fetch_corner(model_view, face, i);
        any |= vertex->clip_flags;
        all &= vertex->clip_flags;
    }
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    workspace->face = face;
    workspace->first = *fetch_corner(model_view, face, 0);
    workspace->before = *fetch_corner(model_view, face, 1);
    workspace->corner = 2;
    workspace->clip.flat_count = workspace->clip.solid_count = 0;
    bool is_cut = (any & FXL_PLANES_ALL) != 0;
    if (!next_of_fan(model_view, screen)) {
        return is_cut ? FXL_CLIP_OUTSIDE : FXL_CLIP_DEGENERATE;
    }
    return is_cut ? FXL_CLIP_CUT : FXL_CLIP_INSIDE;
}

static fxl_clip_result next(const fxl_model_view *model_view, fxl_clipper_work *work,
                            fxl_screen_polygon *screen)
{
    (void)work;
    return next_of_fan(model_view, screen) ? FXL_CLIP_INSIDE : FXL_CLIP_OUTSIDE;
}

const fxl_clipper fxl_clipper_triangles = {
    .clip = clip, .next = next, .workspace_size = sizeof(fxl_fan_workspace)};
