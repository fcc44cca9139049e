/* SPDX-License-Identifier: MIT */
/* Any light for a renderer, and any ramp. */
#include <string.h>

#include "demand.h"
#include "record.h"
#include "stages.h"

static fxl_q2_30 any_fraction(fuzz_input *in)
{
    return fuzz_below(in, 16) ? fuzz_between(in, 0, FXL_Q2_30_ONE) : fuzz_any(in);
}

/* place light: a new setting: random settings */
static fxl_light_settings any_settings(fuzz_input *in)
{
    fxl_light_settings made;
    fxl_camera camera;
    const fxl_pose pose = fuzz_pose(in);
    DEMAND(fxl_camera_from_pose(&pose, &camera) == FXL_OK);
    memset(&made, 0, sizeof made);
    made.ambient = any_fraction(in);
    made.strength = fuzz_below(in, 2) ? any_fraction(in) : 0;
    made.direction = camera.axes.forward;
    if (fuzz_below(in, 16) == 0) {
        made.direction.y = fuzz_any(in);
    }
    made.point_count = fuzz_below(in, FXL_LIGHT_POINTS_MAX + 2);
    for (uint32_t i = 0; i < made.point_count && i < FXL_LIGHT_POINTS_MAX; i++) {
        made.points[i].position = fuzz_point(in, FXL_COORDINATE_MAX);
        made.points[i].range =
            fuzz_below(in, 16) ? fuzz_between(in, 1, FXL_COORDINATE_MAX) : fuzz_any(in);
        made.points[i].strength = any_fraction(in);
    }
    if (fuzz_below(in, 2)) {
        made.fog_near = fuzz_below(in, 8) ? fuzz_between(in, 0, 20 * 65536) : fuzz_any(in);
        made.fog_far = fuzz_below(in, 8) ? fuzz_between(in, 20 * 65536, FXL_FAR_MAX) : fuzz_any(in);
    }
    made.levels = fuzz_below(in, 8) ? 2 + fuzz_below(in, 5) : fuzz_below(in, 70);
    return made;
}

/* Level 0 of colour c is black's entry; the top level is c. */
static void demand_ramp(const fxl_light_settings *settings, uint8_t *ramp, fuzz_input *in)
{
    static const uint8_t black[3] = {0, 0, 0};
    static uint8_t palette[768];
    for (int i = 3; i < 768; i++) {
        palette[i] = (uint8_t)fuzz_bits(in, i < 30 ? 1 : 0);
    }
    const fxl_status status = fxl_light_make_ramp(palette, black, settings->levels, ramp);
    DEMAND((status == FXL_OK) ==
           (settings->levels >= FXL_LIGHT_LEVELS_MIN && settings->levels <= FXL_LIGHT_LEVELS_MAX));
    record_bytes(ramp, status == FXL_OK ? FXL_LIGHT_RAMP_BYTES(settings->levels) : 0);
    for (uint32_t i = 0; status == FXL_OK && i < 256; i++) {
        DEMAND(ramp[i] == 0 && ramp[256 * (settings->levels - 1) + i] == i);
    }
    DEMAND(fxl_light_make_ramp(NULL, black, 4, ramp) == FXL_E_ARGUMENT);
    DEMAND(fxl_light_make_ramp(palette, NULL, 4, ramp) == FXL_E_ARGUMENT);
    DEMAND(fxl_light_make_ramp(palette, black, 4, NULL) == FXL_E_ARGUMENT);
}

void fuzz_set_light(fxl_renderer *renderer, fxl_light *light, fuzz_input *in)
{
    static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(FXL_LIGHT_LEVELS_MAX)];
    static fxl_renderer none;
    fxl_light_settings settings = any_settings(in);
    const fxl_light before = *light;
    const fxl_shader *const shader = renderer->shader;
    DEMAND(fxl_attach_light(renderer, light, &settings) == FXL_E_ARGUMENT);
    settings.ramp = ramp;
    if (fuzz_below(in, 4) == 0) {
        demand_ramp(&settings, ramp, in);
    }
    DEMAND(fxl_attach_light(NULL, light, &settings) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_light(renderer, NULL, &settings) == FXL_E_ARGUMENT);
    DEMAND(fxl_attach_light(&none, light, &settings) == FXL_E_ORDER);
    if (fxl_attach_light(renderer, light, &settings) != FXL_OK) {
        DEMAND(memcmp(&before, light, sizeof before) == 0 && renderer->shader == shader);
        DEMAND(fxl_attach_light(renderer, NULL, NULL) == FXL_OK);
    }
}
