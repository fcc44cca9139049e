/* SPDX-License-Identifier: MIT */
/* A depth buffer (SPEC.md, section 10) from its definition: at a pixel, of all faces that cover its
 * centre, that is seen which the ray through the centre meets first. */
#ifndef REF_DEPTH_BUFFER_H
#define REF_DEPTH_BUFFER_H

#include "reference/camera.h"
#include "reference/scene.h"

/* The plane of a face in the view: normal . point = height. */
typedef struct {
    ref_view_point normal;
    long double height;
    double slack; /* by how much of itself a nearness of the library may be off */
} ref_depth_plane;

/* Finds the plane of a face of an instance through its vertices: the middle of them, and the sum of
 * the products of neighbours. The slack is what a plane that is moved by 2 FXL_PLANARITY_MAX and
 * 2^-27 of the face's size makes of it. */
void ref_depth_plane_find(const ref_scene *scene, const ref_camera *camera,
                          const ref_instance *instance, const ref_face *face,
                          ref_depth_plane *plane);

/* 1 / z, where z is the distance at which the plane is seen at a point of the screen. */
double ref_nearness(const ref_depth_plane *plane, const ref_lens *lens, double x, double y);

/* The ratio of nearnesses, less 1, from which on a buffer of so many bits tells two faces apart. */
double ref_depth_resolution(const ref_lens *lens, int bits);

#endif
