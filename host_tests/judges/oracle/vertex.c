/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "oracle/setup.h"
#include "reference/camera.h"
#include "stages/bridge.h"
#include "oracle/angle.h"
#include "view/placement.h"

/* vertex_unclipped: transforms and projects a visible vertex. Compares it with the exact
 * quotient, given the 16.16 vertex and eye, the 2.30 matrix and the 16.16 focal length.
 * Everything fits 128 bits: focal X is below 2^91. */

/* In 1/65536 pixel: the error of double for a coordinate of up to 2^26 units. */
#define TWIN_BOUND 1e-6

static void generate_unclipped(oracle_random *random, oracle_input *input)
{
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
        const double view[3] = {x * z / focal, y * z / focal, z};
        input->count = ORACLE_SETUP_NUMBERS;
        if (oracle_put_point(input, view)) {
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

static oracle_outcome judge_unclipped(const oracle_input *input, FILE *words,
                                      oracle_verdict *verdict)
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
    .generate = generate_unclipped,
    .judge = judge_unclipped,
};

/* vertex_turned: a vertex of a turned instance in the view, against the exact product of the view's
 * rows, the orientation and the scale as given. Rows of an orientation need not be exactly those of
 * a rotation: half of the samples have rows at a corner of the tolerance (SPEC.md, section 8.1). */

enum {
    ANGLES = 3,
    EYE = 3,
    CENTRE = 6,
    ROWS = 9,
    SCALE = 18,
    VERTEX = 19,
    NUMBERS = 22
};

static const double tolerance = 0x1p-28; /* of squares and of x . y; of a component of z 4 times */

static int sign(oracle_random *random)
{
    return oracle_below(random, 2) ? 1 : -1;
}

/* Rows whose products are off by `part` of the tolerance, each with a sign of its own. */
static void shear(double exact[3][3], const int signs[6], double part, int32_t rows[9])
{
    double moved[3][3];
    const double off = part * tolerance;
    for (int k = 0; k < 3; k++) {
        moved[0][k] = exact[0][k] * (1 + signs[0] * off / 2) + exact[1][k] * signs[2] * off / 2;
        moved[1][k] = exact[1][k] * (1 + signs[1] * off / 2) + exact[0][k] * signs[2] * off / 2;
    }
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        moved[2][k] =
            moved[0][i] * moved[1][j] - moved[0][j] * moved[1][i] + signs[3 + k] * 4 * off;
    }
    for (int i = 0; i < 9; i++) {
        rows[i] = (int32_t)floor(moved[i / 3][i % 3] * FXL_Q2_30_ONE + 0.5);
    }
}

static bool is_taken(const int32_t rows[9])
{
    const fxl_point centre = {0, 0, 0};
    fxl_placement placement = {.scale = FXL_Q16_16_ONE};
    for (int i = 0; i < 9; i++) {
        (&placement.orientation.x.x)[i] = rows[i];
    }
    return fxl_placement_check(&placement, &centre, 0) == FXL_OK;
}

/* The rounding of the entries takes a part of the tolerance; what is left decides how near to the
 * corner rows may come. */
static void put_rows(oracle_random *random, bool at_corner, oracle_input *input)
{
    fxl_orientation made;
    int32_t rows[9];
    double exact[3][3];
    int signs[6];
    (void)fxl_orientation_from_angles(oracle_any_angle(random), oracle_any_angle(random),
                                      oracle_any_angle(random), &made);
    for (int i = 0; i < 6; i++) {
        signs[i] = sign(random);
    }
    for (int i = 0; i < 9; i++) {
        rows[i] = (&made.x.x)[i];
        exact[i / 3][i % 3] = ldexp(rows[i], -30);
    }
    if (at_corner) {
        for (double part = 1; part > 0.05; part -= 1.0 / 16) {
            shear(exact, signs, part, rows);
            if (is_taken(rows)) {
                break;
            }
        }
    }
    for (int i = 0; i < 9; i++) {
        oracle_put(input, rows[i]);
    }
}

static void generate_turned(oracle_random *random, oracle_input *input)
{
    const double scale = oracle_below(random, 4) == 0
                             ? 1
                             : oracle_spread(random, FXL_SCALE_MIN, FXL_SCALE_MAX) / 65536;
    const double reach = oracle_spread(random, 1, 4000);
    const double size = oracle_spread(random, 1.0 / 256, 2300) / (scale > 1 ? scale : 1);
    input->kind = (int)(input->index % 2);
    oracle_put_angles(random, ANGLES, input);
    for (int i = EYE; i < ROWS; i++) {
        oracle_put(input, (int64_t)(oracle_uniform(random, -reach, reach) * 65536));
    }
    put_rows(random, input->kind == 1, input);
    oracle_put(input, (int64_t)(scale * 65536));
    for (int i = VERTEX; i < NUMBERS; i++) {
        oracle_put(input, (int64_t)(oracle_uniform(random, -size, size) * 65536));
    }
}

typedef struct {
    fxl_point vertex;
    uint16_t index;
    fxl_model model;
    fxl_instance instance;
    fxl_placement placement;
    fxl_scene scene;
    fxl_view view;
} turned_sample;

