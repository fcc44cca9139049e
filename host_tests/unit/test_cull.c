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

static const fxl_face *next_face(const fxl_model_view *model_view, fxl_face_walk *walk)
{
#if FXL_IS_COMPACT
    return fxl_next_face_by(model_view, walk, fxl_model_view_face_is_front);
#else
    return fxl_next_front_face(model_view, walk);
#endif
}

/* Compares a walk over the cube's faces, whose first vertices are fetched or not, with each face asked
 * for itself. Returns how many are found. */
static uint32_t check_walk(tiny_scene *tiny, const fxl_view *view, int32_t step, bool drops,
                           bool is_fetched)
{
    static fxl_cached_vertex entries[16];
    fxl_vertex_cache cache = {0};
    fxl_model_view model_view;
    fxl_vertex_cache_init(&cache, entries, 16);
    fxl_model_view_of_instance(&model_view, &tiny->scene, &tiny->instances[0], view, &cache);
    for (uint32_t i = 0; is_fetched && i < 8; i++) {
        (void)fxl_fetch_vertex(&model_view, i);
    }
    fxl_face_walk walk = {
        .face = &tiny->faces[step > 0 ? 0 : 5], .step = step, .left = 6, .drops = drops};
    const fxl_face *found[6], *last = NULL;
    uint32_t left[6], count = 0, outside = 0, at = 0;
    while (count < 6 && (last = next_face(&model_view, &walk)) != NULL) {
        left[count] = walk.left;
        found[count++] = last;
    }
    TEST_ASSERT_TRUE(count == 6 || walk.left == 0);
    for (uint32_t i = 0; i < 6; i++) {
        const fxl_face *face = &tiny->faces[step > 0 ? i : 5 - i];
        if (!fxl_model_view_face_is_front(&model_view, face)) {
            continue;
        }
        if (drops && fxl_face_is_outside(&model_view, face)) {
            outside++;
            continue;
        }
        TEST_ASSERT_TRUE(at < count);
        TEST_ASSERT_EQUAL_PTR(face, found[at]);
        TEST_ASSERT_EQUAL_UINT32(5 - i, left[at]);
        at++;
    }
    TEST_ASSERT_EQUAL_UINT32(count, at);
    TEST_ASSERT_EQUAL_UINT32(outside, walk.outside);
    return count;
}

/* In both directions, with faces outside dropped and not, of squares and of triangles. */
void test_a_walk_finds_the_faces_that_face_the_eye(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_view view;
    fxl_lens lens;
    uint32_t found = 0, kept = 0;
    fxl_lens_from_fov(64, 48, FXL_DEGREES(60), FXL_RATIO(1, 4), Q16(100), 4, &lens);
    fxl_view_set_lens(&view, &lens);
    tiny->instances[0].centre = (fxl_point){0, 0, 0};
    for (uint32_t i = 0; i < 64; i++) {
        const fxl_pose pose = {unit_point(Q16(5)), (fxl_angle)(i << 28), 0, 0};
        const bool is_square = i % 2 == 0;
        fxl_view_set_pose(&view, &pose);
        for (uint32_t f = 0; f < 6; f++) {
            if (!is_square) {
                memcpy(tiny->faces[f].indices, fxl_face_indices(tiny->corners, &tiny->faces[f]),
                       sizeof tiny->faces[f].indices);
                tiny->faces[f].count = 3;
            }
        }
        for (uint32_t way = 0; way < 8; way++) {
            const uint32_t count = check_walk(tiny, &view, way & 1 ? -1 : 1, (way & 2) != 0,
                                              (way & 4) != 0);
            found += way & 2 ? 0 : count;
            kept += way & 2 ? count : 0;
        }
        tiny = tiny_make();
        tiny->instances[0].centre = (fxl_point){0, 0, 0};
    }
    TEST_ASSERT_TRUE(kept > 0 && kept < found);
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
