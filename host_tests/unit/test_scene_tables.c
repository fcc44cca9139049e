/* SPDX-License-Identifier: MIT */
/* A scene whose tables are as long as their counts and stand apart from each other: no check and no
 * stage may read beyond one. The sanitizers watch over the host's run. */
#include "bsp_scene.h"
#include "choices.h"

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

/* A triangle is the least scene: the counts may be no smaller. */
void test_the_smallest_scene(void)
{
    for (int less = 0; less <= 7; less++) {
        make(false, false);
        vertices[0] = (fxl_point){0, 0, 0};
        vertices[1] = (fxl_point){0, Q16(1), 0};
        vertices[2] = (fxl_point){Q16(1), 0, 0};
        memcpy(corners, (const uint16_t[]){0, 1, 2}, 3 * sizeof corners[0]);
        faces[0] = (fxl_face){.normal = {0, 0, -FXL_Q2_30_ONE}, .count = 3};
        models[0] = (fxl_model){.vertex_count = 3, .face_count = 1, .radius = Q16(1)};
        instances[0] = (fxl_instance){.model = 0};
        uint32_t *const counts[] = {&scene.vertex_count,   &scene.index_count,
                                    &scene.face_count,     &scene.model_count,
                                    &scene.instance_count, &models[0].vertex_count,
                                    &models[0].face_count};
        const uint32_t least[] = {3, 3, 1, 1, 1, 3, 1};
        for (int i = 0; i < 7; i++) {
            *counts[i] = least[i] - (i == less);
        }
        TEST_ASSERT_EQUAL(less == 7 ? FXL_OK : FXL_E_COUNT, fxl_scene_check(&scene, NULL));
    }
    TEST_ASSERT_EQUAL_UINT32(1, scene.draw_list_needed);
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
