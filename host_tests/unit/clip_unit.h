/* SPDX-License-Identifier: MIT */
/* Polygons for the tests of the family of clippers; views from anywhere, and points and polygons of
 * the world that lie at given places of a view; and cases of one plane, worked out by hand, with
 * the vertex that neighbours share. */
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

/* The volume of a lens. */
static inline void clip_volume(const fxl_lens *lens, uint32_t screen, fxl_volume *volume)
{
    fxl_view_frustum sides;
    fxl_view_frustum_from_lens(lens, &sides);
    fxl_volume_from_sides(&sides, lens->focal, screen, volume);
}

/* The camera of a pose, and the planes of its view: in the view and in the world. */
static inline void clip_look(const fxl_pose *pose, const fxl_lens *lens, fxl_camera *camera,
                             fxl_view_frustum *frustum, fxl_frustum *world)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, camera));
    fxl_view_frustum_from_lens(lens, frustum);
    fxl_frustum_from_sides(camera, lens, frustum, world);
}

/* Transforms each vertex of a polygon, and copies colour and count. */
static inline void clip_see_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                                    fxl_view_polygon *seen)
{
    seen->colour = polygon->colour;
    seen->count = polygon->count;
    for (int i = 0; i < polygon->count; i++) {
        fxl_transform_point(camera, &polygon->vertices[i].position, &seen->vertices[i].position);
    }
}

enum {
    PLANE_CASES = 12
};

/* A polygon as whole numbers: how far each vertex is inside the plane, and how far along it. */
typedef struct {
    uint8_t count;
    int numbers[14];
} plane_polygon;

typedef struct {
    const char *name;
    fxl_clip_result result;
    plane_polygon polygon;
    plane_polygon left; /* of FXL_CLIP_CUT */
} plane_case;

extern const plane_case plane_cases[PLANE_CASES];

/* Whether one of the vertices, of so many bytes each, is this one, bit for bit. */
bool plane_has_vertex(const void *vertices, int count, size_t size, const void *vertex);

/* Two polygons that share the edge a-b are cut. The new vertex on that edge must be one and the
 * same. outs: their vertices. */
void expect_shared_crossing(const void *const outs[2], const int counts[2], size_t size,
                            const void *a, const void *b, bool a_is_inside);

/* The same of polygons, two of them, and vertices of any type. */
#define EXPECT_SHARED_CROSSING(outs, a, b, a_is_inside) \
    expect_shared_crossing((const void *const[]){(outs)[0].vertices, (outs)[1].vertices}, \
                           (const int[]){(outs)[0].count, (outs)[1].count}, sizeof(a), &(a), &(b), \
                           (a_is_inside))

/* A cut that leaves so many vertices is refused beyond the capacity; else the polygon has them. */
void expect_capacity(fxl_clip_result result, int left, int count);

#endif
