/* SPDX-License-Identifier: MIT */
/* The integers that exact clipping takes as given: a matrix, six planes and the way onto
 * the screen. Some clippers have other ones than the view. */
#ifndef ORACLE_SPACE_H
#define ORACLE_SPACE_H

#include "oracle/setup.h"

/* Inside is x x' + y y' + z z' + offset 2^up w >= 0 for the point (x', y', z') / w in units of
 * 2^-46; up makes the units those of the products. */
typedef struct {
    int64_t x, y, z, offset;
    unsigned up;
} oracle_plane;

typedef struct {
    fxl_camera camera; /* a row is 2^-shift times its direction, then rounded to 2^-46 */
    unsigned x_shift, y_shift, z_shift;
    oracle_plane planes[FXL_PLANE_COUNT];
    int64_t centre_x, centre_y; /* of the screen, 1/65536 pixel */
    int64_t x_scale, y_scale;   /* pixels of 1/65536 for side / depth = 1 */
} oracle_space;

/* SPEC.md, sections 4.6 to 4.8. */
oracle_space oracle_space_of_view(const fxl_view *view);

/* docs/extras/clippers.md, section 2.2: the field of view folded into the matrix. */
oracle_space oracle_space_of_normalised(const fxl_view *view);

#endif
