/* SPDX-License-Identifier: MIT */
#include "view/model_view.h"
#include "view/outcode.h"
#include "view/project.h"
#include "view/view.h"

#include "equality.h"
#include "sides.h"

static fxl_point vertices[8];
static fxl_view view;
static fxl_model_view placed;

static bool same(const fxl_cached_vertex *a, const fxl_cached_vertex *b)
{
    return a->tag == b->tag && a->clip_flags == b->clip_flags && a->screen.x == b->screen.x &&
           a->screen.y == b->screen.y && a->position.x == b->position.x &&
           a->position.y == b->position.y && a->position.z == b->position.z;
}

#if FXL_TRANSFORMS_AND_PROJECTS

/* The same function that projects, too: whether it does what two do. Without all planes a vertex may lie so
 * that it must not be projected. */
static bool projects_the_same(uint32_t number, const fxl_cached_vertex *untouched)
{
    fxl_cached_vertex both = *untouched, two = *untouched;
    if (placed.planes != FXL_PLANES_ALL) {
        return true;
    }
    portable_transform_vertex(&placed, number, &two);
    const int32_t status =
        two.clip_flags != FXL_VERTEX_UNPROJECTED
            ? -1
            : (int32_t)portable_project_inside(&view.projection, &two.position, &two.screen);
    const bool equal =
        fxl_transform_and_project(&placed, number, &both, placed.tag + number) == status;
    if (status != -1) {
        both.clip_flags = two.clip_flags;
    }
    return equal && same(&both, &two);
}

#else

static bool projects_the_same(uint32_t number, const fxl_cached_vertex *untouched)
{
    (void)number;
    (void)untouched;
    return true;
}

#endif

static void compare(uint32_t number)
{
    const fxl_cached_vertex untouched = {0xDEADBEEFu, 0x55u, {123, 456}, {1, 2, 3}};
    fxl_cached_vertex core = untouched, portable = untouched;
    fxl_transform_vertex(&placed, number, &core);
    portable_transform_vertex(&placed, number, &portable);
    equality_case(same(&core, &portable) && projects_the_same(number, &untouched));
}

static int32_t within(int32_t limit)
{
    return (int32_t)(any_32() % (2u * (uint32_t)limit + 1u)) - limit;
}

static void any_view(void)
{
    fxl_pose pose;
    fxl_lens lens;
    fxl_angle fov = FXL_FOV_MIN + any_32() % (FXL_FOV_MAX - FXL_FOV_MIN + 1u);
    fxl_q16_16 near = FXL_NEAR_MIN << (any_32() >> 9 & 7u);
    fxl_q16_16 inset = any_32() & 64u ? 4 : within(FXL_INSET_MAX / 2) + FXL_INSET_MAX / 2;
    pose.position = (fxl_point){within(FXL_COORDINATE_MAX), within(FXL_COORDINATE_MAX),
                                within(FXL_COORDINATE_MAX)};
    pose.yaw = any_32();
    pose.pitch = any_32();
    pose.roll = any_32();
    fxl_lens_from_fov((uint16_t)(1u + any_32() % 1024u), (uint16_t)(1u + any_32() % 1024u), fov,
                      near, FXL_FAR_MAX >> (any_32() >> 9 & 7u), inset, &lens);
    any_centre(&lens);
    fxl_view_set_lens(&view, &lens);
    fxl_view_set_pose(&view, &pose);
    placed.view = &view;
    placed.vertices = vertices;
    placed.tag = any_32() & 0xFFFF0000u;
    placed.planes = (fxl_planes)(any_32() >> 5 & FXL_PLANES_ALL);
    if (any_32() & 0x300u) {
        placed.planes = FXL_PLANES_ALL;
    }
    placed.axes = &view.camera.axes;
}

/* Puts the origin of the vertices somewhere else than the eye. */
static void move_origin(const fxl_point *origin)
{
    placed.translation = (fxl_view_point){0, 0, 0};
    fxl_rotate(placed.axes, origin, &placed.translation, &placed.translation);
}

/* A vertex relative to the eye: anywhere, or within a few units of a side plane,
 * where the upper words leave it open. */
static fxl_point any_vertex(void)
{
    const fxl_camera *camera = &view.camera;
    const fxl_view_frustum *frustum = &view.view_frustum;
    if ((any_32() & 0x600u) == 0) {
        int32_t limit = FXL_COORDINATE_MAX >> (any_32() >> 8 & 15u);
        return (fxl_point){within(limit), within(limit), within(limit)};
    }
    bool upright = (any_32() & 32u) != 0;
    int32_t far = (FXL_COORDINATE_MAX >> 1) >> (any_32() >> 8 & 15u);
    /* On the plane: (depth, -side) from the eye. */
    int32_t along = within(far), other = within(far);
    fxl_q2_30 side = upright ? frustum->y_side : frustum->x_side;
    fxl_q2_30 depth = upright ? frustum->y_depth : frustum->x_depth;
    int32_t across = (int32_t)((int64_t)along * depth >> 30);
    int32_t forward = (int32_t)((int64_t)along * side >> 30);
    forward = any_32() & 256u ? -forward : forward;
    const fxl_direction *axis = upright ? &camera->axes.up : &camera->axes.right;
    const fxl_direction *rest = upright ? &camera->axes.right : &camera->axes.up;
    fxl_point point;
    point.x = (int32_t)(((int64_t)axis->x * across + (int64_t)rest->x * other +
                         (int64_t)camera->axes.forward.x * forward) >>
                        30) +
              within(2);
    point.y = (int32_t)(((int64_t)axis->y * across + (int64_t)rest->y * other +
                         (int64_t)camera->axes.forward.y * forward) >>
                        30) +
              within(2);
    point.z = (int32_t)(((int64_t)axis->z * across + (int64_t)rest->z * other +
                         (int64_t)camera->axes.forward.z * forward) >>
                        30) +
              within(2);
    return point;
}

/* The ends of what a difference of coordinates may be. */
static void boundaries(void)
{
    static const int32_t ends[] = {0,         1,          -1,         65536,      -65536,
                                   536805376, -536805376, 1073610752, -1073610752};
    move_origin(&(fxl_point){0, 0, 0});
    for (uint32_t x = 0; x < 9; x++) {
        for (uint32_t y = 0; y < 9; y++) {
            for (uint32_t z = 0; z < 9; z++) {
                vertices[3] = (fxl_point){ends[x], ends[y], ends[z]};
                compare(3);
            }
        }
    }
}

void test_look_at(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds / 32u + 8u; i++) {
        any_view();
        if (i < 8) {
            boundaries();
        }
        const fxl_point origin = {within(FXL_COORDINATE_MAX), within(FXL_COORDINATE_MAX),
                                  within(FXL_COORDINATE_MAX)};
        move_origin(&origin);
        for (uint32_t j = 0; j < 32; j++) {
            const fxl_point from_eye = any_vertex();
            vertices[j & 7u] =
                (fxl_point){from_eye.x - origin.x, from_eye.y - origin.y, from_eye.z - origin.z};
            compare(j & 7u);
        }
    }
}
