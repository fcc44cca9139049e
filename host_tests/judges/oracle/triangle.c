/* SPDX-License-Identifier: MIT */
#include "oracle/triangle.h"

#include <math.h>

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