static bool read_sample(const int64_t *n, turned_sample *sample)
{
    fxl_lens lens;
    const fxl_pose pose = {.position = {(int32_t)n[EYE], (int32_t)n[EYE + 1], (int32_t)n[EYE + 2]},
                           .yaw = (uint32_t)n[0],
                           .pitch = (uint32_t)n[1],
                           .roll = (uint32_t)n[2]};
    for (int i = 0; i < 9; i++) {
        (&sample->placement.orientation.x.x)[i] = (int32_t)n[ROWS + i];
    }
    const double length =
        sqrt((double)n[VERTEX] * (double)n[VERTEX] + (double)n[VERTEX + 1] * (double)n[VERTEX + 1] +
             (double)n[VERTEX + 2] * (double)n[VERTEX + 2]);
    if (length > FXL_RADIUS_MAX - 2) {
        return false;
    }
    sample->placement.scale = (int32_t)n[SCALE];
    sample->vertex =
        (fxl_point){(int32_t)n[VERTEX], (int32_t)n[VERTEX + 1], (int32_t)n[VERTEX + 2]};
    sample->index = 0;
    sample->model = (fxl_model){.vertex_count = 1, .radius = (int32_t)length + 1};
    sample->instance = (fxl_instance){
        {(int32_t)n[CENTRE], (int32_t)n[CENTRE + 1], (int32_t)n[CENTRE + 2]}, 0, 0, 0};
    sample->scene = (fxl_scene){.vertices = &sample->vertex,
                                .indices = &sample->index,
                                .models = &sample->model,
                                .instances = &sample->instance,
                                .vertex_count = 1,
                                .index_count = 1,
                                .model_count = 1,
                                .instance_count = 1,
                                .placements = &sample->placement,
                                .placement_code = &fxl_turned_instances};
    if (fxl_lens_from_fov(320, 240, FXL_ANGLE_QUARTER, 4096, FXL_FAR_MAX, 0, &lens) != FXL_OK) {
        return false;
    }
    fxl_view_set_lens(&sample->view, &lens);
    return fxl_view_set_pose(&sample->view, &pose) == FXL_OK &&
           fxl_placement_check(&sample->placement, &sample->instance.centre,
                               sample->model.radius) == FXL_OK;
}

/* row . O . vertex times the scale, in units of 2^-92. Row and O are of about unit length, 2^30,
 * and the scaled vertex is within 2^13 world units, 2^45: below 2^106. */
static oracle_wide exact_along(const fxl_direction *row, const turned_sample *sample)
{
    const int32_t of[3] = {row->x, row->y, row->z};
    const int32_t v[3] = {sample->vertex.x, sample->vertex.y, sample->vertex.z};
    const int32_t *o = &sample->placement.orientation.x.x;
    oracle_wide sum = 0;
    for (int i = 0; i < 9; i++) {
        sum += (oracle_wide)of[i / 3] * o[i] * v[i % 3];
    }
    return sum * sample->placement.scale;
}

/* What the library adds to the place of the centre, as a share of what an entry's rounding may
 * cost, 2^(k - 31), times the sum of the vertex's coordinates. */
static double share_of(const turned_sample *sample, const fxl_direction *row, int64_t added)
{
    int k = 0;
    while (65536 << k < sample->placement.scale) {
        k++;
    }
    const double sum = fabs((double)sample->vertex.x) + fabs((double)sample->vertex.y) +
                       fabs((double)sample->vertex.z);
    const oracle_wide off = ((oracle_wide)added << 46) - exact_along(row, sample);
    return sum == 0 ? (off == 0 ? 0 : ORACLE_REFUSED)
                    : fabs(ldexp((double)off, -92)) / ldexp(sum, k - 31 - 16);
}

static oracle_outcome judge_turned(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static turned_sample sample;
    static fxl_vertex_cache cache;
    static fxl_turned_view turned;
    fxl_cached_vertex entry = {.tag = 0};
    const int64_t *n = input->numbers;
    if (input->count != NUMBERS || !oracle_are_angles(n, ANGLES) ||
        !oracle_are_words(n + ANGLES, NUMBERS - ANGLES)) {
        return ORACLE_UNUSABLE;
    }
    if (!read_sample(n, &sample)) {
        return ORACLE_SKIPPED;
    }
    (void)fxl_turned_view_of_instance(&turned, &sample.scene, 0, &sample.view, &cache, 0);
    fxl_transform_vertex(&turned.model_view, 0, &entry);
    const fxl_axes *axes = &sample.view.camera.axes;
    const int64_t from_eye[3] = {n[CENTRE], n[CENTRE + 1], n[CENTRE + 2]};
    const oracle_view_point centre = oracle_transform(&sample.view.camera, from_eye);
    const double shares[3] = {share_of(&sample, &axes->right, entry.position.x - centre.x),
                              share_of(&sample, &axes->up, entry.position.y - centre.y),
                              share_of(&sample, &axes->forward, entry.position.z - centre.z)};
    for (int i = 0; i < 3; i++) {
        verdict->value = fmax(verdict->value, shares[i]);
        if (words) {
            fprintf(words, "%c in the view: %9.6f of its bound\n", "xyz"[i], shares[i]);
        }
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_vertex_turned = {
    .id = "vertex_turned",
    .unit = "of its bound",
    .numbers = "yaw pitch roll of the camera, eye x y z, centre x y z, nine entries of the "
               "orientation, scale, vertex x y z",
    .kinds = {"orientations as they are made", "rows at a corner of the tolerance"},
    .generate = generate_turned,
    .judge = judge_turned,
};
