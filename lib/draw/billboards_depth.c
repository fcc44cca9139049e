/* SPDX-License-Identifier: MIT */
/* Billboards with a depth buffer: each pixel is compared at the distance of the instance. */
#include "renderer.h"
#include "surface_polygon.h"
#include "../paint/depth_band.h"
#include "depth_plane.h"
#include "../paint/depth_ratio.h"
#include "../paint/billboard_paint.h"
#include "../paint/billboard_walk.h"

/* Where a billboard is in the depth buffer. */
typedef struct {
    const fxl_band *band;
    uint8_t *cells; /* of the band's first pixel */
    uint32_t code;  /* of the billboard */
    fxl_depth_rule rule;
} depth_place;

static inline void paint_row(fxl_billboard_row *row, const void *with)
{
    const depth_place *at = (const depth_place *)with;
    const fxl_band *band = at->band;
    const size_t row_bytes = (size_t)band->width * (at->rule.wide ? 4u : 2u);
    void *cells = at->cells + (row->y - band->first_row) * row_bytes;
    for (int32_t x = row->columns.first; x < row->columns.end; x++) {
        const uint32_t value =
            fxl_sprite_value(row->sprite, row->texels, row->along.texel, row->shift);
        if (value != row->sprite->key && fxl_depth_passes(cells, x, at->code, at->rule)) {
            row->pixels[x] = fxl_sprite_colour(row->sprite, value);
            fxl_depth_keep(cells, x, at->code, at->rule.wide); /* bug: sprite-depth-kept */
        }
        fxl_take_step(&row->along);
    }
}

/* The plane at a distance, above 0, that is parallel to the screen. Its depth is off relatively by
 * less than 2^-28. near_z has units of 2^-16 and the distance of 2^-46, so near_z / distance is the
 * ratio of the mantissas times 2^(30 + the difference of the exponents). */
static void find_plane(const fxl_lens *lens, fxl_q18_46 distance, fxl_depth_plane *plane)
{
    const fxl_normalised near_z = fxl_normalise((uint32_t)lens->near_z);
    const fxl_normalised divisor = fxl_normalise((uint64_t)distance);
    plane->gradient.at = fxl_ratio_of(&near_z, &divisor);
    plane->gradient.along = plane->gradient.down = 0;
    plane->one = divisor.exponent - near_z.exponent + 1;
}

/* The code of a plane that is parallel to the screen: that of every pixel. The sum is modulo 2^32,
 * as the bias of the farthest octave is below 0. */
static uint32_t code_of(fxl_depth_scale scale, const fxl_depth_plane *plane)
{
    fxl_depth_octave octave;
    fxl_depth_octave_of(scale, plane, plane->gradient.at, &octave);
    return octave.is_constant ? octave.bias
                              : octave.bias + fxl_depth_shifted(plane->gradient.at, octave.drop);
}

static void paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                  const fxl_screen_point *points, const fxl_band *band)
{
    fxl_depth_head *head = (fxl_depth_head *)workspace->raster_workspace;
    if (head->pass == FXL_DEPTH_BLENDED) {
        return; /* bug: sprite-depth-pass */
    }
    const fxl_q18_46 distance =
        (fxl_q18_46)((uint64_t)(uint32_t)points[3].x << 32 | (uint32_t)points[3].y);
    fxl_depth_plane plane;
    find_plane(&renderer->frame.view.lens, distance, &plane);
    const depth_place at = {band,
                            (uint8_t *)(head + 1),
                            code_of(head->scale, &plane),
                            {fxl_surface_backend_of(renderer)->depth_bits == 32, head->or_equal}};
    fxl_billboard_walk_rows(fxl_billboard_sprite(renderer, (uint32_t)points[2].x), &points[0],
                            &points[1], band, paint_row, &at);
}

static const fxl_billboard_painter paints_by_depth = {paint, FXL_BILLBOARD_POINTS_MAX};

fxl_status fxl_renderer_set_billboards_by_depth(fxl_renderer *renderer, fxl_billboards *billboards,
                                                const fxl_billboard_set *set)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = fxl_billboards_check_setting(renderer, billboards, set);
    if (status == FXL_OK && !(fxl_billboards_may_join(renderer) &&
                              fxl_surface_backend_of(renderer)->find_depth != NULL)) {
        status = FXL_E_ORDER;
    }
    return status == FXL_OK ? fxl_billboards_join(renderer, billboards, set, &paints_by_depth)
                            : fxl_refuse(&renderer->workspace, status);
}
