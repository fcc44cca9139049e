/* SPDX-License-Identifier: MIT */
/* What a fault names: the kind of element, and its number. Where a whole table or a setting is at
 * fault the number is 0. */
#include "expect_scene.h"

void test_the_fault_names_the_element(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault;
    tiny->faces[7].count = 2;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(7, fault.index);
    tiny = tiny_make();
    tiny->instances[2].model = 9;
    TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_UINT32(2, fault.index);
}

/* What fxl_scene_open names of an image with one word that is something else. */
static void expect_name(fxl_status status, const char *what, uint32_t index, uint32_t at,
                        uint32_t value)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    tiny_put32(tiny_at(image, at), value);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(status, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
}

/* The same for an image of so many vertices. */
static void expect_vertices(fxl_status status, const char *what, uint32_t index, uint32_t count)
{
    fxl_point vertices[17] = {{0, 0, 0}};
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    memcpy(vertices, tiny_make()->vertices, 16 * sizeof vertices[0]);
    tiny_set_section(image, SECTION_VERTICES, vertices, count, sizeof vertices[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(status, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
}

void test_the_fault_names_the_part(void)
{
    tiny_image *image = tiny_image_make(false);
    expect_name(FXL_E_SIZE, "image", 0, AT_VERSION, IMAGE_VERSION | 1000u << 16);
    expect_name(FXL_E_SIZE, "image", 0, AT_SIZE, image->size + 4);
    expect_name(FXL_E_COUNT, "face bounds table", 0, AT_KEYS + 4, 0);
    expect_vertices(FXL_E_COUNT, "vertex table", 0, 17); /* more than the models take */
    expect_vertices(FXL_E_INDEX, "model", 1, 15);
    tiny_scene *tiny = tiny_make();
    fxl_scene_fault fault = {"nothing", 99};
    tiny->scene.face_bounds_count = 7; /* one more than the models take */
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("face bounds table", fault.what);
    TEST_ASSERT_EQUAL_UINT32(0, fault.index);
}

/* Two models that are sorted, and bounds for all faces of the first and some of the second. */
void test_too_few_bounds_for_the_second_model(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_face_bounds bounds[12];
    fxl_scene_fault fault = {"nothing", 99};
    for (int i = 0; i < 12; i++) {
        bounds[i] = tiny->keys[i % 6];
    }
    tiny->models[0].kind = FXL_MODEL_SORTED;
    tiny->models[1].first_face_bounds = 6;
    tiny->scene.face_bounds = bounds;
    tiny->scene.face_bounds_count = 12;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, &fault));
    for (uint32_t count = 6; count < 12; count++) {
        tiny->scene.face_bounds_count = count;
        TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
        TEST_ASSERT_EQUAL_STRING("model", fault.what);
        TEST_ASSERT_EQUAL_UINT32(1, fault.index);
    }
}

/* The same for a word of an entry of a table, which begins `at` bytes into the entry. */
static void expect_entry_name(fxl_status status, const char *what, uint32_t table, uint32_t number,
                              uint32_t size, uint32_t at, uint32_t value)
{
    tiny_image *image = tiny_image_make(false);
    expect_name(status, what, number, tiny_get(image, table) + number * size + at, value);
}

void test_an_image_as_a_whole(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_open(NULL, 1000, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("image", fault.what);
    TEST_ASSERT_EQUAL_UINT32(0, fault.index);
    fault = (fxl_scene_fault){"nothing", 99};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_open(image->words, image->size, NULL, &fault));
    TEST_ASSERT_EQUAL_STRING("image", fault.what);
    TEST_ASSERT_EQUAL_UINT32(0, fault.index);
    fault = (fxl_scene_fault){"nothing", 99};
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      fxl_scene_open(tiny_at(image, 2), image->size - 4, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("image", fault.what);
    TEST_ASSERT_EQUAL_UINT32(0, fault.index);
    expect_name(FXL_E_MAGIC, "image", 0, AT_MAGIC, 0);
    expect_name(FXL_E_VERSION, "image", 0, AT_VERSION, TINY_SECTIONS << 16 | (IMAGE_VERSION - 1));
    expect_name(FXL_E_RESERVED, "image", 0, AT_BACKGROUND, 0x1000); /* of the target */
    expect_name(FXL_E_OFFSET, "section", 0, HEADER_SIZE, 0x10000);  /* of kind 0 */
    expect_name(FXL_E_OFFSET, "palette table", 0, HEADER_SIZE + SECTION_BYTES, 0x10001);
    expect_name(FXL_E_VERSION, "section", 0, HEADER_SIZE, 0x10000 | SECTION_KINDS);
    expect_name(FXL_E_RESERVED, "section", 7, AT_KEYS - 4, 0x1000000 | SECTION_KINDS);
}

void test_a_setting(void)
{
    expect_name(FXL_E_RANGE, "lens", 0, AT_NEAR, 0);
    for (uint32_t i = 0; i < 12; i += 4) {
        expect_name(FXL_E_RANGE, "start pose", 0, AT_START + i, 0x80000000u);
        expect_name(FXL_E_RANGE, "motion limits", 0, AT_MOTION_LIMITS + i, 0x80000000u);
    }
    expect_name(FXL_E_RANGE, "motion limits", 0, AT_MOTION_LIMITS + 12, 0x80000000u);
}

void test_a_table(void)
{
    static const struct {
        uint32_t at;
        const char *name;
    } tables[] = {{AT_PALETTE, "palette table"}, {AT_VERTICES, "vertex table"},
                  {AT_CORNERS, "index table"},   {AT_FACES, "face table"},
                  {AT_MODELS, "model table"},    {AT_INSTANCES, "instance table"},
                  {AT_PATH, "path table"},       {AT_KEYS, "face bounds table"}};
    for (size_t i = 0; i < sizeof tables / sizeof tables[0]; i++) {
        tiny_image *image = tiny_image_make(false);
        const uint32_t offset = tiny_get(image, tables[i].at);
        expect_name(FXL_E_COUNT, tables[i].name, 0, tables[i].at + 4, 0);
        expect_name(FXL_E_COUNT, tables[i].name, 0, tables[i].at + 4, 0xFFFFFFFFu);
        expect_name(FXL_E_ALIGNMENT, tables[i].name, 0, tables[i].at, offset + 1);
        expect_name(FXL_E_ALIGNMENT, tables[i].name, 0, tables[i].at, offset + 2);
        expect_name(FXL_E_OFFSET, tables[i].name, 0, tables[i].at, 0);
        expect_name(FXL_E_OFFSET, tables[i].name, 0, tables[i].at, image->size);
    }
    expect_name(FXL_E_COUNT, "path table", 0, AT_FRAMES, TINY_POSES + 1);
}

/* A path must be there, though it says that it has no frames. */
void test_an_image_without_a_path(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    fxl_scene_fault fault = {"nothing", 99};
    tiny_set_section(image, SECTION_POSES, NULL, 0, 0);
    tiny_put32(tiny_at(image, AT_FRAMES), 0);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("path table", fault.what);
}

void test_an_entry_of_a_table(void)
{
    expect_entry_name(FXL_E_COUNT, "face", AT_FACES, 4, FACE, 12, 2);
    expect_entry_name(FXL_E_INDEX, "face", AT_FACES, 4, FACE, 12, 8u << 16 | 3); /* a triangle */
    expect_entry_name(FXL_E_INDEX, "face", AT_FACES, 4, FACE, 16, 46);
    expect_entry_name(FXL_E_NORMAL, "face", AT_FACES, 4, FACE, 0, 1u << 29);
    expect_entry_name(FXL_E_RESERVED, "model", AT_MODELS, 1, MODEL, 16, 2);
    expect_entry_name(FXL_E_RANGE, "model", AT_MODELS, 1, MODEL, 20, 0xFFFFFFFFu);
    expect_entry_name(FXL_E_COUNT, "model", AT_MODELS, 1, MODEL, 4, 2);
    expect_entry_name(FXL_E_COUNT, "model", AT_MODELS, 1, MODEL, 12, 0);
    expect_entry_name(FXL_E_INDEX, "model", AT_MODELS, 1, MODEL, 8, 5);
    expect_entry_name(FXL_E_RESERVED, "model", AT_MODELS, 0, MODEL, 24, 1);
    expect_entry_name(FXL_E_INDEX, "model", AT_MODELS, 1, MODEL, 24, 1);
    expect_entry_name(FXL_E_INDEX, "instance", AT_INSTANCES, 1, INSTANCE, 12, 2);
    expect_entry_name(FXL_E_RESERVED, "instance", AT_INSTANCES, 1, INSTANCE, 12, 1u << 24);
    expect_entry_name(FXL_E_RANGE, "instance", AT_INSTANCES, 1, INSTANCE, 8, 0x7FFFFFFFu);
    expect_entry_name(FXL_E_RADIUS, "vertex", AT_MODELS, 0, MODEL, 20, 0);
    expect_entry_name(FXL_E_RANGE, "pose", AT_PATH, 1, POSE, 4, 0x7FFFFFFFu);
}

/* An index out of range is the fault of the face that has it, in whichever model and corner. */
void test_a_face_with_an_index_out_of_range(void)
{
    for (uint32_t corner = 0; corner < 48; corner++) {
        tiny_scene *tiny = tiny_make();
        fxl_scene_fault fault = {"nothing", 99};
        tiny->corners[corner] = 8;
        TEST_ASSERT_EQUAL(FXL_E_INDEX, fxl_scene_check(&tiny->scene, &fault));
        TEST_ASSERT_EQUAL_STRING("face", fault.what);
        TEST_ASSERT_EQUAL_UINT32(corner / 4, fault.index);
    }
}

void test_a_segment_of_the_path(void)
{
    for (uint32_t number = 0; number < TINY_STRIDES; number++) {
        for (int no_frames = 0; no_frames < 2; no_frames++) {
            tiny_image *image = tiny_image_make(true);
            fxl_scene_image opened;
            fxl_scene_fault fault = {"nothing", 99};
            tiny_put16(tiny_entry(image, AT_PATH, number, STRIDE) + 2 * no_frames,
                       no_frames ? 0 : FXL_KEY_ALL + 1);
            tiny_seal(image);
            TEST_ASSERT_EQUAL(no_frames ? FXL_E_COUNT : FXL_E_RESERVED,
                              fxl_scene_open(image->words, image->size, &opened, &fault));
            TEST_ASSERT_EQUAL_STRING("path segment", fault.what);
            TEST_ASSERT_EQUAL_UINT32(number, fault.index);
        }
    }
}

/* Each table of a scene must be there. */
void test_a_scene_without_a_table(void)
{
    for (int i = 0; i < 6; i++) {
        fxl_scene *scene = &tiny_make()->scene;
        fxl_scene_fault fault = {"nothing", 99};
        scene->vertices = i == 0 ? NULL : scene->vertices;
        scene->indices = i == 1 ? NULL : scene->indices;
        scene->faces = i == 2 ? NULL : scene->faces;
        scene->models = i == 3 ? NULL : scene->models;
        scene->instances = i == 4 ? NULL : scene->instances;
        TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(i == 5 ? NULL : scene, &fault));
        TEST_ASSERT_EQUAL_STRING("scene", fault.what);
        TEST_ASSERT_EQUAL_UINT32(0, fault.index);
    }
}

static void expect_fault(fxl_status status, const char *what, uint32_t index, fxl_scene *scene,
                         fxl_status (*check)(fxl_scene *scene, fxl_scene_fault *fault))
{
    fxl_scene_fault fault = {"nothing", 99};
    TEST_ASSERT_EQUAL(status, check(scene, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
}

static const void *moved(const void *table, int by)
{
    return (const void *)((uintptr_t)table + (unsigned)by);
}

/* Each table of a scene must begin where its records may. */
void test_a_scene_with_a_misaligned_table(void)
{
    static const uint64_t anywhere[64];
    for (int i = 0; i < 10; i++) {
        fxl_scene *scene = &tiny_make()->scene;
        scene->vertices = (const fxl_point *)moved(scene->vertices, i == 0 ? 1 : 0);
        scene->indices = (const uint16_t *)moved(scene->indices, i == 1 ? 1 : 0);
        scene->faces = (const fxl_face *)moved(scene->faces, i == 2 ? 2 : 0);
        scene->models = (const fxl_model *)moved(scene->models, i == 3 ? 1 : 0);
        scene->instances = (const fxl_instance *)moved(scene->instances, i == 4 ? 2 : 0);
        scene->face_bounds = (const fxl_face_bounds *)moved(scene->face_bounds, i == 5 ? 1 : 0);
        scene->bsp_nodes = i == 6 ? (const fxl_bsp_node *)moved(anywhere, 2) : NULL;
        scene->beams = i == 7 ? (const fxl_beam *)moved(anywhere, 1) : NULL;
        scene->clusters = i == 8 ? (const fxl_cluster *)moved(anywhere, 2) : NULL;
        scene->placements = i == 9 ? (const fxl_placement *)moved(anywhere, 1) : NULL;
        expect_fault(FXL_E_ALIGNMENT, "scene", 0, scene, fxl_scene_check_all);
        expect_fault(FXL_E_ALIGNMENT, "scene", 0, scene, fxl_scene_check);
    }
}

/* fxl_scene_check takes no scene of which any word says that it has a tree or beams. */
void test_trees_and_beams_need_the_other_check(void)
{
    static const fxl_bsp_node node;
    for (int i = 0; i < 4; i++) {
        fxl_scene *scene = &tiny_make()->scene;
        scene->bsp_nodes = i == 0 ? &node : NULL;
        scene->bsp_node_count = i == 1;
        scene->bsp_instance = i == 2;
        scene->beam_count = i == 3;
        expect_fault(FXL_E_ARGUMENT, i < 3 ? "BSP node table" : "beam table", 0, scene,
                     fxl_scene_check);
    }
}

void test_a_beam(void)
{
    static const fxl_point window[] = {
        {Q16(-1), Q16(5), Q16(-1)}, {Q16(1), Q16(5), Q16(-1)}, {0, Q16(5), Q16(1)}};
    static const uint8_t lit[256];
    static fxl_beam beams[FXL_BEAMS_MAX + 1];
    const fxl_point lamp = {0, Q16(9), 0};
    for (int i = 0; i <= FXL_BEAMS_MAX; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 3, &beams[i]));
    }
    fxl_scene *scene = &tiny_make()->scene;
    scene->beams = beams;
    scene->lit = lit;
    scene->beam_count = 2;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
    scene->lit = NULL;
    expect_fault(FXL_E_ARGUMENT, "beam table", 0, scene, fxl_scene_check_all);
    scene->lit = lit;
    scene->beams = NULL;
    expect_fault(FXL_E_ARGUMENT, "beam table", 0, scene, fxl_scene_check_all);
    scene->beams = beams;
    scene->beam_count = FXL_BEAMS_MAX; /* so many may be, but not for a face of 4 vertices */
    expect_fault(FXL_E_CAPACITY, "face", 0, scene, fxl_scene_check_all);
    scene->beam_count = FXL_BEAMS_MAX + 1;
    expect_fault(FXL_E_COUNT, "beam table", 0, scene, fxl_scene_check_all);
    scene->beam_count = 2;
    for (uint32_t i = 0; i < 2; i++) {
        beams[i].kind = 2;
        expect_fault(FXL_E_RESERVED, "beam", i, scene, fxl_scene_check_all);
        beams[i].kind = FXL_BEAM_POINT;
    }
}

/* Beams of 5 and 8 planes fit a face of 3 vertices and none of 4, whichever face that is. */
void test_a_face_that_does_not_fit_the_beams(void)
{
    static const fxl_point four[] = {{Q16(-1), Q16(5), Q16(-1)},
                                     {Q16(1), Q16(5), Q16(-1)},
                                     {Q16(1), Q16(5), Q16(1)},
                                     {Q16(-1), Q16(5), Q16(1)}};
    static const fxl_point seven[] = {{Q16(8), Q16(5), 0},        {Q16(5), Q16(5), Q16(6)},
                                      {Q16(-2), Q16(5), Q16(8)},  {Q16(-7), Q16(5), Q16(3)},
                                      {Q16(-7), Q16(5), Q16(-3)}, {Q16(-2), Q16(5), Q16(-8)},
                                      {Q16(5), Q16(5), Q16(-6)}};
    static const uint8_t lit[256];
    const fxl_point lamp = {0, Q16(9), 0};
    fxl_beam beams[2];
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, four, 4, &beams[0]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, seven, 7, &beams[1]));
    for (uint32_t large = 0; large <= 12 && FXL_FACE_VERTICES_MAX == 24; large++) {
        tiny_scene *tiny = tiny_make();
        tiny->scene.face_bounds = NULL;
        tiny->scene.face_bounds_count = 0;
        for (uint32_t i = 0; i < 12; i++) {
            tiny->faces[i].count = i == large ? 4 : 3;
            fxl_face_take_indices(&tiny->faces[i], tiny->corners, 4 * i);
        }
        tiny->scene.beams = beams;
        tiny->scene.lit = lit;
        tiny->scene.beam_count = 2;
        if (large < 12) {
            expect_fault(FXL_E_CAPACITY, "face", large, &tiny->scene, fxl_scene_check_all);
        } else {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
        }
    }
}
