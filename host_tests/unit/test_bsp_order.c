/* SPDX-License-Identifier: MIT */
/* Drawing by a tree beside other layers, near to far, through the near plane, with a clipper that
 * gives several polygons a face, and with light. */
#include "../../lib/scene/bsp_node.h"
#include "bsp_scene.h"
#include "choices.h"
#include "frame_bands.h"
#include "painters.h"
#include "study/clippers.h"

enum {
    WIDTH = BSP_WIDTH,
    HEIGHT = BSP_HEIGHT,
    BACKGROUND = BSP_BACKGROUND,
    PIECES = 3072,
    LIGHT = 2048
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT], lit[256];
static uint64_t workspace[64], pieces[PIECES / 8], light_room[LIGHT / 8];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static fxl_clipper_workspace clip_room;
static bsp_scene *made;

static void start(const choice *visibility, const fxl_lens *lens)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    fxl_scene *scene = &made->tiny->scene;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, visibility, workspace, sizeof workspace));
    if (visibility->order->memory_size != NULL && scene->bsp_nodes != NULL) {
        fxl_bsp_workspace *tree = renderer.order_memory;
        tree->pieces = pieces;
        tree->pieces_size = sizeof pieces;
    }
}

static void draw(uint8_t *frame, const fxl_pose *pose, uint32_t rows)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

/* Cubes on layers 0, 1 and 2, the tree's on each of them in turn, each hiding some of the one
 * before. Near to far the layers come in reverse, and the same pixels win. */
/* bsp 2.3, 2.1a */
void test_layers_come_in_reverse_near_to_far(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    choice reverse = choice_tree;
    reverse.target = painter_under(BACKGROUND);
    for (uint32_t turn = 0; turn < 3; turn++) {
        made = bsp_make();
        for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
            fxl_instance *instance = &made->tiny->instances[i];
            instance->layer = (uint8_t)((i + turn) % 3);
            instance->centre =
                (fxl_point){Q16(0.75) * instance->layer, Q16(0.5) * instance->layer, Q16(5)};
        }
        start(&choice_tree, &lens);
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
        start(&reverse, &lens);
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        for (uint32_t i = 0; i < TINY_INSTANCES; i++) { /* every cube is seen */
            const uint8_t front = i == 1 ? 15 : 5;
            TEST_ASSERT_NOT_NULL(memchr(whole, front, sizeof whole));
        }
    }
}

/* The spheres of the tree cross the near plane and no other. */
void test_a_tree_through_the_near_plane_is_drawn(void)
{
    fxl_lens lens;
    const fxl_pose pose = {{0, Q16(4), 0}, 0, 0, 0};
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_lens_from_fov(WIDTH, HEIGHT, FXL_ANGLE_QUARTER, Q16(9.5), Q16(100), 0, &lens));
    made = bsp_make();
    made->tiny->instances[0].layer = made->tiny->instances[2].layer = 1;
    made->tiny->instances[0].centre.z = made->tiny->instances[2].centre.z = Q16(-50);
    start(&choice_sorted, &lens);
    draw(other, &pose, HEIGHT);
    TEST_ASSERT_NOT_NULL(memchr(other, 14, sizeof other));
    start(&choice_tree, &lens);
    draw(whole, &pose, HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(1u << FXL_PLANE_NEAR, order[0].instance.planes);
    TEST_ASSERT_EQUAL_MEMORY(other, whole, sizeof whole);
}

/* A cube that moves through the tree's, beside it and into it. */
static void make_crossing(void)
{
    made = bsp_make();
    made->tiny->instances[0].centre = (fxl_point){Q16(0.75), Q16(0.5), Q16(9.25)};
    made->tiny->instances[2].centre = (fxl_point){Q16(-1.25), Q16(-0.5), Q16(10.5)};
}

