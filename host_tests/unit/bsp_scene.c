/* SPDX-License-Identifier: MIT */
#include "bsp_scene.h"

/* Each face has a node of its own, and all else is behind it. */
bsp_scene *bsp_make(void)
{
    static bsp_scene made;
    made.tiny = tiny_make();
    fxl_scene *scene = &made.tiny->scene;
    for (uint32_t i = 0; i < BSP_NODES; i++) {
        fxl_bsp_node *node = &made.nodes[i];
        uint64_t distance = (uint64_t)FXL_Q2_30_ONE * 65536u;
        *node = (fxl_bsp_node){.normal = made.tiny->faces[6 + i].normal,
                               .distance_low = (uint32_t)distance,
                               .distance_high = (uint32_t)(distance >> 32),
                               .front = FXL_BSP_NONE,
                               .back = (uint16_t)(i + 1),
                               .parent = (uint16_t)(i - 1),
                               .first_face = (uint16_t)i,
                               .face_count = 1,
                               .radius = TINY_RADIUS};
    }
    made.nodes[0].parent = FXL_BSP_NONE;
    made.nodes[BSP_NODES - 1].back = FXL_BSP_NONE;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        made.tiny->instances[i].layer = 0;
    }
    scene->bsp_nodes = made.nodes;
    scene->bsp_node_count = BSP_NODES;
    scene->bsp_instance = 1;
    return &made;
}

enum {
    AIM = 1 << 27 /* eleven degrees */
};

/* The axes of what moves, and of what does not. */
static fxl_camera tilted, upright;

static fxl_q16_16 along(fxl_q2_30 right, fxl_q2_30 up, fxl_q2_30 forward, const fxl_point *v)
{
    return (fxl_q16_16)(((int64_t)right * v->x + (int64_t)up * v->y + (int64_t)forward * v->z +
                         (1 << 29)) >>
                        30);
}

static fxl_direction times_sign(const fxl_direction *of, int32_t sign)
{
    return (fxl_direction){of->x * sign, of->y * sign, of->z * sign};
}

void bsp_tilt(bsp_scene *made, fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    const fxl_pose straight = {{0, 0, 0}, 0, 0, 0};
    const fxl_pose pose = {{0, 0, 0}, yaw, pitch, roll};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&straight, &upright));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &tilted));
    const fxl_direction *const axes[3] = {&tilted.axes.right, &tilted.axes.up,
                                          &tilted.axes.forward};
    for (uint32_t i = 0; i < 8; i++) {
        const fxl_point from = made->tiny->vertices[i];
        made->tiny->vertices[i] =
            (fxl_point){along(tilted.axes.right.x, tilted.axes.up.x, tilted.axes.forward.x, &from),
                        along(tilted.axes.right.y, tilted.axes.up.y, tilted.axes.forward.y, &from),
                        along(tilted.axes.right.z, tilted.axes.up.z, tilted.axes.forward.z, &from)};
    }
    for (uint32_t i = 0; i < 6; i++) {
        made->tiny->faces[i].normal = times_sign(axes[i / 2], i % 2 ? 1 : -1);
    }
}

fxl_pose bsp_shuffle(bsp_scene *made)
{
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    /* In this order, on every compiler. */
    const fxl_angle yaw = unit_random(), pitch = unit_random(), roll = unit_random();
    bsp_tilt(made, yaw, pitch, roll);
    for (uint32_t i = 0; i < TINY_INSTANCES; i += 2) {
        fxl_point *centre = &made->tiny->instances[i].centre;
        centre->x = unit_between(-Q16(2), Q16(2));
        centre->y = unit_between(-Q16(2), Q16(2));
        centre->z = unit_between(Q16(8.5), Q16(12));
    }
    pose.position.x = unit_between(-Q16(7), Q16(7));
    pose.position.y = unit_between(-Q16(5), Q16(5));
    pose.position.z = unit_between(Q16(3), Q16(5));
    /* Mostly towards the cubes. */
    pose.yaw = (fxl_angle)(-(int64_t)pose.position.x * 1200 + unit_between(-AIM, AIM));
    pose.pitch = (fxl_angle)(-(int64_t)pose.position.y * 1200 + unit_between(-AIM, AIM));
    return pose;
}

/* In units of 1/65536 unit, along an axis of the cube. */
static double dot(const fxl_direction *along, const double v[3])
{
    return (along->x * v[0] + along->y * v[1] + along->z * v[2]) / FXL_Q2_30_ONE;
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double size(double a)
{
    return a < 0 ? -a : a;
}

/* A cube's faces; the eye is outside. */
static void look_at_cube(const fxl_point *eye, const double way[3], const fxl_instance *instance,
                         uint8_t colour, bsp_sight *seen)
{
    const fxl_camera *cube = colour == 1 ? &tilted : &upright;
    const fxl_direction *const axes[3] = {&cube->axes.right, &cube->axes.up, &cube->axes.forward};
    const double from[3] = {(eye->x - instance->centre.x) / 65536.0,
                            (eye->y - instance->centre.y) / 65536.0,
                            (eye->z - instance->centre.z) / 65536.0};
    for (int face = 0; face < 6; face++) {
        const fxl_direction *along = axes[face / 2];
        const double out = face % 2 ? 1 : -1;
        const double height = out - dot(along, from);
        if (out * height >= 0 || size(dot(along, way)) < 1e-9 || height / dot(along, way) <= 0) {
            continue; /* turned away, or behind the eye */
        }
        const double distance = height / dot(along, way);
        double margin = 1e9;
        for (int across = 0; across < 3; across++) {
            double at = dot(axes[across], from) + distance * dot(axes[across], way);
            margin = across == face / 2 ? margin : least(margin, 1 - size(at));
        }
        seen->margin = least(seen->margin, size(margin) / (distance + 1));
        if (margin > 0) {
            seen->margin = least(seen->margin, size(distance - seen->distance));
            if (distance < seen->distance) {
                seen->distance = distance;
                seen->colour = (uint8_t)(colour + face);
            }
        }
    }
}

/* 90 degrees, so that the focal length is half the width. */
bsp_sight bsp_look(const bsp_scene *made, const fxl_pose *pose, uint32_t x, uint32_t y)
{
    fxl_camera camera;
    bsp_sight seen = {1e9, 1e9, BSP_BACKGROUND};
    const double right = ((double)x + 0.5 - BSP_WIDTH / 2) / (BSP_WIDTH / 2);
    const double up = (BSP_HEIGHT / 2 - (double)y - 0.5) / (BSP_WIDTH / 2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, &camera));
    const double way[3] = {
        (camera.axes.right.x * right + camera.axes.up.x * up + camera.axes.forward.x) /
            FXL_Q2_30_ONE,
        (camera.axes.right.y * right + camera.axes.up.y * up + camera.axes.forward.y) /
            FXL_Q2_30_ONE,
        (camera.axes.right.z * right + camera.axes.up.z * up + camera.axes.forward.z) /
            FXL_Q2_30_ONE};
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        const fxl_instance *instance = &made->tiny->instances[i];
        look_at_cube(&pose->position, way, instance, i == 1 ? 11 : 1, &seen);
    }
    return seen;
}
