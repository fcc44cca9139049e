/* SPDX-License-Identifier: MIT */
#include "designs/stage.h"

#include <math.h>

static uint8_t division_of(enum designs_stage stage)
{
    return stage == DESIGNS_TEXEL_16       ? FXL_DIVIDE_16
           : stage == DESIGNS_TEXEL_8      ? FXL_DIVIDE_8
           : stage == DESIGNS_TEXEL_AFFINE ? FXL_AFFINE
                                           : FXL_DIVIDE_1;
}

static bool is_depth(enum designs_stage stage)
{
    return stage == DESIGNS_DEPTH_16 || stage == DESIGNS_DEPTH_32;
}

/* --- reading -------------------------------------------------------------------------------- */

static bool is_before_near(const oracle_setup *setup, const fxl_point *corner)
{
    const int64_t point[3] = {corner->x, corner->y, corner->z};
    return oracle_transform(&setup->view.camera, point).z <
           (int64_t)setup->view.lens.near_z * (1 << 30);
}

static bool read_surface(enum designs_stage stage, const oracle_input *face,
                         designs_surface *surface)
{
    const int count = stage == DESIGNS_LIGHT ? SURFACE_LIGHT_NUMBERS : SURFACE_NUMBERS;
    if (face->count != count || !surface_sample_read(face, &surface->sample)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        if (is_before_near(&surface->sample.setup, &surface->sample.corners[i])) {
            return false;
        }
    }
    if (stage == DESIGNS_LIGHT) {
        surface_sample_light(face, &surface->sample, surface->normals, &surface->light);
        return designs_fixel.level(surface) >= 0;
    }
    return (stage != DESIGNS_TEXEL_AFFINE || surface_sample_make_affine(&surface->sample)) &&
           designs_fixel.texel(surface, FXL_DIVIDE_1) >= 0;
}

static bool read_faces(const oracle_input *face, depth_sample *faces)
{
    if (face->count != DEPTH_NUMBERS || !depth_sample_read(face, faces)) {
        return false;
    }
    for (int i = 0; i < 3 * DEPTH_FACES; i++) {
        if (is_before_near(&faces->setup, &faces->corners[i])) {
            return false;
        }
    }
    double gap, slack;
    return depth_sample_gap(faces, &gap, &slack) && depth_sample_covers(faces, 0) &&
           depth_sample_covers(faces, 1);
}

bool designs_is_surface(enum designs_stage stage, const oracle_input *face)
{
    static designs_surface surface;
    static depth_sample faces;
    return is_depth(stage) ? read_faces(face, &faces) : read_surface(stage, face, &surface);
}

/* --- samples -------------------------------------------------------------------------------- */

static double between(oracle_random *random, designs_range range)
{
    return range.low < range.high ? oracle_spread(random, range.low, range.high) : range.low;
}

/* The view of the other stages' samples: 320 x 240 pixels, a centred lens. */
static void put_setup(const designs_plan *plan, oracle_random *random, oracle_input *face)
{
    const double degrees = oracle_uniform(random, plan->fov.low, plan->fov.high);
    const double fov = degrees * (4294967296.0 / 360);
    oracle_put(face, 320);
    oracle_put(face, 240);
    oracle_put(face, (int64_t)fmin(fmax(fov, FXL_FOV_MIN), FXL_FOV_MAX));
    oracle_put(face, (int64_t)(between(random, plan->near) * 65536));
    oracle_put(face, plan->far < 16384 ? (int64_t)(plan->far * 65536) : FXL_FAR_MAX);
    oracle_put(face, 4);
    for (int i = 0; i < 3; i++) {
        oracle_put(face, (int64_t)(oracle_uniform(random, -plan->eye, plan->eye) * 65536));
    }
    for (int i = 0; i < 3; i++) {
        oracle_put(face, (int64_t)(oracle_random_next(random) >> 32));
    }
    oracle_put(face, 160 * 65536);
    oracle_put(face, 120 * 65536);
}

