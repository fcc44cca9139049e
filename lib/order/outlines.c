/* SPDX-License-Identifier: MIT */
/* Outlines: the renderer's target stands behind a copy of it, which draws a face by the target, and
 * then the face's edges. */
#include "../draw/renderer.h"
#include "../draw/surface_polygon.h"
#include "../math/memory.h"
#include "../math/pixel_centre.h"
#include "outlines.h"

/* An edge with both ends this near to one side of the screen, or beyond it, is where the clipper
 * cut: 1/256 pixel. A clipped vertex is less than 1/512 pixel from the side. */
#define SIDE 256

/* fxl_target.draw_band. All workspaces draw with the outlines of the renderer, whose own is not
 * written here: other cores read it while they draw. */
/* wire 3.4 */
static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    if (workspace != &renderer->workspace) {
        workspace->target_memory = renderer->workspace.target_memory;
    }
    return fxl_painted_target(renderer)->draw_band(renderer, workspace, band);
}

/* wire 3.2 */
static bool are_beside(fxl_q16_16 a, fxl_q16_16 b, int32_t size)
{
    const fxl_q16_16 end = size * 65536 - SIDE;
    return (a < SIDE && b < SIDE) || (a > end && b > end);
}

/* A coordinate in the rows that a polygon reaches: its vertices are at most half a pixel outside of
 * them. Other rows need not be drawn: a band, or a display list, may pass over the polygon there.
 */
/* wire 3.3 */
static fxl_q16_16 within(fxl_q16_16 y, int32_t first, int32_t end)
{
    return y < first * 65536 ? first * 65536 : y >= end * 65536 ? end * 65536 - 1 : y;
}

/* place fill-rule: the rows of an outline */
/* Requires a polygon that reaches a row. */
/* wire 3.1 */
static void draw_edges(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                       const fxl_band *band)
{
    const fxl_outlines *outlines = (const fxl_outlines *)workspace->target_memory;
    fxl_q16_16 top = points[0].y, bottom = points[0].y;
    for (uint32_t i = 1; i < count; i++) {
        top = points[i].y < top ? points[i].y : top;
        bottom = points[i].y > bottom ? points[i].y : bottom;
    }
    const int32_t first = fxl_first_centre_from(top), end = fxl_first_centre_from(bottom);
    FXL_ASSERT(first < end);
    const fxl_screen_point *a = &points[count - 1];
    for (uint32_t i = 0; i < count; i++) {
        const fxl_screen_point *b = &points[i];
        if (!are_beside(a->x, b->x, band->width) && !are_beside(a->y, b->y, outlines->height)) {
            const fxl_screen_point from = {a->x, within(a->y, first, end)};
            const fxl_screen_point to = {b->x, within(b->y, first, end)};
            fxl_wire_line(&from, &to, outlines->style.line, band);
        }
        a = b;
    }
}

/* fxl_target.flat. A polygon that is filled in another colour is changed in the workspace. A
 * clipper that has not cut the whole face keeps its colour there. */
/* wire 3.1 */
static bool paint(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    const fxl_outlines *outlines = (const fxl_outlines *)workspace->target_memory;
    const fxl_outline_style *style = &outlines->style;
    fxl_screen_polygon *screen = &workspace->screen;
    const uint8_t colour = screen->colour;
    if (!style->keeps_colours) {
        if (polygon != screen) {
            memcpy(screen, polygon,
                   offsetof(fxl_screen_polygon, points) +
                       polygon->count * sizeof polygon->points[0]);
        }
        screen->colour = style->fill;
        screen->shade = 0;
        polygon = screen;
    }
    (void)outlines->extras.outlined->flat(workspace, polygon, band);
    screen->colour = colour;
    draw_edges(workspace, polygon->points, polygon->count, band);
    return true;
}

/* The target stands in the renderer, or in its place its copy. A target with a depth buffer stays, and
 * so does one of the study, which is refused with outlines before a frame begins. */
static void change_target(fxl_renderer *renderer, fxl_outlines *outlines)
{
    fxl_workspace *workspace = &renderer->workspace;
    const fxl_target *target =
        renderer->target != NULL ? fxl_painted_target(renderer) : renderer->target;
    if (target == NULL || target->depth_bits != 0 || target->memory_size != NULL) {
        return;
    }
    renderer->target = target;
    workspace->target_memory = outlines;
    FXL_COUNT_CHANGE(workspace);
    if (outlines != NULL) {
        outlines->height = renderer->frame.view.lens.height;
        const fxl_target_extras extras = {.outlined = target, .outline = draw_edges};
        outlines->extras = extras;
        outlines->target = *target;
        outlines->target.draws_over = false;
        outlines->target.draw_band = draw_band;
        outlines->target.flat = paint;
        outlines->target.extras = &outlines->extras;
        renderer->target = &outlines->target;
    }
}

fxl_status fxl_attach_outlines(fxl_renderer *renderer, fxl_outlines *outlines,
                               const fxl_outline_style *style)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    if (style == NULL) {
        fxl_renderer_attach(renderer, FXL_SHADER_OUTLINES, NULL);
        change_target(renderer, NULL);
        return FXL_OK;
    }
    if (outlines == NULL || !fxl_is_aligned(outlines, 8)) {
        return fxl_refuse(&renderer->workspace,
                          outlines == NULL ? FXL_E_ARGUMENT : FXL_E_ALIGNMENT);
    }
    outlines->style = *style;
    outlines->overdraw.shader.code = &fxl_mark;
    outlines->overdraw.draw_over = NULL;
    outlines->overdraw.draw_record = NULL;
    if (style->code != NULL && renderer->target != NULL && renderer->target->depth_bits != 0) {
        style->code->attach(outlines);
    }
    fxl_renderer_attach(renderer, FXL_SHADER_OUTLINES, &outlines->overdraw.shader);
    change_target(renderer, outlines);
    return FXL_OK;
}