/* Faces that come as several polygons count once, whole or in pieces. */
void test_a_clipper_of_several_polygons(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose poses[] = {{{Q16(2.5), Q16(2), Q16(7)}, DEGREES(-40), DEGREES(-30), 0},
                              {{Q16(0.5), Q16(1), Q16(6)}, 0, 0, 0}};
    uint32_t clipped = 0;
    for (uint32_t i = 0; i < 2; i++) {
        make_crossing();
        start(&choice_tree, &lens);
        draw(whole, &poses[i], HEIGHT);
        const fxl_counters counters = renderer.workspace.counters;
        start(&choice_tree, &lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_triangles,
                                                           &clip_room, sizeof clip_room));
        draw(other, &poses[i], HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
        TEST_ASSERT_EQUAL_UINT32(counters.drawn, renderer.workspace.counters.drawn);
        TEST_ASSERT_EQUAL_UINT32(counters.backfacing, renderer.workspace.counters.backfacing);
        clipped += counters.clipped;
        uint32_t differing = 0;
        for (uint32_t k = 0; k < WIDTH * HEIGHT; k++) {
            differing += whole[k] != other[k];
        }
        TEST_ASSERT_TRUE(differing <= 2); /* the clippers round their vertices differently */
    }
    TEST_ASSERT_TRUE(clipped > 0);
}

/* Pieces of what moves are split by the beam as its faces would be: the pixels are those without
 * light, some of them lit, in bands as whole. */
void test_pieces_are_lit(void)
{
    static const fxl_point window[] = {{Q16(-2), Q16(4), Q16(8.6)},
                                       {Q16(-2), Q16(4), Q16(9.7)},
                                       {Q16(1.1), Q16(4), Q16(9.7)},
                                       {Q16(1.1), Q16(4), Q16(8.6)}};
    const fxl_direction down = {0, -FXL_Q2_30_ONE, 0};
    const fxl_pose pose = {{0, Q16(5), Q16(7)}, 0, DEGREES(-50), 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_beam beam;
    const fxl_beam_set beams = {&beam, 1, lit};
    uint32_t bright[2] = {0, 0}, dark[2] = {0, 0};
    for (uint32_t i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + 100);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&down, window, 4, &beam));
    make_crossing();
    start(&choice_tree, &lens);
    draw(whole, &pose, HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(0, ((const fxl_bsp_workspace *)renderer.order_memory)->unsplit);
    for (uint32_t rows = HEIGHT; rows > 0; rows /= 4) {
        start(&choice_tree, &lens);
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_beams(&renderer, &beams, light_room, sizeof light_room));
        draw(other, &pose, rows);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t moves = whole[i] <= 6;
            TEST_ASSERT_TRUE(other[i] == whole[i] || other[i] == lit[whole[i]]);
            bright[moves] += other[i] != whole[i];
            dark[moves] += other[i] == whole[i];
        }
    }
    TEST_ASSERT_TRUE(bright[0] > 4 && bright[1] > 4 && dark[0] > 4 && dark[1] > 4);
}

/* Cubes on the planes of the tree and not across them stay whole: the memory that is used is that
 * of the faces that face the eye, 12 bytes each and 16 for each of their vertices. */
/* bsp 3.5 */
void test_what_touches_a_plane_is_not_cut(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{Q16(5), Q16(4), Q16(4)}, DEGREES(-45), DEGREES(-20), 0};
    static const fxl_point places[] = {
        {Q16(2), 0, Q16(10)},  {0, Q16(2), Q16(10)},       {0, 0, Q16(8)},
        {0, 0, Q16(10)},       {Q16(2), Q16(2), Q16(8)},   {Q16(-2), 0, Q16(10)},
        {0, Q16(-2), Q16(10)}, {Q16(2), Q16(-2), Q16(12)}, {0, 0, Q16(12)}};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        made = bsp_make();
        made->tiny->instances[0].centre = places[i];
        made->tiny->instances[2].layer = 1;
        start(&choice_tree, &lens);
        draw(whole, &pose, HEIGHT);
        const fxl_bsp_workspace *tree = renderer.order_memory;
        uint32_t front = 0;
        for (uint32_t k = 0; k < 6; k++) {
            front += fxl_face_is_front(&made->tiny->scene, &made->tiny->instances[0],
                                       &made->tiny->faces[k], &pose.position);
        }
        TEST_ASSERT_TRUE(front > 0);
        TEST_ASSERT_EQUAL_UINT32(front * (12 + 4 * 16), tree->used);
    }
}

