/* SPDX-License-Identifier: MIT */
/* Where the tables of a scene may lie, how long they may be, and which element a fault names; limits
 * that are reached. */
#include "expect_scene.h"
#include "bsp_scene.h"
#include "choices.h"

static fxl_scene_image opened;

static fxl_status open(tiny_image *image, fxl_scene_fault *fault)
{
    tiny_seal(image);
    return fxl_scene_open(image->words, image->size, &opened, fault);
}

/* Each section begins where the one before it ends, and the last ends with the image. */
/* formats 1.2c */
void test_sections_lie_behind_each_other(void)
{
    for (uint32_t at = AT_PALETTE; at <= AT_KEYS; at += SECTION_BYTES) {
        for (int step = -4; step <= 4; step += 8) {
            fxl_scene_fault fault = {"", 0};
            tiny_image *image = tiny_image_make(false);
            tiny_put32(tiny_at(image, at), tiny_get(image, at) + (uint32_t)step);
            TEST_ASSERT_EQUAL(FXL_E_OFFSET, open(image, &fault));
        }
    }
    fxl_scene_fault fault = {"", 0};
    tiny_image *image = tiny_image_make(false);
    image->size += 4;
    tiny_put32(tiny_at(image, AT_SIZE), image->size);
    TEST_ASSERT_EQUAL(FXL_E_SIZE, open(image, &fault));
    TEST_ASSERT_EQUAL_STRING("image", fault.what);
}

/* Who begins to walk stands still, and was not held anywhere. */
void test_the_start_is_at_rest(void)
{
    memset(&opened, 0x5A, sizeof opened);
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL(FXL_OK, open(tiny_image_make(true), &fault));
    TEST_ASSERT_EQUAL_INT32(0, opened.start.speed);
    TEST_ASSERT_EQUAL_UINT32(0, opened.start.clamped);
    TEST_ASSERT_EQUAL_UINT8(200, opened.background);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), opened.motion_limits.acceleration);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25), opened.motion_limits.friction);
    TEST_ASSERT_EQUAL_INT32(Q16(2), opened.motion_limits.speed_max);
    TEST_ASSERT_EQUAL_HEX32(DEGREES(3), opened.motion_limits.turn);
}

