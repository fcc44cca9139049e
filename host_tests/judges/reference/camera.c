/* SPDX-License-Identifier: MIT */
#include "reference/camera.h"

#include <math.h>

static const double two_pi = 6.283185307179586476925286766559;

/* Converts an angle to radians, 0 <= a < 2 pi. */
static double radians_of(ref_angle angle)
{
    return (double)angle / 4294967296.0 * two_pi;
}

/* The angle is reduced, in integers, to at most an eighth of a turn from a multiple of a quarter
 * turn, because libm's sine of a rounded pi is not 0, and a camera that looks along an axis must
 * do so exactly. */
double ref_sin(ref_angle angle)
{
    uint32_t quarters = (angle + 0x20000000u) >> 30;
    int64_t rest = (int64_t)angle - ((int64_t)quarters << 30);
    if (rest > INT64_C(0x20000000)) { /* the last eighth belongs to the next turn */
        rest -= INT64_C(0x100000000);
    }
    double radians = (double)rest / 4294967296.0 * two_pi;
    switch (quarters) {
    case 0:
        return sin(radians);
    case 1:
        return cos(radians);
    case 2:
        return -sin(radians);
    default:
        return -cos(radians);
    }
}

double ref_cos(ref_angle angle)
{
    return ref_sin(angle + 0x40000000u);
}

/* The axes of the view start as the axes of the world. Each turn rotates the view about one of
 * its own axes: it replaces the two other axes by combinations of themselves. This follows the
 * words of SPEC.md, section 1.3, so the table of products there is checked, not copied. */

/* Turns axis a towards axis b by an angle whose sine and cosine are given. */
static void turn(ref_point *a, ref_point *b, double s, double c)
{
    ref_point old_a = *a, old_b = *b;
    a->x = c * old_a.x + s * old_b.x;
    a->y = c * old_a.y + s * old_b.y;
    a->z = c * old_a.z + s * old_b.z;
    b->x = c * old_b.x - s * old_a.x;
    b->y = c * old_b.y - s * old_a.y;
    b->z = c * old_b.z - s * old_a.z;
}

ref_point ref_point_from_lattice(const ref_lattice_point *point)
{
    return (ref_point){point->x / REF_ONE, point->y / REF_ONE, point->z / REF_ONE};
}

ref_camera ref_camera_from_pose(const ref_pose *pose)
{
    ref_camera camera = {.position = ref_point_from_lattice(&pose->position),
                         .right = {1, 0, 0},
                         .up = {0, 1, 0},
                         .forward = {0, 0, 1}};
    /* Yaw: the view from +z towards +x. */
    turn(&camera.forward, &camera.right, ref_sin(pose->yaw), ref_cos(pose->yaw));
    /* Pitch: the view towards up. */
    turn(&camera.forward, &camera.up, ref_sin(pose->pitch), ref_cos(pose->pitch));
    /* Roll: the right side towards the up side. */
    turn(&camera.right, &camera.up, ref_sin(pose->roll), ref_cos(pose->roll));
    return camera;
}

void ref_camera_take_eye(ref_camera *camera)
{
    const double forward[3] = {camera->forward.x, camera->forward.y, camera->forward.z};
    camera->has_no_eye = true;
    for (int i = 0; i < 3; i++) {
        camera->forward_30[i] = (int32_t)floor(forward[i] * 0x1p30 + 0.5);
    }
}

ref_point ref_forward(ref_angle yaw, ref_angle pitch)
{
    ref_pose pose = {.yaw = yaw, .pitch = pitch};
    return ref_camera_from_pose(&pose).forward;
}

/* accuracy 4.1 */
ref_lens ref_lens_from_fov(int width, int height, ref_angle fov, double near_z, double far_z,
                           double inset)
{
    double focal = width / 2.0 / tan(radians_of(fov) / 2);
    return (ref_lens){.width = width,
                      .height = height,
                      .focal = floor(focal * REF_ONE + 0.5) / REF_ONE,
                      .near_z = near_z,
                      .far_z = far_z,
                      .inset = inset,
                      .centre_x = width / 2.0,
                      .centre_y = height / 2.0};
}

