/* SPDX-License-Identifier: MIT */
#include "oracle/triangle.h"

#include <math.h>
#include <stdlib.h>

/* Whether the corners are clockwise as the eye sees them. */
static int is_clockwise(double view[3][3])
{
    const double *p = view[0];
    double a[3], b[3];
    for (int k = 0; k < 3; k++) {
        a[k] = view[1][k] - p[k];
        b[k] = view[2][k] - p[k];
    }
    return (a[1] * b[2] - a[2] * b[1]) * p[0] + (a[2] * b[0] - a[0] * b[2]) * p[1] +
               (a[0] * b[1] - a[1] * b[0]) * p[2] <
           0;
}

void oracle_triangle_about(oracle_random *random, const double point[3], double most,
                           double view[3][3])
{
    double edges[2][3], part[2];
    for (int i = 0; i < 2; i++) {
        const double length = point[2] * oracle_spread(random, most / 1000, most);
        oracle_direction(random, 0.01, edges[i]);
        part[i] = oracle_uniform(random, 0.05, 0.45);
        for (int k = 0; k < 3; k++) {
            edges[i][k] *= length;
        }
    }
    for (int k = 0; k < 3; k++) {
        view[0][k] = point[k] - part[0] * edges[0][k] - part[1] * edges[1][k];
        view[1][k] = view[0][k] + edges[0][k];
        view[2][k] = view[0][k] + edges[1][k];
    }
    if (!is_clockwise(view)) {
        for (int k = 0; k < 3; k++) {
            const double other = view[1][k];
            view[1][k] = view[2][k];
            view[2][k] = other;
        }
    }
}

void oracle_triangle_point(const oracle_input *input, const int64_t pixel[2], double z,
                           double point[3])
{
    const int64_t *n = input->numbers;
    const double focal = (double)n[0] / 2 / tan(ldexp((double)n[2], -32) * 3.141592653589793);
    point[0] = ((double)pixel[0] + 0.5 - (double)n[0] / 2) * z / focal;
    point[1] = ((double)n[1] / 2 - (double)pixel[1] - 0.5) * z / focal;
    point[2] = z;
}

/* The unit normal of the corners, each component to nearest; coordinates are below 2^30, so
 * products are below 2^63. */
fxl_direction oracle_triangle_normal(const fxl_point *p)
{
    const int64_t a[3] = {(int64_t)p[1].x - p[0].x, (int64_t)p[1].y - p[0].y,
                          (int64_t)p[1].z - p[0].z};
    const int64_t b[3] = {(int64_t)p[2].x - p[0].x, (int64_t)p[2].y - p[0].y,
                          (int64_t)p[2].z - p[0].z};
    const long double n[3] = {(long double)((oracle_wide)a[1] * b[2] - (oracle_wide)a[2] * b[1]),
                              (long double)((oracle_wide)a[2] * b[0] - (oracle_wide)a[0] * b[2]),
                              (long double)((oracle_wide)a[0] * b[1] - (oracle_wide)a[1] * b[0])};
    const long double length = sqrtl(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length == 0) {
        return (fxl_direction){0, 0, 0};
    }
    return (fxl_direction){(int32_t)floorl(n[0] / length * FXL_Q2_30_ONE + 0.5L),
                           (int32_t)floorl(n[1] / length * FXL_Q2_30_ONE + 0.5L),
                           (int32_t)floorl(n[2] / length * FXL_Q2_30_ONE + 0.5L)};
}

void oracle_vectors_init(oracle_vector *vectors, int count)
{
    for (int i = 0; i < 3 * count; i++) {
        mpz_init(vectors[i / 3].c[i % 3]);
    }
}

void oracle_vectors_clear(oracle_vector *vectors, int count)
{
    for (int i = 0; i < 3 * count; i++) {
        mpz_clear(vectors[i / 3].c[i % 3]);
    }
}

static void set_cross(oracle_vector *to, const oracle_vector *a, const oracle_vector *b)
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        mpz_mul(to->c[k], a->c[i], b->c[j]);
        mpz_submul(to->c[k], a->c[j], b->c[i]);
    }
}

void oracle_vector_dot(mpz_t to, const oracle_vector *a, const int64_t way[3])
{
    mpz_t factor;
    mpz_init(factor);
    mpz_set_si(to, 0);
    for (int k = 0; k < 3; k++) {
        mpz_set_si(factor, way[k]);
        mpz_addmul(to, a->c[k], factor);
    }
    mpz_clear(factor);
}

double oracle_vector_size(const oracle_vector *v)
{
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        largest = fmax(largest, fabs(mpz_get_d(v->c[k])));
    }
    return largest;
}

void oracle_triangle_planes(const oracle_view_point corners[3], oracle_vector planes[3])
{
    oracle_vector edges[3]; /* the first corner; from it to the others */
    oracle_vectors_init(edges, 3);
    for (int i = 0; i < 3; i++) {
        mpz_set_si(edges[i].c[0], corners[i].x);
        mpz_set_si(edges[i].c[1], corners[i].y);
        mpz_set_si(edges[i].c[2], corners[i].z);
    }
    for (int k = 0; k < 3; k++) {
        mpz_sub(edges[1].c[k], edges[1].c[k], edges[0].c[k]);
        mpz_sub(edges[2].c[k], edges[2].c[k], edges[0].c[k]);
    }
    set_cross(&planes[0], &edges[1], &edges[2]);
    set_cross(&planes[1], &edges[2], &edges[0]);
    set_cross(&planes[2], &edges[0], &edges[1]);
    oracle_vectors_clear(edges, 3);
}

void oracle_pixel_way(const fxl_view *view, int64_t x, int64_t y, int64_t way[3])
{
    way[0] = x * 65536 + 32768 - view->projection.centre_x;
    way[1] = view->projection.centre_y - 32768 - y * 65536;
    way[2] = fxl_view_drawn_focal(view);
}
