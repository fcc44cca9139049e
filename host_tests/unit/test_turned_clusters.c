/* SPDX-License-Identifier: MIT */
/* Clusters of turned instances: their spheres, and cones before an eye that was rounded. */
#include "frame_bands.h"
#include "tiny.h"
#include "scene/placement_code.h"
#include "study/clippers.h"
#include "view/clusters.h"
#include "view/placement.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    ENTRIES = TINY_INSTANCES + 6
};

static fxl_renderer renderer;
static fxl_draw_entry order[ENTRIES];
static fxl_cached_vertex cache[16];
static uint8_t pixels[2][HEIGHT * WIDTH];
static fxl_placement placements[TINY_INSTANCES];

/* Whether an eye less e units away from the apex is in a cone. By the definition, in double, of
 * which the error is far below 2^-20 for such small numbers. */
static bool in_cone(const fxl_cluster *cluster, const double u[3])
{
    const double along = (u[0] * cluster->axis.x + u[1] * cluster->axis.y + u[2] * cluster->axis.z);
    const double square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    const double unit = 1073741824.0;
    return along > -1e-6 * unit &&
           along * along / unit / unit > square * (cluster->cutoff / 4294967296.0) - 1e-6;
}

/* An eye so near to the apex that half a unit decides often. */
void test_a_rounded_eye_in_a_cone(void)
{
    uint32_t inside = 0, slack = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_cluster cluster = {.axis = unit_direction(),
                                     .cutoff = (uint32_t)unit_wide(32),
                                     .apex = unit_point(FXL_COORDINATE_MAX)};
        const fxl_point u = unit_point(60);
        const fxl_point eye = {cluster.apex.x - u.x, cluster.apex.y - u.y, cluster.apex.z - u.z};
        const double exact[3] = {u.x + unit_between(-512, 512) / 1024.0,
                                 u.y + unit_between(-512, 512) / 1024.0,
                                 u.z + unit_between(-512, 512) / 1024.0};
        if (fxl_cluster_is_surely_turned_away(&cluster, &eye, NULL)) {
            TEST_ASSERT_TRUE(in_cone(&cluster, exact));
            inside++;
        } else {
            slack += fxl_cluster_is_turned_away(&cluster, &eye);
        }
    }
    TEST_ASSERT_TRUE(inside > UNIT_REPEAT / 20 && slack > UNIT_REPEAT / 100);
}

static bool is_orthographic;

/* A frame into pixels[which]. */
static fxl_counters draw(tiny_scene *tiny, const fxl_pose *pose, int which, bool with_memory,
                         const fxl_clipper *clipper)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {
        order, ENTRIES, NULL, 0, with_memory ? cache : NULL, with_memory ? 16 : 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    if (is_orthographic) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(3)));
    }
    frame_draw_pose(&renderer, pose, pixels[which], HEIGHT, 0);
    return renderer.workspace.counters;
}

/* Turns all; the sorted cube is as small or as large as leaves it in the world. */
static void place_all(tiny_scene *tiny)
{
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement){unit_orientation(), FXL_Q16_16_ONE};
    }
    placements[1].scale =
        unit_between(0, 1) ? unit_between(FXL_Q16_16_ONE / 4, 6 * FXL_Q16_16_ONE) : FXL_Q16_16_ONE;
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 0;
    tiny->scene.placement_code = &fxl_turned_instances;
}

/* The sphere test rejects the cluster where its instance's placement puts it. */
static bool is_outside(const cluster_scene *made, const fxl_view *view, const fxl_cluster *cluster)
{
    fxl_point centre;
    fxl_placement_point(&placements[1], &made->tiny->instances[1].centre, &cluster->centre,
                        &centre);
    return fxl_sphere_planes(&view->camera, &view->view_frustum, &centre,
                             fxl_placement_radius(&placements[1], cluster->radius)) ==
           FXL_SPHERE_OUTSIDE;
}

static bool is_front(const cluster_scene *made, const fxl_view *view, const fxl_face *face)
{
    const tiny_scene *tiny = made->tiny;
    const fxl_point *cube = &tiny->instances[1].centre, *eye = &view->camera.position;
    const fxl_point *first = &tiny->vertices[tiny->models[1].first_vertex + face->indices[0]];
    const fxl_q18_46 height = (int64_t)face->normal.x * first->x +
                              (int64_t)face->normal.y * first->y +
                              (int64_t)face->normal.z * first->z;
    const fxl_point from_eye = {cube->x - eye->x, cube->y - eye->y, cube->z - eye->z};
    return fxl_placement_is_front(&placements[1], &from_eye, &face->normal, height);
}

static const cluster_definition definition = {is_outside, is_front};

