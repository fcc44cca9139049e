/* SPDX-License-Identifier: MIT */
/* Clipping to the normalised frustum: the field of view is folded into the
 * matrix, so that the side planes lie at x = +-z and y = +-z. Source: chapter 65 (A13). */
#ifndef FXL_NORMALISED_H
#define FXL_NORMALISED_H

#include "fixel/extra/clippers/clip_record.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A row of the matrix: 2^-shift times a direction of 2.30, which is at least
 * 1/2 and at most 1 long. */
typedef struct {
    fxl_direction direction;
    uint8_t shift;
} fxl_normalised_row;

/* The frustum and the way into it. A point (x, y, z) is inside
 *   left, right   where  z +- x >= x_inset,
 *   bottom, top   where  z +- y >= y_inset,
 *   near, far     where  near <= z <= far.
 * These integers are the planes. */
typedef struct {
    fxl_point eye;
    fxl_normalised_row x, y, z;
    fxl_q18_46 x_inset, y_inset, near_z, far_z;
    fxl_q16_16 half_width, half_height; /* pixels */
} fxl_normalised;

/* With X, Y, Z along right, up and forward, as transform has them:
 *   x = s (focal / (width / 2)) X,  y = s (focal / (height / 2)) Y,  z = s Z,
 * s the largest power of two, 1 at most, at which no factor exceeds 1: so depths stay as
 * exact as they were, and what lies in the near plane does. The insets of the sides are
 * as large as a distance measured along the normal makes them.
 * Requires a camera and a lens made by their functions.
 * Error: an entry of the matrix, taken without its shift, 1.1 units of 2^-30;
 * none in near and far; an inset 2^-25 of itself,
 * on screens at most twice as high as wide and four times as wide as high. */
void fxl_normalised_from_camera(const fxl_camera *camera, const fxl_lens *lens,
                                fxl_normalised *frustum);

/* Requires a point in range. Error, given the matrix: half a unit of 2^-46 a
 * coordinate, none where the row's shift is 0. Each is below 2^61. */
void fxl_normalised_point(const fxl_normalised *frustum, const fxl_point *point,
                          fxl_view_point *seen);

/* The same for a point relative to the eye, along the world's axes; each below 2^30. */
void fxl_normalised_from_eye(const fxl_normalised *frustum, const fxl_point *from_eye,
                             fxl_view_point *seen);

/* A bit, 1 << FXL_PLANE_..., for each plane that the point lies outside of.
 * Exact. Requires |x|, |y|, |z| < 2^61. */
uint32_t fxl_normalised_code(const fxl_normalised *frustum, const fxl_view_point *point);

/* How far inside a plane, in units of 2^-46, times a factor that is the plane's.
 * Exact, below 2^63. */
fxl_q18_46 fxl_normalised_distance(const fxl_normalised *frustum, int plane,
                                   const fxl_view_point *point);

/* Clips a polygon of normalised points. One that is outside as a whole by one
 * plane, or inside of all, is known by its vertices' codes; otherwise it is cut by
 * those planes alone that a vertex lies outside of, in the order of their numbers.
 * *result is the input itself where nothing was cut, else in room; null where
 * nothing is left. The input may be either polygon of room, and is then lost.
 * Error of a new vertex: 1 unit of 2^-46 a coordinate from the edge for each
 * plane that made it, 3 from the plane. */
fxl_clip_result fxl_clip_normalised(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                                    fxl_clip_workspace *workspace,
                                    const fxl_varying_polygon **result);

/* x = width/2 (1 + x / z), y = height/2 (1 - y / z).
 * Error, given the point: 0.52 unit of 1/65536 pixel.
 * FXL_E_RANGE where z <= 0 or the point lies further than 4095 pixels off. */
fxl_status fxl_normalised_project(const fxl_normalised *frustum, const fxl_view_point *point,
                                  fxl_screen_point *screen);

#ifdef __cplusplus
}
#endif

#endif
