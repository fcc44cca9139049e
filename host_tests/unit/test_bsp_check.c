/* SPDX-License-Identifier: MIT */
/* What the loader refuses of a tree. */
#include "bsp_scene.h"

static bsp_scene *made;
static fxl_scene_fault fault;

void setUp(void)
{
    made = bsp_make();
}

static void expect(fxl_status status, const char *what, uint32_t index)
{
    fault.what = "nothing";
    TEST_ASSERT_EQUAL(status, fxl_scene_check_all(&made->tiny->scene, &fault));
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_STRING(what, fault.what);
        TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    }
    made = bsp_make();
}

/* A node's member, a value, and the status that names the node. */
#define NODE(number, member, value, status) \
    UNIT_FIELD(made->nodes[number].member, value), status, "BSP node", number

/* bsp 1.1a */
void test_a_sound_tree(void)
{
    expect(FXL_OK, NULL, 0);
    made->tiny->scene.face_bounds = NULL;
    made->tiny->scene.face_bounds_count = 0;
    made->tiny->models[1].first_face_bounds = 0;
    expect(FXL_OK, NULL, 0);
}

/* formats 1.7i */
void test_whose_it_is(void)
{
    const unit_field fields[] = {
        {UNIT_FIELD(made->tiny->scene.bsp_instance, TINY_INSTANCES), FXL_E_INDEX, "BSP tree", 0},
        /* Its model is convex. */
        {UNIT_FIELD(made->tiny->scene.bsp_instance, 0), FXL_E_RESERVED, "BSP tree", 0},
        {UNIT_FIELD(made->tiny->instances[2].model, 1), FXL_E_BSP, "instance", 2},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    static const fxl_placement placements[] = {FXL_PLACEMENT_NONE, FXL_PLACEMENT_NONE};
    made->tiny->scene.placements = placements;
    made->tiny->scene.placement_code = &fxl_turned_instances;
    made->tiny->scene.first_turned = 1; /* what has a tree stands still */
    expect(FXL_E_BSP, "BSP tree", 0);
    made->tiny->scene.placements = placements;
    made->tiny->scene.placement_code = &fxl_turned_instances;
    made->tiny->scene.first_turned = 2;
    expect(FXL_OK, NULL, 0);
    made->tiny->models[0].kind = FXL_MODEL_SORTED;
    made->tiny->scene.face_bounds = NULL;
    made->tiny->scene.face_bounds_count = 0;
    expect(FXL_E_BSP, "instance", 0);
    made->tiny->models[0].kind = FXL_MODEL_SORTED; /* on another layer it may be */
    made->tiny->scene.face_bounds = NULL;
    made->tiny->scene.face_bounds_count = 0;
    made->tiny->instances[0].layer = 1;
    made->tiny->instances[2].layer = 2;
    expect(FXL_OK, NULL, 0);
}

void test_counts(void)
{
    made->tiny->scene.bsp_node_count = 0;
    expect(FXL_E_COUNT, "BSP node table", 0);
    made->tiny->scene.bsp_node_count = FXL_BSP_NODES_MAX + 1;
    expect(FXL_E_COUNT, "BSP node table", 0);
    made->tiny->scene.bsp_nodes = NULL;
    expect(FXL_E_COUNT, "BSP node table", 0);
    made->tiny->scene.bsp_nodes = NULL;
    made->tiny->scene.bsp_node_count = 0;
    expect(FXL_E_COUNT, "BSP node table", 0); /* but it says whose it is */
    made->tiny->scene.bsp_nodes = NULL;
    made->tiny->scene.bsp_node_count = 0;
    made->tiny->scene.bsp_instance = 0;
    expect(FXL_OK, NULL, 0);
}

/* formats 1.7j */
void test_planes(void)
{
    const unit_field fields[] = {
        {NODE(3, reserved, 1, FXL_E_RESERVED)},
        {NODE(3, normal.y, made->nodes[3].normal.y + 8, FXL_E_NORMAL)},
        {NODE(2, distance_high, 0xDFFFFFFFu, FXL_E_RANGE)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->nodes[2].distance_high = 0x20000000u; /* 2^61 and the least bit more */
    made->nodes[2].distance_low = 1;
    expect(FXL_E_RANGE, "BSP node", 2);
    made->nodes[2].distance_high = 0x20000000u; /* 2^61 itself, and then no face is near */
    made->nodes[2].distance_low = 0;
    expect(FXL_E_PLANARITY, "BSP node", 2);
}

/* 8 units of 2^-16 off is near enough, the least bit more is not. */
/* formats 1.7l */
void test_faces_lie_on_the_plane(void)
{
    const uint64_t one = (uint64_t)FXL_Q2_30_ONE * 65536u, most = (uint64_t)8 << 30;
    const struct {
        uint64_t distance;
        fxl_status status;
    } cases[] = {{one + most, FXL_OK},
                 {one - most, FXL_OK},
                 {one + most + 1, FXL_E_PLANARITY},
                 {one - most - 1, FXL_E_PLANARITY}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        made->nodes[4].distance_low = (uint32_t)cases[i].distance;
        made->nodes[4].distance_high = (uint32_t)(cases[i].distance >> 32);
        expect(cases[i].status, "BSP node", 4);
    }
}

/* A triangle, and a plane that is tilted about one of its edges by a thousandth: the vertex that is
 * not on it is found wherever the triangle begins. */
void test_each_vertex_of_a_face_lies_on_the_plane(void)
{
    const fxl_q2_30 sine = 1 << 20, cosine = FXL_Q2_30_ONE - 512;
    const uint64_t distance = (uint64_t)(sine + cosine) * 65536u;
    for (uint32_t first = 0; first < 3; first++) {
        fxl_face *face = &made->tiny->faces[11];
        const uint16_t *corners = fxl_face_indices(made->tiny->corners, face);
        const uint16_t triangle[] = {corners[0], corners[1], corners[2]};
        for (uint32_t i = 0; i < 3; i++) {
            face->indices[i] = triangle[(first + i) % 3];
        }
        face->count = 3;
        made->tiny->scene.index_count--;
        made->tiny->scene.face_bounds = NULL;
        made->tiny->scene.face_bounds_count = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&made->tiny->scene, NULL));
        made->nodes[5].normal = (fxl_direction){0, sine, cosine};
        made->nodes[5].distance_low = (uint32_t)distance;
        made->nodes[5].distance_high = (uint32_t)(distance >> 32);
        expect(FXL_E_PLANARITY, "BSP node", 5);
    }
}

/* formats 1.7g, 1.7j, 1.7l-m */
void test_spheres(void)
{
    const unit_field fields[] = {
        {NODE(3, radius, -1, FXL_E_RANGE)},
        {NODE(0, radius, FXL_RADIUS_MAX, FXL_OK)},
        {NODE(0, radius, FXL_RADIUS_MAX + 1, FXL_E_RANGE)},
        /* The object of node 2 stands at 10. */
        {NODE(2, centre.z, FXL_COORDINATE_MAX - Q16(10) + 1, FXL_E_RANGE)},
        {NODE(2, centre.y, -FXL_COORDINATE_MAX - 1, FXL_E_RANGE)},
        {NODE(5, radius, Q16(1.7), FXL_E_RADIUS)}, /* sqrt(3) is more */
        /* Less than that below it. */
        {UNIT_FIELD(made->nodes[0].radius, TINY_RADIUS - 1), FXL_E_RADIUS, "BSP node", 1},
        {NODE(5, centre.x, 1, FXL_E_RADIUS)}, /* as large, and elsewhere */
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->nodes[5].centre.x = 3; /* 5 away from the one above, which is 5 larger */
    made->nodes[5].centre.y = -4;
    for (int i = 0; i < 5; i++) {
        made->nodes[i].radius = TINY_RADIUS + 5;
    }
    expect(FXL_OK, NULL, 0);
    made->nodes[5].centre.x = 3;
    made->nodes[5].centre.y = -4;
    for (int i = 0; i < 5; i++) {
        made->nodes[i].radius = TINY_RADIUS + 4;
    }
    expect(FXL_E_RADIUS, "BSP node", 5);
}

/* A sphere about one corner of the last node's face, which any of the others leaves. */
void test_a_sphere_holds_every_corner(void)
{
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_face *face = &made->tiny->faces[11];
        const uint16_t corner = fxl_face_indices(made->tiny->corners, face)[i];
        made->nodes[5].centre = made->tiny->vertices[8 + corner];
        made->nodes[5].radius = 256;
        expect(FXL_E_RADIUS, "BSP node", 5);
    }
}

/* A sphere about one corner of the last node's face that leaves out the opposite one alone: the
 * face is a square of side 2. */
void test_a_sphere_that_lacks_one_corner(void)
{
    for (uint32_t i = 0; i < 4; i++) {
        const fxl_face *face = &made->tiny->faces[11];
        const uint16_t corner = fxl_face_indices(made->tiny->corners, face)[(i + 2) % 4];
        for (uint32_t k = 0; k < 5; k++) {
            made->nodes[k].radius = Q16(9);
        }
        made->nodes[5].centre = made->tiny->vertices[8 + corner];
        made->nodes[5].radius = Q16(2.8);
        expect(FXL_E_RADIUS, "BSP node", 5);
        for (uint32_t k = 0; k < 5; k++) {
            made->nodes[k].radius = Q16(9);
        }
        made->nodes[5].centre = made->tiny->vertices[8 + corner];
        made->nodes[5].radius = Q16(2.83); /* sqrt(8) is 2.8284 */
        expect(FXL_OK, NULL, 0);
    }
}

/* bsp 1.1, formats 1.7e */
void test_every_face_has_one_node(void)
{
    const unit_field fields[] = {
        {NODE(1, first_face, 2, FXL_E_INDEX)},
        {UNIT_FIELD(made->nodes[5].face_count, 0), FXL_E_COUNT, "BSP node table", 0},
        {NODE(5, face_count, 2, FXL_E_INDEX)},
        {NODE(5, face_count, 0xFFFF, FXL_E_INDEX)},
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
}

/* bsp 1.1, formats 1.7c, 1.7k */
void test_links(void)
{
    const unit_field fields[] = {
        {NODE(0, parent, 0, FXL_E_BSP)},
        {NODE(3, back, 3, FXL_E_BSP)}, /* round and round */
        {NODE(3, back, 0, FXL_E_BSP)},
        {NODE(3, back, 5, FXL_E_BSP)}, /* 4 hangs nowhere */
        {UNIT_FIELD(made->nodes[3].back, FXL_BSP_NONE), FXL_E_BSP, "BSP node", 4},
        {NODE(5, front, 6, FXL_E_BSP)}, /* past the end */
        {NODE(5, front, 0xFFFE, FXL_E_BSP)},
        {UNIT_FIELD(made->nodes[4].parent, 2), FXL_E_BSP, "BSP node", 3},
        {NODE(2, front, 3, FXL_E_BSP)}, /* twice */
    };
    unit_expect_fields(fields, sizeof fields / sizeof fields[0], expect);
    made->nodes[2].front = 3; /* in front instead of behind: sound, for this check */
    made->nodes[2].back = FXL_BSP_NONE;
    expect(FXL_OK, NULL, 0);
}

/* A chain of nodes without faces, behind each other: as deep as may be, and one deeper. */
/* formats 1.7f, 1.7k */
void test_depth(void)
{
#ifndef UNIT_ON_TARGET
    static fxl_bsp_node chain[FXL_BSP_DEPTH_MAX + 2];
    for (uint32_t count = FXL_BSP_DEPTH_MAX + 1; count <= FXL_BSP_DEPTH_MAX + 2; count++) {
        for (uint32_t i = 0; i < count; i++) {
            uint32_t own = i < BSP_NODES ? i : BSP_NODES - 1;
            chain[i] = made->nodes[own];
            chain[i].parent = (uint16_t)(i == 0 ? FXL_BSP_NONE : i - 1);
            chain[i].front = FXL_BSP_NONE;
            chain[i].back = (uint16_t)(i + 1 < count ? i + 1 : FXL_BSP_NONE);
            if (i >= BSP_NODES) {
                chain[i].first_face = BSP_NODES;
                chain[i].face_count = 0;
            }
        }
        made->tiny->scene.bsp_nodes = chain;
        made->tiny->scene.bsp_node_count = count;
        expect(count == FXL_BSP_DEPTH_MAX + 1 ? FXL_OK : FXL_E_BSP, "BSP node", FXL_BSP_DEPTH_MAX);
    }
#endif
}

/* A short branch in front of the root, and a chain behind it: the chain's depth counts from the
 * root. */
void test_depth_behind_a_branch(void)
{
#ifndef UNIT_ON_TARGET
    enum {
        BRANCH = 3
    };
    static fxl_bsp_node tree[BRANCH + FXL_BSP_DEPTH_MAX + 2];
    const uint32_t most = BRANCH + FXL_BSP_DEPTH_MAX + 1;
    for (uint32_t count = most; count <= most + 1; count++) {
        for (uint32_t i = 0; i < count; i++) {
            const bool ends = i == BRANCH || i + 1 == count;
            tree[i] = made->nodes[i < BSP_NODES ? i : BSP_NODES - 1];
            tree[i].parent = (uint16_t)(i == 0 ? FXL_BSP_NONE : i == BRANCH + 1 ? 0 : i - 1);
            tree[i].front = (uint16_t)(i == 0 ? 1 : FXL_BSP_NONE);
            tree[i].back = (uint16_t)(i == 0 ? BRANCH + 1 : ends ? FXL_BSP_NONE : i + 1);
            tree[i].first_face = (uint16_t)(i < BSP_NODES ? i : BSP_NODES);
            tree[i].face_count = i < BSP_NODES;
        }
        made->tiny->scene.bsp_nodes = tree;
        made->tiny->scene.bsp_node_count = count;
        expect(count == most ? FXL_OK : FXL_E_BSP, "BSP node", most - 1);
    }
#endif
}

/* As many nodes as may be: chains of front nodes, hung behind each other. */
void test_the_largest_tree(void)
{
#ifndef UNIT_ON_TARGET
    enum {
        CHAIN = 700
    };
    static fxl_bsp_node many[FXL_BSP_NODES_MAX];
    for (uint32_t i = 0; i < FXL_BSP_NODES_MAX; i++) {
        const bool ends = i % CHAIN == CHAIN - 1 || i + 1 == FXL_BSP_NODES_MAX;
        const uint32_t behind = i + CHAIN, above = i % CHAIN == 0 ? i - CHAIN : i - 1;
        many[i] = made->nodes[i < BSP_NODES ? i : BSP_NODES - 1];
        many[i].parent = (uint16_t)(i == 0 ? FXL_BSP_NONE : above);
        many[i].front = (uint16_t)(ends ? FXL_BSP_NONE : i + 1);
        many[i].back =
            (uint16_t)(i % CHAIN == 0 && behind < FXL_BSP_NODES_MAX ? behind : FXL_BSP_NONE);
        many[i].first_face = (uint16_t)(i < BSP_NODES ? i : BSP_NODES);
        many[i].face_count = i < BSP_NODES;
    }
    made->tiny->scene.bsp_nodes = many;
    made->tiny->scene.bsp_node_count = FXL_BSP_NODES_MAX;
    expect(FXL_OK, NULL, 0);
#endif
}

/* A tree of one node, for a model of one face. */
void test_the_smallest_tree(void)
{
    fxl_scene *scene = &made->tiny->scene;
    made->tiny->models[1].face_count = 1;
    scene->face_count = 7;
    scene->face_bounds = NULL;
    scene->face_bounds_count = 0;
    scene->bsp_node_count = 1;
    made->nodes[0].back = FXL_BSP_NONE;
    expect(FXL_OK, NULL, 0);
}

/* A sphere need not hold the faces of the nodes beside its own. The second node is a leaf in front
 * of the first, and all others are behind that. */
void test_a_sphere_is_of_its_own_faces_alone(void)
{
    made->nodes[0].front = 1;
    made->nodes[0].back = 2;
    made->nodes[0].radius = Q16(3);
    made->nodes[1].back = FXL_BSP_NONE;
    made->nodes[2].parent = 0;
    made->nodes[1].centre.x = Q16(1); /* the middle of its face, whose corners are sqrt(2) away */
    made->nodes[1].radius = Q16(1.415);
    expect(FXL_OK, NULL, 0);
}

/* An image with a tree: its nodes follow all else, and are used in place. */
/* formats 1.1w, 1.2s, 1.7b */
void test_a_tree_in_an_image(void)
{
    tiny_image *image = tiny_image_make(false);
    fxl_scene_image opened;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, NULL));
    TEST_ASSERT_NULL(opened.scene.bsp_nodes);
    tiny_set_section(image, SECTION_BSP_NODES, bsp_make()->nodes, BSP_NODES, sizeof made->nodes[0]);
    tiny_put32(tiny_at(image, AT_BSP_INSTANCE), 1);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_PTR(tiny_at(image, tiny_get(image, AT_MORE)), opened.scene.bsp_nodes);
    TEST_ASSERT_EQUAL_UINT32(BSP_NODES, opened.scene.bsp_node_count);
    TEST_ASSERT_EQUAL_UINT32(1, opened.scene.bsp_instance);
    tiny_put32(tiny_at(image, AT_MORE + 4), BSP_NODES + 1); /* past the end of the image */
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_OFFSET, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("BSP node table", fault.what);
    tiny_put32(tiny_at(image, AT_MORE + 4), 65535 + 1);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
}