static void expect_fault(fxl_status status, const char *what, uint32_t number, fxl_scene *scene)
{
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL(status, fxl_scene_check(scene, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(number, fault.index);
}

/* The tiny scene with all instances of one model, so that the other is placed nowhere. */
static tiny_scene *with_instances_of(uint16_t model)
{
    tiny_scene *tiny = tiny_make();
    for (int i = 0; i < TINY_INSTANCES; i++) {
        tiny->instances[i].model = model;
    }
    return tiny;
}

void test_faults_name_the_last_element_as_well_as_the_first(void)
{
    tiny_scene *tiny = tiny_make();
    tiny->scene.model_count = 1; /* the second model's vertices belong to nobody */
    tiny->instances[1].model = 0;
    expect_fault(FXL_E_COUNT, "vertex table", 0, &tiny->scene);
    tiny = tiny_make();
    tiny->models[1].face_count -= 1; /* the last face belongs to nobody */
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    expect_fault(FXL_E_COUNT, "face table", 0, &tiny->scene);
    tiny = with_instances_of(0);
    tiny->vertices[15].z = INT32_MAX;
    expect_fault(FXL_E_RANGE, "vertex", 15, &tiny->scene);
    tiny = with_instances_of(1);
    tiny->vertices[0].y = INT32_MIN;
    expect_fault(FXL_E_RANGE, "vertex", 0, &tiny->scene);
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) { /* any instance, by its first vertex alone */
        for (int axis = 0; axis < 3; axis++) {
            tiny = with_instances_of(0);
            fxl_point *vertex = &tiny->vertices[0], *centre = &tiny->instances[i].centre;
            fxl_q16_16 *const numbers[] = {&vertex->x, &vertex->y, &vertex->z,
                                           &centre->x, &centre->y, &centre->z};
            *numbers[axis] = -Q16(2);
            *numbers[axis + 3] = Q16(1.5) - FXL_COORDINATE_MAX;
            expect_fault(FXL_E_RANGE, "instance", i, &tiny->scene);
        }
    }
    for (uint32_t i = 0; i < 3;
         i++) { /* 5 indices from the first of the last face's 4 are too many */
        static const uint16_t counts[] = {2, 25, 5};
        tiny = tiny_make();
        uint32_t wholes[12] = {0};
        wholes[11] = FXL_WHOLE(44, counts[i]);
        tiny->scene.wholes = wholes;
        expect_fault(i < 2 ? FXL_E_COUNT : FXL_E_INDEX, "face", 11, &tiny->scene);
    }
    tiny = tiny_make();
    uint32_t wholes[12] = {0};
    tiny->scene.wholes = wholes;
    wholes[11] = FXL_WHOLE(44, 4);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    tiny->faces[11].count = 3; /* of the first three vertices of its whole */
    fxl_face_take_indices(&tiny->faces[11], tiny->corners, 44);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    tiny->corners[47] = 8; /* a model has 8 vertices */
    expect_fault(FXL_E_INDEX, "face", 11, &tiny->scene);
    tiny = tiny_make();
    tiny->instances[2].recolour = 1;
    expect_fault(FXL_E_RESERVED, "instance", 2, &tiny->scene);
    tiny = tiny_make();
    tiny->models[1].reserved = 1;
    expect_fault(FXL_E_RESERVED, "model", 1, &tiny->scene);
    tiny = tiny_make();
    tiny->models[1].first_cluster = 1;
    expect_fault(FXL_E_RESERVED, "model", 1, &tiny->scene);
    tiny = tiny_make();
    tiny->faces[10].normal.x = 1 << 20; /* no unit vector any more */
    expect_fault(FXL_E_NORMAL, "face", 10, &tiny->scene);
    tiny = tiny_make();
    tiny->keys[5].box_y += 1;
    expect_fault(FXL_E_FACE_BOUNDS, "face", 11, &tiny->scene);
}

/* formats 1.2k-o */
void test_tables_of_too_few_and_too_many(void)
{
    static const struct {
        uint32_t few, many;
        const char *name;
    } tables[] = {{0, FXL_SCENE_VERTICES_MAX + 1, "vertex table"},
                  {FXL_SCENE_INDICES_MAX + 1, FXL_SCENE_INDICES_MAX + 1, "index table"},
                  {FXL_SCENE_FACES_MAX + 1, FXL_SCENE_FACES_MAX + 1, "face table"},
                  {0, FXL_SCENE_MODELS_MAX + 1, "model table"},
                  {0, FXL_SCENE_INSTANCES_MAX + 1, "instance table"}};
    for (int i = 0; i < 5; i++) {
        for (int many = 0; many < 2; many++) {
            fxl_scene *scene = &tiny_make()->scene;
            uint32_t *const counts[] = {&scene->vertex_count, &scene->index_count,
                                        &scene->face_count, &scene->model_count,
                                        &scene->instance_count};
            *counts[i] = many ? tables[i].many : tables[i].few;
            expect_fault(FXL_E_COUNT, tables[i].name, 0, scene);
        }
    }
}

/* Tiny's image whose second model has one face. */
static tiny_image *with_a_single_face(void)
{
    tiny_image *image = tiny_image_make(false);
    tiny_set_section(image, SECTION_FACES, tiny_make()->faces, 7, FACE);
    tiny_set_section(image, SECTION_FACE_BOUNDS, tiny_make()->keys, 1, KEY);
    ((fxl_model *)(void *)tiny_entry(image, AT_MODELS, 1, MODEL))->face_count = 1;
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        ((fxl_instance *)(void *)tiny_entry(image, AT_INSTANCES, i, INSTANCE))->layer = 0;
    }
    return image;
}