/* What a cluster of the cube may cross, of some planes: those that its sphere crosses. */
static uint32_t planes_by_definition(const fxl_cluster *cluster, const fxl_instance *cube,
                                     const fxl_view *view, uint32_t planes)
{
    fxl_point centre;
    fxl_placement_point(&placements[1], &cube->centre, &cluster->centre, &centre);
    const uint32_t crossed =
        fxl_sphere_planes(&view->camera, &view->view_frustum, &centre,
                          fxl_scaled_radius(placements[1].scale, cluster->radius));
    return planes == 0 || crossed != FXL_SPHERE_OUTSIDE ? planes & crossed : crossed;
}

static bool is_cube_in_sight(void)
{
    for (uint32_t i = 0; i < renderer.frame.visible_count; i++) {
        if (renderer.frame.draw_list[i].index == 1) {
            return true;
        }
    }
    return false;
}

/* The same pixels as without clusters, and the counters that SPEC.md, section 8.4, defines. */
void test_frames_with_turned_clusters(void)
{
    uint32_t left_out = 0, crossed = 0;
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        cluster_scene *made = cluster_make();
        tiny_scene *tiny = made->tiny;
        const fxl_clipper *clipper = i % 4 == 3 ? &fxl_clipper_world : &fxl_clipper_view;
        fxl_pose pose = unit_pose();
        pose.position = (fxl_point){unit_between(Q16(-6), Q16(6)), unit_between(Q16(-6), Q16(6)),
                                    unit_between(Q16(4), Q16(16))};
        place_all(tiny);
        if (i % 8 == 5) { /* so small and so far away that its eye has another unit */
            placements[1].scale = FXL_SCALE_MIN;
            pose.position.z -= unit_between(Q16(100), Q16(400));
            pose.yaw = pose.pitch = 0;
        }
        tiny->scene.face_bounds = i % 3 ? tiny->keys : NULL;
        tiny->scene.face_bounds_count = i % 3 ? 6 : 0;
        const fxl_counters with = draw(tiny, &pose, 0, i % 2, clipper);
        const bool in_sight = is_cube_in_sight();
        uint32_t outside = 0, backfacing = 0;
        if (in_sight) {
            cluster_count(made, &definition, &renderer.frame.view, &outside, &backfacing);
        }
        tiny->models[1].first_cluster = 0;
        tiny->scene.clusters = NULL;
        tiny->scene.cluster_count = 0;
        const fxl_counters without = draw(tiny, &pose, 1, i % 2, clipper);
        TEST_ASSERT_EQUAL_MEMORY(pixels[1], pixels[0], sizeof pixels[0]);
        TEST_ASSERT_EQUAL_UINT32(without.in, with.in);
        TEST_ASSERT_EQUAL_UINT32(without.drawn, with.drawn);
        TEST_ASSERT_EQUAL_UINT32(without.clipped, with.clipped);
        TEST_ASSERT_EQUAL_UINT32(with.in, with.backfacing + with.outside + with.degenerate +
                                              with.refused + with.drawn);
        /* Without clusters the cube's faces outside are backfacing where they face away. */
        TEST_ASSERT_TRUE(with.outside >= without.outside && with.outside >= outside);
        if (outside == 0) {
            TEST_ASSERT_EQUAL_UINT32(without.backfacing, with.backfacing);
        } else {
            TEST_ASSERT_TRUE(with.backfacing >= backfacing &&
                             without.backfacing - with.backfacing <= outside);
        }
        left_out += outside;
        crossed += in_sight && outside == 0;
    }
    TEST_ASSERT_TRUE(left_out > UNIT_REPEAT / 500 && crossed > UNIT_REPEAT / 500);
}

