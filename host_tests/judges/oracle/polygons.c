/* SPDX-License-Identifier: MIT */
#include "oracle/polygons.h"

#include <math.h>
#include <stdlib.h>

enum {
    ROUND,
    SLIVER,
    HUGE_ONES,
    GROUND,
    COLLINEAR,
    ON_PLANES,
    AT_ENDS,
    AROUND,
    PARALLEL = ORACLE_NEAR_PARALLEL,
    ON_CENTRES,
    KINDS
};

#define FULL_TURN 6.283185307179586

typedef struct {
    oracle_random *random;
    oracle_input *input;
    int count_max;
    double near, far, inset; /* near and far, moved by the inset */
    double slope_x, slope_y; /* tangents of half the fields of view */
    int count;
    double vertices[FXL_FACE_VERTICES_MAX]
                   [3]; /* relative to the eye, along the axes of the world */
} maker;

static double uniform(const maker *m, double low, double high)
{
    return oracle_uniform(m->random, low, high);
}

static int some(const maker *m, int least, int most)
{
    most = most < m->count_max ? most : m->count_max;
    return (int)oracle_between(m->random, least, most);
}

static void measure_lens(maker *m)
{
    const int64_t *n = m->input->numbers;
    m->inset = (double)n[5] / 65536;
    m->near = (double)n[3] / 65536 + m->inset;
    m->far = (double)n[4] / 65536 - m->inset;
    m->slope_x = tan(ldexp((double)n[2], -32) * FULL_TURN / 2);
    m->slope_y = m->slope_x * (double)n[1] / (double)n[0];
}

/* For samples whose points must lie exactly on borders: a sheared view rounds them once more. */
static void centre_lens(maker *m)
{
    int64_t *n = m->input->numbers;
    n[12] = n[0] * 32768;
    n[13] = n[1] * 32768;
}

/* A visible point, or one just outside the view. */
static void anchor(const maker *m, double view[3])
{
    view[2] = oracle_spread(m->random, m->near, fmin(m->far, 9000));
    view[0] = uniform(m, -1.1, 1.1) * view[2] * m->slope_x;
    view[1] = uniform(m, -1.1, 1.1) * view[2] * m->slope_y;
}

static void any_direction(const maker *m, double v[3])
{
    oracle_direction(m->random, 0.01, v);
}

static void put_view(maker *m, const double view[3])
{
    oracle_to_world(m->input, view, m->vertices[m->count++]);
}

/* Points of an ellipse at rising angles, equally spaced or not. */
static void ellipse(maker *m, const double centre[3], const double a[3], const double b[3],
                    int count)
{
    double turn = uniform(m, 0, FULL_TURN), wobble = oracle_below(m->random, 2) ? 0.9 : 0;
    m->count = 0;
    for (int i = 0; i < count; i++) {
        double angle = turn + FULL_TURN * (i + wobble * uniform(m, 0, 1)) / count, view[3];
        for (int k = 0; k < 3; k++) {
            view[k] = centre[k] + a[k] * cos(angle) + b[k] * sin(angle);
        }
        put_view(m, view);
    }
}

static void make_round(maker *m, double least_ratio, double most_ratio)
{
    double centre[3], a[3], b[3];
    anchor(m, centre);
    any_direction(m, a);
    any_direction(m, b);
    double size = centre[2] * m->slope_x * oracle_spread(m->random, 0.05, 30);
    double ratio = oracle_spread(m->random, least_ratio, most_ratio);
    for (int i = 0; i < 3; i++) {
        centre[i] += a[i] * size * uniform(m, -1, 1);
        a[i] *= size;
        b[i] *= size * ratio;
    }
    ellipse(m, centre, a, b, some(m, 3, FXL_FACE_VERTICES_MAX));
}

/* A triangle or a parallelogram, with a visible point in it or near it. */
static void make_huge(maker *m)
{
    double centre[3], a[3], b[3];
    anchor(m, centre);
    any_direction(m, a);
    any_direction(m, b);
    double size = oracle_spread(m->random, 1, 8000), along = uniform(m, 0, 1);
    double across = uniform(m, 0, 1);
    int count = some(m, 3, 4);
    m->count = 0;
    for (int i = 0; i < count; i++) {
        double u = (i == 1 || i == 2) - along, v = (i == 2 || i == 3) - across, view[3];
        for (int k = 0; k < 3; k++) {
            view[k] = centre[k] + size * (a[k] * u + b[k] * v);
        }
        put_view(m, view);
    }
}

