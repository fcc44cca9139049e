/* SPDX-License-Identifier: MIT */
/* Clusters outside the frustum and clusters turned away. */
#include "frame_bands.h"
#include "tiny.h"
#include "view/clusters.h"
#include "study/clippers.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    ENTRIES = TINY_INSTANCES + 6
};

static fxl_renderer renderer;
static fxl_draw_entry order[ENTRIES];
static uint32_t list[64 * FXL_DISPLAY_LIST_WORDS(8)];
static fxl_cached_vertex cache[16];
static uint8_t pixels[2][HEIGHT * WIDTH];

/* The squares of u . axis, if that is positive, and of cutoff's part of |u|, in world units. */
static bool in_cone(const fxl_cluster *cluster, const fxl_point *eye, double margin)
{
    const double x = (double)cluster->apex.x - eye->x, y = (double)cluster->apex.y - eye->y,
                 z = (double)cluster->apex.z - eye->z;
    const double along =
        (x * cluster->axis.x + y * cluster->axis.y + z * cluster->axis.z) / 1073741824.0;
    const double cutoff = cluster->cutoff / 4294967296.0;
    return along > 0 && along * along > (cutoff + margin) * (x * x + y * y + z * z);
}

/* By the definition in double: the test says true of no eye outside the cone, and of every eye a
 * world unit from the apex that is well inside. */
/* SPEC 4.4k, accuracy 1.1m, formats 1.8j-k */
void test_the_cone_is_the_definition(void)
{
    uint32_t inside = 0, outside = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_cluster cluster = {.axis = unit_direction(),
                               .cutoff = (uint32_t)unit_wide(32),
                               .apex = unit_point(2 * FXL_COORDINATE_MAX)};
        fxl_point eye = unit_point(2 * FXL_COORDINATE_MAX);
        const bool turned = fxl_cluster_is_turned_away(&cluster, &eye);
        TEST_ASSERT_FALSE(turned && !in_cone(&cluster, &eye, -1e-6));
        TEST_ASSERT_FALSE(!turned && in_cone(&cluster, &eye, 1e-3));
        inside += turned;
        outside += !turned;
    }
    TEST_ASSERT_TRUE(inside > UNIT_REPEAT / 10 && outside > UNIT_REPEAT / 10);
}

/* The largest numbers, where sums are at their bounds. */
void test_the_cone_at_the_ends_of_the_range(void)
{
    const fxl_q16_16 far = 2 * FXL_COORDINATE_MAX;
    const fxl_q2_30 third = 619925131; /* 2^30 / sqrt(3) */
    const fxl_cluster cluster = {
        .axis = {third, third, third}, .cutoff = 0xFFFF0000u, .apex = {far, far, far}};
    TEST_ASSERT_TRUE(fxl_cluster_is_turned_away(&cluster, &(fxl_point){-far, -far, -far}));
    TEST_ASSERT_FALSE(fxl_cluster_is_turned_away(&cluster, &(fxl_point){-far, -far, far}));
    TEST_ASSERT_FALSE(fxl_cluster_is_turned_away(&cluster, &(fxl_point){far, far, far}));
    const fxl_cluster opposite = {
        .axis = {third, third, third}, .cutoff = 0, .apex = {-far, -far, -far}};
    TEST_ASSERT_FALSE(fxl_cluster_is_turned_away(&opposite, &(fxl_point){far, far, far}));
    const fxl_cluster none = {.radius = 1};
    TEST_ASSERT_FALSE(fxl_cluster_is_turned_away(&none, &(fxl_point){far, 0, 0}));
}

/* Faces and cones of any directions: where the loader takes a cone, no eye in it sees a front. */
void test_no_eye_in_an_accepted_cone_sees_a_front(void)
{
    uint32_t accepted = 0, turned = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        cluster_scene *made = cluster_make();
        tiny_scene *tiny = made->tiny;
        fxl_cluster *cluster = &made->clusters[1];
        tiny->scene.face_bounds = NULL;
        tiny->scene.face_bounds_count = 0;
        do { /* hardly any other axis has an angle below 90 degrees to +x and -y */
            cluster->axis = unit_direction();
        } while (cluster->axis.x <= 0 || cluster->axis.y >= 0);
        cluster->apex = (fxl_point){unit_between(Q16(-6), Q16(1) + 1),
                                    unit_between(Q16(-1) - 1, Q16(6)), unit_between(0, Q16(9))};
        cluster->cutoff = UINT32_MAX - unit_random() / 2;
        if (fxl_scene_check_all(&tiny->scene, NULL) != FXL_OK) {
            continue;
        }
        accepted++;
        for (int k = 0; k < 20; k++) {
            const fxl_point eye = unit_point(k % 2 ? Q16(20) : FXL_COORDINATE_MAX - Q16(16));
            if (fxl_cluster_is_turned_away(cluster, &eye)) {
                const fxl_point world = {eye.x, eye.y, eye.z + Q16(10)};
                turned++;
                for (int f = 1; f <= 2; f++) {
                    TEST_ASSERT_FALSE(fxl_face_is_front(&tiny->scene, &tiny->instances[1],
                                                        &tiny->faces[6 + f], &world));
                }
            }
        }
    }
    TEST_ASSERT_TRUE(accepted > UNIT_REPEAT / 100 && turned > accepted / 8);
}

