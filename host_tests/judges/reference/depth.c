/* SPDX-License-Identifier: MIT */
#include "reference/depth.h"

#include <math.h>

#include "reference/cull.h"

/* accuracy 4.3 */
double ref_depth_bound(const ref_polygon *polygon, const ref_point *eye, const ref_lens *lens)
{
    double largest = 0;
    for (int i = 0; i < polygon->count; i++) {
        const ref_point *point = &polygon->vertices[i].position;
        largest = fmax(largest,
                       fabs(point->x - eye->x) + fabs(point->y - eye->y) + fabs(point->z - eye->z));
    }
    double shorter = fmin(lens->width, lens->height);
    return 0x2p-30 * largest + 0x4p-46 * fmax(1, 2 * lens->focal / shorter);
}

bool ref_depth_is_in_doubt(const ref_view_frustum *frustum, const ref_camera *camera,
                           const ref_polygon *polygon, double bound)
{
    for (int plane = REF_PLANE_NEAR; plane <= REF_PLANE_FAR; plane++) {
        ref_wide least = INFINITY, most = -INFINITY;
        for (int i = 0; i < polygon->count; i++) {
            ref_view_point view_point = ref_transform_point(camera, &polygon->vertices[i].position);
            ref_wide distance = ref_view_distance(&frustum->planes[plane], &view_point);
            least = distance < least ? distance : least;
            most = distance > most ? distance : most;
        }
        if (least <= bound && most >= -bound) {
            return true;
        }
    }
    return false;
}

void ref_depth_move_frustum(ref_frustum *frustum, double distance)
{
    frustum->planes[REF_PLANE_NEAR].distance -= distance;
    frustum->planes[REF_PLANE_FAR].distance -= distance;
}

void ref_depth_move_view_frustum(ref_view_frustum *frustum, double distance)
{
    frustum->planes[REF_PLANE_NEAR].distance -= distance;
    frustum->planes[REF_PLANE_FAR].distance -= distance;
}

#define PLANARITY_MAX (4 / REF_ONE)

static long double product(const ref_view_point *a, const ref_view_point *b)
{
    return a->x * b->x + a->y * b->y + a->z * b->z;
}

static ref_view_point difference(const ref_view_point *a, const ref_view_point *b)
{
    return (ref_view_point){a->x - b->x, a->y - b->y, a->z - b->z};
}

static void add_cross(ref_view_point *sum, const ref_view_point *a, const ref_view_point *b)
{
    sum->x += a->y * b->z - a->z * b->y;
    sum->y += a->z * b->x - a->x * b->z;
    sum->z += a->x * b->y - a->y * b->x;
}

void ref_depth_plane_find(const ref_scene *scene, const ref_camera *camera,
                          const ref_instance *instance, const ref_face *face,
                          ref_depth_plane *plane)
{
    ref_polygon polygon;
    ref_view_polygon view;
    ref_view_point middle = {0, 0, 0};
    double size = 0;
    ref_face_to_polygon(scene, instance, face, false, &polygon);
    ref_transform_polygon(camera, &polygon, &view);
    for (int i = 0; i < view.count; i++) {
        const ref_view_point *at = &view.vertices[i].position;
        middle.x += at->x / view.count;
        middle.y += at->y / view.count;
        middle.z += at->z / view.count;
    }
    plane->normal = (ref_view_point){0, 0, 0};
    for (int i = 0; i < view.count; i++) {
        const ref_view_point a = difference(&view.vertices[i].position, &middle);
        const ref_view_point b = difference(&view.vertices[(i + 1) % view.count].position, &middle);
        add_cross(&plane->normal, &a, &b);
        size = fmax(size, sqrt((double)product(&a, &a)));
    }
    plane->height = product(&plane->normal, &middle);
    const double length = sqrt((double)product(&plane->normal, &plane->normal));
    plane->moved = (2 * PLANARITY_MAX + 0x1p-26 * size) * length / fabs((double)plane->normal.z);
    plane->slack =
        (2 * PLANARITY_MAX + 0x1p-26 * size) * length / fabs((double)plane->height) + 0x1p-26;
}

void ref_depth_plane_take_eye(ref_depth_plane *plane, const ref_lens *lens)
{
    plane->slack = plane->moved / (lens->far_z - lens->near_z) + 0x1p-26;
}

/* docs/extras/orthographic.md, 2.11 */
long double ref_nearness_of_point(const ref_lens *lens, long double z)
{
    return lens->scale != 0 ? 1 - (z - lens->near_z) / (2 * (lens->far_z - lens->near_z)) : 1 / z;
}

static double nearness_along(const ref_depth_plane *plane, const ref_lens *lens, double x, double y)
{
    const long double across = (x - lens->centre_x) / lens->scale;
    const long double upright = (lens->centre_y - y) / lens->scale;
    if (plane->normal.z == 0) {
        return 0;
    }
    const long double z =
        (plane->height - plane->normal.x * across - plane->normal.y * upright) / plane->normal.z;
    return (double)ref_nearness_of_point(lens, z);
}

double ref_nearness(const ref_depth_plane *plane, const ref_lens *lens, double x, double y)
{
    const ref_screen_point at = {x, y};
    if (lens->scale != 0) {
        return nearness_along(plane, lens, x, y);
    }
    const ref_view_point ray = ref_ray_through(lens, &at);
    return (double)(product(&plane->normal, &ray) / (plane->height * ray.z));
}

double ref_depth_resolution(const ref_lens *lens, int bits)
{
    const double range = lens->far_z / lens->near_z * 257 / 256;
    const int octaves = lens->scale != 0 ? 1 : (int)fmax(1, ceil(log2(range)));
    int mantissa = 16;
    while (octaves * pow(2, mantissa) >= 65536) {
        mantissa--;
    }
    return bits == 16 ? (1 + 1.0 / 32) * pow(2, -mantissa) : pow(2, -mantissa - 5);
}
