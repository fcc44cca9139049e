/* SPDX-License-Identifier: MIT */
/* Whether a pixel's centre lies exactly on an edge of a polygon as it is seen:
 * such a centre belongs to either side by the fill rule alone, and no rounded
 * arithmetic can tell to which.
 *
 * Decided for every pose, with the matrix as its angles define it and not as
 * 2.30 rounds it. An edge A B (relative to the eye) is seen through the centre
 * where (A x B) . (px right + py up + focal forward) = 0. Multiplied out that is
 * a sum of whole numbers times cosines of multiples of 2^-32 turn, and those of
 * 0 to 2^30 - 1 are linearly independent over the rationals (powers of a root of
 * unity of degree 2^31), so the sum is 0 only where each has the factor 0. Ties
 * are common at quarter turns, possible at eighths, and at any yaw for an edge
 * at the eye's height.
 *
 * Only edges of the polygon itself are looked at. An edge that the frustum made
 * is never called tied: without inset those of the sides have no centre on
 * them, and a centre on one of the near or far plane is left to its distance.
 *
 * Links with -lm only. */
#ifndef ORACLE_TIE_H
#define ORACLE_TIE_H

#include <stdbool.h>
#include <stdint.h>

/* The scene's integers, as they stand: 16.16 and binary angles. */
typedef struct {
    int32_t eye[3];
    uint32_t yaw, pitch, roll;
    int32_t width, height;    /* pixels */
    int32_t focal;            /* pixels, 16.16, as the lens rounds it */
    int32_t near, far, inset; /* 16.16 */
} oracle_tie_view;

/* Whether the centre of pixel (column, row) lies on the seen part of an edge of
 * the polygon with these vertices of the world (x y z of each in 16.16,
 * within +-8191, in order, closed). The line is decided exactly; where the seen part ends, to 1e-9
 * of its depth and including the end. */
bool oracle_tied(const oracle_tie_view *view, const int32_t *vertices, int count, int column,
                 int row);

#endif
