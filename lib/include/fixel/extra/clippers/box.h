/* SPDX-License-Identifier: MIT */
/* A box about an object against the frustum: tighter than a sphere about what is
 * long or flat, and dearer. A renderer asks spheres. Source: chapter 65 (A9). */
#ifndef FXL_BOX_H
#define FXL_BOX_H

#include "fixel/stage/frustum.h"
#include "fixel/scene.h"
#include "fixel/stage/sphere.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A part of the world with its sides along the axes: least <= point <= most in each
 * coordinate. */
typedef struct {
    fxl_point least, most;
} fxl_box;

/* The least box about all vertices of an object, where it stands. Exact. One look at
 * each vertex of its model: so keep it where the object does not move.
 * Requires an object of a checked scene. */
void fxl_box_of_instance(const fxl_scene *scene, const fxl_instance *instance, fxl_box *box);

/* Which planes a box may cross, as fxl_sphere_planes answers: a bit each, 0 where it lies
 * inside all of them, FXL_SPHERE_OUTSIDE alone where it lies outside of one. A plane is
 * crossed unless all corners of the box lie outside of it by more than 2^-9 unit, or all
 * inside of it by no less, with the world's integers, exactly. The 2^-9 unit covers what lies
 * between them and those of the view, and what every clipper rounds. So of vertices that lie in the
 * box no face is drawn, by whatever clipper, where the answer is FXL_SPHERE_OUTSIDE; and every one
 * is inside a plane whose bit is not set. Requires a frustum made by its function, corners within
 * FXL_COORDINATE_MAX. At most twelve sums of three long products. */
uint32_t fxl_box_planes(const fxl_frustum *frustum, const fxl_box *box);

#ifdef __cplusplus
}
#endif

#endif
