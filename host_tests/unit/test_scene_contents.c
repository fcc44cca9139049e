/* SPDX-License-Identifier: MIT */
/* What a scene's tables hold: faces, models, objects, vertices, path. */
#include "expect_scene.h"

/* formats 1.2m, 1.2ay, 1.2az, 1.5a-b, SPEC 3.1r */
void test_face_contents(void)
{
    expect_entry_byte(FXL_E_COUNT, AT_FACES, 5, FACE, 12, 2);
    expect_entry_byte(FXL_E_COUNT, AT_FACES, 5, FACE, 12, 25);
#if FXL_FACE_VERTICES_MAX < 24
    expect_entry_byte(FXL_E_CAPACITY, AT_FACES, 5, FACE, 12, 24);
    expect_entry_byte(FXL_E_CAPACITY, AT_FACES, 5, FACE, 12, FXL_FACE_VERTICES_MAX + 1);
#endif
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 16, 45);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 16, 0xFFFFFFFFu);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 16, 0xFFFFFFFDu);
    expect_entry_word(FXL_E_INDEX, AT_FACES, 5, FACE, 16, 21); /* of its second vertex */
    expect_entry_byte(FXL_E_INDEX, AT_FACES, 5, FACE, 14, 7);  /* its second vertex */
    expect_entry_byte(FXL_E_INDEX, AT_FACES, 5, FACE, 15, 1);
}

void test_corner_contents(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_CORNERS, 13, CORNER), 8);
    expect_opening(FXL_E_INDEX, image);
    image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_CORNERS, 47, CORNER), 65535);
    expect_opening(FXL_E_INDEX, image);
}

/* formats 1.4c-d */
void test_model_contents(void)
{
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 9);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 0xFFFFFFFCu);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 4, 9);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 4, 2);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 4, 65536);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 7);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 0xFFFFFFFCu);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 12, 7);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 12, 0);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 12, 65536);
}

/* SPEC 3.1d */
void test_object_contents(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_put16(tiny_entry(image, AT_INSTANCES, 2, INSTANCE) + 12, 2);
    expect_opening(FXL_E_INDEX, image);
    for (uint32_t axis = 0; axis < 12; axis += 4) {
        uint32_t end = (uint32_t)FXL_COORDINATE_MAX, inner = end - (uint32_t)Q16(1);
        expect_entry_word(FXL_E_RANGE, AT_INSTANCES, 1, INSTANCE, axis, end + 1);
        expect_entry_word(FXL_E_RANGE, AT_INSTANCES, 1, INSTANCE, axis, 0x80000000u);
        /* The centre in range, a vertex a unit outside, and just inside. */
        expect_entry_word(FXL_E_RANGE, AT_INSTANCES, 1, INSTANCE, axis, inner + 1);
        expect_entry_word(FXL_OK, AT_INSTANCES, 1, INSTANCE, axis, inner);
        expect_entry_word(FXL_E_RANGE, AT_INSTANCES, 1, INSTANCE, axis, 0u - inner - 1);
        expect_entry_word(FXL_OK, AT_INSTANCES, 1, INSTANCE, axis, 0u - inner);
    }
}

/* formats 1.5a */
void test_vertices_far_out_do_not_wrap(void)
{
    expect_entry_word(FXL_E_RANGE, AT_VERTICES, 3, VERTEX, 4, 0x7FFFFFFFu);
    expect_entry_word(FXL_E_RANGE, AT_VERTICES, 3, VERTEX, 4, 0x80000000u);
}

/* Vertex 0 of model 1 at (-1, -1, -1): the square of the radius against the sum
 * of three squares, to the unit. */
/* SPEC 3.1o, 4.4a, formats 1.5a */
void test_radius(void)
{
    expect_entry_word(FXL_E_RANGE, AT_MODELS, 1, MODEL, 20, 0xFFFFFFFFu);
    expect_entry_word(FXL_E_RANGE, AT_MODELS, 1, MODEL, 20, 0x80000000u);
    expect_entry_word(FXL_E_RANGE, AT_MODELS, 1, MODEL, 20, (uint32_t)FXL_RADIUS_MAX + 1);
    expect_entry_word(FXL_OK, AT_MODELS, 1, MODEL, 20, (uint32_t)FXL_RADIUS_MAX);
    expect_entry_word(FXL_E_RADIUS, AT_MODELS, 1, MODEL, 20, 0);
    /* 65536 sqrt(3) = 113511.68 */
    expect_entry_word(FXL_E_RADIUS, AT_MODELS, 0, MODEL, 20, 113511);
    expect_entry_word(FXL_OK, AT_MODELS, 0, MODEL, 20, 113512);
}

/* Vertices that lie exactly on the sphere, and one unit off it; also where the
 * squares have 62 bits. */
