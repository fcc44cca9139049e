/* SPDX-License-Identifier: MIT */
/* Clips to the normalised frustum: the matrix includes the field of view, so the side planes lie
 * at x = +-z and y = +-z. Source: chapter 65 (A13). */
#ifndef FXL_NORMALISED_H
#define FXL_NORMALISED_H

#include "../clip/volume.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A row of the matrix: 2^-shift times a direction in 2.30. The direction is at least 1/2 and at
 * most 1 long. */
typedef struct {
    fxl_direction direction;
    uint8_t shift;
} fxl_normalised_row;

/* The frustum and the matrix into it. A point (x, y, z) is inside
 *   left, right   where  z +- x >= x_inset,
 *   bottom, top   where  z +- y >= y_inset,
 *   near, far     where  near_z <= z <= far_z.
 * The planes are exactly what these integers say. */
typedef struct {
    fxl_point eye;
    fxl_normalised_row x, y, z;
    fxl_q18_46 x_inset, y_inset, near_z, far_z;
    fxl_q16_16 half_width, half_height; /* pixels */
} fxl_normalised;

/* Makes the normalised frustum of a camera and a lens. With X, Y, Z along right, up and forward,
 * as fxl_transform_point gives them:
 *   x = s (focal / (width / 2)) X,  y = s (focal / (height / 2)) Y,  z = s Z.
 * s is the largest power of two, at most 1, for which no factor exceeds 1. So depths stay as
 * exact as they were, and a point of the near plane stays in it. The insets of the sides equal
 * the lens's inset, measured along each plane's normal.
 * Requires a camera and a lens made by their functions.
 * Error: an entry of the matrix, taken without its shift, 1.1 units of 2^-30; near_z and far_z
 * none; an inset 2^-25 of itself, on screens at most twice as high as wide and at most four
 * times as wide as high. With an off-centre lens the matrix is that of the longer focal length, so
 * on the screen its error counts up to sqrt(17) times. */
void fxl_normalised_from_camera(const fxl_camera *camera, const fxl_lens *lens,
                                fxl_normalised *frustum);

/* Transforms a point that is given relative to the eye, along the axes of the world. Requires
 * each of its coordinates below 2^30. Error, given the matrix: half a unit of 2^-46 a coordinate,
 * none where the row's shift is 0. Each coordinate of the result is below 2^61. */
void fxl_normalised_from_eye(const fxl_normalised *frustum, const fxl_point *from_eye,
                             fxl_view_point *seen);

/* Returns the outcode of a point: a bit, 1 << FXL_PLANE_..., for each plane that the point lies
 * outside of. Exact. Requires |x|, |y|, |z| < 2^61. */
uint32_t fxl_normalised_code(const fxl_normalised *frustum, const fxl_view_point *point);

/* Returns how far a point is inside a plane, in units of 2^-46 times a constant factor of that
 * plane. Exact, below 2^63. */
fxl_q18_46 fxl_normalised_distance(const fxl_normalised *frustum, int plane,
                                   const fxl_view_point *point);

/* Clips a polygon of normalised points. Outcodes reject a polygon whose vertices are all outside
 * one plane, and accept one whose vertices are all inside all planes. Any other polygon is
 * clipped, in the order of their numbers, to the planes that a vertex lies outside of.
 * *result is the input itself where nothing was cut, a polygon of workspace where something was,
 * null where nothing is left. The input may be a polygon of workspace, and is then overwritten.
 * Error of a new vertex: 1 unit of 2^-46 a coordinate from the edge for each plane that made it,
 * and 3 units from the plane. */
fxl_clip_result fxl_clip_normalised(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                                    fxl_clip_workspace *workspace,
                                    const fxl_varying_polygon **result);

/* Projects a point: x = width/2 (1 + x / z), y = height/2 (1 - y / z).
 * Error, given the point: 0.52 unit of 1/65536 pixel.
 * FXL_E_RANGE: z <= 0, or the result is more than 4095 pixels off; *screen untouched. */
fxl_status fxl_normalised_project(const fxl_normalised *frustum, const fxl_view_point *point,
                                  fxl_screen_point *screen);

#ifdef __cplusplus
}
#endif

#endif
