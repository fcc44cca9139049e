/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "reference/camera.h"
#include "reference/placement.h"
#include "stages/bridge.h"
#include "stages/measure.h"

_Static_assert(sizeof(fxl_orientation) == sizeof(int32_t[3][3]), "nine entries");

const stages_tally stages_placement_tally = {
    .stage = "placement",
    .unit = "1/65536 world unit",
    .measure = "largest coordinate difference of a view point of a turned instance from the "
               "reference's, both given the same camera matrix, placement and vertex; facing, "
               "the eye in "
               "the model's space, rounded points and normals and the radius must be equal",
    .bound = "2^(shift - 31) (|x| + |y| + |z|) of the vertex, in 1/65536 unit",
};

static double uniform(stages_random *random)
{
    return stages_random_below(random, 1u << 30) / (double)(1 << 30);
}

/* From a random unit quaternion. */
static void random_rows(stages_random *random, int32_t rows[3][3])
{
    double q[4], length = 0;
    for (int i = 0; i < 4; i++) {
        q[i] = uniform(random) - 0.5;
        length += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++) {
        q[i] = length > 0 ? q[i] / sqrt(length) : i == 0;
    }
    const double a = q[0], b = q[1], c = q[2], d = q[3];
    const double exact[3][3] = {
        {1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)},
        {2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)},
        {2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)}};
    for (int i = 0; i < 9; i++) {
        rows[i / 3][i % 3] = (int32_t)floor(exact[i / 3][i % 3] * 0x1p30 + 0.5);
    }
}

typedef struct {
    fxl_placement placement;
    ref_placement exact;
    fxl_q16_16 radius;
    fxl_point centre, vertex;
} instance;

static int32_t within(stages_random *random, int32_t limit)
{
    return (int32_t)stages_random_below(random, 2 * (uint32_t)limit + 1) - limit;
}

static instance random_instance(stages_random *random)
{
    instance of;
    random_rows(random, of.exact.rows);
    memcpy(&of.placement.orientation, of.exact.rows, sizeof of.exact.rows);
    of.placement.scale = stages_random_below(random, 4) == 0
                             ? FXL_Q16_16_ONE
                             : (int32_t)exp2(8 + 16 * uniform(random));
    of.exact.scale = of.placement.scale;
    const int64_t most =
        ((int64_t)(FXL_COORDINATE_MAX - FXL_PLACEMENT_SLACK) << 16) / of.placement.scale;
    of.radius = most < FXL_RADIUS_MAX ? (fxl_q16_16)most : FXL_RADIUS_MAX;
    of.radius >>= stages_random_below(random, 16);
    const int32_t side = (int32_t)((int64_t)of.radius * 577 / 1000);
    of.vertex = (fxl_point){within(random, side), within(random, side), within(random, side)};
    const int32_t free = FXL_COORDINATE_MAX - fxl_placement_radius(&of.placement, of.radius);
    of.centre = (fxl_point){within(random, free), within(random, free), within(random, free)};
    return of;
}

static ref_lattice_point lattice(const fxl_point *point)
{
    return (ref_lattice_point){point->x, point->y, point->z};
}

static bool same(const fxl_point *point, const ref_lattice_point *exact)
{
    return point->x == exact->x && point->y == exact->y && point->z == exact->z;
}

static int64_t along(const fxl_direction *axis, const fxl_point *point)
{
    return (int64_t)axis->x * point->x + (int64_t)axis->y * point->y + (int64_t)axis->z * point->z;
}

/* The view point by the library's matrix: t + 2^shift M . v. */
static void measure_vertex(stages_tally *tally, const fxl_camera *camera, const instance *of,
                           const fxl_point *from_eye)
{
    fxl_axes matrix;
    const unsigned shift = fxl_placement_matrix(&of->placement, &camera->axes, &matrix);
    const int64_t scale = (int64_t)1 << shift;
    const fxl_view_point fixed = {
        along(&camera->axes.right, from_eye) + scale * along(&matrix.right, &of->vertex),
        along(&camera->axes.up, from_eye) + scale * along(&matrix.up, &of->vertex),
        along(&camera->axes.forward, from_eye) + scale * along(&matrix.forward, &of->vertex)};
    const ref_camera exact_camera = bridge_camera(camera);
    const ref_lattice_point centre = lattice(&of->centre), vertex = lattice(&of->vertex);
    const ref_point point = ref_placement_point(&of->exact, &centre, &vertex);
    const ref_view_point exact = ref_transform_point(&exact_camera, &point);
    const ref_view_point found = bridge_view_point(&fixed);
    const double difference = (double)fmaxl(
        fabsl(found.x - exact.x), fmaxl(fabsl(found.y - exact.y), fabsl(found.z - exact.z)));
    const double size = fabs((double)vertex.x) + fabs((double)vertex.y) + fabs((double)vertex.z);
    /* 1e-6 covers the rounding of a point of the world to double, 2^-41 unit a coordinate. */
    stages_count(tally, REF_ONE * difference,
                 REF_ONE * difference <= ldexp(size, (int)shift - 31) + 1e-6);
}

void stages_measure_placement(stages_tally *tally, stages_random *random)
{
    const instance of = random_instance(random);
    const fxl_pose pose = stages_random_pose(random);
    fxl_camera camera;
    if (fxl_placement_check(&of.placement, &of.centre, of.radius) != FXL_OK ||
        fxl_camera_from_pose(&pose, &camera) != FXL_OK) {
        tally->mismatched++;
        return;
    }
    fxl_point near = pose.position, rounded, in_model;
    if (stages_random_below(random,
                            2)) { /* an eye that lies almost on a plane through the vertex */
        fxl_placement_point(&of.placement, &of.centre, &of.vertex, &near);
        camera.position = near;
    }
    const fxl_point from_eye = {of.centre.x - near.x, of.centre.y - near.y, of.centre.z - near.z};
    measure_vertex(tally, &camera, &of, &from_eye);

    const ref_lattice_point centre = lattice(&of.centre), vertex = lattice(&of.vertex),
                            eye = lattice(&near);
    ref_lattice_point exact = ref_placement_rounded(&of.exact, &centre, &vertex);
    fxl_placement_point(&of.placement, &of.centre, &of.vertex, &rounded);
    tally->mismatched += !same(&rounded, &exact);
    const int shift = ref_placement_eye(&of.exact, &centre, &eye, of.radius, &exact);
    tally->mismatched +=
        (int)fxl_placement_eye(&of.placement, &from_eye, of.radius, &in_model) != shift ||
        !same(&in_model, &exact);

    int32_t rows[3][3], turned[3];
    fxl_direction normal, fixed;
    random_rows(random, rows);
    normal = (fxl_direction){rows[0][0], rows[0][1], rows[0][2]};
    fxl_placement_direction(&of.placement, &normal, &fixed);
    ref_placement_normal(&of.exact, rows[0], turned);
    tally->mismatched += fixed.x != turned[0] || fixed.y != turned[1] || fixed.z != turned[2];
    tally->mismatched +=
        fxl_placement_is_front(&of.placement, &from_eye, &normal, along(&normal, &of.vertex)) !=
        ref_placement_is_front(&of.exact, &centre, &eye, rows[0], &vertex);
    ref_model model = {.radius = of.radius};
    ref_instance placed = {.centre = centre};
    ref_placement placement = of.exact;
    const ref_scene scene = {.models = &model, .instances = &placed, .placements = &placement};
    tally->mismatched +=
        fxl_placement_radius(&of.placement, of.radius) != ref_instance_radius(&scene, &placed);
}