void test_tables_of_one_entry(void)
{
    const fxl_bsp_node node = {.normal = {-FXL_Q2_30_ONE, 0, 0},
                               .distance_high = FXL_Q2_30_ONE >> 16,
                               .front = FXL_BSP_NONE,
                               .back = FXL_BSP_NONE,
                               .parent = FXL_BSP_NONE,
                               .face_count = 1,
                               .radius = TINY_RADIUS};
    fxl_scene_fault fault = {"", 0};
    tiny_image *image = with_a_single_face();
    TEST_ASSERT_EQUAL(FXL_OK, open(image, &fault));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.face_bounds_count);
    TEST_ASSERT_EQUAL_MEMORY(tiny_entry(image, AT_KEYS, 0, KEY), opened.scene.face_bounds, KEY);
    tiny_set_section(image, SECTION_BSP_NODES, &node, 1, sizeof node);
    tiny_put32(tiny_at(image, AT_BSP_INSTANCE), 1);
    TEST_ASSERT_EQUAL(FXL_OK, open(image, &fault));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.bsp_node_count);
    TEST_ASSERT_EQUAL_MEMORY(&node, opened.scene.bsp_nodes, sizeof node);
}

/* The path's frames are those that the header states. */
void test_a_path_of_other_frames(void)
{
    for (uint32_t frames = TINY_POSES - 1; frames <= TINY_POSES + 1; frames++) {
        fxl_scene_fault fault = {"", 9};
        tiny_image *image = tiny_image_make(false);
        tiny_put32(tiny_at(image, AT_FRAMES), frames);
        TEST_ASSERT_EQUAL(frames == TINY_POSES ? FXL_OK : FXL_E_COUNT, open(image, &fault));
        TEST_ASSERT_EQUAL_UINT32(frames == TINY_POSES ? 9 : 0, fault.index);
    }
}

/* What lies within the limits is taken, at their ends too. */
void test_limits_that_are_reached(void)
{
    tiny_scene *tiny = tiny_make();
    tiny->models[0].radius = tiny->models[1].radius = FXL_RADIUS_MAX;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    tiny->models[1].radius = FXL_RADIUS_MAX + 1;
    expect_fault(FXL_E_RANGE, "model", 1, &tiny->scene);
    tiny = with_instances_of(1);
    tiny->vertices[4].x =
        2 * FXL_COORDINATE_MAX + 1; /* the most that any vertex may have, and one */
    expect_fault(FXL_E_RANGE, "vertex", 4, &tiny->scene);
    tiny->vertices[4].x = 2 * FXL_COORDINATE_MAX;
    const fxl_status status = fxl_scene_check(&tiny->scene, NULL); /* other checks refuse it */
    TEST_ASSERT_TRUE(status != FXL_OK && status != FXL_E_RANGE);
}

/* A scene whose tables are as long as their counts and stand apart from each other: no check and no
 * stage may read beyond one. The sanitizers watch over the host's run. */

enum {
    WIDTH = 24,
    HEIGHT = 16
};

static fxl_point vertices[16];
static uint16_t corners[48];
static fxl_face faces[12];
static fxl_model models[2];
static fxl_instance instances[TINY_INSTANCES];
static fxl_face_bounds bounds[6];
static fxl_bsp_node nodes[BSP_NODES];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static uint8_t pixels[HEIGHT][WIDTH];
static uint64_t workspace[40];
static fxl_renderer renderer;
static fxl_scene scene;

static void make(bool with_bounds, bool with_tree)
{
    const bsp_scene *made = bsp_make();
    memcpy(vertices, made->tiny->vertices, sizeof vertices);
    memcpy(corners, made->tiny->corners, sizeof corners);
    memcpy(faces, made->tiny->faces, sizeof faces);
    memcpy(models, made->tiny->models, sizeof models);
    memcpy(instances, made->tiny->instances, sizeof instances);
    memcpy(bounds, made->tiny->keys, sizeof bounds);
    memcpy(nodes, made->nodes, sizeof nodes);
    scene = made->tiny->scene;
    scene.vertices = vertices;
    scene.indices = corners;
    scene.faces = faces;
    scene.models = models;
    scene.instances = instances;
    scene.face_bounds = with_bounds ? bounds : NULL;
    scene.face_bounds_count = with_bounds ? 6 : 0;
    scene.bsp_nodes = with_tree ? nodes : NULL;
    scene.bsp_node_count = with_tree ? BSP_NODES : 0;
    scene.bsp_instance = with_tree;
}