/* With the mark of a scale that is shifted, where there is a plane. */
/* SPEC 8.4d-e */
void test_the_planes_of_a_turned_cluster(void)
{
    static const fxl_planes given[] = {0, FXL_PLANES_ALL, 1, 2, 0x30};
    uint32_t met[3] = {0, 0, 0}; /* outside, inside, crossing */
    fxl_vertex_cache none = {.entries = NULL};
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        cluster_scene *made = cluster_make();
        fxl_pose pose = unit_pose();
        pose.position = (fxl_point){unit_between(Q16(-6), Q16(6)), unit_between(Q16(-6), Q16(6)),
                                    unit_between(Q16(4), Q16(16))};
        const bool is_wide = i % 4 == 3;
        if (is_wide) { /* so far away that the near plane cuts no sphere, however large */
            pose = (fxl_pose){.position = {0, 0, Q16(-8100)}};
        }
        place_all(made->tiny);
        (void)draw(made->tiny, &pose, 0, false, &fxl_clipper_view);
        for (int c = 0; is_wide && c < CLUSTERS; c++) {
            made->clusters[c].radius =
                (fxl_q16_16)(((int64_t)unit_between(Q16(4000), FXL_COORDINATE_MAX - 65536) << 16) /
                             placements[1].scale);
        }
        const fxl_view *view = &renderer.frame.view;
        for (int k = 0; k < 5; k++) {
            fxl_turned_view turned;
            (void)fxl_turned_view_of_instance(&turned, &made->tiny->scene, 1, view, &none,
                                              given[k]);
            const uint32_t mark = placements[1].scale > FXL_Q16_16_ONE ? FXL_MODEL_VIEW_SCALED : 0;
            for (int c = 0; c < CLUSTERS; c++) {
                const uint32_t planes = planes_by_definition(
                    &made->clusters[c], &made->tiny->instances[1], view, given[k]);
                const bool is_outside = planes == FXL_SPHERE_OUTSIDE;
                TEST_ASSERT_EQUAL_HEX32(is_outside || planes == 0 ? planes : planes | mark,
                                        fxl_turned_cluster_planes(&turned, &made->clusters[c]));
                met[is_outside ? 0 : planes == 0 ? 1 : 2]++;
            }
        }
    }
    TEST_ASSERT_TRUE(met[0] > UNIT_REPEAT / 500 && met[1] > UNIT_REPEAT / 500 &&
                     met[2] > UNIT_REPEAT / 500);
}

/* Where a sphere is too large for the test, or its centre out of the world, all planes stay, though
 * the eye looks away from it. */
void test_turned_clusters_that_no_sphere_test_takes(void)
{
    cluster_scene *made = cluster_make();
    tiny_scene *tiny = made->tiny;
    const fxl_pose pose = {.position = {0, 0, Q16(20)}};
    fxl_vertex_cache none = {.entries = NULL};
    fxl_turned_view turned;
    place_all(tiny);
    placements[1] = (fxl_placement){FXL_ORIENTATION_NONE, 4 * FXL_Q16_16_ONE};
    (void)draw(tiny, &pose, 0, false, &fxl_clipper_view);
    const fxl_view *view = &renderer.frame.view;
    (void)fxl_turned_view_of_instance(&turned, &tiny->scene, 1, view, &none, FXL_PLANES_ALL);
    fxl_cluster cluster = {.radius = FXL_COORDINATE_MAX / 4};
    TEST_ASSERT_NOT_EQUAL(FXL_SPHERE_OUTSIDE, fxl_turned_cluster_planes(&turned, &cluster));
    cluster.radius = FXL_RADIUS_MAX;
    TEST_ASSERT_EQUAL_HEX32(FXL_PLANES_ALL | FXL_MODEL_VIEW_SCALED,
                            fxl_turned_cluster_planes(&turned, &cluster));
    cluster = (fxl_cluster){.centre = {0, 0, Q16(-20)}, .radius = Q16(1)};
    TEST_ASSERT_EQUAL_HEX32(FXL_SPHERE_OUTSIDE, fxl_turned_cluster_planes(&turned, &cluster));
    cluster.centre.z = -FXL_COORDINATE_MAX / 4 - Q16(5);
    TEST_ASSERT_EQUAL_HEX32(FXL_PLANES_ALL | FXL_MODEL_VIEW_SCALED,
                            fxl_turned_cluster_planes(&turned, &cluster));
}

/* Clusters change no pixel of an orthographic lens: of models that are turned, and of others. */
/* orthographic 2.4a */
void test_clusters_with_an_orthographic_lens(void)
{
    uint32_t drawn = 0;
    is_orthographic = true;
    for (int i = 0; i < UNIT_REPEAT / 200; i++) {
        cluster_scene *made = cluster_make();
        tiny_scene *tiny = made->tiny;
        fxl_pose pose = unit_pose();
        pose.position = (fxl_point){unit_between(Q16(-4), Q16(4)), unit_between(Q16(-4), Q16(4)),
                                    unit_between(Q16(-6), Q16(6))};
        if (i % 2 == 0) {
            place_all(tiny);
        }
        drawn += draw(tiny, &pose, 0, i % 4 < 2, &fxl_clipper_view).drawn;
        tiny->models[1].first_cluster = 0;
        tiny->scene.clusters = NULL;
        tiny->scene.cluster_count = 0;
        (void)draw(tiny, &pose, 1, i % 4 < 2, &fxl_clipper_view);
        TEST_ASSERT_EQUAL_MEMORY(pixels[1], pixels[0], sizeof pixels[0]);
    }
    is_orthographic = false;
    TEST_ASSERT_GREATER_THAN_UINT32(UNIT_REPEAT / 500, drawn);
}
