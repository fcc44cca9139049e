/* SPDX-License-Identifier: MIT */
/* A tree whose nodes have spheres of their own, and nodes on both sides: what is out of sight is
 * left out and counted, and all else is drawn as without a tree. */
#include "bsp_scene.h"
#include "choices.h"
#include "frame_bands.h"
#include "painters.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    NODES = 7,
    WORDS = 12 * FXL_DISPLAY_LIST_WORDS(5)
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static uint32_t list[WORDS];
static uint64_t workspace[64], pieces[2048 / 8];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_bsp_node nodes[NODES];
static fxl_renderer renderer;
static tiny_scene *tiny;

static fxl_bsp_node node(uint32_t face, uint16_t front, uint16_t back, uint16_t parent)
{
    const uint64_t distance = (uint64_t)FXL_Q2_30_ONE * 65536u;
    return (fxl_bsp_node){.normal = tiny->faces[6 + face].normal,
                          .distance_low = (uint32_t)distance,
                          .distance_high = (uint32_t)(distance >> 32),
                          .front = front,
                          .back = back,
                          .parent = parent,
                          .first_face = (uint16_t)face,
                          .face_count = 1,
                          .radius = Q16(2.5)};
}

/* Object 1 is a cube, so its faces hide none of each other, whatever their order. The root halves
 * it at x = 0 and has no face. The faces -x +x -y are below its front side, the faces +y -z +z
 * below its back side. The last node of either side has a sphere about its face alone, whose
 * corners are sqrt(2) from the middle. Those above hold that sphere, which reaches 1 + sqrt(2) from
 * the centre. */
static void make(void)
{
    tiny = bsp_make()->tiny;
    nodes[0] = node(1, 1, 4, FXL_BSP_NONE);
    nodes[0].distance_low = nodes[0].distance_high = 0;
    nodes[0].first_face = nodes[0].face_count = 0;
    nodes[1] = node(0, FXL_BSP_NONE, 2, 0);
    nodes[2] = node(1, FXL_BSP_NONE, 3, 1);
    nodes[3] = node(2, FXL_BSP_NONE, FXL_BSP_NONE, 2);
    nodes[4] = node(3, FXL_BSP_NONE, 5, 0);
    nodes[5] = node(4, FXL_BSP_NONE, 6, 4);
    nodes[6] = node(5, FXL_BSP_NONE, FXL_BSP_NONE, 5);
    nodes[3].centre = (fxl_point){0, Q16(-1), 0};
    nodes[6].centre = (fxl_point){0, 0, Q16(1)};
    nodes[3].radius = nodes[6].radius = Q16(1.4143);
    tiny->scene.bsp_nodes = nodes;
    tiny->scene.bsp_node_count = NODES;
}

/* The root has no faces, so its two subtrees' spheres are tested one after the other where the
 * first is out of sight. They are of one size, and differ in one coordinate: one face lies before
 * the root's plane, and its sphere is about a point beyond the face. */
static void make_spheres_of_one_size(uint32_t axis)
{
    tiny = bsp_make()->tiny;
    const fxl_face first = tiny->faces[6];
    tiny->faces[6] = tiny->faces[6 + 2 * axis];
    tiny->faces[6 + 2 * axis] = first;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    nodes[0] = node(0, 1, 2, FXL_BSP_NONE);
    nodes[0].distance_low = nodes[0].distance_high = 0;
    nodes[0].face_count = 0;
    nodes[0].radius = Q16(4);
    for (uint16_t i = 1; i < NODES; i++) {
        nodes[i] = node(i - 1u, FXL_BSP_NONE, (uint16_t)(i == 1 || i == 6 ? FXL_BSP_NONE : i + 1u),
                        (uint16_t)(i <= 2 ? 0 : i - 1u));
        nodes[i].radius = TINY_RADIUS;
    }
    nodes[1].centre =
        (fxl_point){axis == 0 ? -Q16(2) : 0, axis == 1 ? -Q16(2) : 0, axis == 2 ? -Q16(2) : 0};
    tiny->scene.bsp_nodes = nodes;
    tiny->scene.bsp_node_count = NODES;
}

static void start(const choice *visibility, const fxl_lens *lens, uint32_t words)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, list, words, NULL, 0};
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check_all(&tiny->scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, visibility, workspace, sizeof workspace));
    if (visibility->order->memory_size != NULL) {
        fxl_bsp_workspace *tree = renderer.order_memory;
        tree->pieces = pieces;
        tree->pieces_size = sizeof pieces;
    }
}

static fxl_counters draw(uint8_t *frame, const fxl_pose *pose, uint32_t rows)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
    return renderer.workspace.counters;
}

