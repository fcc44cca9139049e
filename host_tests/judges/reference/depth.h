/* SPDX-License-Identifier: MIT */
/* Depths: how far the library's may be off, and the depth buffer. */
#ifndef REF_DEPTH_H
#define REF_DEPTH_H

#include "reference/clip.h"
#include "reference/scene.h"

/* How far a depth of the library may differ from the exact one, and the frustum with near and
 * far moved by that much (docs/accuracy.md, sections 1 and 4). */

/* Returns the most that rounding may change the depth of a point of the polygon. It is 2 units
 * of 2^-30 an entry of the camera's matrix, times the largest |dx| + |dy| + |dz| of a vertex,
 * plus 4 units of 2^-46 of a clipper's own coordinates. Those may be smaller than the world's by
 * the ratio of the shorter side of the screen to twice the focal length. */
double ref_depth_bound(const ref_polygon *polygon, const ref_point *eye, const ref_lens *lens);

/* Tells whether near or far, moved by at most the bound, cuts the polygon or meets a vertex of
 * it. */
bool ref_depth_is_in_doubt(const ref_view_frustum *frustum, const ref_camera *camera,
                           const ref_polygon *polygon, double bound);

/* Moves near and far apart by a distance; towards each other where it is negative. */
void ref_depth_move_frustum(ref_frustum *frustum, double distance);
void ref_depth_move_view_frustum(ref_view_frustum *frustum, double distance);

/* A depth buffer (SPEC.md, section 10) from its definition: at a pixel, of all faces that cover its
 * centre, that is seen which the ray through the centre meets first. */

/* The plane of a face in the view: normal . point = height. */
typedef struct {
    ref_view_point normal;
    long double height;
    double slack; /* by how much of itself a nearness of the library may be off */
    double moved; /* by how much a depth may be off, in world units */
} ref_depth_plane;

/* Finds the plane of a face of an instance through its vertices: the middle of them, and the sum of
 * the products of neighbours. The slack is what a plane that is moved by 2 FXL_PLANARITY_MAX and
 * 2^-27 of the face's size makes of it. */
void ref_depth_plane_find(const ref_scene *scene, const ref_camera *camera,
                          const ref_instance *instance, const ref_face *face,
                          ref_depth_plane *plane);

/* Makes the slack that of an orthographic lens. */
void ref_depth_plane_take_eye(ref_depth_plane *plane, const ref_lens *lens);

/* With an orthographic lens the depth of docs/extras/orthographic.md, 2.11; else
 * 1 / z, where z is the distance at which the plane is seen at a point of the screen. */
double ref_nearness(const ref_depth_plane *plane, const ref_lens *lens, double x, double y);

/* The same of a point at a depth. */
long double ref_nearness_of_point(const ref_lens *lens, long double z);

/* The ratio of nearnesses, less 1, from which on a buffer of so many bits tells two faces apart. */
double ref_depth_resolution(const ref_lens *lens, int bits);

#endif
