/* SPDX-License-Identifier: MIT */
#include "draw_band.h"
#include "surface_polygon.h"

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                  uint32_t count, const fxl_band *band)
{
    fxl_paint how;
    fxl_surface_paint_of(fxl_surfaces_of(renderer), polygon, &how);
    fxl_paint_polygon(&how, points, count, band, &workspace->work.scan, NULL, NULL);
}

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    (void)fxl_draw_band_by(renderer, workspace, band, fxl_surface_draw_list);
    return FXL_OK;
}

static const fxl_surface_backend backend = {.backend = {.draw_band = draw_band,
                                                        .draw_polygon = fxl_draw_over,
                                                        .draws_over = true,
                                                        .draws_surfaces = true},
                                            .paint = paint};

const fxl_visibility fxl_visibility_surfaces = {.submit = fxl_submit_by_distance,
                                                .backend = &backend.backend};