static uint32_t used_by(const fxl_point *centre, const fxl_pose *pose)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    made->tiny->instances[0].centre = *centre;
    made->tiny->instances[2].layer = 1;
    start(&choice_tree, &lens);
    draw(whole, pose, HEIGHT);
    const fxl_bsp_workspace *tree = renderer.order_memory;
    TEST_ASSERT_EQUAL_UINT32(0, tree->unsplit);
    return tree->used;
}

/* The first cube has no room for its parts, and is whole; what it had taken is free again for the
 * second. */
/* bsp 3.7 */
void test_what_a_failed_cut_took_is_free_again(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{Q16(5), Q16(4), Q16(4)}, DEGREES(-45), DEGREES(-20), 0};
    made = bsp_make();
    made->tiny->instances[0].centre = (fxl_point){Q16(1), 0, Q16(8)};
    made->tiny->instances[2].centre = (fxl_point){Q16(2), Q16(2), Q16(6)};
    start(&choice_tree, &lens);
    fxl_bsp_workspace *tree = renderer.order_memory;
    draw(whole, &pose, HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(0, tree->unsplit);
    TEST_ASSERT_EQUAL_UINT32(5 * 12 + 5 * 4 * 16 + 3 * (12 + 4 * 16), tree->used);
    tree->pieces_size = 5 * 12 + 5 * 4 * 16 - 4; /* four bytes too few for the first */
    draw(other, &pose, HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(1, tree->unsplit);
    TEST_ASSERT_TRUE(tree->used <= tree->pieces_size);
}

/* Two bits a node, in words, and 4 bytes a node and 12 a mover; one bit where nothing moves. */
void test_room_for_trees_of_any_size(void)
{
    static const uint32_t nodes[] = {1, 31, 32, 33, 64, 65};
    static const uint32_t words[] = {1, 1, 1, 2, 2, 3};
    made = bsp_make();
    fxl_scene *scene = &made->tiny->scene;
    for (int i = 0; i < 6; i++) {
        const uint32_t record = (uint32_t)sizeof(fxl_bsp_workspace);
        scene->bsp_node_count = nodes[i];
        made->tiny->instances[0].layer = made->tiny->instances[2].layer = 0;
        TEST_ASSERT_EQUAL_UINT32(record + 8 * words[i] + 4 * nodes[i] + 2 * 12,
                                 choice_tree.order->memory_size(scene));
        made->tiny->instances[0].layer = 1;
        TEST_ASSERT_EQUAL_UINT32(record + 8 * words[i] + 4 * nodes[i] + 12,
                                 choice_tree.order->memory_size(scene));
        made->tiny->instances[2].layer = 1;
        TEST_ASSERT_EQUAL_UINT32(record + 4 * words[i], choice_tree.order->memory_size(scene));
    }
}

/* The plane x = 1 halves two of the three faces. Each half has two corners of the face and two
 * intersections. Through two corners of a face, a plane makes no intersection: each half has both
 * corners. */
void test_how_much_a_cut_takes(void)
{
    const fxl_pose pose = {{Q16(5), Q16(4), Q16(4)}, DEGREES(-45), DEGREES(-20), 0};
    const fxl_point halved = {Q16(1), 0, Q16(8)}, diamond = {Q16(1), Q16(-20), Q16(8)};
    const fxl_pose before_it = {{Q16(1), Q16(-19.8), Q16(4)}, 0, 0, 0};
    made = bsp_make();
    TEST_ASSERT_EQUAL_UINT32(5 * 12 + 5 * 4 * 16, used_by(&halved, &pose));
    made = bsp_make();
    bsp_tilt(made, 0, 0, DEGREES(45));
    TEST_ASSERT_EQUAL_UINT32(2 * 12 + 2 * 3 * 16, used_by(&diamond, &before_it));
}

enum {
    DEEP = 70 /* nodes: more than two words of bits */
};
static fxl_bsp_node deep[DEEP];

/* Hangs the tree below nodes that have no faces. Everything is behind their planes, 1000 units off,
 * and each sphere is a little larger than the one below. */
static void deepen_to(uint32_t count)
{
    const uint32_t above = count - BSP_NODES;
    for (uint32_t i = 0; i < count; i++) {
        deep[i] = made->nodes[i < above ? 0 : i - above];
        deep[i].front = FXL_BSP_NONE;
        deep[i].back = (uint16_t)(i + 1 < count ? i + 1 : FXL_BSP_NONE);
        deep[i].parent = (uint16_t)(i > 0 ? i - 1 : FXL_BSP_NONE);
        deep[i].radius += (fxl_q16_16)(count - i);
        if (i < above) {
            deep[i].distance_high = 1000 << 14;
            deep[i].face_count = 0;
        }
    }
    made->tiny->scene.bsp_nodes = deep;
    made->tiny->scene.bsp_node_count = count;
}

static void deepen(void)
{
    deepen_to(DEEP);
}

/* The frame and its counters are the same after the tree has been changed. */
static void expect_no_change(const fxl_lens *lens, const fxl_pose *pose, void (*change)(void))
{
    start(&choice_tree, lens);
    draw(whole, pose, HEIGHT);
    const fxl_counters counters = renderer.workspace.counters;
    change();
    start(&choice_tree, lens);
    draw(other, pose, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
}

void test_nodes_without_faces_change_nothing(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (uint32_t round = 0; round < UNIT_REPEAT / 1000; round++) {
        made = bsp_make();
        const fxl_pose pose = bsp_shuffle(made);
        expect_no_change(&lens, &pose, deepen);
    }
}

/* All spheres of the tree are behind the eye, though that of its object is not. What moves before
 * the eye is drawn all the same: its leaf is below the last node. */
/* bsp 3.5a-b */
void test_what_moves_is_drawn_where_the_tree_is_not(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{0, 0, Q16(14)}, 0, 0, 0};
    for (int is_deep = 0; is_deep < 2; is_deep++) {
        made = bsp_make();
        made->tiny->models[1].radius = Q16(20);
        made->tiny->instances[0].centre = (fxl_point){0, 0, Q16(18)};
        made->tiny->instances[2].centre = (fxl_point){0, 0, Q16(-100)};
        if (is_deep) {
            deepen();
        }
        start(&choice_tree, &lens);
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT8(5, whole[WIDTH * HEIGHT / 2 + WIDTH / 2]);
        TEST_ASSERT_EQUAL_UINT8(BACKGROUND, whole[0]);
        TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.drawn);
        TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
    }
}

