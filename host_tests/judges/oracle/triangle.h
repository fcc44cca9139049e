/* SPDX-License-Identifier: MIT */
/* Triangles of the world about a pixel: random ones, and their planes in exact arithmetic. */
#ifndef ORACLE_TRIANGLE_H
#define ORACLE_TRIANGLE_H

#include <gmp.h>

#include "oracle/setup.h"

/* --- random ones --------------------------------------------------------------------------------
 */

/* The point of the view at depth z that the centre of a pixel shows, for the setup of an input. */
void oracle_triangle_point(const oracle_input *input, const int64_t pixel[2], double z,
                           double point[3]);

/* Three corners in the view about a point, clockwise. Edges are from a thousandth of `most` to
 * `most` times as long as the point is deep. */
void oracle_triangle_about(oracle_random *random, const double point[3], double most,
                           double view[3][3]);

/* The unit normal of three corners of the world, each component to nearest; 0 where they are on one
 * line. */
fxl_direction oracle_triangle_normal(const fxl_point *corners);

/* --- exact ---------------------------------------------------------------------------------------
 */

typedef struct {
    mpz_t c[3];
} oracle_vector;

void oracle_vectors_init(oracle_vector *vectors, int count);
void oracle_vectors_clear(oracle_vector *vectors, int count);

/* a . way */
void oracle_vector_dot(mpz_t to, const oracle_vector *a, const int64_t way[3]);

/* The size of the largest component. */
double oracle_vector_size(const oracle_vector *v);

/* Of corners P0, P1 and P2 with the edges E1 and E2: E1 x E2, E2 x P0 and P0 x E1. */
void oracle_triangle_planes(const oracle_view_point corners[3], oracle_vector planes[3]);

/* The direction of the centre of a pixel: x to the right, y upward, the focal length; 16.16. */
void oracle_pixel_way(const fxl_view *view, int64_t x, int64_t y, int64_t way[3]);

#endif
