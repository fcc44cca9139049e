/* SPDX-License-Identifier: MIT */
/* Frames of 16 bits a pixel: the calls. */
#include "../math/memory.h"
#include "../paint/rgb565_colour.h"
#include "fixel/rgb565.h"
#include "renderer.h"
#include "submit.h"
#include "surface_polygon.h"

#define STRIDE_MAX 32767u /* twice of it, in bytes, fits a band */

static const fxl_visibility visibility_rgb565 = {.order = &fxl_by_distance, .target = &fxl_rgb565};

fxl_status fxl_renderer_set_rgb565(fxl_renderer *renderer, fxl_rgb565_frame *frame,
                                   const uint16_t *palette, uint16_t dark)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (frame == NULL || palette == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(palette, sizeof *palette)) {
        return fxl_refuse(&renderer->workspace, FXL_E_ALIGNMENT);
    }
    const uint16_t *before = renderer->palette;
    renderer->palette = palette;
    const fxl_status status =
        fxl_renderer_set_visibility(renderer, &visibility_rgb565, NULL, 0);
    if (status == FXL_OK) {
        fxl_surfaces *surfaces = (fxl_surfaces *)(uintptr_t)fxl_surfaces_of(renderer);
        renderer->order_memory = frame;
        frame->dark = dark;
        if (surfaces != NULL) {
            surfaces->painter = FXL_SURFACES_OF(fxl_rgb565);
            surfaces->shader.code = surfaces->painter->code;
            surfaces->dark = dark;
        }
    } else {
        renderer->palette = before;
    }
    return status;
}

fxl_status fxl_renderer_set_surfaces_rgb565(fxl_renderer *renderer, fxl_surfaces *surfaces,
                                            const fxl_surface_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->target != &fxl_rgb565) {
        return fxl_refuse(&renderer->workspace, FXL_E_ORDER);
    }
    const fxl_status status = fxl_surfaces_attach(renderer, surfaces, set,
                                                  fxl_surfaces_check_rgb565,
                                                  FXL_SURFACES_OF(fxl_rgb565));
    if (status == FXL_OK && set != NULL) {
        surfaces->dark = (uint16_t)((const fxl_rgb565_frame *)renderer->order_memory)->dark;
    }
    return status;
}

/* The status of a band, and of a workspace that draws it. */
static fxl_status check_band(const fxl_renderer *renderer, const fxl_workspace *workspace,
                             const fxl_band_565 *band)
{
    if (renderer->target != &fxl_rgb565 ||
        workspace->settings_version != renderer->workspace.settings_version) {
        return FXL_E_ORDER;
    }
    if (((uintptr_t)band->pixels & 1u) != 0) {
        return FXL_E_ALIGNMENT;
    }
    return band->stride < band->width || band->stride > STRIDE_MAX ? FXL_E_RANGE : FXL_OK;
}

fxl_status fxl_frame_draw_rgb565_with(const fxl_renderer *renderer, fxl_workspace *workspace,
                                      const fxl_band_565 *band)
{
    if (workspace == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer == NULL || band == NULL || band->pixels == NULL) {
        return fxl_refuse(workspace, FXL_E_ARGUMENT);
    }
    fxl_status status = check_band(renderer, workspace, band);
    if (status != FXL_OK) {
        return fxl_refuse(workspace, status);
    }
    const fxl_band pixels = {.pixels = (uint8_t *)(void *)band->pixels, .width = band->width,
                             .stride = band->stride, .first_row = band->first_row,
                             .rows = band->rows, .palette = renderer->palette};
    return fxl_frame_draw_with(renderer, workspace, &pixels);
}

fxl_status fxl_frame_draw_rgb565(fxl_renderer *renderer, const fxl_band_565 *band)
{
    return fxl_frame_draw_rgb565_with(renderer, renderer == NULL ? NULL : &renderer->workspace,
                                      band);
}

fxl_status fxl_render_rgb565(fxl_renderer *renderer, const fxl_pose *eye, uint16_t *pixels,
                             uint16_t stride)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (eye == NULL || pixels == NULL) {
        return fxl_refuse(&renderer->workspace, FXL_E_ARGUMENT);
    }
    const fxl_lens *lens = &renderer->frame.view.lens;
    const fxl_band_565 whole = {.pixels = pixels, .width = lens->width, .stride = stride,
                                .first_row = 0, .rows = lens->height};
    fxl_status status = check_band(renderer, &renderer->workspace, &whole);
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    status = fxl_begin_one_band(renderer, eye);
    if (status != FXL_OK) {
        return status;
    }
    fxl_fill_rgb565(&whole, renderer->palette[renderer->frame.background]);
    return fxl_frame_draw_rgb565(renderer, &whole);
}

void fxl_fill_rgb565(const fxl_band_565 *band, uint16_t colour)
{
    uint16_t *row = band->pixels;
    for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
        fxl_fill_row_rgb565(row, row + band->width, colour);
    }
}