/* The workspace is as large as the method says, and not a byte of what follows is written, for
 * trees whose bits fill a word or not. */
void test_the_workspace_is_large_enough(void)
{
    static FXL_ALIGN_8 uint8_t room[sizeof(fxl_bsp_workspace) + 16 + 4 * DEEP + 24 + 64];
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, TINY_INSTANCES + 6, NULL, 0, NULL, 0};
    static const uint32_t counts[] = {30, 31, 32, 33, 62, 63, 64, 65, 70};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        make_crossing();
        const fxl_pose pose = {{Q16(2.5), Q16(2), Q16(7)}, DEGREES(-40), DEGREES(-30), 0};
        start(&choice_tree, &lens);
        draw(whole, &pose, HEIGHT);
        deepen_to(counts[i]);
        fxl_scene *scene = &made->tiny->scene;
        const uint32_t size = choice_tree.order->memory_size(scene);
        const uint32_t rounded = (size + 7) / 8 * 8;
        TEST_ASSERT_TRUE(rounded + 32 <= sizeof room);
        memset(room, 0x5A, sizeof room);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, &lens, &memory));
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, room, rounded));
        fxl_bsp_workspace *tree = renderer.order_memory;
        memset(room + sizeof *tree, 0x5A, sizeof room - sizeof *tree);
        tree->pieces = pieces;
        tree->pieces_size = i % 2 ? sizeof pieces : 0;
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room + size, sizeof room - size);
        if (i % 2) {
            TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        }
    }
}

