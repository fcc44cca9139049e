/* SPDX-License-Identifier: MIT */
#include "visibility_rgb565.h"

#include "draw_band.h"
#include "renderer.h"
#include "../raster/fill_row.h"
#include "surface_polygon.h"
#include "../paint/paint_rgb565.h"

/* The memory of the method is that of submit, and then that of the band. */
FXL_STATIC_ASSERT(offsetof(fxl_rgb565_frame, raster) % 8 == 0, "it is a workspace of its own");

static uint32_t submit_workspace_size(const fxl_scene *scene)
{
    (void)scene;
    return (uint32_t)offsetof(fxl_rgb565_frame, raster);
}

static uint32_t raster_workspace_size(const fxl_lens *lens)
{
    (void)lens;
    return (uint32_t)sizeof(fxl_rgb565_raster);
}

/* A band that fxl_frame_draw was given has a byte a pixel: it is refused. */
static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    fxl_rgb565_raster *raster = (fxl_rgb565_raster *)workspace->raster_workspace;
    if (raster->opened != band) { /* bug: band-of-bytes */
        return fxl_refuse(workspace, FXL_E_ORDER);
    }
    raster->palette = ((const fxl_rgb565_frame *)renderer->submit_workspace)->palette;
    (void)fxl_draw_band_by(renderer, workspace, band, fxl_surface_draw_list);
    return FXL_OK;
}

/* Two pixels are one aligned word, but for the first and the last one. */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour)
{
    if (pixel != end && ((uintptr_t)pixel & 2u) != 0) {
        *pixel++ = colour;
    }
    uint16_t *whole = pixel + ((end - pixel) & ~(ptrdiff_t)1);
    fxl_fill_row((uint8_t *)pixel, (uint8_t *)whole, colour * 0x00010001u);
    if (whole != end) {
        *whole = colour; /* bug: odd-pixel */
    }
}

static void fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint16_t colour)
{
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    uint8_t *row = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++, row += band->stride) {
        uint16_t *pixels = (uint16_t *)(void *)row;
        if (a.x != b.x) {
            fxl_fill_row_rgb565(pixels + (a.x < b.x ? a.x : b.x), pixels + (a.x < b.x ? b.x : a.x),
                                colour);
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
    }
}

static bool draw_polygon(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                         uint8_t colour, const fxl_band *band)
{
    const uint16_t *palette = ((const fxl_rgb565_raster *)workspace->raster_workspace)->palette;
    fxl_scan *scan = &workspace->work.scan;
    const fxl_trapezoid *trapezoid;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fill_trapezoid(band, trapezoid, palette[colour]);
    }
    return true;
}

static void paint_of(const fxl_renderer *renderer, const fxl_surface_polygon *polygon,
                     fxl_paint_565 *of)
{
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    const fxl_rgb565_frame *frame = (const fxl_rgb565_frame *)renderer->submit_workspace;
    fxl_surface_paint_of(surfaces, polygon, &of->paint);
    const uint32_t levels = of->paint.levels_less_1;
    of->palette = frame->palette;
    of->part_of_level = of->paint.ramp != NULL ? (65536u + levels / 2) / levels : 0;
    of->dark = (uint16_t)frame->dark;
    of->key = surface->texture != 0 ? surfaces->set->textures[surface->texture - 1].key_565 : 0;
    of->flags = surface->flags;
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                  uint32_t count, const fxl_band *band)
{
    fxl_paint_565 of;
    paint_of(renderer, polygon, &of);
    fxl_paint_polygon(&of.paint, points, count, band, &workspace->work.scan, fxl_paint_row_rgb565,
                      NULL);
}

static const fxl_surface_backend backend = {.backend = {.workspace_size = raster_workspace_size,
                                                        .draw_band = draw_band,
                                                        .draw_polygon = draw_polygon,
                                                        .draws_surfaces = true},
                                            .paint = paint,
                                            .draws_565 = true};

const fxl_visibility fxl_visibility_rgb565 = {.submit = fxl_submit_by_distance,
                                              .submit_workspace_size = submit_workspace_size,
                                              .backend = &backend.backend};
