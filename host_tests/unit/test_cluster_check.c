/* SPDX-License-Identifier: MIT */
/* What the loader refuses of clusters. */
#include "tiny.h"

static cluster_scene *made;

void setUp(void)
{
    made = cluster_make();
}

static void expect(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {"nothing", 0};
    TEST_ASSERT_EQUAL_STRING(fxl_status_text(status),
                             fxl_status_text(fxl_scene_check_all(&made->tiny->scene, &fault)));
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_STRING(what, fault.what);
        TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    }
    made = cluster_make();
}

/* A cluster's member, a value, and the status that names the cluster. */
#define CLUSTER(number, member, value, status) \
    UNIT_FIELD(made->clusters[number].member, value), status, "cluster", number

/* formats 1.8 */
void test_sound_clusters(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
    TEST_ASSERT_TRUE(made->tiny->scene.cluster_code == &fxl_clusters);
    made->tiny->scene.face_bounds = NULL;
    made->tiny->scene.face_bounds_count = 0;
    expect(FXL_OK, NULL, 0);
}

/* Of six faces, which have no cone. */
/* formats 1.2v */
void test_the_only_cluster_of_an_image_is_used_in_place(void)
{
    const fxl_cluster only = {.radius = 113512, .face_count = 6};
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    tiny_set_section(image, SECTION_CLUSTERS, &only, 1, sizeof only);
    tiny_put16(tiny_entry(image, AT_MODELS, 1, sizeof(fxl_model)) + 18, 1);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.cluster_count);
    TEST_ASSERT_EQUAL_MEMORY(&only, opened.scene.clusters, sizeof only);
    tiny_put32(tiny_at(image, AT_MORE + 4), 65535 + 1);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, NULL));
}

/* A check that knows no clusters refuses them; without them no code is named. */
void test_scenes_without_clusters(void)
{
    fxl_scene *scene = &made->tiny->scene;
    fxl_scene_fault fault;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(scene, &fault));
    TEST_ASSERT_EQUAL_STRING("cluster table", fault.what);
    scene->clusters = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scene_check(scene, NULL));
    scene->cluster_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_scene_check(scene, &fault));
    TEST_ASSERT_EQUAL_STRING("model", fault.what);
    TEST_ASSERT_EQUAL_UINT32(1, fault.index);
    TEST_ASSERT_EQUAL(FXL_E_RESERVED, fxl_scene_check_all(scene, NULL));
    made->tiny->models[1].first_cluster = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    scene->cluster_code = &fxl_clusters;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
    TEST_ASSERT_NULL(scene->cluster_code);
}