static fxl_angle any_angle(int32_t degrees)
{
    return (fxl_angle)(unit_between(-degrees, degrees) * (int32_t)DEGREES(1));
}

/* Before the cube at (0, 0, 10) or within it, so near that some of it is often beside the screen.
 */
static fxl_pose any_pose(void)
{
    return (fxl_pose){{unit_between(Q16(-3), Q16(3)), unit_between(Q16(-3), Q16(3)),
                       unit_between(Q16(6), Q16(10))},
                      any_angle(50),
                      any_angle(40),
                      unit_random()};
}

/* A lens whose near and far planes often lie within the cube. */
static fxl_lens any_lens(void)
{
    fxl_lens lens;
    const fxl_q16_16 near = unit_between(Q16(0.1), Q16(5));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(WIDTH, HEIGHT, DEGREES(60), near,
                                                near + unit_between(Q16(0.5), Q16(10)), 0, &lens));
    return lens;
}

static uint32_t drawn, clipped, unturned;

static void expect_as_without_a_tree(bool moving)
{
    const uint32_t axis = unit_random() % 6;
    if (axis < 3) {
        make_spheres_of_one_size(axis);
    } else {
        make();
    }
    for (int i = 0; i < TINY_INSTANCES; i += 2) {
        tiny->instances[i].centre = (fxl_point){0, 0, Q16(-1000)};
        tiny->instances[i].layer = !moving;
    }
    if (moving) { /* beside the cube, and never over it */
        tiny->instances[0].centre = (fxl_point){Q16(100), 0, Q16(10)};
    }
    fxl_pose pose = any_pose();
    const fxl_lens lens = any_lens();
    if (axis == 2 && pose.roll % 2 == 0) { /* from the other side */
        pose.position.z = Q16(20) - pose.position.z;
        pose.yaw += 2 * FXL_ANGLE_QUARTER;
    }
    start(&choice_sorted, &lens, 0);
    const fxl_counters expected = draw(whole, &pose, HEIGHT);
    start(&choice_tree, &lens, unit_random() % 3 * (uint32_t)unit_between(0, WORDS / 2));
    const fxl_counters counters = draw(other, &pose, (uint32_t)unit_between(1, HEIGHT));
    TEST_ASSERT_EQUAL_UINT32(18, counters.in);
    TEST_ASSERT_EQUAL_UINT32(expected.drawn, counters.drawn);
    TEST_ASSERT_EQUAL_UINT32(expected.clipped, counters.clipped);
    TEST_ASSERT_EQUAL_UINT32(0, counters.refused);
    TEST_ASSERT_TRUE(counters.outside >= expected.outside);
    TEST_ASSERT_EQUAL_UINT32(18, counters.backfacing + counters.outside + counters.degenerate +
                                     counters.drawn);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    drawn += counters.drawn;
    clipped += counters.clipped;
    unturned += counters.outside > expected.outside;
}

/* A face of a node out of sight counts as outside, whichever way it is turned. Without a tree a
 * face that is turned away counts as that. */
/* bsp 4.1a */
void test_a_tree_with_spheres_draws_the_same(void)
{
    drawn = clipped = unturned = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 25; round++) {
        expect_as_without_a_tree(round % 4 == 0);
    }
    TEST_ASSERT_TRUE(drawn > UNIT_REPEAT / 200 && clipped > UNIT_REPEAT / 200 &&
                     unturned > UNIT_REPEAT / 1000);
}

/* The sphere of a node has the centre of the node above it, and is smaller: it is tested by itself.
 * The eye is in the cube, above that sphere, and looks up. So no face is turned to it, and the
 * node's face is out of sight, as are the objects far behind. */
void test_a_smaller_sphere_about_the_same_centre(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose up = {{0, Q16(0.6), Q16(10)}, 0, DEGREES(90), 0};
    make();
    for (uint32_t i = 0; i < 3; i++) {
        nodes[i].centre = nodes[3].centre;
        nodes[i].radius = i == 0 ? Q16(3.6) : Q16(2.5);
    }
    tiny->instances[0].layer = tiny->instances[2].layer = 1;
    tiny->instances[0].centre = tiny->instances[2].centre = (fxl_point){0, Q16(-100), 0};
    start(&choice_tree, &lens, 0);
    const fxl_counters counters = draw(whole, &up, HEIGHT);
    TEST_ASSERT_EQUAL_UINT32(18, counters.in);
    TEST_ASSERT_EQUAL_UINT32(5, counters.backfacing);
    TEST_ASSERT_EQUAL_UINT32(13, counters.outside);
}

