/* SPDX-License-Identifier: MIT */
#include "tiny.h"
#include "view/cull.h"
#include "view/model_view.h"
#include "view/order.h"

static int64_t side_of(const fxl_face *face, const fxl_point *first, const fxl_point *eye)
{
    return (int64_t)face->normal.x * (eye->x - first->x) +
           (int64_t)face->normal.y * (eye->y - first->y) +
           (int64_t)face->normal.z * (eye->z - first->z);
}

void test_three_faces_of_a_cube_are_seen(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_point eye = {Q16(10), Q16(10), Q16(10)};
    int seen = 0;
    for (int f = 0; f < 6; f++) {
        const fxl_face *face = &tiny->faces[f];
        bool front = fxl_face_is_front(&tiny->scene, &tiny->instances[0], face, &eye);
        TEST_ASSERT_EQUAL(face->normal.x + face->normal.y + face->normal.z > 0, front);
        seen += front;
    }
    TEST_ASSERT_EQUAL(3, seen);
}

/* On the face's plane it is edge-on, and not drawn; a unit further, it is. */
/* SPEC 4.5a */
void test_edge_on_is_not_seen(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_point eye = {Q16(1), Q16(50), Q16(-70)};
    for (int f = 0; f < 6; f++) {
        if (tiny->faces[f].normal.x <= 0) {
            continue;
        }
        eye.x = Q16(1);
        TEST_ASSERT_FALSE(
            fxl_face_is_front(&tiny->scene, &tiny->instances[0], &tiny->faces[f], &eye));
        eye.x = Q16(1) + 1;
        TEST_ASSERT_TRUE(
            fxl_face_is_front(&tiny->scene, &tiny->instances[0], &tiny->faces[f], &eye));
    }
}

/* The least sum that there is, 1 unit of 2^-46, decides. */
/* SPEC 4.5b */
void test_the_least_bit_decides(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_face *face = &tiny->faces[1];
    const fxl_point *first = &tiny->vertices[face->indices[0]];
    face->normal.y = 1;
    for (int32_t side = -1; side <= 1; side++) {
        fxl_point eye = {first->x, first->y + side, first->z};
        TEST_ASSERT_EQUAL(side > 0,
                          fxl_face_is_front(&tiny->scene, &tiny->instances[0], face, &eye));
    }
}

/* An eye in the plane of a face does not see it; a unit before it, it does. With the bounds that
 * the scene stores, and without. */
void test_an_eye_in_the_plane_of_a_face(void)
{
    static fxl_draw_entry entries[6];
    tiny_scene *tiny = tiny_make();
    const fxl_instance *cube = &tiny->instances[1];
    for (int bounds = 0; bounds < 2; bounds++) {
        tiny->scene.face_bounds = bounds ? tiny->keys : NULL;
        for (int unit = -1; unit <= 1; unit++) {
            const fxl_point eye = {0, Q16(1) + unit, cube->centre.z};
            const fxl_point from = {eye.x, eye.y, 0};
            const uint32_t count = fxl_list_front_faces(
                &tiny->scene, &tiny->scene.models[cube->model], &from, entries);
            TEST_ASSERT_EQUAL_UINT32(unit > 0, count);
            TEST_ASSERT_TRUE(count == 0 || entries[0].index == 3);
            TEST_ASSERT_EQUAL(unit > 0,
                              fxl_face_is_front(&tiny->scene, cube, &tiny->faces[9], &eye));
        }
    }
}

/* SPEC 4.5b, accuracy 1.1n */
void test_facing_is_exact_everywhere(void)
{
    tiny_scene *tiny = tiny_make();
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_face *face = &tiny->faces[0];
        fxl_point eye = unit_point(FXL_COORDINATE_MAX);
        face->normal = unit_direction();
        tiny->instances[0].centre = unit_point(FXL_COORDINATE_MAX - Q16(1));
        fxl_point first = tiny->vertices[face->indices[0]];
        first.x += tiny->instances[0].centre.x;
        first.y += tiny->instances[0].centre.y;
        first.z += tiny->instances[0].centre.z;
        if (i % 4 == 0) {
            eye = (fxl_point){first.x, first.y, first.z};
            eye.y += unit_between(-1, 1);
        }
        TEST_ASSERT_EQUAL(side_of(face, &first, &eye) > 0,
                          fxl_face_is_front(&tiny->scene, &tiny->instances[0], face, &eye));
        fxl_view view = {.camera.position = eye};
        fxl_vertex_cache cache = {0};
        fxl_model_view model_view;
        fxl_model_view_of_instance(&model_view, &tiny->scene, &tiny->instances[0], &view, &cache);
        TEST_ASSERT_EQUAL(side_of(face, &first, &eye) > 0,
                          fxl_model_view_face_is_front(&model_view, face));
    }
}

void test_a_face_becomes_a_polygon_of_the_world(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_polygon polygon;
    memset(&polygon, 0x5A, sizeof polygon);
    tiny->instances[0].centre = (fxl_point){Q16(100), Q16(-200), Q16(300)};
    const fxl_face *face = &tiny->faces[4];
    fxl_view view = {.camera.position = {Q16(7), Q16(-8), Q16(9)}};
    fxl_vertex_cache cache = {0};
    fxl_model_view model_view;
    fxl_model_view_of_instance(&model_view, &tiny->scene, &tiny->instances[0], &view, &cache);
    fxl_face_to_polygon(&model_view, face, &polygon);
    TEST_ASSERT_EQUAL(face->material, polygon.colour);
    TEST_ASSERT_EQUAL(4, polygon.count);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &polygon.vertices[4], sizeof polygon.vertices[4]);
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_point *from = &tiny->vertices[fxl_face_indices(tiny->corners, face)[i]];
        const fxl_vertex *vertex = &polygon.vertices[i];
        TEST_ASSERT_EQUAL_INT32(from->x + Q16(100), vertex->position.x);
        TEST_ASSERT_EQUAL_INT32(from->y - Q16(200), vertex->position.y);
        TEST_ASSERT_EQUAL_INT32(from->z + Q16(300), vertex->position.z);
    }
    TEST_ASSERT_FALSE(polygon.textured);
}
