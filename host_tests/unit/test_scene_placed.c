/* SPDX-License-Identifier: MIT */
/* How much a loader agrees to look at. On its own because it takes a megabyte
 * of RAM, which few boards have. */
#include "expect_scene.h"

/* Objects times vertices is what a loader has to look at: 65535 x 61 is within
 * the limit, 65535 x 62 is not. */
void test_too_many_placed_vertices_are_refused(void)
{
    static fxl_instance many[FXL_SCENE_INSTANCES_MAX];
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