/* A level plane a little below the eye. One edge or two pass close to the eye, with ends that
 * are far away. Half of the time pitch and roll are small. */
static void make_ground(maker *m)
{
    int64_t *n = m->input->numbers;
    if (oracle_below(m->random, 2)) {
        n[10] = (uint32_t)(int32_t)oracle_signed_spread(m->random, 1, 1 << 28);
        n[11] = oracle_below(m->random, 2)
                    ? 0
                    : (uint32_t)(int32_t)oracle_signed_spread(m->random, 1, 1 << 26);
    }
    double down = -oracle_spread(m->random, 1.0 / 256, 2);
    double close = oracle_signed_spread(m->random, 1.0 / 256, 1);
    double wide = oracle_signed_spread(m->random, 1.0 / 256, 16000);
    double angle = uniform(m, 0, FULL_TURN);
    if (oracle_below(m->random, 2)) { /* along the view */
        angle = ldexp((double)n[9], -32) * FULL_TURN + oracle_signed_spread(m->random, 1e-6, 0.3);
    }
    double reach = oracle_spread(m->random, 8, 11000), skew = uniform(m, -0.5, 0.5);
    double s = sin(angle), c = cos(angle);
    int count = some(m, 3, 4);
    m->count = 0;
    for (int i = 0; i < count; i++) {
        double along = i == 0 || i == 3 ? -reach : reach * (1 + skew);
        double across = i < 2 ? close : wide;
        double *vertex = m->vertices[m->count++];
        vertex[0] = s * along + c * across;
        vertex[1] = down;
        vertex[2] = c * along - s * across;
    }
}

/* A round polygon with rounded points on its edges, and repeated points. */
static void make_collinear(maker *m)
{
    make_round(m, 0.05, 1);
    for (int i = 1; i + 1 < m->count; i++) {
        uint32_t what = oracle_below(m->random, 4);
        for (int k = 0; k < 3; k++) {
            if (what < 2) {
                m->vertices[i][k] = (m->vertices[i - 1][k] + m->vertices[i + 1][k]) / 2;
            } else if (what == 2) {
                m->vertices[i][k] = m->vertices[i - 1][k];
            }
        }
        i += what < 2;
    }
}

/* A view coordinate that is a multiple of 1/65536, or of 1/2. */
static double whole(const maker *m, double value)
{
    double unit = oracle_below(m->random, 2) ? 1.0 / 65536 : 0.5;
    return round(value / unit) * unit;
}

/* A rectangle that faces the eye, with some of its sides on those of the frustum. */
static void make_facing(maker *m, double level)
{
    double sides[4]; /* left, right, low, high */
    for (int i = 0; i < 4; i++) {
        double out = oracle_below(m->random, 2) ? level : whole(m, uniform(m, 0, 3) * level);
        sides[i] = i % 2 ? out : -out;
    }
    if (oracle_below(m->random, 2)) {
        level = m->near;
    }
    int count = some(m, 3, 4);
    for (int i = 0; i < count; i++) {
        double view[3] = {sides[i == 1 || i == 2], sides[2 + (i >= 2)], level};
        put_view(m, view);
    }
}

/* Quarter turns, a square screen and 90 degrees, so the sides are x = +-z and y = +-z. Triangles
 * whose vertices lie on them, and on near and far. */
static void make_on_planes(maker *m)
{
    int64_t *n = m->input->numbers;
    n[1] = n[0];
    n[2] = FXL_ANGLE_QUARTER;
    n[5] = oracle_below(m->random, 2) ? 0 : n[5];
    for (int i = 9; i < 12; i++) {
        n[i] &= 0xC0000000;
    }
    centre_lens(m);
    measure_lens(m);
    double level = whole(m, oracle_spread(m->random, m->near, fmin(m->far, 4000)));
    m->count = 0;
    if (oracle_below(m->random, 4) == 0) {
        make_facing(m, level);
        return;
    }
    for (int i = 0; i < 3; i++) {
        double view[3];
        uint32_t depth = oracle_below(m->random, 4);
        view[2] = depth == 0   ? m->near
                  : depth == 1 ? fmin(m->far, 4000)
                  : depth == 2 ? level
                               : whole(m, uniform(m, -4, 64));
        for (int k = 0; k < 2; k++) {
            view[k] = oracle_below(m->random, 2) ? view[2] : -view[2];
            if (oracle_below(m->random, 3) == 0) {
                view[k] = whole(m, uniform(m, -3, 3) * view[2]);
            }
        }
        put_view(m, view);
    }
}

