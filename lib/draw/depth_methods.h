/* SPDX-License-Identifier: MIT */
/* The methods of a depth buffer: code that each of the two resolutions compiles for itself, so none
 * costs a test at run time. Internal. The file that includes this one defines:
 *
 *   FXL_DEPTH_BITS         16 or 32, of a pixel
 *   FXL_DEPTH_METHOD       the name of its method
 *   FXL_DEPTH_FAR_TO_NEAR  and of the one that draws what is blended */
#ifndef FXL_DEPTH_METHODS_H
#define FXL_DEPTH_METHODS_H

#include "submit.h"
#include "surface_polygon.h"
#include "../paint/depth_band.h"
#include "depth_draw.h"
#include "depth_plane.h"
#include "fixel/depth.h"

static uint32_t workspace_size(const fxl_lens *lens)
{
    return FXL_DEPTH_BYTES(lens->width, 1, FXL_DEPTH_BITS);
}

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    fxl_depth_draw_parts(renderer, workspace, band, FXL_DEPTH_BITS / 8);
    return FXL_OK;
}

static bool draw_polygon(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                         uint8_t colour, const fxl_band *band)
{
    fxl_depth_draw_polygon(workspace, points, count, colour, band, FXL_DEPTH_BITS == 32);
    return true;
}

static void paint_row(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                      int32_t x1)
{
    fxl_depth_paint_surface_row(with, paint, row, x0, x1, FXL_DEPTH_BITS == 32);
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                  uint32_t count, const fxl_band *band)
{
    fxl_depth_paint(renderer, workspace, polygon, points, count, band, paint_row,
                    FXL_DEPTH_BITS == 32);
}

static const fxl_surface_backend backend = {.backend = {.workspace_size = workspace_size,
                                                        .draw_band = draw_band,
                                                        .draw_polygon = draw_polygon,
                                                        .draws_surfaces = true},
                                            .find_depth = fxl_depth_plane_find,
                                            .paint = paint,
                                            .far_to_near = &FXL_DEPTH_FAR_TO_NEAR,
                                            .depth_bits = FXL_DEPTH_BITS};

const fxl_visibility FXL_DEPTH_FAR_TO_NEAR = {
    .front_to_back = false, .submit = fxl_submit_by_distance, .backend = &backend.backend};

const fxl_visibility FXL_DEPTH_METHOD = {
    .front_to_back = true, .submit = fxl_submit_by_distance, .backend = &backend.backend};

#endif
