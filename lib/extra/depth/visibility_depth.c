/* SPDX-License-Identifier: MIT */
/* The depth buffer of 16 bits a pixel. */
#include "../../src/draw/submit.h"
#include "depth_band.h"
#include "depth_draw.h"
#include "depth_plane.h"
#include "fixel/extra/depth.h"

static uint32_t workspace_size(const fxl_lens *lens)
{
    return FXL_DEPTH_BYTES(lens->width, 1, 16);
}

static void draw_band(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    fxl_depth_draw_parts(renderer, workspace, band, 2);
}

static bool draw_polygon(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                         uint8_t colour, const fxl_band *band)
{
    fxl_depth_draw_polygon(workspace, points, count, colour, band, false);
    return true;
}

static void paint_row(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                      int32_t x1)
{
    fxl_depth_paint_surface_row(with, paint, row, x0, x1, false);
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                  uint32_t count, const fxl_band *band)
{
    fxl_depth_paint(renderer, workspace, polygon, points, count, band, paint_row, false);
}

static const fxl_surface_backend backend = {.backend = {.workspace_size = workspace_size,
                                                        .draw_band = draw_band,
                                                        .draw_polygon = draw_polygon,
                                                        .draws_surfaces = true},
                                            .find_depth = fxl_depth_plane_find,
                                            .paint = paint,
                                            .far_to_near = &fxl_depth_far_to_near,
                                            .depth_bits = 16};

const fxl_visibility fxl_depth_far_to_near = {
    .front_to_back = false, .submit = fxl_submit_by_distance, .backend = &backend.backend};

const fxl_visibility fxl_visibility_depth = {
    .front_to_back = true, .submit = fxl_submit_by_distance, .backend = &backend.backend};
