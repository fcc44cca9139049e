/* SPDX-License-Identifier: MIT */
#include "stages/random.h"

#include <math.h>

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t next(stages_random *random)
{
    uint64_t z = random->state += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

stages_random stages_random_start(uint64_t seed, uint64_t shard)
{
    stages_random random = {seed};
    random.state = next(&random) + shard;
    random.state = next(&random);
    return random;
}

uint32_t stages_random_below(stages_random *random, uint32_t limit)
{
    return (uint32_t)((next(random) >> 32) * limit >> 32);
}

/* low <= x < high */
static double uniform(stages_random *random, double low, double high)
{
    return low + (high - low) * ldexp((double)(next(random) >> 11), -53);
}

/* Distributed evenly by magnitude. */
static double spread(stages_random *random, double low, double high)
{
    return low * pow(high / low, uniform(random, 0, 1));
}

static double signed_spread(stages_random *random, double low, double high)
{
    double size = spread(random, low, high);
    return stages_random_below(random, 2) ? size : -size;
}

static fxl_q16_16 coordinate(double units)
{
    double limit = FXL_COORDINATE_MAX;
    return (fxl_q16_16)fmax(-limit, fmin(limit, round(units * 65536)));
}

static fxl_point point_at(double x, double y, double z)
{
    return (fxl_point){coordinate(x), coordinate(y), coordinate(z)};
}

static fxl_angle angle(stages_random *random)
{
    uint32_t any = (uint32_t)(next(random) >> 32);
    return stages_random_below(random, 8) == 0 ? any & 0xE0000000u : any;
}

fxl_pose stages_random_pose(stages_random *random)
{
    double reach = stages_random_below(random, 2) ? 8191 : spread(random, 1, 8191);
    fxl_pose pose = {.yaw = angle(random), .pitch = angle(random), .roll = angle(random)};
    pose.position = point_at(uniform(random, -reach, reach), uniform(random, -reach, reach),
                             uniform(random, -reach, reach));
    return pose;
}

fxl_lens stages_random_lens(stages_random *random)
{
    fxl_lens lens;
    fxl_status status;
    do {
        uint32_t any = stages_random_below(random, 4);
        uint16_t width = 320, height = 240;
        if (any == 0) {
            width = (uint16_t)(1 + stages_random_below(random, FXL_SCREEN_MAX));
            height = (uint16_t)(1 + stages_random_below(random, FXL_SCREEN_MAX));
        }
        fxl_angle fov = FXL_FOV_MIN + 1 + stages_random_below(random, FXL_FOV_MAX - FXL_FOV_MIN - 1);
        fxl_q16_16 near = (fxl_q16_16)spread(random, FXL_NEAR_MIN, 8 * 65536.0);
        fxl_q16_16 far = (fxl_q16_16)spread(random, 16 * 65536.0, FXL_FAR_MAX);
        fxl_q16_16 inset = 4;
        if (stages_random_below(random, 4) == 0) {
            inset = (fxl_q16_16)stages_random_below(random, FXL_INSET_MAX + 1);
        }
        status = fxl_lens_from_fov(width, height, fov, near, far, inset, &lens);
    } while (status != FXL_OK);
    return lens;
}

fxl_lens stages_random_moved_lens(stages_random *random)
{
    fxl_lens lens = stages_random_lens(random);
    if (stages_random_below(random, 3) == 0) {
        const double focal = 4.0 * lens.focal;
        const double x = fmin(lens.width * 98304.0, focal), y = fmin(lens.height * 98304.0, focal);
        lens.inset = 0;
        fxl_lens_set_centre(&lens, lens.width * 32768 + (fxl_q16_16)uniform(random, -x, x),
                            lens.height * 32768 + (fxl_q16_16)uniform(random, -y, y));
    }
    return lens;
}

/* eye + right x + up y + forward z */
static void along_camera(const fxl_camera *camera, const double view[3], double world[3])
{
    const fxl_direction *axes[3] = {&camera->axes.right, &camera->axes.up, &camera->axes.forward};
    world[0] = camera->position.x / 65536.0;
    world[1] = camera->position.y / 65536.0;
    world[2] = camera->position.z / 65536.0;
    for (int i = 0; i < 3; i++) {
        world[0] += view[i] * axes[i]->x * 0x1p-30;
        world[1] += view[i] * axes[i]->y * 0x1p-30;
        world[2] += view[i] * axes[i]->z * 0x1p-30;
    }
}

static void set_vertex(stages_random *random, fxl_vertex *vertex, fxl_point position)
{
    vertex->position = position;
    vertex->u = (fxl_q16_16)stages_random_below(random, 1024 * 65536u) - 512 * 65536;
    vertex->v = (fxl_q16_16)stages_random_below(random, 1024 * 65536u) - 512 * 65536;
}

static void any_polygon(stages_random *random, const fxl_camera *camera, fxl_polygon *polygon)
{
    polygon->count = (uint8_t)(3 + stages_random_below(random, FXL_POLYGON_CAPACITY - 2));
    for (int i = 0; i < polygon->count; i++) {
        set_vertex(random, &polygon->vertices[i], stages_random_point(random, &camera->position));
    }
}

/* Points of an ellipse at rising angles: a polygon that is flat and convex except for rounding. */
static void round_polygon(stages_random *random, const fxl_camera *camera, fxl_polygon *polygon)
{
    double depth = spread(random, 1.0 / 64, 8191), size = depth * spread(random, 1.0 / 64, 16);
    double centre[3] = {uniform(random, -depth, depth), uniform(random, -depth, depth),
                        uniform(random, -0.25, 1) * depth};
    double a[3], b[3];
    for (int i = 0; i < 3; i++) {
        a[i] = uniform(random, -size, size);
        b[i] = uniform(random, -size, size);
    }
    polygon->count = (uint8_t)(3 + stages_random_below(random, FXL_FACE_VERTICES_MAX - 2));
    double start = uniform(random, 0, 6.28);
    for (int i = 0; i < polygon->count; i++) {
        double turn = start + 6.283185307179586 * i / polygon->count, view[3], world[3];
        for (int k = 0; k < 3; k++) {
            view[k] = centre[k] + a[k] * cos(turn) + b[k] * sin(turn);
        }
        along_camera(camera, view, world);
        set_vertex(random, &polygon->vertices[i], point_at(world[0], world[1], world[2]));
    }
}

fxl_polygon stages_random_polygon(stages_random *random, const fxl_camera *camera)
{
    fxl_polygon polygon = {.colour = 1, .textured = true};
    if (stages_random_below(random, 8) == 0) {
        any_polygon(random, camera, &polygon);
    } else {
        round_polygon(random, camera, &polygon);
    }
    return polygon;
}

fxl_point stages_random_point(stages_random *random, const fxl_point *eye)
{
    if (stages_random_below(random, 4) == 0) {
        return point_at(uniform(random, -8191, 8191), uniform(random, -8191, 8191),
                        uniform(random, -8191, 8191));
    }
    return point_at(eye->x / 65536.0 + signed_spread(random, 1.0 / 65536, 16382),
                    eye->y / 65536.0 + signed_spread(random, 1.0 / 65536, 16382),
                    eye->z / 65536.0 + signed_spread(random, 1.0 / 65536, 16382));
}

fxl_q16_16 stages_random_radius(stages_random *random, const fxl_camera *camera,
                                const fxl_view_frustum *frustum, const fxl_point *centre)
{
    double radius = spread(random, 1, FXL_RADIUS_MAX);
    if (stages_random_below(random, 2)) {
        fxl_view_point seen;
        fxl_transform_point(camera, centre, &seen);
        int plane = (int)stages_random_below(random, FXL_PLANE_COUNT);
        double gap = fabs(ldexp((double)fxl_view_distance(frustum, plane, &seen), -30));
        radius = gap + uniform(random, -400, 400);
    }
    return (fxl_q16_16)fmax(0, fmin(FXL_RADIUS_MAX, radius));
}

/* With random bits below the 53 of a double. */
static fxl_q18_46 view_coordinate(stages_random *random, double units)
{
    const double limit = 0x1p61 - 0x1p12;
    double rounded = fmax(-limit, fmin(limit, round(ldexp(units, 46))));
    return (fxl_q18_46)rounded + (fxl_q18_46)stages_random_below(random, 512);
}

fxl_view_point stages_random_view_point(stages_random *random, const fxl_lens *lens)
{
    /* 1 in 16 misses the screen widely, with z of either sign */
    double reach = 1, focal = lens->focal / 65536.0;
    double z = spread(random, 1.0 / 512, 28000);
    if (stages_random_below(random, 16) == 0) {
        reach = 20;
        z = stages_random_below(random, 4) ? z : -z;
    }
    double x = uniform(random, -reach, reach) * z * lens->width / 2 / focal;
    double y = uniform(random, -reach, reach) * z * lens->height / 2 / focal;
    return (fxl_view_point){view_coordinate(random, x), view_coordinate(random, y),
                            view_coordinate(random, z)};
}

/* place fill-rule: random corners within a unit of a centre, where ties are */
static fxl_q16_16 screen_coordinate(stages_random *random, uint32_t kind, int size)
{
    switch (kind) {
    case 0: /* anywhere in range */
        return (fxl_q16_16)uniform(random, -FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    case 1: /* whole and half pixels: centres exactly on edges and vertices */
        return (fxl_q16_16)(stages_random_below(random, (uint32_t)(2 * size + 5)) * 32768) -
               2 * 32768;
    case 2: /* within a unit of a pixel centre */
        return (fxl_q16_16)(stages_random_below(random, (uint32_t)size) * 65536 + 32767 +
                            stages_random_below(random, 3));
    default:
        return (fxl_q16_16)uniform(random, -4 * 65536.0, (size + 4) * 65536.0);
    }
}

fxl_screen_polygon stages_random_outline(stages_random *random, int width, int height)
{
    fxl_screen_polygon polygon = {.colour = 1};
    uint32_t kind = stages_random_below(random, 5);
    uint32_t many = stages_random_below(random, 4) == 0 ? FXL_POLYGON_CAPACITY - 2 : 4;
    polygon.count = (uint8_t)(3 + stages_random_below(random, many));
    for (int i = 0; i < polygon.count; i++) {
        polygon.points[i].x = screen_coordinate(random, kind, width);
        polygon.points[i].y = screen_coordinate(random, kind, height);
    }
    return polygon;
}
