/* SPDX-License-Identifier: MIT */
/* Tells whether a pixel's centre lies exactly on an edge of a polygon on the screen. Only the
 * fill rule decides to which side such a centre belongs, and no rounded arithmetic can tell.
 *
 * The test is exact for every pose. It uses the matrix as the angles define it, not as 2.30
 * rounds it. An edge A B (relative to the eye) passes the centre where (A x B) . (px right + py
 * up + focal forward) = 0. Multiplied out, this is a sum of integers times cosines of multiples
 * of 2^-32 turn. The cosines of 0 to 2^30 - 1 are linearly independent over the rationals
 * (powers of a root of unity of degree 2^31), so the sum is 0 only where every factor is 0. Ties
 * are common at quarter turns, possible at eighths, and at any yaw for an edge at the height of
 * the eye.
 *
 * The test looks only at edges of the polygon itself. An edge that the frustum made never counts
 * as tied. Without an inset, the edges that the sides make have no centre on them. A centre on
 * an edge of the near or far plane is judged by its distance.
 *
 * Links with -lm only. */
/* place fill-rule: definition: whether a centre is on a tie */
#ifndef ORACLE_TIE_H
#define ORACLE_TIE_H

#include <stdbool.h>
#include <stdint.h>

/* The integers of the scene, unchanged: 16.16 and binary angles. */
typedef struct {
    int32_t eye[3];
    uint32_t yaw, pitch, roll;
    int32_t width, height;    /* pixels */
    int32_t focal;            /* pixels, 16.16, rounded as in the lens */
    int32_t near, far, inset; /* 16.16 */
    int32_t centre[2];        /* where the screen is straight ahead: x, and y down; pixels, 16.16 */
} oracle_tie_view;

/* Tells whether the centre of pixel (column, row) lies on the visible part of an edge of the
 * polygon with these vertices of the world (x y z of each in 16.16, within +-8191, in order,
 * closed). The line is decided exactly. The ends of the visible part are decided to 1e-9 of the
 * depth; an end is included. */
bool oracle_tied(const oracle_tie_view *view, const int32_t *vertices, int count, int column,
                 int row);

#endif
