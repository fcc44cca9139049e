/* SPDX-License-Identifier: MIT */
#include "reference/rectangle.h"

/* A point is inside where a x + b y + c >= 0. */
typedef struct {
    double a, b, c;
} half_plane;

static double distance(const half_plane *of, const ref_screen_point *at)
{
    return of->a * at->x + of->b * at->y + of->c;
}

static void cut(const ref_screen_polygon *in, const half_plane *by, ref_screen_polygon *out)
{
    out->colour = in->colour;
    out->count = 0;
    for (int i = 0; i < in->count; i++) {
        const ref_screen_point *here = &in->points[i], *next = &in->points[(i + 1) % in->count];
        const double from = distance(by, here), to = distance(by, next);
        if (from >= 0) {
            out->points[out->count++] = *here;
        }
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            const double t = from / (from - to);
            out->points[out->count++] = (ref_screen_point){here->x + t * (next->x - here->x),
                                                           here->y + t * (next->y - here->y)};
        }
    }
}

bool ref_clip_to_rectangle(const ref_screen_polygon *in, const ref_rectangle *rectangle,
                           ref_screen_polygon *out)
{
    const half_plane borders[] = {{1, 0, -rectangle->left},
                                  {-1, 0, rectangle->right},
                                  {0, 1, -rectangle->top},
                                  {0, -1, rectangle->bottom}};
    ref_screen_polygon before = *in;
    for (int i = 0; i < 4 && before.count >= 3; i++) {
        cut(&before, &borders[i], out);
        before = *out;
    }
    *out = before;
    return before.count >= 3;
}
