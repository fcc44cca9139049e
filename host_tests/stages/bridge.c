/* SPDX-License-Identifier: MIT */
#include "stages/bridge.h"

#include <math.h>

static double q16(fxl_q16_16 value)
{
    return ldexp(value, -16);
}

static ref_point direction(const fxl_direction *d)
{
    return (ref_point){ldexp(d->x, -30), ldexp(d->y, -30), ldexp(d->z, -30)};
}

ref_point bridge_point(const fxl_point *point)
{
    return (ref_point){q16(point->x), q16(point->y), q16(point->z)};
}

ref_plane bridge_plane(const fxl_plane *plane)
{
    return (ref_plane){direction(&plane->normal), ldexpl((long double)plane->distance, -46)};
}

ref_camera bridge_camera(const fxl_camera *camera)
{
    return (ref_camera){.position = bridge_point(&camera->position),
                        .right = direction(&camera->axes.right),
                        .up = direction(&camera->axes.up),
                        .forward = direction(&camera->axes.forward)};
}

ref_lens bridge_lens(const fxl_lens *lens)
{
    return (ref_lens){.width = lens->width,
                      .height = lens->height,
                      .focal = q16(lens->focal),
                      .near_z = q16(lens->near_z),
                      .far_z = q16(lens->far_z),
                      .inset = q16(lens->inset),
                      .centre_x = q16(lens->centre_x),
                      .centre_y = q16(lens->centre_y)};
}

ref_polygon bridge_polygon(const fxl_polygon *polygon)
{
    ref_polygon result = {.colour = polygon->colour, .count = polygon->count};
    for (int i = 0; i < result.count; i++) {
        const fxl_vertex *vertex = &polygon->vertices[i];
        result.vertices[i] = (ref_vertex){.position = bridge_point(&vertex->position)};
        if (polygon->textured) {
            result.vertices[i].u = q16(vertex->u);
            result.vertices[i].v = q16(vertex->v);
        }
    }
    return result;
}

static long double q46(fxl_q18_46 value)
{
    return ldexpl((long double)value, -46);
}

ref_view_point bridge_view_point(const fxl_view_point *point)
{
    return (ref_view_point){q46(point->x), q46(point->y), q46(point->z)};
}

ref_view_polygon bridge_view_polygon(const fxl_view_polygon *polygon)
{
    ref_view_polygon result = {.colour = polygon->colour, .count = polygon->count};
    for (int i = 0; i < result.count; i++) {
        const fxl_view_vertex *vertex = &polygon->vertices[i];
        result.vertices[i] = (ref_view_vertex){.position = bridge_view_point(&vertex->position)};
    }
    return result;
}

ref_view_frustum bridge_view_frustum(const fxl_view_frustum *f)
{
    double x = ldexp(f->x_side, -30), x_depth = ldexp(f->x_depth, -30);
    double y = ldexp(f->y_side, -30), y_depth = ldexp(f->y_depth, -30);
    long double inset = q46(f->inset);
    return (ref_view_frustum){{
        [REF_PLANE_LEFT] = {false, x, x_depth, inset},
        [REF_PLANE_RIGHT] = {false, -x, x_depth, inset},
        [REF_PLANE_BOTTOM] = {true, y, y_depth, inset},
        [REF_PLANE_TOP] = {true, -y, y_depth, inset},
        [REF_PLANE_NEAR] = {false, 0, 1, q46(f->near_z)},
        [REF_PLANE_FAR] = {false, 0, -1, -q46(f->far_z)},
    }};
}

ref_screen_polygon bridge_screen_polygon(const fxl_screen_polygon *polygon)
{
    ref_screen_polygon result = {.colour = polygon->colour, .count = polygon->count};
    for (int i = 0; i < result.count; i++) {
        result.points[i] = (ref_screen_point){q16(polygon->points[i].x), q16(polygon->points[i].y)};
    }
    return result;
}
