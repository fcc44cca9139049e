/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "designs/exact.h"
#include "designs/sample.h"
#include "designs/stage.h"

/* FNV-1a. */
static uint64_t hash(const char *text)
{
    uint64_t value = UINT64_C(0xCBF29CE484222325);
    for (; *text; text++) {
        value = (value ^ (uint8_t)*text) * UINT64_C(0x100000001B3);
    }
    return value;
}

oracle_random designs_random_start(uint64_t seed, const char *kind, uint64_t point, uint64_t shard)
{
    oracle_random random = {seed};
    random.state = oracle_random_next(&random) ^ hash(kind);
    random.state = oracle_random_next(&random) + point;
    random.state = oracle_random_next(&random) + shard;
    random.state = oracle_random_next(&random);
    return random;
}

double designs_random_spread(oracle_random *random, double low, double high)
{
    uint32_t octaves = 1;
    for (double end = 2 * low; end < high; end *= 2) {
        octaves++;
    }
    double from = low;
    for (uint32_t i = oracle_below(random, octaves); i > 0; i--) {
        from *= 2;
    }
    return oracle_uniform(random, from, 2 * from < high ? 2 * from : high);
}

const designs_plan designs_whole = {
    .near = {1.0 / 256, 8},
    .depth = {1.0 / 256, 16384},
    .fov = {10, 150},
    .eye = 8191,
    .reach = 8191,
    .edge = {1.0 / 16, 8192},
    .angle = {0, 90},
    .far = 16384,
    .face = 20,
    .texels = {1, 8000},
};

/* A place of the view, or a direction in it. */
typedef struct {
    double axes[3];
} place;

static fxl_angle any_angle(oracle_random *random)
{
    uint32_t any = (uint32_t)(oracle_random_next(random) >> 32);
    return oracle_below(random, 8) == 0 ? any & 0xE0000000u : any;
}

static void sample_pose(const designs_plan *plan, oracle_random *random, fxl_pose *pose)
{
    fxl_q16_16 *axes[3] = {&pose->position.x, &pose->position.y, &pose->position.z};
    for (int i = 0; i < 3; i++) {
        *axes[i] = (fxl_q16_16)(oracle_uniform(random, -plan->eye, plan->eye) * 65536);
    }
    pose->yaw = any_angle(random);
    pose->pitch = any_angle(random);
    pose->roll = any_angle(random);
}

static double between(oracle_random *random, designs_range range)
{
    return range.low < range.high ? designs_random_spread(random, range.low, range.high)
                                  : range.low;
}

/* Camera and lens; what is given to the designs is what the library made of
 * pose and field of view, whatever it is. */
static void sample_view(const designs_plan *plan, oracle_random *random, designs_input *input)
{
    sample_pose(plan, random, &input->pose);
    (void)fxl_camera_from_pose(&input->pose, &input->camera);
    double degrees = oracle_uniform(random, plan->fov.low, plan->fov.high);
    double fov = degrees * (4294967296.0 / 360);
    fov = fov < FXL_FOV_MIN ? FXL_FOV_MIN : fov > FXL_FOV_MAX ? FXL_FOV_MAX : fov;
    (void)fxl_lens_from_fov(320, 240, (fxl_angle)fov,
                            (fxl_q16_16)(between(random, plan->near) * 65536), FXL_FAR_MAX, 4,
                            &input->lens);
}

/* The world's nearest point to a place of the view; false where it lies outside
 * the plan's reach. */
static bool put_point(const designs_plan *plan, const designs_input *input, const place *view,
                      fxl_point *point)
{
    const fxl_camera *camera = &input->camera;
    const fxl_direction *rows[3] = {&camera->axes.right, &camera->axes.up, &camera->axes.forward};
    double world[3] = {camera->position.x, camera->position.y, camera->position.z};
    for (int i = 0; i < 3; i++) {
        double along = view->axes[i] * 65536 * 0x1p-30;
        world[0] += along * rows[i]->x;
        world[1] += along * rows[i]->y;
        world[2] += along * rows[i]->z;
    }
    for (int i = 0; i < 3; i++) {
        world[i] = rint(world[i]);
        if (fabs(world[i]) > plan->reach * 65536) {
            return false;
        }
    }
    *point = (fxl_point){(fxl_q16_16)world[0], (fxl_q16_16)world[1], (fxl_q16_16)world[2]};
    return true;
}

/* Half the screen's extent at a depth of 1. */
static double half_extent(const fxl_lens *lens, int axis)
{
    return (axis == 0 ? lens->width : lens->height) * 32768.0 / lens->focal;
}

static double sample_depth(const designs_plan *plan, oracle_random *random, const fxl_lens *lens)
{
    double near = lens->near_z / 65536.0;
    designs_range depth = plan->depth;
    depth.low = depth.low < near ? near : depth.low;
    return between(random, depth);
}

static bool is_visible(const designs_input *input, const fxl_view_point *view)
{
    if (view->z < (int64_t)input->lens.near_z << 30) {
        return false;
    }
    designs_screen screen = exact_screen(input, view);
    return screen.x >= 0 && screen.x <= input->lens.width * 65536.0 && screen.y >= 0 &&
           screen.y <= input->lens.height * 65536.0;
}

static bool try_vertex(const designs_plan *plan, oracle_random *random, designs_input *input)
{
    sample_view(plan, random, input);
    double z = sample_depth(plan, random, &input->lens);
    place view = {{0, 0, z}};
    for (int axis = 0; axis < 2; axis++) {
        view.axes[axis] = z * half_extent(&input->lens, axis) * oracle_uniform(random, -1, 1);
    }
    if (!put_point(plan, input, &view, &input->points[0])) {
        return false;
    }
    fxl_view_point point = exact_view_point(input, 0);
    return is_visible(input, &point);
}

