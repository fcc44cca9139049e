/* SPDX-License-Identifier: MIT */
/* orthographic_vertex, orthographic_texel and orthographic_depth: vertices, textures and depth with an
 * orthographic lens (docs/extras/orthographic.md), given the camera's rows. */
#include <math.h>

#include "draw/renderer.h"
#include "oracle/depth.h"
#include "oracle/surface_sample.h"

#define LENS_TEXT "width height, less the scale, near far 0, eye x y z yaw pitch roll, centre x y"

/* --- samples ---------------------------------------------------------------------------------- */

static double scale_of(const oracle_input *input)
{
    return ldexp(-(double)input->numbers[2], -16);
}

/* The point of the view that the centre of a pixel shows at a depth, from the middle of the screen. */
static void point_of(const oracle_input *input, const int64_t pixel[2], double z, double point[3])
{
    const int64_t *n = input->numbers;
    point[0] = ((double)pixel[0] + 0.5 - (double)n[0] / 2) / scale_of(input);
    point[1] = ((double)n[1] / 2 - (double)pixel[1] - 0.5) / scale_of(input);
    point[2] = z;
}

/* Three corners about a point of the view, clockwise, with edges up to so many pixels. */
static void triangle_about(oracle_random *random, const oracle_input *input, const double point[3],
                           double most, double view[3][3])
{
    static const double ahead[3] = {0, 0, 1};
    oracle_triangle_about(random, ahead, most / scale_of(input), view);
    const double along = (view[1][0] - view[0][0]) * (view[2][1] - view[0][1]) -
                         (view[1][1] - view[0][1]) * (view[2][0] - view[0][0]);
    for (int k = 0; k < 3; k++) {
        const double second = view[1][k];
        view[1][k] = along > 0 ? view[2][k] : second;
        view[2][k] = along > 0 ? second : view[2][k];
        for (int i = 0; i < 3; i++) {
            view[i][k] += point[k] - ahead[k];
        }
    }
}

/* A depth between near and far, and in the world. */
static double any_depth(oracle_random *random, const oracle_input *input)
{
    const double near = (double)input->numbers[3] / 65536, far = (double)input->numbers[4] / 65536;
    return oracle_uniform(random, near, fmin(far, near + 8000));
}

static void put_pixel(oracle_random *random, oracle_input *input)
{
    oracle_put(input, oracle_between(random, 0, input->numbers[0] - 1));
    oracle_put(input, oracle_between(random, 0, input->numbers[1] - 1));
}

/* Corners in the view from the pose's eye, which an off-centre lens moves. */
static void find_corners(const oracle_setup *setup, const fxl_point points[3],
                         oracle_view_point corners[3])
{
    fxl_camera camera = setup->view.camera;
    camera.position = setup->pose.position;
    for (int i = 0; i < 3; i++) {
        const int64_t point[3] = {points[i].x, points[i].y, points[i].z};
        corners[i] = oracle_transform(&camera, point);
    }
}

/* --- vertices --------------------------------------------------------------------------------- */

static void generate_vertex(oracle_random *random, oracle_input *input)
{
    oracle_setup_generate_orthographic(random, FXL_SCREEN_MAX, input);
    input->kind = (int)oracle_below(random, 2);
    for (int tries = 0; tries < 64; tries++) {
        const int64_t pixel[2] = {oracle_between(random, 0, input->numbers[0] - 1),
                                  oracle_between(random, 0, input->numbers[1] - 1)};
        double point[3];
        point_of(input, pixel, any_depth(random, input), point);
        if (input->kind == 1) { /* around the screen, as faces that planes cut have vertices */
            for (int k = 0; k < 2; k++) {
                point[k] += oracle_uniform(random, -2000, 2000) / scale_of(input);
            }
        }
        input->count = ORACLE_SETUP_NUMBERS;
        if (oracle_put_point(input, point)) {
            return;
        }
    }
}

/* |got - scale side| in units of 1/65536 pixel: the scale has 16 bits of fraction, and the side 46. */
static double error_of(int64_t got, int64_t scale, int64_t side)
{
    return fabs(ldexp((double)(((oracle_wide)got << 46) - (oracle_wide)scale * side), -46));
}