/* The plane z = 3, whose front is towards -z. */
/* bsp 1.2b */
void test_an_eye_on_a_plane_is_behind_it(void)
{
    static const fxl_bsp_node node = {.normal = {0, 0, -FXL_Q2_30_ONE},
                                      .distance_high = (uint32_t)(-3 * 16384)};
    for (int32_t beside = -Q16(9); beside <= Q16(9); beside += Q16(3)) {
        const fxl_point before = {beside, -beside, Q16(3) - 1}, on = {beside, -beside, Q16(3)},
                        beyond = {beside, -beside, Q16(3) + 1};
        TEST_ASSERT_TRUE(fxl_bsp_is_front(&node, &before));
        TEST_ASSERT_FALSE(fxl_bsp_is_front(&node, &on));
        TEST_ASSERT_FALSE(fxl_bsp_is_front(&node, &beyond));
    }
}

/* Before and behind the cube of the tree, which is about (0, 0, 10), a cube lies in one leaf, and
 * needs no memory for pieces to be drawn as with it. */
/* bsp 3.7b */
void test_what_lies_in_one_leaf_is_drawn_whole_there(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{Q16(0.5), Q16(0.25), 0}, 0, 0, 0};
    for (uint32_t is_behind = 0; is_behind < 2; is_behind++) {
        made = bsp_make();
        made->tiny->instances[0].centre = (fxl_point){0, 0, is_behind ? Q16(13) : Q16(7)};
        made->tiny->instances[2].centre = (fxl_point){0, 0, Q16(-100)};
        start(&choice_tree, &lens);
        draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(0, ((fxl_bsp_workspace *)renderer.order_memory)->unsplit);
        start(&choice_tree, &lens);
        ((fxl_bsp_workspace *)renderer.order_memory)->pieces_size = 0;
        draw(other, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(1, ((fxl_bsp_workspace *)renderer.order_memory)->unsplit);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        TEST_ASSERT_EQUAL_UINT8(is_behind ? 15 : 5, whole[HEIGHT / 2 * WIDTH + WIDTH / 2]);
    }
}

/* Vertices on the plane are in both parts. With any memory that is too small for the parts, the
 * cube is whole. */
/* bsp 3.7 */
void test_any_memory_too_small_for_vertices_on_a_plane(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_point diamond = {Q16(1), Q16(-20), Q16(8)};
    const fxl_pose before_it = {{Q16(1), Q16(-19.8), Q16(4)}, 0, 0, 0};
    made = bsp_make();
    bsp_tilt(made, 0, 0, DEGREES(45));
    const uint32_t used = used_by(&diamond, &before_it);
    for (uint32_t bytes = 0; bytes <= used; bytes += 4) {
        start(&choice_tree, &lens);
        fxl_bsp_workspace *tree = renderer.order_memory;
        tree->pieces_size = bytes;
        draw(other, &before_it, HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(bytes < used, tree->unsplit);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* Nodes without faces above the tree, which is in front of their planes, and nothing behind them.
 */
static void deepen_in_front(void)
{
    const uint32_t above = 3, count = above + BSP_NODES;
    for (uint32_t i = 0; i < count; i++) {
        deep[i] = made->nodes[i < above ? 0 : i - above];
        deep[i].front = (uint16_t)(i < above ? i + 1 : FXL_BSP_NONE);
        deep[i].back = (uint16_t)(i >= above && i + 1 < count ? i + 1 : FXL_BSP_NONE);
        deep[i].parent = (uint16_t)(i > 0 ? i - 1 : FXL_BSP_NONE);
        deep[i].radius += (fxl_q16_16)(count - i) + (i < above ? Q16(20) : 0);
        if (i < above) {
            deep[i].distance_low = 0;
            deep[i].distance_high = (uint32_t) - (1000 << 14);
            deep[i].face_count = 0;
        }
    }
    made->tiny->scene.bsp_nodes = deep;
    made->tiny->scene.bsp_node_count = count;
}

void test_nodes_with_nothing_behind_them_change_nothing(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (uint32_t round = 0; round < UNIT_REPEAT / 1000 + 8; round++) {
        made = bsp_make();
        fxl_pose pose = bsp_shuffle(made);
        if (round % 2) { /* the spheres of the tree are behind the eye, but not those above it */
            made->tiny->models[1].radius = Q16(20);
            pose = (fxl_pose){{0, 0, Q16(14)}, 0, 0, 0};
        }
        expect_no_change(&lens, &pose, deepen_in_front);
    }
}