static bool put_surface(enum designs_stage stage, const designs_plan *plan, oracle_random *random,
                        double z, oracle_input *face)
{
    const double size = between(random, plan->texels) * 65536;
    double point[3], view[3][3];
    bool inside = true;
    oracle_put(face, oracle_between(random, 0, 319));
    oracle_put(face, oracle_between(random, 0, 239));
    oracle_triangle_point(face, &face->numbers[ORACLE_SETUP_NUMBERS], z, point);
    oracle_triangle_about(random, point, plan->face, view);
    for (int i = 0; i < 3; i++) {
        inside = oracle_put_point(face, view[i]) && inside;
        oracle_put(face, (int64_t)oracle_uniform(random, -size, size));
        oracle_put(face, 0);
        oracle_put(face, 0);
    }
    if (stage == DESIGNS_LIGHT) {
        surface_sample_put_light(random, face);
    }
    return inside;
}

/* Distances that differ by 2^-24 to 1/2 of themselves; in half of the samples the first face is the
 * nearer one. */
static bool put_faces(const designs_plan *plan, oracle_random *random, double z, oracle_input *face)
{
    const double other = z * (1 + oracle_spread(random, 0x1p-24, 0.5));
    const bool first = oracle_below(random, 2) == 0;
    const double depths[DEPTH_FACES] = {first ? z : other, first ? other : z};
    return depth_sample_put(random, depths, plan->face, face);
}

void designs_sample_surface(enum designs_stage stage, const designs_plan *plan,
                            oracle_random *random, designs_input *input)
{
    oracle_random own = {oracle_random_next(random)};
    oracle_input *face = &input->face;
    for (;;) {
        *face = (oracle_input){.count = 0};
        put_setup(plan, &own, face);
        const double near = (double)(face->numbers[3] + 8) / 65536;
        designs_range depth = plan->depth;
        depth.low = fmax(depth.low, near);
        const double z = between(&own, depth);
        const bool inside = is_depth(stage) ? put_faces(plan, &own, z, face)
                                            : put_surface(stage, plan, &own, z, face);
        if (inside && designs_is_surface(stage, face)) {
            return;
        }
    }
}

/* --- errors --------------------------------------------------------------------------------- */

/* place sampling: the texel of a pixel in other arithmetic */
static void measure_texel(enum designs_stage stage, designs_surface *face,
                          double errors[DESIGNS_COUNT])
{
    double bound;
    const int64_t exact = surface_sample_exact(&face->sample, 0, &bound);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        const int texel = designs_all[i]->texel(face, division_of(stage));
        errors[i] = surface_texel_distance(exact, texel, DESIGNS_TEXEL_LOG);
    }
}

static void measure_level(designs_surface *face, double errors[DESIGNS_COUNT])
{
    double bound;
    const double exact = surface_sample_exact_level(&face->sample, &bound);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        errors[i] = surface_level_distance(exact, designs_all[i]->level(face));
    }
}

static void measure_depth(enum designs_stage stage, const depth_sample *faces,
                          double errors[DESIGNS_COUNT])
{
    double gap = 0, slack;
    (void)depth_sample_gap(faces, &gap, &slack);
    for (int i = 0; i < DESIGNS_COUNT; i++) {
        const int shown = designs_all[i]->nearer(faces, stage == DESIGNS_DEPTH_32);
        errors[i] = shown == (gap > 0 ? 0 : 1) ? 0 : fabs(gap) * 65536;
    }
}

void designs_surface_errors(enum designs_stage stage, const designs_input *input,
                            double errors[DESIGNS_COUNT])
{
    static designs_surface surface;
    static depth_sample faces;
    if (is_depth(stage)) {
        (void)read_faces(&input->face, &faces);
        measure_depth(stage, &faces, errors);
        return;
    }
    (void)read_surface(stage, &input->face, &surface);
    if (stage == DESIGNS_LIGHT) {
        measure_level(&surface, errors);
    } else {
        measure_texel(stage, &surface, errors);
    }
}