/* Triangles, and axis-aligned rectangles, at the ends of the range. */
static void make_at_ends(maker *m)
{
    const int64_t *n = m->input->numbers;
    int axis = (int)oracle_below(m->random, 3), flat = oracle_below(m->random, 2) == 0;
    double level = oracle_signed_spread(m->random, 1.0 / 256, 8000);
    int count = flat ? some(m, 3, 4) : 3;
    m->count = 0;
    for (int i = 0; i < count; i++) {
        double *vertex = m->vertices[m->count++];
        for (int k = 0; k < 3; k++) {
            int high = k == (axis + 1) % 3 ? i == 1 || i == 2 : i == 2 || i == 3;
            high = flat ? high : (int)oracle_below(m->random, 2);
            vertex[k] = (high ? 8191 : -8191) - (double)n[6 + k] / 65536;
            if (flat ? k == axis : oracle_below(m->random, 4) == 0) {
                vertex[k] = flat ? level : uniform(m, -8, 8);
            }
        }
    }
}

/* A polygon around the eye or behind it; its plane passes the eye at some distance. */
static void make_around(maker *m)
{
    double centre[3], a[3], b[3];
    double size = oracle_spread(m->random, 0.1, 8000);
    double off = size * oracle_spread(m->random, 1e-4, 1);
    any_direction(m, centre);
    any_direction(m, a);
    any_direction(m, b);
    for (int i = 0; i < 3; i++) {
        centre[i] *= off;
        a[i] *= size;
        b[i] *= size;
    }
    ellipse(m, centre, a, b, some(m, 3, FXL_FACE_VERTICES_MAX));
}

/* A polygon tilted by 1e-9..0.1 against one of the six planes, and crossing it where it is
 * visible. */
static void make_parallel(maker *m)
{
    int plane = (int)oracle_below(m->random, FXL_PLANE_COUNT);
    double centre[3], across[3] = {1, 0, 0}, along[3] = {0, 1, 0}, normal[3] = {0, 0, 1};
    anchor(m, centre);
    if (plane == FXL_PLANE_NEAR || plane == FXL_PLANE_FAR) {
        centre[0] /= centre[2];
        centre[1] /= centre[2];
        centre[2] = plane == FXL_PLANE_NEAR ? m->near : fmin(m->far, 9000);
        centre[0] *= centre[2];
        centre[1] *= centre[2];
    } else {
        int k = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_RIGHT ? 0 : 1;
        double slope = k == 0 ? m->slope_x : m->slope_y, length = hypot(1, slope);
        double sign = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_BOTTOM ? 1 : -1;
        centre[k] = -sign * (centre[2] * slope - m->inset * length);
        for (int i = 0; i < 3; i++) {
            across[i] = i == 2 ? 1 / length : i == k ? -sign * slope / length : 0;
            along[i] = i == 1 - k;
            normal[i] = i == 2 ? slope / length : i == k ? sign / length : 0;
        }
    }
    double size = centre[2] * oracle_spread(m->random, 0.1, 1e4);
    double tilt = oracle_spread(m->random, 1e-9, 0.1), turn = uniform(m, 0, FULL_TURN);
    double a[3], b[3], place = size * uniform(m, -1, 1);
    for (int i = 0; i < 3; i++) {
        a[i] = size * (across[i] * cos(turn) + along[i] * sin(turn) + normal[i] * tilt);
        b[i] = size * (along[i] * cos(turn) - across[i] * sin(turn));
        centre[i] += place * (b[i] / size);
    }
    ellipse(m, centre, a, b, some(m, 3, 8));
}

/* Quarter turns and a focal length of half the width. At depth width / 2 a unit of the world is
 * a pixel of the screen. Parallelograms and triangles on half pixels. */