/* formats 1.8b-c, 1.8o */
void test_counts(void)
{
    made->tiny->scene.clusters = NULL;
    expect(FXL_E_COUNT, "cluster table", 0);
    const unit_field fields[] = {
        {UNIT_FIELD(made->tiny->scene.cluster_count, 0), FXL_E_COUNT, "cluster table", 0},
        {UNIT_FIELD(made->tiny->scene.cluster_count, FXL_SCENE_CLUSTERS_MAX + 1), FXL_E_COUNT,
         "cluster table", 0},
        /* The last three faces are in no cluster. */
        {UNIT_FIELD(made->tiny->scene.cluster_count, 2), FXL_E_INDEX, "model", 1},
        {CLUSTER(0, face_count, 0, FXL_E_COUNT)},
        {CLUSTER(2, face_count, 4, FXL_E_COUNT)},
        {CLUSTER(2, face_count, 65535, FXL_E_COUNT)},
        {CLUSTER(2, reserved, 1, FXL_E_RESERVED)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->clusters[1].face_count = 5; /* and no face is left for the last */
    made->clusters[1].axis.x = made->clusters[1].axis.y = 0;
    made->clusters[1].apex.x = made->clusters[1].apex.y = 0;
    made->clusters[1].cutoff = 0;
    expect(FXL_E_COUNT, "cluster table", 0);
}

/* formats 1.8d */
void test_which_models_have_some(void)
{
    const unit_field fields[] = {
        {UNIT_FIELD(made->tiny->models[1].first_cluster, 2), FXL_E_INDEX, "model", 1},
        /* Clusters that no model has. */
        {UNIT_FIELD(made->tiny->models[1].first_cluster, 0), FXL_E_COUNT, "cluster table", 0},
        /* A convex model. */
        {UNIT_FIELD(made->tiny->models[0].first_cluster, 1), FXL_E_RESERVED, "model", 0},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* The sphere of cluster 0 about (-1, 0, 0): its vertices are (-1, +-1, +-1). */
/* formats 1.8h, 1.8p */
void test_spheres(void)
{
    const unit_field fields[] = {
        {CLUSTER(0, radius, 92681, FXL_E_RADIUS)}, /* sqrt(2) is more than 92681.9 */
        {CLUSTER(0, centre.y, 1, FXL_E_RADIUS)},
        {CLUSTER(0, centre.x, made->clusters[0].centre.x + 1, FXL_E_RANGE)},
        {CLUSTER(2, centre.z, Q16(-1) - 1, FXL_E_RANGE)},
        {CLUSTER(2, radius, -1, FXL_E_RANGE)},
        {CLUSTER(2, radius, FXL_RADIUS_MAX + 1, FXL_E_RANGE)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->clusters[0].radius = Q16(3);
    made->clusters[0].centre.y = Q16(1); /* a corner of the box, and a unit beyond it */
    expect(FXL_OK, NULL, 0);
    made->clusters[0].radius = Q16(3);
    made->clusters[0].centre.y = Q16(1) + 1;
    expect(FXL_E_RANGE, "cluster", 0);
    made->clusters[0].radius = Q16(3);
    made->clusters[0].centre.y = Q16(-1) - 1;
    expect(FXL_E_RANGE, "cluster", 0);
    made->clusters[2].radius = Q16(4);
    made->clusters[2].centre.z = Q16(1) + 1;
    expect(FXL_E_RANGE, "cluster", 2);
    for (int i = 0; i < 8; i++) { /* the corners of the cube; and of a face */
        made->clusters[2].centre = (fxl_point){i & 1 ? Q16(1) : Q16(-1), i & 2 ? Q16(1) : Q16(-1),
                                               i & 4 ? Q16(1) : Q16(-1)};
        made->clusters[2].radius = Q16(4);
        expect(FXL_OK, NULL, 0);
    }
}

/* formats 1.8m, 1.8q-r */
void test_cones(void)
{
    const unit_field fields[] = {
        {CLUSTER(0, axis.x, made->clusters[0].axis.x - 8, FXL_E_NORMAL)},
        {CLUSTER(0, apex.y, FXL_CLUSTER_APEX_MAX, FXL_OK)}, /* in the face's plane */
        {CLUSTER(0, apex.y, FXL_CLUSTER_APEX_MAX + 1, FXL_E_RANGE)},
        {CLUSTER(0, apex.x, -FXL_CLUSTER_APEX_MAX - 1, FXL_E_RANGE)},
        {CLUSTER(0, apex.z, FXL_CLUSTER_APEX_MAX + 1, FXL_E_RANGE)},
        /* An eye there sees the front of the face. */
        {CLUSTER(0, apex.x, made->clusters[0].apex.x - 1, FXL_E_CLUSTER)},
        {CLUSTER(1, apex.y, made->clusters[1].apex.y - 1, FXL_E_CLUSTER)},
        {CLUSTER(1, apex.y, made->clusters[1].apex.y + 1, FXL_OK)}, /* behind both faces */
        {CLUSTER(2, cutoff, 1, FXL_E_RESERVED)},
        {CLUSTER(2, apex.z, 1, FXL_E_RESERVED)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* The normals of cluster 1 are 45 degrees off its axis. So a cone of 45 degrees is the widest, with
 * a cutoff of 1/2. */
/* formats 1.8s-u */
void test_cutoffs(void)
{
    const unit_field fields[] = {
        {CLUSTER(1, cutoff, 0x7FFFFFFFu, FXL_E_CLUSTER)},
        {CLUSTER(1, cutoff, 0xFFFFFFFFu, FXL_OK)}, /* a narrow one */
        {CLUSTER(1, cutoff, 0, FXL_E_CLUSTER)},
        {CLUSTER(0, cutoff, 15, FXL_E_CLUSTER)}, /* less than rounding takes */
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->clusters[1].axis.x = -made->clusters[1].axis.x; /* now +x looks the other way */
    made->clusters[1].cutoff = 0xFFFFFFFFu;
    expect(FXL_E_CLUSTER, "cluster", 1);
}

/* Numbers with which both sides of the condition are the same: 142846884^2. */
void test_a_cutoff_on_the_border(void)
{
    made->clusters[0].axis = (fxl_direction){-142846884, 930745171, 515974513};
    made->clusters[0].cutoff = 4218951879u;
    expect(FXL_OK, NULL, 0);
    made->clusters[0].axis = (fxl_direction){-142846884, 930745171, 515974513};
    made->clusters[0].cutoff = 4218951878u;
    expect(FXL_E_CLUSTER, "cluster", 0);
}

/* A tree's nodes take the faces of their model in turn, so it has no clusters. */
/* formats 1.8e */
void test_no_clusters_with_a_tree(void)
{
    static const fxl_bsp_node node = {.front = FXL_BSP_NONE, .back = FXL_BSP_NONE};
    made->tiny->scene.bsp_nodes = &node;
    made->tiny->scene.bsp_node_count = 1;
    made->tiny->scene.bsp_instance = 1;
    expect(FXL_E_BSP, "BSP tree", 0);
}

/* Each vertex alone lies outside of its cluster's sphere: one of each corner of the first face, and
 * those that only a later face has. */
/* formats 1.8g, 1.8p */
void test_every_vertex_is_in_the_sphere(void)
{
    for (int i = 0; i < 4; i++) {
        const int32_t y = i & 1 ? Q16(-0.5) : Q16(0.5), z = i & 2 ? Q16(-0.5) : Q16(0.5);
        made->clusters[0].centre = (fxl_point){Q16(-1), y, z};
        made->clusters[0].radius = Q16(2.13); /* 1.5 sqrt(2) is 2.12 */
        expect(FXL_OK, NULL, 0);
        made->clusters[0].centre = (fxl_point){Q16(-1), y, z};
        made->clusters[0].radius = Q16(1.7);
        expect(FXL_E_RADIUS, "cluster", 0);
    }
    made->clusters[1].centre = (fxl_point){Q16(1), 0, 0};
    made->clusters[1].radius = Q16(2.45); /* sqrt(6) */
    expect(FXL_OK, NULL, 0);
    made->clusters[1].centre = (fxl_point){Q16(1), 0, 0};
    made->clusters[1].radius = Q16(1.5); /* of the face +x each is within sqrt(2) */
    expect(FXL_E_RADIUS, "cluster", 1);
}
