/* SPDX-License-Identifier: MIT */
#include "oracle/setup.h"

#include <math.h>
#include <stdlib.h>

static int in_32_bits(int64_t number)
{
    return number >= INT32_MIN && number <= INT32_MAX;
}

int oracle_setup_is_orthographic(const oracle_input *input)
{
    return input->count >= ORACLE_SETUP_NUMBERS && input->numbers[2] < 0;
}

static fxl_status make_lens(const oracle_input *input, fxl_lens *lens)
{
    const int64_t *n = input->numbers;
    return oracle_setup_is_orthographic(input)
               ? fxl_lens_orthographic((uint16_t)n[0], (uint16_t)n[1], (int32_t)-n[2],
                                       (int32_t)n[3], (int32_t)n[4], lens)
               : fxl_lens_from_fov((uint16_t)n[0], (uint16_t)n[1], (uint32_t)n[2], (int32_t)n[3],
                                   (int32_t)n[4], (int32_t)n[5], lens);
}

int oracle_setup_lens(const oracle_input *input, fxl_lens *lens)
{
    const int64_t *n = input->numbers;
    return make_lens(input, lens) == FXL_OK &&
           fxl_lens_set_centre(lens, (int32_t)n[12], (int32_t)n[13]) == FXL_OK;
}

int oracle_setup_read(const oracle_input *input, oracle_setup *setup)
{
    const int64_t *n = input->numbers;
    if (input->count < ORACLE_SETUP_NUMBERS || n[0] < 0 || n[0] > UINT16_MAX || n[1] < 0 ||
        n[1] > UINT16_MAX) {
        return 0;
    }
    for (int i = 2; i < ORACLE_SETUP_NUMBERS; i++) {
        int is_angle = (i == 2 && n[i] >= 0) || (i >= 9 && i <= 11);
        if (is_angle ? n[i] < 0 || n[i] > UINT32_MAX : !in_32_bits(n[i])) {
            return 0;
        }
    }
    setup->pose = (fxl_pose){.position = {(int32_t)n[6], (int32_t)n[7], (int32_t)n[8]},
                             .yaw = (uint32_t)n[9],
                             .pitch = (uint32_t)n[10],
                             .roll = (uint32_t)n[11]};
    fxl_lens lens;
    if (!oracle_setup_lens(input, &lens)) {
        return 0;
    }
    fxl_view_set_lens(&setup->view, &lens);
    if (fxl_view_set_pose(&setup->view, &setup->pose) != FXL_OK) {
        return 0;
    }
    if (!oracle_setup_is_orthographic(input)) {
        setup->view.lens = fxl_view_drawn_lens(&setup->view);
    }
    return 1;
}

static int side(oracle_random *random, int usual, int side_max)
{
    switch (oracle_below(random, 4)) {
    case 0:
        return side_max;
    case 1:
        return 1 + (int)oracle_below(random, (uint32_t)side_max);
    default:
        return usual < side_max ? usual : side_max;
    }
}

static int64_t field_of_view(oracle_random *random)
{
    static const int64_t some[] = {FXL_FOV_MIN, FXL_FOV_MAX, 715827883, FXL_ANGLE_QUARTER};
    uint32_t which = oracle_below(random, 8);
    return which < 4 ? some[which] : oracle_between(random, FXL_FOV_MIN + 1, FXL_FOV_MAX - 1);
}

static void generate_depths(oracle_random *random, oracle_input *input)
{
    static const int32_t nears[] = {FXL_NEAR_MIN, FXL_NEAR_MIN, 4096, 16384, 65536, 262144};
    static const int32_t insets[] = {4, 4, 4, 0, 0};
    uint32_t which = oracle_below(random, 12);
    int64_t near =
        which < 6 ? nears[which] : (int64_t)oracle_spread(random, FXL_NEAR_MIN, 64 * 65536.0);
    which = oracle_below(random, 8);
    int64_t inset = which < 5 ? insets[which] : (int64_t)oracle_spread(random, 1, 65536);
    int64_t far = FXL_FAR_MAX;
    if (oracle_below(random, 2)) {
        far = (int64_t)oracle_spread(random, (double)(near + 2 * inset + 1), FXL_FAR_MAX) + 1;
    }
    oracle_put(input, near);
    oracle_put(input, far);
    oracle_put(input, inset);
}

static double focal_of(const oracle_input *input)
{
    const int64_t *n = input->numbers;
    return (double)n[0] / 2 / tan(ldexp((double)n[2], -32) * 3.141592653589793);
}

/* A third of the lenses have their centre elsewhere, a quarter of these at the end of its range. */
static void generate_centre(oracle_random *random, oracle_input *input)
{
    int64_t *n = input->numbers;
    const int moved = oracle_below(random, 3) == 0;
    const double focal = focal_of(input);
    if (moved) {
        n[5] = 0; /* no inset */
    }
    for (int i = 0; i < 2; i++) {
        const double most = floor(fmin(1.5 * (double)n[i], 4 * focal - 1.0 / 1024) * 65536);
        const double offset = oracle_below(random, 4) ? oracle_uniform(random, -most, most) : most;
        oracle_put(input, n[i] * 32768 + (moved ? (int64_t)offset : 0));
    }
}

static uint32_t angle(oracle_random *random)
{
    uint32_t any = (uint32_t)oracle_random_next(random);
    switch (oracle_below(random, 8)) {
    case 0:
        return any & 0xC0000000u;
    case 1:
        return (any & 0xE0000000u) + (uint32_t)(int32_t)oracle_signed_spread(random, 1, 1 << 24);
    default:
        return any;
    }
}

