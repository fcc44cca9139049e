/* SPDX-License-Identifier: MIT */
/* The integers that exact clipping takes as given: a matrix, six planes and the scales of the
 * projection. Some clippers have other integers than the view. */
#ifndef ORACLE_SPACE_H
#define ORACLE_SPACE_H

#include "oracle/setup.h"

/* A point (x', y', z') / w, in units of 2^-46, is inside where x x' + y y' + z z' + offset 2^up
 * w >= 0. up gives the offset the unit of the products. */
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

/* The integers of the view: SPEC.md, sections 4.6 to 4.8. */
oracle_space oracle_space_of_view(const fxl_view *view);

/* The integers of the normalised frustum, docs/extras/clippers.md, section 2.2: the matrix
 * includes the field of view. */
oracle_space oracle_space_of_normalised(const fxl_view *view);

#endif
