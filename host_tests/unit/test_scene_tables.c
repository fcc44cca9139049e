/* SPDX-License-Identifier: MIT */
/* A scene whose tables are as long as their counts and stand apart from each other: no check and no
 * stage may read beyond one. The sanitizers watch over the host's run. */
#include "bsp_scene.h"

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
static fxl_order_entry order[TINY_INSTANCES + 6];
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
        TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES + 6, scene.order_needed);
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
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_visibility(&renderer, &fxl_visibility_bsp,
                                                                  workspace, sizeof workspace));
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