static void shift(fxl_point *point, const fxl_point *way)
{
    point->x += way->x;
    point->y += way->y;
    point->z += way->z;
}

/* Everything in its place, and the eye, moved by the same way: the same picture, whether what
 * moves is cut into pieces or is whole. */
void test_a_scene_moved_as_a_whole_looks_the_same(void)
{
    uint32_t cubes[2] = {0, 0};
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        const uint32_t pieces_size = round % 2 ? sizeof pieces : 0;
        const fxl_point way = unit_point(Q16(4000));
        const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
        fxl_pose pose = any_pose();
        make();
        for (int i = 0; i < TINY_INSTANCES; i += 2) { /* beside the tree's cube, or within it */
            tiny->instances[i].centre =
                (fxl_point){unit_between(Q16(-3), Q16(3)), unit_between(Q16(-3), Q16(3)),
                            unit_between(Q16(8), Q16(13))};
        }
        pose.position.z -= Q16(3);
        for (int moved = 0; moved < 2; moved++) {
            start(&choice_tree, &lens, 0);
            ((fxl_bsp_workspace *)renderer.order_memory)->pieces_size = pieces_size;
            draw(moved ? other : whole, &pose, HEIGHT);
            for (int i = 0; i < TINY_INSTANCES; i++) {
                shift(&tiny->instances[i].centre, &way);
            }
            shift(&pose.position, &way);
        }
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            cubes[0] += whole[i] <= 6;
            cubes[1] += whole[i] >= 11 && whole[i] <= 16;
        }
    }
    TEST_ASSERT_TRUE(cubes[0] > UNIT_REPEAT / 10 && cubes[1] > UNIT_REPEAT / 10);
}

/* The first node of the tree has three faces: the whole side -x in two colours, one over the other,
 * and a third over both. The last of them is seen, far to near as near to far. */
void test_a_node_of_several_faces(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{Q16(-5), 0, Q16(10)}, DEGREES(90), 0, 0};
    choice reverse = choice_tree;
    reverse.target = painter_under(BACKGROUND);
    for (int near_first = 0; near_first < 2; near_first++) {
        tiny = bsp_make()->tiny;
        for (uint32_t i = 1; i < 3; i++) {
            const uint8_t colour = tiny->faces[6 + i].material;
            tiny->faces[6 + i] = tiny->faces[6];
            tiny->faces[6 + i].material = colour;
        }
        tiny->scene.face_bounds = NULL;
        tiny->scene.face_bounds_count = 0;
        nodes[0] = node(0, FXL_BSP_NONE, 1, FXL_BSP_NONE);
        nodes[0].face_count = 3;
        nodes[1] = node(3, FXL_BSP_NONE, 2, 0);
        nodes[2] = node(4, FXL_BSP_NONE, 3, 1);
        nodes[3] = node(5, FXL_BSP_NONE, FXL_BSP_NONE, 2);
        tiny->scene.bsp_nodes = nodes;
        tiny->scene.bsp_node_count = 4;
        start(near_first ? &reverse : &choice_tree, &lens, 0);
        const fxl_counters counters = draw(whole, &pose, HEIGHT);
        TEST_ASSERT_EQUAL_UINT8(13, whole[HEIGHT / 2 * WIDTH + WIDTH / 2]);
        TEST_ASSERT_NULL(memchr(whole, 11, sizeof whole));
        TEST_ASSERT_NULL(memchr(whole, 12, sizeof whole));
        TEST_ASSERT_EQUAL_UINT32(18, counters.in);
    }
}

/* From each of the six sides, a cube that is not cut lies between the eye and the tree's cube, and
 * hides it; then beyond it, and is hidden. All its faces are drawn beside the list. */