static void generate_pose(oracle_random *random, oracle_input *input)
{
    double reach = oracle_below(random, 4) ? oracle_spread(random, 1, 8191) : 8191;
    int at_ends = oracle_below(random, 16) == 0;
    for (int i = 0; i < 3; i++) {
        int64_t position = (int64_t)(oracle_uniform(random, -reach, reach) * 65536);
        if (at_ends && oracle_below(random, 2)) {
            position = oracle_below(random, 2) ? FXL_COORDINATE_MAX : -FXL_COORDINATE_MAX;
        }
        oracle_put(input, position);
    }
    int quarters = oracle_below(random, 8) == 0;
    for (int i = 0; i < 3; i++) {
        oracle_put(input, quarters ? angle(random) & 0xC0000000u : angle(random));
    }
}

void oracle_setup_generate(oracle_random *random, int side_max, oracle_input *input)
{
    oracle_put(input, side(random, 320, side_max));
    oracle_put(input, side(random, 240, side_max));
    oracle_put(input, field_of_view(random));
    generate_depths(random, input);
    generate_pose(random, input);
    generate_centre(random, input);
}

void oracle_setup_generate_orthographic(oracle_random *random, int side_max, oracle_input *input)
{
    oracle_setup setup;
    for (int tries = 0; tries < 64; tries++) {
        const int moved = oracle_below(random, 3) == 0;
        input->count = 0;
        oracle_put(input, side(random, 320, side_max));
        oracle_put(input, side(random, 240, side_max));
        oracle_put(input, -(int64_t)oracle_spread(random, FXL_ORTHOGRAPHIC_SCALE_MIN,
                                                  FXL_ORTHOGRAPHIC_SCALE_MAX + 1));
        generate_depths(random, input);
        input->numbers[5] = 0; /* no inset */
        generate_pose(random, input);
        for (int i = 0; i < 2; i++) {
            oracle_put(input, input->numbers[i] * 32768 +
                                  (moved ? oracle_between(random, -FXL_ORTHOGRAPHIC_CENTRE_MAX,
                                                          FXL_ORTHOGRAPHIC_CENTRE_MAX)
                                         : 0));
        }
        if (oracle_setup_read(input, &setup)) {
            return;
        }
    }
}

void oracle_to_world(const oracle_input *input, const double view[3], double world[3])
{
    double s[3], c[3]; /* yaw, pitch, roll */
    for (int i = 0; i < 3; i++) {
        double radians = ldexp((double)input->numbers[9 + i], -32) * 6.283185307179586;
        s[i] = sin(radians);
        c[i] = cos(radians);
    }
    double right[3] = {c[2] * c[0] - s[2] * s[1] * s[0], s[2] * c[1],
                       -c[2] * s[0] - s[2] * s[1] * c[0]};
    double up[3] = {-s[2] * c[0] - c[2] * s[1] * s[0], c[2] * c[1],
                    s[2] * s[0] - c[2] * s[1] * c[0]};
    double forward[3] = {c[1] * s[0], s[1], c[1] * c[0]};
    const int64_t *n = input->numbers;
    const double scale = oracle_setup_is_orthographic(input) ? -1 / (double)n[2]
                                                             : view[2] / (65536 * focal_of(input));
    const double x = view[0] - (double)(n[12] - n[0] * 32768) * scale;
    const double y = view[1] - (double)(n[1] * 32768 - n[13]) * scale;
    for (int i = 0; i < 3; i++) {
        world[i] = x * right[i] + y * up[i] + view[2] * forward[i];
    }
}

int oracle_put_point(oracle_input *input, const double view[3])
{
    double world[3];
    int inside = 1;
    oracle_to_world(input, view, world);
    for (int k = 0; k < 3; k++) {
        const int64_t coordinate = input->numbers[6 + k] + (int64_t)floor(world[k] * 65536 + 0.5);
        inside = inside && llabs(coordinate) <= FXL_COORDINATE_MAX;
        oracle_put(input, coordinate);
    }
    return inside;
}

static int64_t dot(const fxl_direction *row, const int64_t d[3])
{
    /* Below 2^61: SPEC.md, section 3. */
    return (int64_t)((oracle_wide)row->x * d[0] + (oracle_wide)row->y * d[1] +
                     (oracle_wide)row->z * d[2]);
}

oracle_view_point oracle_transform(const fxl_camera *camera, const int64_t point[3])
{
    int64_t d[3] = {point[0] - camera->position.x, point[1] - camera->position.y,
                    point[2] - camera->position.z};
    return (oracle_view_point){dot(&camera->axes.right, d), dot(&camera->axes.up, d),
                               dot(&camera->axes.forward, d)};
}

oracle_wide oracle_distance(const fxl_view_frustum *frustum, int plane,
                            const oracle_view_point *point)
{
    const oracle_wide one = FXL_Q2_30_ONE;
    oracle_wide x = (oracle_wide)frustum->x_side * point->x;
    oracle_wide y = (oracle_wide)frustum->y_side * point->y;
    oracle_wide depth_x = (oracle_wide)frustum->x_depth * point->z - one * frustum->inset;
    oracle_wide depth_y = (oracle_wide)frustum->y_depth * point->z - one * frustum->inset;
    switch (plane) {
    case FXL_PLANE_LEFT:
        return depth_x + x;
    case FXL_PLANE_RIGHT:
        return depth_x - x;
    case FXL_PLANE_BOTTOM:
        return depth_y + y;
    case FXL_PLANE_TOP:
        return depth_y - y;
    case FXL_PLANE_NEAR:
        return one * point->z - one * frustum->near_z;
    default:
        return one * frustum->far_z - one * point->z;
    }
}