/* A place on the clip plane that is seen, and the plane's normal; in double, for
 * what is exact is computed from the integers afterwards. */
static place place_on_plane(const designs_plan *plan, oracle_random *random,
                            const designs_input *input, place *normal)
{
    const fxl_lens *lens = &input->lens;
    bool near = input->plane == FXL_PLANE_NEAR;
    double z = near ? (lens->near_z + lens->inset) / 65536.0 : sample_depth(plan, random, lens);
    place view = {{0, 0, z}};
    for (int axis = 0; axis < 2; axis++) {
        view.axes[axis] = z * half_extent(lens, axis) * oracle_uniform(random, -1, 1);
    }
    *normal = (place){{0, 0, 1}};
    if (!near) {
        int axis = input->plane == FXL_PLANE_BOTTOM || input->plane == FXL_PLANE_TOP;
        double sign = input->plane == FXL_PLANE_LEFT || input->plane == FXL_PLANE_BOTTOM ? 1 : -1;
        double half = half_extent(lens, axis), length = sqrt(1 + half * half);
        normal->axes[axis] = sign / length;
        normal->axes[2] = half / length;
        view.axes[axis] = sign * (lens->inset / 65536.0 * length - half * z);
    }
    return view;
}

/* A unit vector that goes into the plane's inside, at the plan's angle to it. */
static place sample_way(const designs_plan *plan, oracle_random *random, const place *normal)
{
    place way;
    double along = 0;
    oracle_direction(random, 0x1p-20, way.axes);
    for (int i = 0; i < 3; i++) {
        along += way.axes[i] * normal->axes[i];
    }
    if (plan->angle.low > 0) {
        fxl_angle angle = (fxl_angle)(plan->angle.low * (4294967296.0 / 360));
        double rest = sqrt(1 - along * along), sine = exact_sine(angle);
        double cosine = exact_sine(angle + FXL_ANGLE_QUARTER);
        for (int i = 0; i < 3; i++) {
            double within = (way.axes[i] - along * normal->axes[i]) / rest;
            way.axes[i] = cosine * within + sine * normal->axes[i];
        }
    } else if (along < 0) {
        for (int i = 0; i < 3; i++) {
            way.axes[i] = -way.axes[i];
        }
    }
    return way;
}

/* Far is left out: what it cuts is too small on the screen to show anything. */
static const int planes[] = {FXL_PLANE_LEFT, FXL_PLANE_RIGHT, FXL_PLANE_BOTTOM, FXL_PLANE_TOP,
                             FXL_PLANE_NEAR};

static bool try_clip(const designs_plan *plan, oracle_random *random, designs_input *input)
{
    sample_view(plan, random, input);
    input->plane = planes[oracle_below(random, sizeof planes / sizeof planes[0])];
    place normal, crossing = place_on_plane(plan, random, input, &normal);
    place way = sample_way(plan, random, &normal);
    for (int end = 0; end < 2; end++) {
        double length = between(random, plan->edge) * (end == 0 ? 1 : -1);
        place view;
        for (int i = 0; i < 3; i++) {
            view.axes[i] = crossing.axes[i] + length * way.axes[i];
        }
        if (!put_point(plan, input, &view, &input->points[end])) {
            return false;
        }
    }
    /* Rounding the ends to 16.16 may have moved the crossing a long way where
     * the edge is nearly parallel to the plane. */
    fxl_view_point cut;
    designs_screen centre = {0, 0};
    return exact_crossing(input, &cut) && is_visible(input, &cut) &&
           exact_edge_distance(input, &centre) >= 0;
}

/* Small screens mostly: rows and columns far from an outline show nothing. */
static void sample_outline(oracle_random *random, designs_input *input)
{
    static const uint16_t sizes[3][2] = {{32, 24}, {96, 72}, {320, 240}};
    uint32_t kind = oracle_below(random, 16);
    int size = kind < 9 ? 0 : kind < 15 ? 1 : 2;
    bool on_grid = oracle_below(random, 4) == 0;
    input->lens.width = sizes[size][0];
    input->lens.height = sizes[size][1];
    input->outline.colour = 1;
    input->outline.count = (uint8_t)(3 + oracle_below(random, 4));
    for (int i = 0; i < input->outline.count; i++) {
        uint32_t x = oracle_below(random, (input->lens.width + 8u) * 65536u);
        uint32_t y = oracle_below(random, (input->lens.height + 8u) * 65536u);
        if (on_grid) { /* quarter pixels: edges through pixel centres */
            x &= ~0x3FFFu;
            y &= ~0x3FFFu;
        }
        input->outline.points[i].x = (fxl_q16_16)x - 4 * 65536;
        input->outline.points[i].y = (fxl_q16_16)y - 4 * 65536;
    }
}

void designs_sample(enum designs_stage stage, const designs_plan *plan, oracle_random *random,
                    designs_input *input)
{
    *input = (designs_input){.plane = 0};
    switch (stage) {
    case DESIGNS_MATRIX:
        sample_pose(plan, random, &input->pose);
        break;
    case DESIGNS_VERTEX:
        while (!try_vertex(plan, random, input)) {
        }
        break;
    case DESIGNS_CLIP:
        while (!try_clip(plan, random, input)) {
        }
        break;
    case DESIGNS_FILL:
        sample_outline(random, input);
        break;
    default:
        designs_sample_surface(stage, plan, random, input);
    }
}
