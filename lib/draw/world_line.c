/* SPDX-License-Identifier: MIT */
/* A line in the view, and one of the world over a band that was drawn. */
#include "line_view.h"

#include "../clip/volume.h"
#include "../math/arith.h"
#include "../view/model_view.h"
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

/* lines 2.1 */
fxl_line_outcome fxl_place_line(const fxl_view *view, const fxl_volume *volume, fxl_clip_line *line,
                                fxl_painted_line *painted)
{
    uint32_t intersections = 0;
    line->carried = 0;
    if (!fxl_line_by_codes(line, volume, &intersections)) {
        return FXL_LINE_OUTSIDE;
    }
    if (!place_end(view, &line->from.position, painted, 0) ||
        !place_end(view, &line->to.position, painted, 1)) {
        return FXL_LINE_REFUSED;
    }
    return intersections > 0 ? FXL_LINE_CLIPPED : FXL_LINE_DRAWN;
}

void fxl_find_line_volume(const fxl_view *view, fxl_volume *volume)
{
    fxl_volume_from_sides(&view->view_frustum, fxl_view_drawn_focal(view), FXL_PLANES_ALL, volume);
}

fxl_line_canvas fxl_line_canvas_of(const fxl_renderer *renderer, const fxl_workspace *workspace,
                                   const fxl_band *band)
{
    const uint8_t bits = renderer->target->depth_bits;
    const fxl_line_canvas canvas = {
        band, bits != 0 ? (const fxl_depth_head *)workspace->target_memory : NULL,
        renderer->frame.view.lens.near_z, bits == 32};
    return canvas;
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
    fxl_volume volume;
    fxl_band_begin_at_column_0(&from_0);
    fxl_find_line_volume(view, &volume);
    fxl_transform_point(&view->camera, &line->from, &clipped.from.position);
    fxl_transform_point(&view->camera, &line->to, &clipped.to.position);
    if (fxl_place_line(view, &volume, &clipped, &painted) >= FXL_LINE_DRAWN) {
        const fxl_line_canvas canvas = fxl_line_canvas_of(renderer, workspace, &from_0);
        painted.colour = line->colour;
        painted.width = line->width;
        painted.is_point =
            line->from.x == line->to.x && line->from.y == line->to.y && line->from.z == line->to.z;
        painted.plane_count = 0;
        if (canvas.head != NULL) {
            fxl_depth_clear_rest(workspace, &from_0, renderer->target->depth_bits / 8u);
        }
        fxl_paint_wide_line(&canvas, &painted);
    }
    return FXL_OK;
}
