/* SPDX-License-Identifier: MIT */
/* vertex_unclipped: transforms and projects a visible vertex. Compares it with the exact
 * quotient, given the 16.16 vertex and eye, the 2.30 matrix and the 16.16 focal length.
 * Everything fits 128 bits: focal X is below 2^91. */
#include <math.h>
#include <stdlib.h>

#include "oracle/setup.h"
#include "reference/project.h"
#include "reference/transform.h"
#include "stages/bridge.h"

/* In 1/65536 pixel: the error of double for a coordinate of up to 2^26 units. */
#define TWIN_BOUND 1e-6

static void generate(oracle_random *random, uint64_t index, oracle_input *input)
{
    (void)index;
    oracle_setup_generate(random, FXL_SCREEN_MAX, input);
    const int64_t *n = input->numbers;
    double half_width = (double)n[0] / 2, half_height = (double)n[1] / 2;
    double focal = half_width / tan(ldexp((double)n[2], -32) * 3.141592653589793);
    double near = (double)(n[3] + n[5]) / 65536, far = (double)(n[4] - n[5]) / 65536;
    input->kind = (int)oracle_below(random, 4);
    for (int tries = 0; tries < 64; tries++) {
        double z = oracle_spread(random, near, fmin(far, 28000));
        if (input->kind == 1) {
            z = near + oracle_spread(random, 1.0 / 65536, 1.0 / 64);
        }
        double x = oracle_uniform(random, -half_width, half_width);
        double y = oracle_uniform(random, -half_height, half_height);
        if (input->kind == 2) { /* at the rim */
            x = oracle_below(random, 2) ? half_width : -half_width;
        }
        double view[3] = {x * z / focal, y * z / focal, z}, world[3];
        oracle_to_world(input, view, world);
        int inside = 1;
        input->count = ORACLE_SETUP_NUMBERS;
        for (int i = 0; i < 3; i++) {
            int64_t coordinate = n[6 + i] + (int64_t)floor(world[i] * 65536 + 0.5);
            inside = inside && llabs(coordinate) <= FXL_COORDINATE_MAX;
            oracle_put(input, coordinate);
        }
        if (inside) {
            return;
        }
    }
}

/* |got - F side / z| in units of 1/65536 pixel. */
static double error_of(int64_t got, int64_t focal, int64_t side, int64_t z)
{
    oracle_wide difference = (oracle_wide)got * z - (oracle_wide)focal * side;
    return (double)fabsl((long double)difference / (long double)z);
}

/* Returns how far the reference renderer is from the exact position, given the same integers. */
static double twin_error(const oracle_setup *setup, const fxl_point *vertex,
                         const oracle_view_point *exact)
{
    const fxl_lens *lens = &setup->view.lens;
    ref_camera camera = bridge_camera(&setup->view.camera);
    ref_lens twin_lens = bridge_lens(lens);
    ref_point point = bridge_point(vertex);
    ref_view_point view = ref_transform_point(&camera, &point);
    ref_screen_point screen = ref_project_point(&twin_lens, &view);
    long double scale = (long double)lens->focal / (long double)exact->z;
    long double x = (long double)lens->width * 32768 + (long double)exact->x * scale;
    long double y = (long double)lens->height * 32768 - (long double)exact->y * scale;
    return fmax((double)fabsl(screen.x * 65536 - x), (double)fabsl(screen.y * 65536 - y));
}

static oracle_outcome judge(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    oracle_setup setup;
    if (input->count != ORACLE_SETUP_NUMBERS + 3 || !oracle_setup_read(input, &setup)) {
        return ORACLE_UNUSABLE;
    }
    const int64_t *point = &input->numbers[ORACLE_SETUP_NUMBERS];
    for (int i = 0; i < 3; i++) {
        if (point[i] < -FXL_COORDINATE_MAX || point[i] > FXL_COORDINATE_MAX) {
            return ORACLE_UNUSABLE;
        }
    }
    const fxl_lens *lens = &setup.view.lens;
    oracle_view_point exact = oracle_transform(&setup.view.camera, point);
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        if (oracle_distance(&setup.view.view_frustum, plane, &exact) < 0) {
            return ORACLE_SKIPPED;
        }
    }
    fxl_point vertex = {(int32_t)point[0], (int32_t)point[1], (int32_t)point[2]};
    fxl_view_point view;
    fxl_screen_point screen;
    fxl_transform_point(&setup.view.camera, &vertex, &view);
    if (fxl_project_point(lens, &view, &screen) != FXL_OK) {
        verdict->value = ORACLE_REFUSED;
        return ORACLE_COUNTED;
    }
    int64_t x = (int64_t)screen.x - lens->width * 32768;
    int64_t y = lens->height * 32768 - (int64_t)screen.y;
    double error_x = error_of(x, lens->focal, exact.x, exact.z);
    double error_y = error_of(y, lens->focal, exact.y, exact.z);
    verdict->value = fmax(error_x, error_y);
    verdict->extras[0] = error_x > 0.5 || error_y > 0.5;
    verdict->extras[1] = twin_error(&setup, &vertex, &exact) > TWIN_BOUND;
    if (words) {
        fprintf(words,
                "exact view point (%.17Lg, %.17Lg, %.17Lg), focal %.9g\n"
                "library: pixel (%.9g, %.9g), off by %.9g and %.9g of 1/65536 pixel\n",
                ldexpl(exact.x, -46), ldexpl(exact.y, -46), ldexpl(exact.z, -46),
                lens->focal / 65536.0, screen.x / 65536.0, screen.y / 65536.0, error_x, error_y);
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_vertex_unclipped = {
    .id = "vertex_unclipped",
    .unit = "1/65536 pixel",
    .numbers = ORACLE_SETUP_TEXT ", vertex x y z",
    .kinds = {"anywhere in sight", "at the near plane", "at the rim", "anywhere in sight too"},
    .extras = {"not_nearest", "twin_off"},
    .generate = generate,
    .judge = judge,
};
