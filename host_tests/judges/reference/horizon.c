/* SPDX-License-Identifier: MIT */
#include "reference/horizon.h"

#include <math.h>

#include "reference/scan.h"
/* place field: the reference's reader: sizes of entries, and offsets as numbers */
#include "reference/sections.h"

bool ref_horizon_read(const uint8_t *bytes, ref_horizon *horizon)
{
    uint32_t count, colours;
    const uint8_t *sine = ref_section(bytes, REF_HORIZON_SINES, &count);
    const uint8_t *colour = ref_section(bytes, REF_HORIZON_COLOURS, &colours);
    double least = -1;
    horizon->count = (int)count;
    for (uint32_t i = 0; i < count; i++) {
        horizon->sines[i] = ref_i32(sine + 4 * (size_t)i) / 0x1p30;
        if (horizon->sines[i] < least || horizon->sines[i] > 1) {
            return false;
        }
        least = horizon->sines[i];
    }
    for (uint32_t i = 0; i < colours; i++) {
        horizon->colours[i] = colour[i];
    }
    return true;
}

int ref_horizon_level(const ref_renderer *renderer, int x, int y, int *low, int *high)
{
    const ref_horizon *horizon = &renderer->scene->horizon;
    const ref_camera *camera = &renderer->camera;
    const ref_view_point ray =
        ref_ray_through(&renderer->lens, &(ref_screen_point){x + 0.5, y + 0.5});
    const double length = (double)sqrtl(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
    const double rise = (double)(camera->right.y * ray.x + camera->up.y * ray.y + camera->forward.y * ray.z);
    int level = 0;
    *low = *high = 0;
    for (int i = 0; i < horizon->count; i++) {
        const double side = rise - horizon->sines[i] * length;
        level += side >= 0;
        *low += side >= REF_HORIZON_BOUND * length;
        *high += side >= -REF_HORIZON_BOUND * length;
    }
    return level;
}

void ref_frame_fill(const ref_renderer *renderer, const ref_band *band, uint8_t background)
{
    const ref_horizon *horizon = &renderer->scene->horizon;
    ref_fill_band(band, ref_pixel_of(renderer, background));
    for (int y = band->first_row; horizon->count > 0 && y < band->first_row + band->rows; y++) {
        for (int x = 0; x < band->width; x++) {
            int low, high;
            const int level = ref_horizon_level(renderer, x, y, &low, &high);
            const ref_span pixel = {y, x, x + 1};
            ref_fill_span(band, &pixel, ref_pixel_of(renderer, horizon->colours[level]));
        }
    }
}
