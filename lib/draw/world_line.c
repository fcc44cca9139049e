/* SPDX-License-Identifier: MIT */
/* A line in the view, of the vertices of a model or of the world, and one of the world over a band that
 * was drawn. */
#include "line_view.h"

#include "../clip/clip_by_view.h"
#include "../clip/volume.h"
#include "../math/arith.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "renderer.h"
#include "surface_polygon.h"

/* --- a line in the view --------------------------------------------------------------------- */

/* Where an end is on the screen, and its distance. False where it is out of the range of screen
 * coordinates. */
/* lines 2.1, orthographic 2.12 */
static bool place_end(const fxl_view *view, const fxl_view_point *point, fxl_painted_line *painted,
                      uint32_t number)
{
    const fxl_orthographic_code *flat = fxl_orthographic_of(&view->lens);
    painted->distances[number] = flat != NULL ? flat->distance_of(view, point->z) : point->z;
    return (flat != NULL
                ? flat->project(view, point, &painted->ends[number])
                : fxl_project_visible(&view->projection, point, &painted->ends[number])) == FXL_OK;
}

/* Any line, by a volume. */
static FXL_COLD fxl_line_outcome place_by_volume(const fxl_view *view, fxl_clip_line *line,
                                                 fxl_painted_line *painted)
{
    uint32_t intersections = 0;
    fxl_volume volume;
    line->carried = 0;
    fxl_volume_from_sides(&view->view_frustum, fxl_view_drawn_focal(view), FXL_PLANES_ALL, &volume);
    if (!fxl_line_by_codes(line, &volume, &intersections)) {
        return FXL_LINE_OUTSIDE;
    }
    if (!place_end(view, &line->from.position, painted, 0) ||
        !place_end(view, &line->to.position, painted, 1)) {
        return FXL_LINE_REFUSED;
    }
    return intersections > 0 ? FXL_LINE_CLIPPED : FXL_LINE_DRAWN;
}

/* Most lines lie inside all planes, or outside one: their outcodes decide it as the volume would. */
/* lines 2.1 */
fxl_line_outcome fxl_place_line(const fxl_view *view, fxl_clip_line *line,
                                fxl_painted_line *painted)
{
    if (fxl_orthographic_of(&view->lens) != NULL) {
        return place_by_volume(view, line, painted);
    }
    const fxl_view_frustum *frustum = &view->view_frustum;
    const fxl_planes from = fxl_outcode(frustum, FXL_PLANES_ALL, &line->from.position);
    const fxl_planes to = fxl_outcode(frustum, FXL_PLANES_ALL, &line->to.position);
    if ((from & to) != 0) {
        return FXL_LINE_OUTSIDE;
    }
    if ((from | to) != 0) {
        return place_by_volume(view, line, painted);
    }
    return place_end(view, &line->from.position, painted, 0) &&
                   place_end(view, &line->to.position, painted, 1)
               ? FXL_LINE_DRAWN
               : FXL_LINE_REFUSED;
}

/* Whose ends planes may cut, or an orthographic lens projects. */
FXL_COLD fxl_line_outcome fxl_place_any_line(const fxl_line_instance *of, const fxl_line *line,
                                             fxl_painted_line *painted)
{
    fxl_clip_line clipped;
    fxl_find_corner(of->model_view, line->from, of->traversal, &clipped.from.position);
    fxl_find_corner(of->model_view, line->to, of->traversal, &clipped.to.position);
    return fxl_place_line(&of->traversal->renderer->frame.view, &clipped, painted);
}

/* A vertex of the cache that is not projected: one inside all planes is, from its position. Returns its
 * clip flags. */
static FXL_COLD uint32_t project(const fxl_model_view *model_view, fxl_cached_vertex *vertex)
{
    if (vertex->clip_flags == FXL_VERTEX_UNPROJECTED &&
        fxl_project_inside(&model_view->view->projection, &vertex->position, &vertex->screen) ==
            FXL_OK) {
        vertex->clip_flags = 0;
    }
    return vertex->clip_flags;
}

/* A vertex that the cache does not have. Returns its clip flags. */
static inline uint32_t transform(const fxl_model_view *model_view, uint32_t number,
                                 fxl_cached_vertex *vertex)
{
#if FXL_TRANSFORMS_AND_PROJECTS
    const int32_t status =
        fxl_transform_and_project(model_view, number, vertex, model_view->tag + number);
    if (status == FXL_OK) {
        vertex->clip_flags = 0;
        return 0;
    }
    if (status != -1) {
        vertex->clip_flags = FXL_VERTEX_UNPROJECTED;
    }
    return vertex->clip_flags;
#else
    fxl_transform_vertex(model_view, number, vertex);
    return project(model_view, vertex);
#endif
}

/* An end that is kept in the cache of vertices. Returns the planes that it is outside of; without
 * any its place is found, or FXL_VERTEX_UNPROJECTED returned. No face is drawn from these vertices, so
 * their clip flags have no place. */
