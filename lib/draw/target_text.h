/* SPDX-License-Identifier: MIT */
/* The text of all targets: how a face of one colour is drawn. The file that includes this one
 * defines:
 *
 *   FXL_TARGET             the target's name
 *   FXL_TARGET_FORMAT      a format of pixel_row.h
 *   FXL_TARGET_DEPTH_BITS  0, 16 or 32
 *
 * So no target tests at run time what it is. Internal. */
#ifndef FXL_TARGET_TEXT_H
#define FXL_TARGET_TEXT_H

#include "../raster/fill.h"
#include "pixel_row.h"
#include "renderer.h"
#include "submit.h"

#if FXL_TARGET_DEPTH_BITS != 0

#include "target_faces_text.h"

/* fxl_target.flat: what has no depth is at infinity. Front to back, the first of these to cover a
 * pixel is seen, as in a span buffer; far to near, the last one. */
static bool flat(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    static const fxl_depth_plane infinity = {{0, 0, 0}, 0};
    (void)paint_flat(workspace, &infinity, polygon->points, polygon->count, polygon->colour,
                     polygon->shade, band);
    return true;
}

static void flat_with_depth(fxl_workspace *workspace, const fxl_screen_polygon *record,
                            const fxl_band *band)
{
    fxl_surface_polygon polygon;
    const uint32_t count = fxl_surface_polygon_read(record, &polygon);
    (void)paint_flat(workspace, &polygon.depth, record->points, count, polygon.colour,
                     polygon.shade, band);
}

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

static const fxl_shader_code code = {
    .reaches = reaches,
    .face = submit,
    .split = split,
#if FXL_WALKS_FACES
#if FXL_TARGET_DEPTH_BITS == 16
    .faces = submit_faces,
#endif
    .walk = fxl_submit_walk,
#endif
};
static const fxl_shader last = {NULL, FXL_SHADER_TARGET, &code};
static const fxl_target_extras extras = {fxl_mixed_draw_list, flat_with_depth, &last, NULL, NULL};

/* --- bands ---------------------------------------------------------------------------------- */

static uint32_t memory_size(const fxl_lens *lens)
{
    return FXL_DEPTH_BYTES(lens->width, 1, FXL_TARGET_DEPTH_BITS);
}

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    const fxl_status status = fxl_check_band(band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    if (FXL_PIXEL_IS_MIXED) {
        workspace->dark = renderer->dark;
    }
    fxl_depth_draw_parts(renderer, workspace, band);
    return FXL_OK;
}

#else

/* A face goes from the clipper straight to here where it can (render.c). */
static bool flat(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    return fxl_draw_flat(&workspace->work.scan, polygon, band, workspace->dark);
}

#if FXL_PIXEL_IS_MIXED

static fxl_status draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band)
{
    const fxl_status status = fxl_check_band(band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    workspace->dark = renderer->dark;
    return fxl_draw_band(renderer, workspace, band);
}

#endif

#endif

const fxl_target FXL_TARGET = {
    .pixel_bits = FXL_PIXEL_BITS,
    .depth_bits = FXL_TARGET_DEPTH_BITS,
    .draws_over = FXL_TARGET_DEPTH_BITS == 0,
    .near_first = FXL_TARGET_DEPTH_BITS != 0,
    .has_palette = FXL_PIXEL_HAS_PALETTE,
    .is_mixed = FXL_PIXEL_IS_MIXED,
    .fill = FXL_FILL_BAND,
#if FXL_PIXEL_IS_MIXED || FXL_TARGET_DEPTH_BITS != 0
    .choose = fxl_choose_with_memory,
#endif
#if FXL_TARGET_DEPTH_BITS != 0
    .memory_size = memory_size,
#endif
#if FXL_PIXEL_IS_MIXED || FXL_TARGET_DEPTH_BITS != 0
    .draw_band = draw_band,
#else
    .draw_band = fxl_draw_band,
#endif
    .flat = flat,
#if FXL_TARGET_DEPTH_BITS != 0
    .extras = &extras,
#endif
};

#endif