/* SPEC 4.4a, formats 1.5a */
void test_vertices_on_the_sphere(void)
{
    const int32_t far = 2 * FXL_COORDINATE_MAX; /* of a model placed nowhere */
    tiny_scene *tiny = tiny_make();
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    tiny->instances[1].model = 0;
    for (int v = 8; v < 16; v++) {
        tiny->vertices[v] = (fxl_point){0, 3, 4};
    }
    tiny->models[1].radius = 5;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    tiny->vertices[15] = (fxl_point){0, 3, -4};
    tiny->vertices[15].x = 1;
    fxl_scene_fault fault;
    TEST_ASSERT_EQUAL(FXL_E_RADIUS, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("vertex", fault.what);
    TEST_ASSERT_EQUAL_UINT32(15, fault.index);
    for (int v = 8; v < 16; v++) {
        tiny->vertices[v] = (fxl_point){far, -far, -far};
    }
    /* sqrt(3) 2 * 8191 * 65536 = 1859548370.02 */
    tiny->models[1].radius = 1859548370;
    TEST_ASSERT_EQUAL(FXL_E_RADIUS, fxl_scene_check(&tiny->scene, NULL));
    tiny->models[1].radius = 1859548371;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
}

/* Keys are what the vertices say, to the unit, and belong to sorted models. */
/* formats 1.2r, 1.6a, 1.6c-d */
void test_keys(void)
{
    uint32_t height = (uint32_t)(((uint64_t)Q16(1) << 30) >> 32);
    expect_entry_word(FXL_OK, AT_KEYS, 5, KEY, 4, height);
    expect_entry_word(FXL_E_FACE_BOUNDS, AT_KEYS, 5, KEY, 4, height + 1);
    for (uint32_t at = 0; at < KEY; at += 4) {
        expect_entry_word(FXL_E_FACE_BOUNDS, AT_KEYS, 0, KEY, at, 1);
        expect_entry_word(FXL_E_FACE_BOUNDS, AT_KEYS, 4, KEY, at, 0x80000000u);
    }
    expect_entry_word(FXL_E_RESERVED, AT_MODELS, 0, MODEL, 24, 1);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 24, 1);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 24, 0xFFFFFFFFu);
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_FACE_BOUNDS, tiny_make()->keys, 5, KEY);
    expect_opening(FXL_E_INDEX, image);
    expect_entry_byte(FXL_E_COUNT, AT_MODELS, 1, MODEL, 16, FXL_MODEL_CONVEX);
    expect_entry_byte(FXL_E_INDEX, AT_MODELS, 0, MODEL, 16, FXL_MODEL_SORTED);
}

/* A scene need not have keys; then no model says where they are. */
/* formats 1.6e */
void test_no_keys(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_FACE_BOUNDS, NULL, 0, 0);
    expect_opening(FXL_OK, image);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.scene.face_bounds);
    tiny_put32(tiny_entry(image, AT_MODELS, 1, MODEL) + 24, 1);
    expect_opening(FXL_E_RESERVED, image);
}

/* SPEC 3.4b */
void test_normals(void)
{
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0x7FFFFFFFu);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, 0x80000000u);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 8, 0x80000000u);
    /* (2^30 + 2)^2 - 2^60 = 2^32 + 4: a little too long; 2^30 + 1 will do. */
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, (1u << 30) + 2);
    expect_entry_word(FXL_OK, AT_FACES, 1, FACE, 0, (1u << 30) + 1);
    expect_entry_word(FXL_E_NORMAL, AT_FACES, 1, FACE, 0, (1u << 30) - 3);
    expect_entry_word(FXL_OK, AT_FACES, 1, FACE, 0, (1u << 30) - 2);
}

/* Vertex 5 of model 0 belongs to a face +x: off its plane by 4 units at most. */
/* SPEC 3.4a */
void test_planarity(void)
{
    uint32_t x = (uint32_t)Q16(1);
    expect_entry_word(FXL_OK, AT_VERTICES, 5, VERTEX, 0, x + 4);
    expect_entry_word(FXL_OK, AT_VERTICES, 5, VERTEX, 0, x - 4);
    expect_entry_word(FXL_E_PLANARITY, AT_VERTICES, 5, VERTEX, 0, x + 5);
    expect_entry_word(FXL_E_PLANARITY, AT_VERTICES, 5, VERTEX, 0, x - 5);
}

/* Any vertex of a cube, off the plane of one of its three faces and along those of the others. */
/* SPEC 3.4a */
void test_planarity_of_every_vertex(void)
{
    for (uint32_t vertex = 0; vertex < 8; vertex++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            const uint32_t place = vertex >> (2 - axis) & 1u ? (uint32_t)Q16(1) : (uint32_t)Q16(-1);
            for (uint32_t off = 0; off < 2; off++) {
                expect_entry_word(FXL_E_PLANARITY, AT_VERTICES, vertex, VERTEX, 4 * axis,
                                  off ? place + 5 : place - 5);
                expect_entry_word(FXL_OK, AT_VERTICES, vertex, VERTEX, 4 * axis,
                                  off ? place + 4 : place - 4);
            }
        }
    }
}

