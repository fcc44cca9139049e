/* SPDX-License-Identifier: MIT */
/* Polygons for the tests of the family of clippers; views from anywhere, and points and polygons of
 * the world that lie at given places of a view. */
#ifndef CLIP_UNIT_H
#define CLIP_UNIT_H

#include "unit.h"

/* World units of the view, exactly. */
#define V(units) ((fxl_q18_46)(units) * ((int64_t)1 << 46))

/* From whole numbers x, y, z of each vertex; two numbers ride along: 65536 x and
 * the vertex's place in the list. */
fxl_varying_polygon clip_shape(const int *numbers, size_t count);
#define SHAPE(...) clip_shape((const int[]){__VA_ARGS__}, sizeof((const int[]){__VA_ARGS__}) / 12)

/* Every second vertex at x = -reach, the others at x = 0, all at depth 10. */
fxl_varying_polygon clip_saw(uint8_t count, int reach);

/* The same vertices in the same order, from whichever vertex on, and what is
 * carried. */
bool clip_same(const fxl_varying_polygon *a, const fxl_varying_polygon *b);

/* A flat convex polygon about somewhere before the eye, up to 2^bits units of
 * 2^-46 in size. */
fxl_varying_polygon clip_random_shape(unsigned bits);

/* Any pose within 100 units, with the tests' standard lens. */
fxl_view clip_random_view(uint16_t width, uint16_t height);

/* A point so far to the right, up and ahead, to within a unit or two. */
fxl_point clip_place(const fxl_view *view, fxl_q16_16 x, fxl_q16_16 y, fxl_q16_16 z);

/* A flat, convex polygon of 3 to 6 vertices; before the eye, or partly behind it. */
fxl_polygon clip_random_face(const fxl_view *view);

/* The camera of a pose, and the planes of its view: in the view and in the world. */
static inline void clip_look(const fxl_pose *pose, const fxl_lens *lens, fxl_camera *camera,
                             fxl_view_frustum *frustum, fxl_frustum *world)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, camera));
    fxl_view_frustum_from_lens(lens, frustum);
    fxl_frustum_from_sides(camera, lens, frustum, world);
}

#endif
