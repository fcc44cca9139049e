/* SPDX-License-Identifier: MIT */
#include "oracle/hausdorff.h"

#include <math.h>

#include "oracle/setup.h"

enum {
    SPOTS_MAX = 96
};

#define UNIT 4294967296.0 /* 2^-48 pixel in 1/65536 pixel */

/* Coordinates are below 2^60, so differences are below 2^61, products below 2^122 and their sums
 * below 2^123. */
static oracle_wide dot(oracle_spot a, oracle_spot b)
{
    return (oracle_wide)a.x * b.x + (oracle_wide)a.y * b.y;
}

static oracle_wide cross(oracle_spot a, oracle_spot b)
{
    return (oracle_wide)a.x * b.y - (oracle_wide)a.y * b.x;
}

static oracle_spot minus(const oracle_spot *a, const oracle_spot *b)
{
    return (oracle_spot){a->x - b->x, a->y - b->y};
}

static double length(oracle_spot v)
{
    return hypot((double)v.x, (double)v.y);
}

double oracle_from_segment(const oracle_spot *p, const oracle_spot *a, const oracle_spot *b)
{
    oracle_spot ap = minus(p, a), ab = minus(b, a);
    if (dot(ap, ab) <= 0) {
        return length(ap) / UNIT;
    }
    oracle_spot bp = minus(p, b);
    if (dot(bp, ab) >= 0) {
        return length(bp) / UNIT;
    }
    return fabs((double)cross(ab, ap)) / length(ab) / UNIT;
}

/* The distances of one spot from every segment of an outline, and the least of them. */
static double from_all(const oracle_spot *p, const oracle_spot *outline, int count, double *all)
{
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        all[i] = oracle_from_segment(p, &outline[i], &outline[i + 1 == count ? 0 : i + 1]);
        least = fmin(least, all[i]);
    }
    return least;
}

typedef struct {
    const oracle_spot *other; /* the outline to which distances are measured */
    int other_count;
    double best; /* the largest distance found so far */
} hunt;

/* Returns the largest distance of a point of the stretch from u to v. The distance from one
 * segment is convex, so over the stretch it is at most the larger distance of the stretch's
 * ends. The least of these values over all segments bounds the distance from the outline. Where
 * that bound is too coarse, the stretch is halved. It is shorter than the tolerance after at
 * most 50 halvings. */
static void search_stretch(hunt *h, const oracle_spot *u, const double *from_u,
                           const oracle_spot *v, const double *from_v)
{
    double above = INFINITY;
    for (int i = 0; i < h->other_count; i++) {
        above = fmin(above, fmax(from_u[i], from_v[i]));
    }
    if (above <= h->best) {
        return;
    }
    double tolerance = fmax(0x1p-10, h->best / 64);
    if (above <= h->best + tolerance || length(minus(u, v)) < 0x1p-10 * UNIT) {
        h->best = above;
        return;
    }
    oracle_spot middle = {u->x + (v->x - u->x) / 2, u->y + (v->y - u->y) / 2};
    double from_middle[SPOTS_MAX];
    h->best = fmax(h->best, from_all(&middle, h->other, h->other_count, from_middle));
    search_stretch(h, u, from_u, &middle, from_middle);
    search_stretch(h, &middle, from_middle, v, from_v);
}

static double directed(const oracle_spot *a, int a_count, const oracle_spot *b, int b_count,
                       double best)
{
    static double from[SPOTS_MAX][SPOTS_MAX];
    hunt h = {b, b_count, best};
    for (int i = 0; i < a_count; i++) {
        h.best = fmax(h.best, from_all(&a[i], b, b_count, from[i]));
    }
    for (int i = 0; i < a_count; i++) {
        int next = i + 1 == a_count ? 0 : i + 1;
        search_stretch(&h, &a[i], from[i], &a[next], from[next]);
    }
    return h.best;
}

double oracle_hausdorff(const oracle_spot *a, int a_count, const oracle_spot *b, int b_count)
{
    return directed(b, b_count, a, a_count, directed(a, a_count, b, b_count, 0));
}

double oracle_from_stroke(const oracle_spot *spots, int count)
{
    int from = 0, to = 0;
    double farthest = -1, widest = 0;
    for (int i = 0; i < count; i++) {
        for (int j = i + 1; j < count; j++) {
            double apart = length(minus(&spots[i], &spots[j]));
            if (apart > farthest) {
                farthest = apart;
                from = i;
                to = j;
            }
        }
    }
    for (int i = 0; i < count; i++) {
        widest = fmax(widest, oracle_from_segment(&spots[i], &spots[from], &spots[to]));
    }
    return widest;
}