static inline uint32_t place_vertex(const fxl_model_view *model_view, fxl_cached_vertex *vertex,
                                    uint32_t tag, uint32_t number, fxl_painted_line *painted,
                                    uint32_t end)
{
    uint32_t flags;
    if (vertex->tag != tag) {
        flags = transform(model_view, number, vertex);
    } else {
        flags = vertex->clip_flags;
        if (flags != 0) {
            flags = project(model_view, vertex);
        }
    }
    painted->ends[end] = vertex->screen;
    painted->distances[end] = vertex->position.z;
    return flags;
}

/* Most lines lie inside all planes. Then the places of their vertices are those of their ends, the
 * same that fxl_place_line finds. */
/* lines 2.1 */
fxl_line_outcome fxl_place_model_line(const fxl_line_instance *of, const fxl_line *line,
                                      fxl_painted_line *painted)
{
    const fxl_model_view *view = of->model_view;
    fxl_cached_vertex *const entries = view->entries;
    const uint32_t mask = view->mask, tag = view->tag, a = line->from, b = line->to;
    const uint32_t from = place_vertex(view, &entries[a & mask], tag + a, a, painted, 0);
    const uint32_t to = place_vertex(view, &entries[b & mask], tag + b, b, painted, 1);
    return (from | to) == 0                    ? FXL_LINE_DRAWN
           : (from & to & FXL_PLANES_ALL) != 0 ? FXL_LINE_OUTSIDE
                                               : fxl_place_any_line(of, line, painted);
}

void fxl_find_line_canvas(const fxl_renderer *renderer, const fxl_workspace *workspace,
                          const fxl_band *band, fxl_line_canvas *canvas)
{
    const uint8_t bits = renderer->target->depth_bits;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    fxl_line_canvas_begin(canvas, band, bits != 0 ? head : NULL, renderer->frame.view.lens.near_z,
                          bits == 32);
}

/* --- over the faces of a band --------------------------------------------------------------- */

/* lines 2.6 */
void fxl_draw_over_instances(const fxl_renderer *renderer, fxl_workspace *workspace,
                             const fxl_band *band, fxl_instance_overdraw *draw, void *with)
{
    const fxl_frame *frame = &renderer->frame;
    fxl_resume_point resume = {0, 0};
    fxl_traversal traversal = fxl_traversal_of(renderer, workspace, &resume);
    traversal.band = band;
    fxl_depth_clear_rest(workspace, band, renderer->target);
    for (uint32_t i = 0; i < frame->visible_count; i++) {
        const uint32_t place = renderer->near_first ? frame->visible_count - 1u - i : i;
        draw(&traversal, frame->draw_list[place].index, with);
    }
}

/* --- a line of the world -------------------------------------------------------------------- */

/* Whether a depth buffer, if there is one, has rows for a whole band. */
static bool holds_band(const fxl_renderer *renderer, const fxl_workspace *workspace,
                       const fxl_band *band)
{
    const uint32_t row = band->width * (renderer->target->depth_bits / 8u);
    return row == 0 ||
           (workspace->target_memory_size - (uint32_t)sizeof(fxl_depth_head)) / row >= band->rows;
}

/* lines 5.2 */
static fxl_status check_world_line(const fxl_renderer *renderer, const fxl_workspace *workspace,
                                   const fxl_world_line *line, const fxl_band *band)
{
    const fxl_lens *lens = &renderer->frame.view.lens;
    if (line == NULL || band == NULL || band->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->frame.state == FXL_FRAME_NONE || !fxl_has_pixels_of(renderer, band)) {
        return FXL_E_ORDER;
    }
    if (band->width != lens->width || !fxl_band_is_within(band, lens->width, lens->height) ||
        !fxl_point_in_range(&line->from) || !fxl_point_in_range(&line->to) || line->width < 1 ||
        line->width > FXL_LINE_WIDTH_MAX) {
        return FXL_E_RANGE;
    }
    if (!fxl_band_is_aligned(band)) {
        return FXL_E_ALIGNMENT;
    }
    return holds_band(renderer, workspace, band) ? FXL_OK : FXL_E_CAPACITY;
}

/* lines 5.1 */
fxl_status fxl_frame_draw_line(fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_world_line *line, const fxl_band *band)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    workspace = workspace != NULL ? workspace : &renderer->workspace;
    const fxl_status status = check_world_line(renderer, workspace, line, band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    const fxl_view *view = &renderer->frame.view;
    fxl_band from_0 = *band;
    fxl_painted_line painted;
    fxl_clip_line clipped;
    fxl_band_begin_at_column_0(&from_0);
    fxl_transform_point(&view->camera, &line->from, &clipped.from.position);
    fxl_transform_point(&view->camera, &line->to, &clipped.to.position);
    painted.colour = line->colour;
    painted.width = line->width;
    painted.is_point =
        line->from.x == line->to.x && line->from.y == line->to.y && line->from.z == line->to.z;
    painted.plane_count = 0;
    if (fxl_place_line(view, &clipped, &painted) >= FXL_LINE_DRAWN &&
        fxl_line_meets_rows(&painted, band->first_row, band->rows)) {
        fxl_line_canvas canvas;
        fxl_find_line_canvas(renderer, workspace, &from_0, &canvas);
        if (canvas.head != NULL) {
            fxl_depth_clear_rest(workspace, &from_0, renderer->target);
        }
        fxl_paint_wide_line(&canvas, &painted);
    }
    return FXL_OK;
}
