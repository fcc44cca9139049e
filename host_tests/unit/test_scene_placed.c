/* SPDX-License-Identifier: MIT */
/* How much a loader agrees to look at. On its own because it takes a megabyte
 * of RAM, which few boards have. */
#include "expect_scene.h"

static fxl_instance many[FXL_SCENE_INSTANCES_MAX];

/* Objects times vertices is what a loader has to look at: 65535 x 61 is within
 * the limit, 65535 x 62 is not. */
/* formats 1.4e */
void test_too_many_placed_vertices_are_refused(void)
{
    static fxl_point vertices[62 + 8];
    for (uint32_t extra = 61; extra <= 62; extra++) {
        tiny_scene *tiny = tiny_make();
        memset(vertices, 0, sizeof vertices);
        memcpy(vertices, tiny->vertices, 8 * sizeof vertices[0]);
        memcpy(vertices + extra, tiny->vertices + 8, 8 * sizeof vertices[0]);
        tiny->models[0].vertex_count = extra;
        tiny->models[1].first_vertex = extra;
        tiny->scene.vertices = vertices;
        tiny->scene.vertex_count = extra + 8;
        tiny->scene.instances = many;
        tiny->scene.instance_count = FXL_SCENE_INSTANCES_MAX;
        TEST_ASSERT_EQUAL(extra == 61 ? FXL_OK : FXL_E_COUNT, fxl_scene_check(&tiny->scene, NULL));
    }
}

/* 40000 x 100 is the limit itself. */
/* formats 1.4e */
void test_as_many_placed_vertices_as_may_be(void)
{
    static fxl_point vertices[100 + 8];
    for (uint32_t more = 0; more < 2; more++) {
        tiny_scene *tiny = tiny_make();
        fxl_scene_fault fault = {"", 0};
        memcpy(vertices, tiny->vertices, 8 * sizeof vertices[0]);
        memcpy(vertices + 100, tiny->vertices + 8, 8 * sizeof vertices[0]);
        tiny->models[0].vertex_count = 100;
        tiny->models[1].first_vertex = 100;
        tiny->scene.vertices = vertices;
        tiny->scene.vertex_count = 100 + 8;
        tiny->scene.instances = many;
        tiny->scene.instance_count = FXL_SCENE_PLACED_MAX / 100 + more;
        TEST_ASSERT_EQUAL(more ? FXL_E_COUNT : FXL_OK, fxl_scene_check(&tiny->scene, &fault));
        TEST_ASSERT_EQUAL_UINT32(more ? FXL_SCENE_PLACED_MAX / 100 : 0, fault.index);
    }
}