/* A frame into pixels[which]. With memory: a display list and a vertex cache. */
static fxl_counters draw(tiny_scene *tiny, const fxl_pose *pose, int which, bool with_memory,
                         const fxl_clipper *clipper)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order,
                               ENTRIES,
                               with_memory ? list : NULL,
                               with_memory ? sizeof list / sizeof list[0] : 0,
                               with_memory ? cache : NULL,
                               with_memory ? 16 : 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
    frame_draw_pose(&renderer, pose, pixels[which], HEIGHT / 2, 0);
    return renderer.workspace.counters;
}

/* The sphere test rejects the cluster. */
static bool is_outside(const cluster_scene *made, const fxl_view *view, const fxl_cluster *cluster)
{
    const fxl_point *cube = &made->tiny->instances[1].centre;
    const fxl_point centre = {cube->x + cluster->centre.x, cube->y + cluster->centre.y,
                              cube->z + cluster->centre.z};
    return fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, cluster->radius) ==
           FXL_SPHERE_OUTSIDE;
}

static bool is_front(const cluster_scene *made, const fxl_view *view, const fxl_face *face)
{
    return fxl_face_is_front(&made->tiny->scene, &made->tiny->instances[1], face,
                             &view->camera.position);
}

static const cluster_definition definition = {is_outside, is_front};

static void take_clusters_out(tiny_scene *tiny)
{
    tiny->models[1].first_cluster = 0;
    tiny->scene.clusters = NULL;
    tiny->scene.cluster_count = 0;
}

/* The same pixels as without clusters, and the counters that SPEC.md, section 4.11, defines. */
/* SPEC 4.4i-j, 4.4m, 4.11d */
void test_frames_with_clusters(void)
{
    uint32_t left_out = 0, drawn = 0;
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        cluster_scene *made = cluster_make();
        const fxl_clipper *clipper = i % 4 == 3 ? &fxl_clipper_world : &fxl_clipper_view;
        fxl_pose pose = unit_pose();
        pose.position = (fxl_point){unit_between(Q16(-4), Q16(4)), unit_between(Q16(-4), Q16(4)),
                                    unit_between(Q16(6), Q16(14))};
        made->tiny->scene.face_bounds = i % 3 ? made->tiny->keys : NULL;
        made->tiny->scene.face_bounds_count = i % 3 ? 6 : 0;
        const fxl_counters with = draw(made->tiny, &pose, 0, i % 2, clipper);
        uint32_t outside, backfacing, hidden = 0;
        bool in_sight = false;
        cluster_count(made, &definition, &renderer.frame.view, &outside, &backfacing);
        for (uint32_t k = 0; k < renderer.frame.visible_count; k++) {
            in_sight = in_sight || renderer.frame.draw_list[k].index == 1;
        }
        take_clusters_out(made->tiny);
        const fxl_counters without = draw(made->tiny, &pose, 1, i % 2, clipper);
        for (uint32_t f = 6; f < 12; f++) {
            hidden += !fxl_face_is_front(&made->tiny->scene, &made->tiny->instances[1],
                                         &made->tiny->faces[f], &pose.position);
        }
        TEST_ASSERT_EQUAL_MEMORY(pixels[1], pixels[0], sizeof pixels[0]);
        TEST_ASSERT_EQUAL_UINT32(without.in, with.in);
        TEST_ASSERT_EQUAL_UINT32(without.drawn, with.drawn);
        TEST_ASSERT_EQUAL_UINT32(without.clipped, with.clipped);
        if (in_sight) {
            TEST_ASSERT_EQUAL_UINT32(without.backfacing - hidden + backfacing, with.backfacing);
        }
        TEST_ASSERT_EQUAL_UINT32(with.in, with.backfacing + with.outside + with.degenerate +
                                              with.refused + with.drawn);
        left_out += in_sight ? outside : 0;
        drawn += with.drawn;
    }
    TEST_ASSERT_TRUE(left_out > UNIT_REPEAT / 1500 && drawn > UNIT_REPEAT / 500);
}

/* An eye in the cones of clusters 0 and 1: of the cube's faces only +y and -z show. */
/* SPEC 4.11c */
void test_clusters_turned_away_count_as_backfacing(void)
{
    cluster_scene *made = cluster_make();
    const fxl_point eye = {Q16(-1) + 1000, Q16(3), Q16(-2)};
    const fxl_pose pose = {{eye.x, eye.y, eye.z + Q16(10)}, 0, 0u - DEGREES(45), 0};
    TEST_ASSERT_TRUE(fxl_cluster_is_turned_away(&made->clusters[0], &eye));
    TEST_ASSERT_TRUE(fxl_cluster_is_turned_away(&made->clusters[1], &eye));
    fxl_model_view model_view;
    fxl_vertex_cache none;
    uint32_t front;
    draw(made->tiny, &pose, 0, false, &fxl_clipper_view);
    fxl_vertex_cache_init(&none, NULL, 0);
    fxl_model_view_of_instance(&model_view, &made->tiny->scene, &made->tiny->instances[1],
                               &renderer.frame.view, &none);
    TEST_ASSERT_EQUAL_UINT32(2, fxl_list_clusters(&made->tiny->scene, &made->tiny->models[1],
                                                  &model_view, false, order, &front));
    TEST_ASSERT_EQUAL_UINT32(2, front);
    TEST_ASSERT_EQUAL_UINT16(3, order[0].index);
    TEST_ASSERT_EQUAL_UINT16(4, order[1].index);
}