void test_checks_read_no_more_than_the_tables(void)
{
    for (int kind = 0; kind < 4; kind++) {
        make(kind & 1, kind & 2);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
        TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES + 6, scene.draw_list_needed);
        if (!(kind & 2)) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
        }
    }
}

/* From both ends of the row of cubes and from the middle. */
void test_frames_read_no_more_than_the_tables(void)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (int kind = 0; kind < 4; kind++) {
        make(kind & 1, kind & 2);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &scene, &lens, &memory));
        if (kind & 2) {
            TEST_ASSERT_EQUAL(FXL_OK,
                              choice_take(&renderer, &choice_tree, workspace, sizeof workspace));
        }
        for (int place = 0; place < 3; place++) {
            const fxl_pose pose = {{Q16(1), Q16(2), Q16(-8) + place * Q16(14)},
                                   place == 2 ? 2 * FXL_ANGLE_QUARTER : 0,
                                   0,
                                   0};
            TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, pixels[0], WIDTH));
            TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
            TEST_ASSERT_TRUE(renderer.workspace.counters.drawn > 0);
        }
    }
}

/* The least scene is a vertex, and the least one with a face a triangle: the counts may be no smaller. */
void test_the_smallest_scene(void)
{
    static const uint32_t leasts[2][6] = {{3, 1, 1, 1, 3, 1}, {1, 0, 1, 1, 1, 0}};
    for (uint32_t without = 0; without < 2; without++) {
        const uint32_t *least = leasts[without];
        for (int less = 0; less <= 6; less++) {
            make(false, false);
            vertices[0] = (fxl_point){0, 0, 0};
            vertices[1] = (fxl_point){0, Q16(1), 0};
            vertices[2] = (fxl_point){Q16(1), 0, 0};
            faces[0] =
                (fxl_face){.normal = {0, 0, -FXL_Q2_30_ONE}, .count = 3, .indices = {0, 1, 2}};
            models[0] = (fxl_model){.radius = Q16(1)};
            instances[0] = (fxl_instance){.model = 0};
            uint32_t *const counts[] = {&scene.vertex_count,     &scene.face_count,
                                        &scene.model_count,      &scene.instance_count,
                                        &models[0].vertex_count, &models[0].face_count};
            scene.indices = NULL; /* a triangle has its own */
            scene.index_count = 0;
            scene.faces = without ? NULL : faces;
            for (int i = 0; i < 6; i++) {
                *counts[i] = least[i] - (i == less && least[i] > 0);
            }
            const bool is_whole = less == 6 || least[less] == 0;
            const fxl_status status = fxl_scene_check(&scene, NULL);
            if (is_whole) {
                TEST_ASSERT_EQUAL(FXL_OK, status);
                TEST_ASSERT_EQUAL_UINT32(1, scene.draw_list_needed);
            } else {
                TEST_ASSERT_NOT_EQUAL(FXL_OK, status);
            }
        }
    }
}

/* A sphere of a node without faces may be a point. */
void test_the_smallest_sphere(void)
{
    static fxl_bsp_node more[BSP_NODES + 1];
    make(true, true);
    memcpy(more, nodes, sizeof nodes);
    more[BSP_NODES - 1].back = BSP_NODES;
    more[BSP_NODES] = nodes[BSP_NODES - 1];
    more[BSP_NODES].parent = BSP_NODES - 1;
    more[BSP_NODES].first_face = BSP_NODES;
    more[BSP_NODES].face_count = 0;
    scene.bsp_nodes = more;
    scene.bsp_node_count = BSP_NODES + 1;
    for (fxl_q16_16 radius = -1; radius <= 0; radius++) {
        more[BSP_NODES].radius = radius;
        TEST_ASSERT_EQUAL(radius < 0 ? FXL_E_RANGE : FXL_OK, fxl_scene_check_all(&scene, NULL));
    }
}
