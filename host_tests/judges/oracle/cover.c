/* SPDX-License-Identifier: MIT */
#include "oracle/cover.h"

#include <math.h>

#include "oracle/setup.h"

/* place fill-rule: definition: the claims coverage and watertight */
typedef struct {
    int column; /* the first column whose centre is at or right of the edge */
    int winding;
} crossing;

static oracle_wide divide_up(oracle_wide numerator, oracle_wide denominator)
{
    oracle_wide quotient = numerator / denominator; /* towards zero */
    return quotient + (numerator % denominator > 0);
}

/* Returns the first column 0..width whose centre is at or right of the point where the edge
 * crosses the row. Coordinates are below 2^61 and differences below 2^62, so the numerator is
 * below 2^124. */
static int first_column(const oracle_spot *a, const oracle_spot *b, int64_t centre, int bits,
                        int width)
{
    const oracle_spot *top = a->y < b->y ? a : b, *bottom = a->y < b->y ? b : a;
    int64_t half = (int64_t)1 << (15 + bits);
    oracle_wide height = (oracle_wide)bottom->y - top->y;
    oracle_wide x = (oracle_wide)(top->x - half) * height +
                    (oracle_wide)(centre - top->y) * ((oracle_wide)bottom->x - top->x);
    oracle_wide column = divide_up(x, height * 2 * half);
    return column < 0 ? 0 : column > width ? width : (int)column;
}

static void insert(crossing *crossings, int count, crossing added)
{
    while (count > 0 && crossings[count - 1].column > added.column) {
        crossings[count] = crossings[count - 1];
        count--;
    }
    crossings[count] = added;
}

void oracle_cover_row(const oracle_spot *points, int count, int bits, int y, int width,
                      uint8_t *row)
{
    crossing crossings[ORACLE_COVER_EDGES];
    int crossed = 0;
    int64_t centre = (2 * (int64_t)y + 1) << (15 + bits);
    for (int i = 0; i < count; i++) {
        const oracle_spot *a = &points[i], *b = &points[i + 1 == count ? 0 : i + 1];
        int winding = a->y <= centre && centre < b->y   ? 1
                      : b->y <= centre && centre < a->y ? -1
                                                        : 0;
        if (winding != 0) {
            crossing added = {first_column(a, b, centre, bits, width), winding};
            insert(crossings, crossed++, added);
        }
    }
    int winding = 0;
    for (int i = 0; i < crossed; i++) {
        winding += crossings[i].winding;
        int end = i + 1 < crossed ? crossings[i + 1].column : width;
        for (int x = crossings[i].column; winding != 0 && x < end; x++) {
            row[x]++;
        }
    }
}

int oracle_winding(const oracle_spot *points, int count, int bits, int x, int y)
{
    oracle_wide cx = (oracle_wide)(2 * x + 1) << (15 + bits);
    oracle_wide cy = (oracle_wide)(2 * y + 1) << (15 + bits);
    int winding = 0;
    for (int i = 0; i < count; i++) {
        const oracle_spot *a = &points[i], *b = &points[(i + 1) % count];
        /* x at cy = a.x + (cy - a.y) (b.x - a.x) / (b.y - a.y) <= cx, times b.y - a.y */
        oracle_wide height = (oracle_wide)b->y - a->y;
        oracle_wide left = (cy - a->y) * ((oracle_wide)b->x - a->x), right = (cx - a->x) * height;
        if (a->y <= cy && cy < b->y && left <= right) {
            winding += 1;
        } else if (b->y <= cy && cy < a->y && left >= right) {
            winding -= 1;
        }
    }
    return winding;
}

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
