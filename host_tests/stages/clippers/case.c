/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "clippers/measure.h"
#include "reference/camera.h"

outline outline_of_screen(const fxl_screen_point *points, int count)
{
    outline made = {.count = count};
    for (int i = 0; i < count; i++) {
        made.x[i] = points[i].x / 65536.0L;
        made.y[i] = points[i].y / 65536.0L;
    }
    return made;
}

outline outline_of_volume(const ref_volume_polygon *polygon, double half_width, double half_height,
                          double x_factor, double y_factor)
{
    outline made = {.count = polygon->count};
    for (int i = 0; i < polygon->count; i++) {
        const ref_volume_vertex *at = &polygon->vertices[i];
        made.x[i] = half_width + x_factor * (long double)(at->x / at->z);
        made.y[i] = half_height - y_factor * (long double)(at->y / at->z);
    }
    return made;
}

static long double from_segment(long double x, long double y, const outline *of, int i)
{
    int k = (i + 1) % of->count;
    long double dx = of->x[k] - of->x[i], dy = of->y[k] - of->y[i];
    long double wx = x - of->x[i], wy = y - of->y[i];
    long double square = dx * dx + dy * dy;
    long double t = square > 0 ? (wx * dx + wy * dy) / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypotl(wx - t * dx, wy - t * dy);
}

static long double one_way(const outline *from, const outline *to)
{
    long double largest = 0;
    for (int i = 0; i < from->count; i++) {
        long double least = INFINITY;
        for (int k = 0; k < to->count; k++) {
            least = fminl(least, from_segment(from->x[i], from->y[i], to, k));
        }
        largest = fmaxl(largest, least);
    }
    return largest;
}

double outline_beyond(const outline *of, long double x, long double y)
{
    long double beyond = 0, sign = outline_area(of) < 0 ? 1 : -1;
    for (int i = 0; i < of->count; i++) {
        int k = (i + 1) % of->count;
        long double dx = of->x[k] - of->x[i], dy = of->y[k] - of->y[i], length = hypotl(dx, dy);
        if (length > 0x1p-8L) { /* shorter ones have no direction to speak of */
            long double side = dx * (y - of->y[i]) - dy * (x - of->x[i]);
            beyond = fmaxl(beyond, sign * side / length);
        }
    }
    return 65536 * (double)beyond;
}

double outline_length(const outline *of)
{
    long double length = 0;
    for (int i = 0; i < of->count; i++) {
        int k = (i + 1) % of->count;
        length += hypotl(of->x[k] - of->x[i], of->y[k] - of->y[i]);
    }
    return (double)length;
}

double outline_distance(const outline *a, const outline *b)
{
    return 65536 * (double)fmaxl(one_way(a, b), one_way(b, a));
}

double outline_area(const outline *of)
{
    long double twice = 0;
    for (int i = 0; i < of->count; i++) {
        int k = (i + 1) % of->count;
        twice += of->x[i] * of->y[k] - of->x[k] * of->y[i];
    }
    return (double)twice / 2;
}

/* A polygon of less is not missed: 1/65536 square pixel. */
#define AREA_MIN 0x1p-16

ref_volume_polygon case_seen(const clipper_case *of)
{
    ref_camera camera = bridge_camera(&of->camera);
    ref_volume_polygon seen = {.count = of->polygon.count, .carried = REF_CARRIED_MAX};
    for (int i = 0; i < seen.count; i++) {
        ref_point point = bridge_point(&of->polygon.vertices[i].position);
        ref_view_point at = ref_transform_point(&camera, &point);
        seen.vertices[i] = (ref_volume_vertex){at.x, at.y, at.z, {point.x, point.y, point.z}};
    }
    return seen;
}

void case_carry(const clipper_case *of, int vertex, fxl_varying_vertex *into)
{
    const fxl_vertex *from = &of->polygon.vertices[vertex];
    into->carried[0] = from->position.x;
    into->carried[1] = from->position.y;
    into->carried[2] = from->position.z;
    into->carried[3] = from->u;
    into->carried[4] = from->v;
    into->carried[5] = vertex % 2 ? 16383 * 65536 : -16383 * 65536;
}

double case_carried_error(const clipper_case *of, const fxl_varying_vertex *vertex, double x,
                          double y, double z)
{
    ref_camera camera = bridge_camera(&of->camera);
    fxl_point point = {vertex->carried[0], vertex->carried[1], vertex->carried[2]};
    ref_point world = bridge_point(&point);
    ref_view_point at = ref_transform_point(&camera, &world);
    return 65536 * (double)hypotl(at.x - x, hypotl(at.y - y, at.z - z));
}

/* The sine of the angle between the polygon and a plane. */
static double sine_between(const ref_volume_polygon *polygon, const ref_half_space *plane)
{
    double n[3] = {0, 0, 0}; /* Newell's normal */
    for (int i = 0; i < polygon->count; i++) {
        const ref_volume_vertex *a = &polygon->vertices[i];
        const ref_volume_vertex *b = &polygon->vertices[(i + 1) % polygon->count];
        n[0] += (double)((a->y - b->y) * (a->z + b->z));
        n[1] += (double)((a->z - b->z) * (a->x + b->x));
        n[2] += (double)((a->x - b->x) * (a->y + b->y));
    }
    double p[3] = {(double)plane->a, (double)plane->b, (double)plane->c};
    double cross[3] = {n[1] * p[2] - n[2] * p[1], n[2] * p[0] - n[0] * p[2],
                       n[0] * p[1] - n[1] * p[0]};
    double lengths = hypot(n[0], hypot(n[1], n[2])) * hypot(p[0], hypot(p[1], p[2]));
    return lengths > 0 ? hypot(cross[0], hypot(cross[1], cross[2])) / lengths : 0;
}

static bool nearly_parallel(const ref_volume_polygon *polygon, const ref_half_space *planes)
{
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        bool in = false, out = false;
        for (int k = 0; k < polygon->count; k++) {
            ref_wide distance = ref_half_space_distance(&planes[i], &polygon->vertices[k]);
            in |= distance >= 0;
            out |= distance < 0;
        }
        if (in && out && sine_between(polygon, &planes[i]) < 0x1p-7) {
            return true;
        }
    }
    return false;
}

bool case_expected_of(const ref_volume_polygon *seen, const fxl_lens *lens,
                      const ref_half_space *planes, outline *expected, bool *parallel)
{
    ref_volume_polygon left;
    double focal = lens->focal / 65536.0;
    *parallel = nearly_parallel(seen, planes);
    ref_clip_to_volume(seen, planes, REF_PLANE_COUNT, &left);
    *expected = outline_of_volume(&left, lens->width / 2.0, lens->height / 2.0, focal, focal);
    return left.count >= 3;
}

bool case_expected(const clipper_case *of, const ref_half_space *planes, outline *expected,
                   bool *parallel)
{
    ref_volume_polygon seen = case_seen(of);
    return case_expected_of(&seen, &of->lens, planes, expected, parallel);
}

void case_compare(clipper_tally *tally, const outline *got, const outline *expected, bool parallel)
{
    if (!got || expected->count < 3) {
        const outline *only = got ? got : expected;
        tally->verdicts += only->count >= 3 && fabs(outline_area(only)) > AREA_MIN;
        return;
    }
    double distance = outline_distance(got, expected);
    tally->cut++;
    tally->moved += distance;
    tally->at_all = fmax(tally->at_all, distance);
    if (distance > tally->claimed) {
        tally->beyond++;
        tally->parallel += parallel;
    }
    if (!parallel) {
        tally->outline = fmax(tally->outline, distance);
    }
}
