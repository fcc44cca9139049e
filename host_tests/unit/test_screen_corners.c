/* SPDX-License-Identifier: MIT */
/* The corners of a face on the screen, from what the clipper has left in the cache, or found anew.
 */
#include "clip_unit.h"
#include "polygon_face.h"
#include "draw/surface_polygon.h"

enum {
    ENTRIES = 8
};

static fxl_view view;
static polygon_face face;
static fxl_scene scene;
static fxl_renderer renderer;
static fxl_traversal traversal;
static fxl_screen_corners expected, found;
static const uint16_t corners[3] = {0, 1, 2};

/* A quadrilateral before the eye, of which the face is the first triangle, as the clipper has left
 * it. */
static void make(void)
{
    static fxl_clipper_work work;
    static fxl_screen_polygon screen;
    static const int32_t places[4][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    fxl_polygon polygon = {.count = 4, .colour = 1};
    view = clip_random_view(64, 48);
    for (uint32_t i = 0; i < 4; i++) {
        polygon.vertices[i].position =
            clip_place(&view, places[i][0] * Q16(0.5), places[i][1] * Q16(0.25), Q16(3));
    }
    polygon_face_set(&face, &polygon, &view, ENTRIES);
    face.model_view.planes = FXL_PLANES_ALL;
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE,
                      fxl_clip_by_view(&face.model_view, &face.face, &work, &screen));
    face.face.count = 3;
    fxl_face_take_indices(&face.face, face.corners, 0);
    scene = (fxl_scene){.indices = face.corners, .faces = &face.face};
    renderer.scene = &scene;
    traversal.renderer = &renderer;
    traversal.clipper = &fxl_clipper_view;
    for (uint32_t i = 0; i < 3; i++) {
        expected.points[i] = screen.points[i];
        expected.depths[i] = fxl_fetch_vertex(&face.model_view, i)->position.z;
    }
}

void setUp(void)
{
    make();
}

/* What fxl_find_screen_corners answers of corners with these vertices. */
static bool finds(const uint16_t vertices[3])
{
    fxl_corner of[3];
    const fxl_corner *const three[3] = {&of[0], &of[1], &of[2]};
    for (uint32_t i = 0; i < 3; i++) {
        of[i] = (fxl_corner){{0, 0}, vertices[i], 0};
    }
    return fxl_find_screen_corners(&face.model_view, &face.face, three, &traversal, &found);
}

static void expect_corners(const uint16_t *vertices, bool is_triangle)
{
    memset(&found, 0x5A, sizeof found);
    TEST_ASSERT_TRUE(finds(vertices));
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_INT32(expected.points[i].x, found.points[i].x);
        TEST_ASSERT_EQUAL_INT32(expected.points[i].y, found.points[i].y);
        TEST_ASSERT_EQUAL_INT64(expected.depths[i], found.depths[i]);
    }
    TEST_ASSERT_EQUAL(is_triangle, found.is_triangle);
}

void test_a_vertex_that_the_cache_lost_is_found_anew(void)
{
    expect_corners(corners, true);
    for (uint32_t i = 0; i < 3; i++) {
        make();
        face.seen[i].tag = 0;
        expect_corners(corners, true);
        expect_corners(corners, true);
    }
}

/* The triangle is a part of the quadrilateral, whose box it has. */
void test_a_part_has_the_box_of_the_whole_face(void)
{
    static const uint32_t whole = FXL_WHOLE(0, 4);
    expect_corners(corners, true);
    const int32_t width = found.width, height = found.height;
    face.vertices[3] = clip_place(&view, Q16(1), -Q16(0.5), Q16(3)); /* far out, on the screen */
    face.seen[3].tag = 0;
    scene.wholes = &whole;
    expect_corners(corners, false);
    TEST_ASSERT_TRUE(found.width > width && found.height > height);
}

/* One, which is no corner, is between the eye and the near plane. The cache has lost it, and then it has it. */
void test_a_face_with_a_vertex_before_the_near_plane_has_no_box(void)
{
    face.vertices[3] = clip_place(&view, 0, 0, view.lens.near_z / 2);
    face.seen[3].tag = 0;
    face.face.count = 4;
    fxl_face_take_indices(&face.face, face.corners, 0);
    TEST_ASSERT_FALSE(finds(corners));
    TEST_ASSERT_FALSE(finds(corners));
}

void test_corners_that_are_not_the_face_s_are_refused(void)
{
    static const uint16_t other[3][3] = {{0, 1, 3}, {0, 3, 2}, {3, 1, 2}};
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_FALSE(finds(other[i]));
    }
}

/* Of a quadrilateral in the cache, none of whose corners is its first vertex, or all in another order. */
void test_corners_in_any_order_have_the_box_of_all_vertices(void)
{
    static const uint16_t last[3] = {1, 2, 3}, turned[3] = {2, 0, 1};
    TEST_ASSERT_TRUE(finds(turned));
    TEST_ASSERT_EQUAL_INT32(expected.points[2].x, found.points[0].x);
    TEST_ASSERT_EQUAL_INT64(expected.depths[0], found.depths[1]);
    TEST_ASSERT_TRUE(found.is_triangle);
    face.face.count = 4;
    fxl_face_take_indices(&face.face, face.corners, 0);
    TEST_ASSERT_TRUE(finds(last));
    const int32_t width = found.width;
    TEST_ASSERT_EQUAL_INT32(expected.points[1].x, found.points[0].x);
    TEST_ASSERT_FALSE(found.is_triangle);
    face.seen[0].screen.x -= 65536;
    TEST_ASSERT_TRUE(finds(last));
    TEST_ASSERT_EQUAL_INT32(width + 65536, found.width);
}
