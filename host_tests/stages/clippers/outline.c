/* SPDX-License-Identifier: MIT */
#include "clippers/outline.h"

#include <math.h>

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