static long double along(const ref_point *axis, const ref_point *from_eye)
{
    return (long double)axis->x * from_eye->x + (long double)axis->y * from_eye->y +
           (long double)axis->z * from_eye->z;
}

ref_view_point ref_transform_point(const ref_camera *camera, const ref_point *point)
{
    ref_point from_eye = {point->x - camera->position.x, point->y - camera->position.y,
                          point->z - camera->position.z};
    return (ref_view_point){along(&camera->right, &from_eye), along(&camera->up, &from_eye),
                            along(&camera->forward, &from_eye)};
}

void ref_transform_polygon(const ref_camera *camera, const ref_polygon *polygon,
                           ref_view_polygon *view)
{
    view->colour = polygon->colour;
    view->count = polygon->count;
    for (int i = 0; i < polygon->count; i++) {
        view->vertices[i].position = ref_transform_point(camera, &polygon->vertices[i].position);
    }
}

ref_screen_point ref_project_point(const ref_lens *lens, const ref_view_point *view)
{
    if (lens->scale != 0) {
        return (ref_screen_point){(double)(lens->centre_x + lens->scale * view->x),
                                  (double)(lens->centre_y - lens->scale * view->y)};
    }
    return (ref_screen_point){(double)(lens->centre_x + lens->focal * view->x / view->z),
                              (double)(lens->centre_y - lens->focal * view->y / view->z)};
}

ref_view_point ref_ray_through(const ref_lens *lens, const ref_screen_point *screen)
{
    return (ref_view_point){(long double)screen->x - lens->centre_x,
                            (long double)lens->centre_y - screen->y,
                            lens->scale != 0 ? lens->scale : lens->focal};
}

void ref_project_polygon(const ref_lens *lens, const ref_view_polygon *view,
                         ref_screen_polygon *screen)
{
    screen->colour = view->colour;
    screen->count = view->count;
    for (int i = 0; i < view->count; i++) {
        screen->points[i] = ref_project_point(lens, &view->vertices[i].position);
    }
}

/* --- a player ----------------------------------------------------------------------------------- */

ref_player ref_player_at(const ref_pose *pose)
{
    return (ref_player){.position = ref_point_from_lattice(&pose->position),
                        .yaw = pose->yaw,
                        .pitch = pose->pitch,
                        .roll = pose->roll};
}

static int pressed(uint32_t keys, uint32_t plus, uint32_t minus)
{
    return ((keys & plus) != 0) - ((keys & minus) != 0);
}

static ref_angle turned(ref_angle angle, int direction, ref_angle by)
{
    return direction > 0 ? angle + by : direction < 0 ? angle - by : angle;
}

static double held(double value, double limit)
{
    return fmax(-limit, fmin(limit, value));
}

void ref_player_step(ref_player *player, uint32_t keys, const ref_motion_limits *limits)
{
    player->yaw = turned(player->yaw, pressed(keys, REF_KEY_RIGHT, REF_KEY_LEFT), limits->turn);
    player->pitch =
        turned(player->pitch, pressed(keys, REF_KEY_PITCH_UP, REF_KEY_PITCH_DOWN), limits->turn);
    player->roll =
        turned(player->roll, pressed(keys, REF_KEY_ROLL_LEFT, REF_KEY_ROLL_RIGHT), limits->turn);

    double push = limits->acceleration * pressed(keys, REF_KEY_FORWARD, REF_KEY_BACK);
    player->speed = held(player->speed + push, limits->speed_max);

    ref_point forward = ref_forward(player->yaw, player->pitch);
    double x = player->position.x + forward.x * player->speed;
    double z = player->position.z + forward.z * player->speed;
    player->position.x = held(x, REF_COORDINATE_MAX);
    player->position.z = held(z, REF_COORDINATE_MAX);
    player->clamped += player->position.x != x || player->position.z != z;

    player->speed = copysign(fmax(fabs(player->speed) - limits->friction, 0), player->speed);
}