/* The tools ensure it: a face that goes the other way round, and one whose outline crosses itself. */
/* SPEC 3.4e */
void test_the_way_round_is_not_checked(void)
{
    for (uint32_t other = 2; other < 4; other++) {
        tiny_scene *tiny = tiny_make();
        uint16_t *corners = tiny->corners + tiny->faces[2].count * 2;
        const uint16_t second = corners[1];
        corners[1] = corners[other];
        corners[other] = second;
        fxl_face_take_indices(&tiny->faces[2], tiny->corners, 8);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    }
}

void test_path_of_poses(void)
{
    uint32_t end = (uint32_t)FXL_COORDINATE_MAX;
    expect_entry_word(FXL_E_RANGE, AT_PATH, 1, POSE, 8, end + 1);
    expect_entry_word(FXL_E_RANGE, AT_PATH, 1, POSE, 0, 0u - end - 1);
    expect_entry_word(FXL_OK, AT_PATH, 1, POSE, 4, end);
    expect_entry_word(FXL_OK, AT_PATH, 1, POSE, 12, 0xFFFFFFFFu);
    expect_word(FXL_E_COUNT, AT_FRAMES, TINY_POSES + 1);
    expect_word(FXL_E_COUNT, AT_FRAMES, 0);
    expect_word(FXL_E_COUNT, AT_FRAMES, 1000001);
}

void test_path_of_strides(void)
{
    tiny_image *image = tiny_image_make(true);
    tiny_put16(tiny_entry(image, AT_PATH, 1, STRIDE), 0x100);
    expect_opening(FXL_E_RESERVED, image);
    image = tiny_image_make(true);
    tiny_put16(tiny_entry(image, AT_PATH, 1, STRIDE) + 2, 0);
    expect_opening(FXL_E_COUNT, image);
    image = tiny_image_make(true);
    tiny_put32(tiny_at(image, AT_FRAMES), 6);
    expect_opening(FXL_E_COUNT, image);
}

void test_a_scene_as_tables(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"untouched", 9};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES + 6, tiny->scene.draw_list_needed);
    TEST_ASSERT_EQUAL_STRING("untouched", fault.what);
    tiny->scene.draw_list_needed = 77;
    tiny->corners[30] = 8;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(77, tiny->scene.draw_list_needed);
    TEST_ASSERT_TRUE(strcmp(fault.what, "untouched") != 0);
    tiny = tiny_make();
    tiny->scene.faces = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(&tiny->scene, NULL));
    tiny = tiny_make();
    tiny->scene.instance_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, NULL));
}

static void expect_order_needed(uint8_t kind0, uint8_t kind1, uint32_t faces1, uint32_t expected)
{
    tiny_scene *tiny = tiny_make();
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    tiny->models[0].kind = kind0;
    tiny->models[1].kind = kind1;
    tiny->models[1].face_count = faces1;
    tiny->scene.face_count = 6 + faces1;
    /* A model behind the table's end does not count. */
    fxl_model models[3] = {tiny->models[0], tiny->models[1], tiny->models[1]};
    models[2].kind = FXL_MODEL_SORTED;
    models[2].face_count = 1000;
    tiny->scene.models = models;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL_UINT32(expected, tiny->scene.draw_list_needed);
}

void test_order_needs_the_objects_and_the_largest_sorted_model(void)
{
    expect_order_needed(FXL_MODEL_CONVEX, FXL_MODEL_CONVEX, 6, TINY_INSTANCES);
    expect_order_needed(FXL_MODEL_CONVEX, FXL_MODEL_SORTED, 4, TINY_INSTANCES + 4);
    expect_order_needed(FXL_MODEL_SORTED, FXL_MODEL_CONVEX, 4, TINY_INSTANCES + 6);
    expect_order_needed(FXL_MODEL_SORTED, FXL_MODEL_SORTED, 4, TINY_INSTANCES + 6);
}

/* Models take the vertices and the faces in turn, none twice, none left out. */
/* formats 1.4g-h */
void test_models_share_nothing_and_leave_nothing_out(void)
{
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 0, 0);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 1, MODEL, 8, 0);
    expect_entry_word(FXL_E_COUNT, AT_MODELS, 1, MODEL, 12, 5);
    expect_entry_word(FXL_E_INDEX, AT_MODELS, 0, MODEL, 12, 5);
}

void test_every_status_has_its_own_sentence(void)
{
    for (int i = 0; i < FXL_STATUS_COUNT; i++) {
        const char *text = fxl_status_text((fxl_status)i);
        TEST_ASSERT_NOT_NULL(text);
        TEST_ASSERT_TRUE(strlen(text) > 5 || i == FXL_OK);
        for (int other = 0; other < i; other++) {
            TEST_ASSERT_TRUE(strcmp(text, fxl_status_text((fxl_status)other)) != 0);
        }
    }
    TEST_ASSERT_NOT_NULL(fxl_status_text(FXL_STATUS_COUNT));
}