static void make_on_centres(maker *m)
{
    int64_t *n = m->input->numbers;
    n[0] = n[1] = 4 << oracle_below(m->random, 5);
    n[2] = FXL_ANGLE_QUARTER;
    centre_lens(m);
    n[3] = 65536;
    n[4] = FXL_FAR_MAX;
    n[5] = oracle_below(m->random, 2) ? 0 : 4;
    int off = oracle_below(m->random, 4) == 0; /* off by a few 2^-32 of a turn */
    for (int i = 9; i < 12; i++) {
        n[i] &= 0xC0000000;
    }
    double depth = (double)n[0] / 2;
    int span = (int)n[0] * 2 + 4, parts = 1 + (int)oracle_below(m->random, 4);
    int64_t p[2], a[2], b[2];
    for (int k = 0; k < 2; k++) {
        p[k] = oracle_between(m->random, -span / 2, span / 2);
        a[k] = oracle_between(m->random, -span / (2 * parts), span / (2 * parts)) * parts;
        b[k] = oracle_between(m->random, -span / 2, span / 2);
    }
    m->count = 0;
    int corners = some(m, 3, 4);
    for (int corner = 0; corner < corners; corner++) {
        int steps = corner == 0 && corners + parts - 1 <= m->count_max ? parts : 1;
        for (int step = 0; step < steps; step++) {
            int64_t u = corner == 0 ? step : corner < 3 ? parts : 0, v = corner >= 2;
            double view[3] = {0, 0, depth};
            for (int k = 0; k < 2; k++) {
                view[k] = (double)(p[k] + u * a[k] / parts + v * b[k]) / 2;
            }
            if (corners == 3 && parts == 1 && oracle_below(m->random, 2)) {
                for (int k = 0; k < 3; k++) {
                    view[k] *= 4;
                }
            }
            put_view(m, view);
        }
    }
    for (int i = 9; i < 12 && off; i++) {
        n[i] = (uint32_t)(n[i] + oracle_between(m->random, -8, 8));
    }
}

static void make(maker *m)
{
    switch (m->input->kind) {
    case ROUND:
        make_round(m, 0.01, 1);
        return;
    case SLIVER:
        make_round(m, 1e-7, 1e-2);
        return;
    case HUGE_ONES:
        make_huge(m);
        return;
    case GROUND:
        make_ground(m);
        return;
    case COLLINEAR:
        make_collinear(m);
        return;
    case ON_PLANES:
        make_on_planes(m);
        return;
    case AT_ENDS:
        make_at_ends(m);
        return;
    case AROUND:
        make_around(m);
        return;
    case PARALLEL:
        make_parallel(m);
        return;
    default:
        make_on_centres(m);
    }
}

/* Rounds to 16.16 and appends the vertices. Returns 0 where one is out of range. */
static int put_vertices(maker *m)
{
    m->input->count = ORACLE_SETUP_NUMBERS;
    oracle_put(m->input, m->count);
    for (int i = 0; i < m->count; i++) {
        for (int k = 0; k < 3; k++) {
            double coordinate =
                (double)m->input->numbers[6 + k] + floor(m->vertices[i][k] * 65536 + 0.5);
            if (!(fabs(coordinate) <= FXL_COORDINATE_MAX)) {
                return 0;
            }
            oracle_put(m->input, (int64_t)coordinate);
        }
    }
    return 1;
}

void oracle_polygon_generate(oracle_random *random, int side_max, int count_max,
                             oracle_input *input)
{
    maker m = {.random = random, .input = input, .count_max = count_max};
    do {
        input->count = 0;
        input->kind = (int)oracle_below(random, KINDS);
        oracle_setup_generate(random, side_max, input);
        measure_lens(&m);
        make(&m);
    } while (!put_vertices(&m));
}

int oracle_polygon_read(const oracle_input *input, int rest, oracle_setup *setup,
                        fxl_polygon *polygon)
{
    const int64_t *n = &input->numbers[ORACLE_SETUP_NUMBERS];
    if (input->count <= ORACLE_SETUP_NUMBERS || !oracle_setup_read(input, setup) || n[0] < 3 ||
        n[0] > FXL_FACE_VERTICES_MAX ||
        input->count != ORACLE_SETUP_NUMBERS + 1 + 3 * n[0] + rest) {
        return 0;
    }
    *polygon = (fxl_polygon){.colour = 1, .count = (uint8_t)n[0]};
    for (int i = 0; i < polygon->count; i++) {
        const int64_t *c = &n[1 + 3 * i];
        if (llabs(c[0]) > FXL_COORDINATE_MAX || llabs(c[1]) > FXL_COORDINATE_MAX ||
            llabs(c[2]) > FXL_COORDINATE_MAX) {
            return 0;
        }
        polygon->vertices[i].position = (fxl_point){(int32_t)c[0], (int32_t)c[1], (int32_t)c[2]};
    }
    return 1;
}