static oracle_outcome judge_vertex(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    oracle_setup setup;
    if (input->count != ORACLE_SETUP_NUMBERS + 3 || !oracle_setup_is_orthographic(input) ||
        !oracle_setup_read(input, &setup)) {
        return ORACLE_UNUSABLE;
    }
    const int64_t *at = &input->numbers[ORACLE_SETUP_NUMBERS];
    fxl_point vertex = {(int32_t)at[0], (int32_t)at[1], (int32_t)at[2]};
    if (!fxl_point_in_range(&vertex)) {
        return ORACLE_UNUSABLE;
    }
    const fxl_point same[3] = {vertex, vertex, vertex};
    const fxl_lens *lens = &setup.view.lens;
    oracle_view_point exact[3];
    fxl_view_point view;
    fxl_screen_point screen;
    find_corners(&setup, same, exact);
    fxl_transform_point(&setup.view.camera, &vertex, &view);
    if (fxl_project_orthographic(&setup.view, &view, &screen) != FXL_OK) {
        return ORACLE_SKIPPED; /* beyond the coordinates of the screen */
    }
    const double x = error_of((int64_t)screen.x - lens->centre_x, lens->focal, exact[0].x);
    const double y = error_of((int64_t)lens->centre_y - screen.y, lens->focal, exact[0].y);
    verdict->value = fmax(x, y);
    if (words) {
        fprintf(words, "pixel (%.9g, %.9g), off by %.9g and %.9g of 1/65536 pixel\n",
                screen.x / 65536.0, screen.y / 65536.0, x, y);
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_orthographic_vertex = {
    .id = "orthographic_vertex",
    .unit = "1/65536 pixel",
    .numbers = LENS_TEXT ", vertex x y z",
    .kinds = {"in sight", "about the screen"},
    .generate = generate_vertex,
    .judge = judge_vertex,
};

/* --- textures --------------------------------------------------------------------------------- */

/* place sampling: the claims of texels */
static void generate_texel(oracle_random *random, oracle_input *input)
{
    oracle_setup_generate_orthographic(random, FXL_SCREEN_MAX, input);
    for (int tries = 0; tries < 64; tries++) {
        const double size = oracle_spread(random, 65536, 2000 * 65536.0);
        double point[3], view[3][3];
        int inside = 1;
        input->count = ORACLE_SETUP_NUMBERS;
        put_pixel(random, input);
        point_of(input, &input->numbers[ORACLE_SETUP_NUMBERS], any_depth(random, input), point);
        triangle_about(random, input, point, oracle_spread(random, 1000, 20000), view);
        for (int i = 0; i < 3; i++) {
            inside &= oracle_put_point(input, view[i]);
            oracle_put(input, (int64_t)oracle_uniform(random, -size, size));
            oracle_put(input, (int64_t)oracle_uniform(random, -size, size));
            oracle_put(input, 0);
        }
        oracle_put(input, oracle_between(random, 1, 7));
        if (inside) {
            return;
        }
    }
}

int surface_sample_make_orthographic(surface_sample *sample)
{
    fxl_view *view = &sample->setup.view;
    oracle_view_point corners[3], *p = sample->on_screen;
    find_corners(&sample->setup, sample->corners, corners);
    view->projection.centre_x = view->lens.centre_x;
    view->projection.centre_y = view->lens.centre_y;
    for (int i = 0; i < 3; i++) {
        const oracle_wide scale = view->lens.focal, half = (oracle_wide)1 << 31;
        const oracle_wide x = (scale * corners[i].x + half) >> 32,
                          y = (scale * corners[i].y + half) >> 32;
        if (x > INT64_MAX / 4 || x < -INT64_MAX / 4 || y > INT64_MAX / 4 || y < -INT64_MAX / 4) {
            return 0;
        }
        p[i] =
            (oracle_view_point){(int64_t)x, (int64_t)y, (int64_t)fxl_view_drawn_focal(view) << 14};
    }
    sample->is_affine = 1;
    return (oracle_wide)(p[1].x - p[0].x) * (p[2].y - p[0].y) !=
           (oracle_wide)(p[2].x - p[0].x) * (p[1].y - p[0].y);
}

const oracle_claim oracle_orthographic_texel = {
    .id = "orthographic_texel",
    .unit = "texel",
    .numbers = LENS_TEXT ", column row, three corners x y z u v light, log2 of the texture's side",
    .kinds = {"anywhere in sight"},
    .extras = {"beyond_own_bound", "not_judged"},
    .variant = FXL_DIVIDE_16,
    .generate = generate_texel,
    .judge = surface_judge_texel,
};

/* --- depth ------------------------------------------------------------------------------------ */

/* The depths differ by 2^-20 to 2^-11 of what is between near and far. */
static void generate_depth(oracle_random *random, oracle_input *input)
{
    oracle_setup_generate_orthographic(random, FXL_SCREEN_MAX, input);
    for (int tries = 0; tries < 64; tries++) {
        const double range = (double)(input->numbers[4] - input->numbers[3]) / 65536;
        const double z = any_depth(random, input);
        const double depths[DEPTH_FACES] = {z, z + range * oracle_spread(random, 0x1p-20, 0x1p-11)};
        int inside = 1;
        input->count = ORACLE_SETUP_NUMBERS;
        put_pixel(random, input);
        for (int face = 0; face < DEPTH_FACES; face++) {
            double point[3], view[3][3];
            point_of(input, &input->numbers[ORACLE_SETUP_NUMBERS], depths[face], point);
            triangle_about(random, input, point, oracle_spread(random, 4, 4000), view);
            for (int i = 0; i < 3; i++) {
                inside &= oracle_put_point(input, view[i]);
            }
        }
        if (inside) {
            return;
        }
    }
}

/* The depth of a face's plane at the pixel: volume / weight in units of 2^-46; and how far it may be off, in world
 * units. */
typedef struct {
    mpz_t volume, weight;
    double slack;
} pixel_depth;

/* The plane may be off by 2^-26 of the face's size along its normal, and the depth by 2^-27 and by what
 * 1/65536 of a column and of a row change it. Returns 0 where that is so much that the face counts as infinite, and where it is seen edge-on. */
static int find_depth(const depth_sample *sample, int face, pixel_depth *depth)
{
    const fxl_lens *lens = &sample->lens;
    /* place fill-rule: definition of a ray through the centre of a pixel */
    const int64_t away[3] = {sample->pixel[0] * 65536 + 32768 - lens->centre_x,
                             lens->centre_y - 32768 - sample->pixel[1] * 65536, 0};
    oracle_view_point corners[3];
    oracle_vector planes[3];
    mpz_t side;
    find_corners(&sample->setup, &sample->corners[3 * face], corners);
    oracle_vectors_init(planes, 3);
    mpz_init(side);
    oracle_triangle_planes(corners, planes);
    const int64_t first[3] = {corners[0].x, corners[0].y, corners[0].z};
    oracle_vector_dot(depth->volume, &planes[0], first);
    mpz_mul_si(depth->volume, depth->volume, lens->focal);
    oracle_vector_dot(side, &planes[0], away);
    mpz_mul_2exp(side, side, 46);
    mpz_sub(depth->volume, depth->volume, side);
    mpz_mul_si(depth->weight, planes[0].c[2], lens->focal);
    const double n[3] = {mpz_get_d(planes[0].c[0]), mpz_get_d(planes[0].c[1]),
                         mpz_get_d(planes[0].c[2])};
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double range = ldexp(lens->far_z - lens->near_z, -16);
    const double along = fabs(n[0] / n[2]) * 0x1p16 / lens->focal,
                 down = fabs(n[1] / n[2]) * 0x1p16 / lens->focal;
    double size = 0;
    for (int i = 1; i < 3; i++) {
        size = fmax(size, hypot(hypot((double)(corners[i].x - corners[0].x),
                                      (double)(corners[i].y - corners[0].y)),
                                (double)(corners[i].z - corners[0].z)));
    }
    depth->slack = 0x1p-26 * ldexp(size, -46) * length / fabs(n[2]) + 0x1p-16 * (along + down) +
                   0x1p-26 * range;
    oracle_vectors_clear(planes, 3);
    mpz_clear(side);
    return n[2] != 0 && fabs(n[2]) > 0x1p-20 * length && fmax(along, down) < 127 * 2 * range;
}

/* How much farther the second face is, in world units. */
static int find_gap(const depth_sample *sample, double *gap, double *slack)
{
    pixel_depth depths[DEPTH_FACES];
    int there = 1;
    for (int i = 0; i < DEPTH_FACES; i++) {
        mpz_init(depths[i].volume);
        mpz_init(depths[i].weight);
        there &= find_depth(sample, i, &depths[i]);
    }
    if (there) {
        const double weight = mpz_get_d(depths[0].weight) * mpz_get_d(depths[1].weight);
        mpz_mul(depths[0].volume, depths[0].volume, depths[1].weight);
        mpz_mul(depths[1].volume, depths[1].volume, depths[0].weight);
        mpz_sub(depths[1].volume, depths[1].volume, depths[0].volume);
        *gap = ldexp(mpz_get_d(depths[1].volume) / weight, -46);
        *slack = depths[0].slack + depths[1].slack;
    }
    for (int i = 0; i < DEPTH_FACES; i++) {
        mpz_clear(depths[i].volume);
        mpz_clear(depths[i].weight);
    }
    return there;
}

static oracle_outcome judge_depth(const oracle_input *input, FILE *words, oracle_verdict *verdict)
{
    static depth_sample sample;
    double gap, slack;
    if (input->count != DEPTH_NUMBERS || !oracle_setup_is_orthographic(input)) {
        return ORACLE_UNUSABLE;
    }
    if (!depth_sample_read(input, &sample) || !find_gap(&sample, &gap, &slack)) {
        return ORACLE_SKIPPED;
    }
    /* A code is below what it stands for by 1/64 at most. */
    const double range = (double)(sample.lens.far_z - sample.lens.near_z) / 65536;
    const double allowed = range / 32768 * (1 + 1.0 / 32) + slack;
    const int nearer = gap > 0 ? 0 : 1, shown = depth_sample_drawn(&sample, 0);
    if (shown < 0 || !depth_sample_covers(&sample, nearer)) {
        return ORACLE_SKIPPED;
    }
    verdict->value = shown != nearer ? fabs(gap) / allowed : 0;
    verdict->extras[0] = shown != nearer;
    if (words) {
        fprintf(words, "the %s face is nearer, by %.9g; the %s one shows; the resolution is %.9g\n",
                nearer ? "second" : "first", fabs(gap), shown ? "second" : "first", allowed);
    }
    return ORACLE_COUNTED;
}

const oracle_claim oracle_orthographic_depth = {
    .id = "orthographic_depth",
    .unit = "of its bound",
    .numbers = LENS_TEXT ", column row, six corners x y z",
    .kinds = {"two faces through a pixel"},
    .extras = {"farther_one_shown"},
    .generate = generate_depth,
    .judge = judge_depth,
};