void test_a_whole_cube_before_and_behind(void)
{
    static const struct {
        int x, y, z; /* out of a side */
        int32_t yaw, pitch;
    } sides[] = {{-1, 0, 0, 90, 0}, {1, 0, 0, -90, 0}, {0, -1, 0, 0, 90},
                 {0, 1, 0, 0, -90}, {0, 0, -1, 0, 0},  {0, 0, 1, 180, 0}};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        const fxl_pose pose = {
            {sides[i].x * Q16(8), sides[i].y * Q16(8), Q16(10) + sides[i].z * Q16(8)},
            (fxl_angle)(sides[i].yaw * (int32_t)DEGREES(1)),
            (fxl_angle)(sides[i].pitch * (int32_t)DEGREES(1)),
            0};
        for (int before = 0; before < 2; before++) {
            const int32_t out = before ? 3 : -3;
            tiny = bsp_make()->tiny; /* whose tree keeps the sides apart */
            tiny->instances[0].centre =
                (fxl_point){sides[i].x * Q16(1) * out, sides[i].y * Q16(1) * out,
                            Q16(10) + sides[i].z * Q16(1) * out};
            tiny->instances[2].layer = 1; /* behind the eye, or beside it */
            tiny->instances[2].centre = (fxl_point){Q16(1000), Q16(1000), Q16(1000)};
            start(&choice_tree, &lens, 0);
            ((fxl_bsp_workspace *)renderer.order_memory)->pieces_size = 0;
            const fxl_counters counters = draw(whole, &pose, HEIGHT);
            const uint8_t seen = whole[HEIGHT / 2 * WIDTH + WIDTH / 2];
            TEST_ASSERT_TRUE(before ? seen <= 6 : seen >= 11 && seen <= 16);
            TEST_ASSERT_EQUAL_UINT32(2, counters.drawn);
            TEST_ASSERT_EQUAL_UINT32(2, counters.spilled);
        }
    }
}

/* On whichever layer the tree is, what moves there is cut by it, and nothing else is. */
/* bsp 4.1b */
void test_what_moves_is_cut_on_any_layer(void)
{
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose pose = {{Q16(0.5), Q16(1), Q16(4)}, 0, 0, 0};
    for (uint8_t layer = 0; layer < 3; layer++) {
        for (int with = 0; with < 2; with++) {
            tiny = bsp_make()->tiny;
            tiny->instances[1].layer = layer;
            tiny->instances[0].layer = with ? layer : (uint8_t)(layer + 1);
            tiny->instances[2].layer = 1; /* beside the two, and in sight */
            tiny->instances[0].centre = (fxl_point){Q16(0.5), Q16(0.75), Q16(9.5)};
            tiny->instances[2].centre = (fxl_point){Q16(4), 0, Q16(12)};
            start(&choice_tree, &lens, 0);
            const fxl_counters counters = draw(whole, &pose, HEIGHT);
            const fxl_bsp_workspace *tree = renderer.order_memory;
            TEST_ASSERT_EQUAL_UINT32(18, counters.in);
            TEST_ASSERT_EQUAL_UINT32(0, tree->unsplit);
            /* A face takes 12 bytes and 16 for each of its vertices; parts take more. */
            TEST_ASSERT_EQUAL(with, tree->used > 3 * (12 + 4 * 16));
        }
    }
}

/* Where the whole tree is inside all planes, no vertex of it is measured. */
void test_nothing_is_measured_inside(void)
{
    static FXL_ALIGN_8 fxl_clip_stats counts;
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_pose inside = {{0, 0, Q16(2)}, 0, 0, 0}, across = {{0, 0, Q16(8)}, 0, 0, 0};
    for (int i = 0; i < 2; i++) {
        make();
        tiny->instances[0].layer = tiny->instances[2].layer = 1;
        tiny->instances[0].centre = tiny->instances[2].centre = (fxl_point){0, 0, Q16(-100)};
        start(&choice_tree, &lens, 0);
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, &counts, sizeof counts));
        counts = (fxl_clip_stats){0, 0, 0};
        const fxl_counters counters = draw(whole, i == 0 ? &inside : &across, HEIGHT);
        TEST_ASSERT_TRUE(counters.drawn > 0);
        TEST_ASSERT_EQUAL(i == 0, counts.distances == 0);
    }
}

static uint32_t faces_seen, planes_seen;

static fxl_clip_result note_planes(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    faces_seen++;
    planes_seen |= model_view->planes;
    return fxl_clip_by_view(model_view, face, work, screen);
}

/* The sphere of the tree's object crosses planes, and those of the nodes do not: then their faces
 * need none. Nearer by, some nodes' spheres do. */
void test_faces_need_the_planes_of_their_node(void)
{
    static const fxl_clipper noting = {.clip = note_planes};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (int near_by = 0; near_by < 2; near_by++) {
        const fxl_pose pose = {{0, 0, near_by ? Q16(8) : 0}, 0, 0, 0};
        make();
        tiny->models[1].radius = Q16(20);
        tiny->instances[0].centre = tiny->instances[2].centre = (fxl_point){0, 0, Q16(-100)};
        start(&choice_tree, &lens, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &noting, NULL, 0));
        faces_seen = planes_seen = 0;
        (void)draw(whole, &pose, HEIGHT);
        TEST_ASSERT_TRUE(faces_seen > 0);
        TEST_ASSERT_EQUAL(near_by, planes_seen != 0);
    }
}
