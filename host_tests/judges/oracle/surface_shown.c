/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "oracle/surface_sample.h"
#include "reference/light.h"
#include "stages/bridge.h"

/* --- what a pixel shows --------------------------------------------------------------------- */

/* u on a texture whose columns differ, v on one whose rows differ, of 1 to 128 of them. */
static uint8_t texels[2][128 * 128];

/* place sampling: the claims of texels */
int surface_sample_texel(surface_sample *sample, int attribute, int log, uint8_t division)
{
    const int other = log < 4 ? 0 : 4; /* as the kernel for most textures takes them */
    const int columns = attribute == 0 ? log : other, rows = attribute == 0 ? other : log;
    const fxl_texture texture = {.texels = texels[attribute],
                                 .log_width = (uint8_t)columns,
                                 .log_height = (uint8_t)rows,
                                 .levels = 1};
    const fxl_surface surface = {.texture = 1, .division = division, .opacity = 16};
    for (int i = 0; i < 1 << (columns + rows); i++) {
        texels[attribute][i] =
            (uint8_t)(100 + (attribute == 0 ? i & ((1 << columns) - 1) : i >> columns));
    }
    const int shown = surface_sample_draw(sample, &texture, &surface, NULL, NULL);
    return shown < 0 ? shown : shown - 100;
}

double surface_texel_distance(int64_t exact, int texel, int log)
{
    const double size = ldexp(1, log);
    double at = fmod(ldexp((double)exact, -32) - texel, size);
    at = at < 0 ? at + size : at;
    return at <= 1 ? 0 : fmin(at - 1, size - at);
}

int surface_sample_level(surface_sample *sample, const fxl_direction normals[3],
                         const fxl_light_settings *settings)
{
    const fxl_surface surface = {.division = FXL_DIVIDE_1, .flags = FXL_SURFACE_LIT, .opacity = 16};
    const int shown = surface_sample_draw(sample, NULL, &surface, normals, settings);
    return shown < 0 ? shown : shown - 100;
}

double surface_level_distance(double exact, int level)
{
    const double held = fmax(0.5, fmin(exact, SURFACE_LEVELS - 0.5));
    return fmax(0, fmax(level - held, held - level - 1));
}

/* --- light ---------------------------------------------------------------------------------- */

static void put_direction(oracle_random *random, oracle_input *input)
{
    const double turn = oracle_uniform(random, 0, 6.283185307179586);
    const double up = oracle_uniform(random, -1, 1), level = sqrt(1 - up * up);
    oracle_put(input, (int64_t)floor(level * cos(turn) * FXL_Q2_30_ONE + 0.5));
    oracle_put(input, (int64_t)floor(up * FXL_Q2_30_ONE + 0.5));
    oracle_put(input, (int64_t)floor(level * sin(turn) * FXL_Q2_30_ONE + 0.5));
}

void surface_sample_put_light(oracle_random *random, oracle_input *input)
{
    const int64_t *corner = &input->numbers[ORACLE_SETUP_NUMBERS + 2];
    const double depth = oracle_spread(random, 65536, 1000 * 65536);
    for (int i = 0; i < 4; i++) { /* the normals, and the way of the directional light */
        put_direction(random, input);
    }
    oracle_put(input, oracle_between(random, 0, FXL_Q2_30_ONE / 4)); /* ambient */
    oracle_put(input, oracle_between(random, 0, FXL_Q2_30_ONE));     /* strength */
    for (int k = 0; k < 3; k++) {
        const double at = (double)corner[k] + oracle_signed_spread(random, 1, depth);
        oracle_put(input, (int64_t)fmax(fmin(at, FXL_COORDINATE_MAX), -FXL_COORDINATE_MAX));
    }
    oracle_put(input, (int64_t)fmin(2 * depth, FXL_COORDINATE_MAX)); /* range */
    oracle_put(input, oracle_below(random, 2)
                          ? 0
                          : (int64_t)oracle_spread(random, 65536, depth * 4 + 65537));
}

/* place light: the claim light_level: pixels of lit surfaces */
/* place light: a new setting: the settings of the claim */
/* The settings of the library and of the reference: from 10 numbers, a direction first. */
static void read_light(const int64_t *n, fxl_light_settings *settings, ref_light *light)
{
    static uint8_t ramp[256 * SURFACE_LEVELS];
    *settings = (fxl_light_settings){.ramp = ramp, .levels = SURFACE_LEVELS, .point_count = 1};
    for (int i = 0; i < 256 * SURFACE_LEVELS; i++) {
        ramp[i] = (uint8_t)(100 + i / 256);
    }
    settings->direction = (fxl_direction){(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]};
    settings->ambient = (int32_t)n[3];
    settings->strength = (int32_t)n[4];
    settings->points[0].position = (fxl_point){(int32_t)n[5], (int32_t)n[6], (int32_t)n[7]};
    settings->points[0].range = (int32_t)n[8];
    settings->points[0].strength = FXL_Q2_30_ONE;
    settings->fog_far = (int32_t)n[9];
    light->ambient = ldexp((double)n[3], -30);
    light->strength = ldexp((double)n[4], -30);
    light->direction =
        (ref_point){ldexp((double)n[0], -30), ldexp((double)n[1], -30), ldexp((double)n[2], -30)};
    light->point_count = 1;
    light->points[0].position = bridge_point(&settings->points[0].position);
    light->points[0].range = ldexp((double)n[8], -16);
    light->points[0].strength = 1;
    light->fog_near = 0;
    light->fog_far = ldexp((double)n[9], -16);
    light->levels = SURFACE_LEVELS;
}

void surface_sample_light(const oracle_input *input, surface_sample *sample,
                          fxl_direction normals[3], fxl_light_settings *settings)
{
    static ref_light light;
    read_light(&input->numbers[SURFACE_NUMBERS + 9], settings, &light);
    const ref_camera camera = bridge_camera(&sample->setup.view.camera);
    for (int i = 0; i < 3; i++) {
        const int64_t *n = &input->numbers[SURFACE_NUMBERS + 3 * i];
        const ref_point normal = {ldexp((double)n[0], -30), ldexp((double)n[1], -30),
                                  ldexp((double)n[2], -30)};
        normals[i] = (fxl_direction){(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]};
        const double level =
            ref_light_brightness(&light, &camera, bridge_point(&sample->corners[i]), normal) *
                (SURFACE_LEVELS - 1) +
            0.5;
        sample->values[i][2] = (int64_t)floor(ldexp(level, 32) + 0.5);
    }
}

double surface_sample_exact_level(const surface_sample *sample, double *bound)
{
    /* Values in 2^-32: so is the result in 2^-48, and the bound in 2^-16. */
    const double exact = ldexp((double)(surface_sample_exact(sample, 2, bound) >> 16), -32);
    *bound *= 0x1p-16;
    return exact;
}
