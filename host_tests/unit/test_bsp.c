/* SPDX-License-Identifier: MIT */
/* Drawing by a tree: what hides what, with cubes that move through a cube. */
#include "bsp_scene.h"
#include "choices.h"
#include "clip/clip_by_view.h"
#include "frame_bands.h"
#include "painters.h"

enum {
    WIDTH = BSP_WIDTH,
    HEIGHT = BSP_HEIGHT,
    BACKGROUND = BSP_BACKGROUND,
    WORDS = 40 * FXL_DISPLAY_LIST_WORDS(5),
    WORKSPACE = 512,
    PIECES = 6144
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT], times[WIDTH * HEIGHT];
static uint32_t list[WORDS];
static uint64_t room[WORKSPACE / 8], pieces[PIECES / 8];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static bsp_scene *made;

static fxl_bsp_workspace *bsp_workspace(void)
{
    return renderer.order_memory;
}

static void start_with(uint32_t words, const choice *visibility, uint32_t pieces_size)
{
    fxl_scene_fault fault = {"", 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_scene *scene = &made->tiny->scene;
    const fxl_memory memory = {order, TINY_INSTANCES + 6, words > 0 ? list : NULL, words, NULL, 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check_all(scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, visibility, room, sizeof room));
    if (visibility->order->memory_size != NULL && scene->bsp_nodes != NULL) {
        bsp_workspace()->pieces = pieces_size > 0 ? pieces : NULL;
        bsp_workspace()->pieces_size = pieces_size;
    }
}

static void draw_rows(uint8_t *frame, uint32_t first, uint32_t rows)
{
    frame_draw_band(&renderer, &renderer.workspace, frame, first, rows, BACKGROUND);
}

static void draw(uint8_t *frame, const fxl_pose *pose)
{
    frame_draw_pose(&renderer, pose, frame, HEIGHT, BACKGROUND);
}

static fxl_pose shuffle(void)
{
    made = bsp_make();
    return bsp_shuffle(made);
}

/* Cubes that pass through each other are cut where a third cube's planes are, but two that move
 * are not cut by each other: those are kept apart. */
/* bsp 1.2a, 2.1b, 2.2a, 2.2c-f, 3.1a, 3.1c, 3.2b */
void test_what_a_ray_sees_first_is_seen(void)
{
    const uint32_t rounds = UNIT_REPEAT / 100;
    uint32_t judged = 0, moved = 0, through = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        fxl_pose pose = shuffle();
        made->tiny->instances[2].centre = (fxl_point){Q16(100), 0, Q16(-100)};
        start_with(0, &choice_tree, sizeof pieces);
        draw(whole, &pose);
        TEST_ASSERT_EQUAL_UINT32(0, bsp_workspace()->unsplit);
        TEST_ASSERT_EQUAL_UINT32(0, bsp_workspace()->refused);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            bsp_sight seen = bsp_look(made, &pose, i % WIDTH, i / WIDTH);
            if (seen.margin > 1e-3) {
                TEST_ASSERT_EQUAL_UINT8(seen.colour, whole[i]);
                judged++;
                moved += seen.colour <= 6;
                through += seen.colour >= 11 && seen.colour <= 16;
            }
        }
    }
    TEST_ASSERT_TRUE(judged > rounds * WIDTH * HEIGHT / 2);
    TEST_ASSERT_TRUE(moved > rounds && through > rounds);
}

/* Two cubes that move lie behind the tree's, in one of its leaves, apart from each other: the
 * nearer hides the farther, in pieces or whole. Whole ones that stick out of the leaf may be hidden
 * by the tree's cube. */
/* bsp 3.1, 3.6 */
void test_two_cubes_in_one_leaf(void)
{
    const uint32_t rounds = UNIT_REPEAT / 500;
    uint32_t judged = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        const uint32_t size = round % 4 < 2 ? sizeof pieces : 0;
        fxl_pose pose = shuffle();
        for (uint32_t i = 0; i < TINY_INSTANCES; i += 2) {
            const bool nearer = i == round % 2 * 2;
            const int32_t aside = size > 0 ? Q16(3) : Q16(0.9);
            made->tiny->instances[i].centre =
                (fxl_point){unit_between(-aside, aside), unit_between(-aside, aside),
                            nearer ? Q16(13) : Q16(17)};
        }
        start_with(0, &choice_tree, size);
        draw(whole, &pose);
        TEST_ASSERT_EQUAL_UINT32(size > 0 ? 0 : bsp_workspace()->movers, bsp_workspace()->unsplit);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            bsp_sight seen = bsp_look(made, &pose, i % WIDTH, i / WIDTH);
            const bool of_tree = whole[i] >= 11 && whole[i] <= 16;
            if (seen.margin > 1e-3 && (size > 0 || !of_tree)) {
                TEST_ASSERT_EQUAL_UINT8(seen.colour, whole[i]);
                judged += seen.colour <= 6;
            }
        }
    }
    TEST_ASSERT_TRUE(judged > 5 * rounds);
}

/* Vertices, edges and faces on the planes of the tree: cubes that stand straight, or on an
 * edge, on a grid. A plane then goes through vertices that it does not add. */
void test_cubes_that_touch_the_planes(void)
{
    uint32_t judged = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        fxl_pose pose = shuffle();
        made = bsp_make();
        bsp_tilt(made, 0, 0, round % 4 ? DEGREES(45) : 0);
        TEST_ASSERT_TRUE(round % 4 == 0 || made->tiny->vertices[0].x == 0);
        made->tiny->instances[0].centre =
            (fxl_point){Q16(0.5) * unit_between(-4, 4), Q16(0.5) * unit_between(-4, 4),
                        Q16(10) + Q16(0.5) * unit_between(-4, 4)};
        made->tiny->instances[2].centre = (fxl_point){Q16(100), 0, Q16(-100)};
        start_with(0, &choice_tree, sizeof pieces);
        draw(whole, &pose);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            bsp_sight seen = bsp_look(made, &pose, i % WIDTH, i / WIDTH);
            if (seen.margin > 1e-3) {
                TEST_ASSERT_EQUAL_UINT8(seen.colour, whole[i]);
                judged++;
            }
        }
    }
    TEST_ASSERT_TRUE(judged > UNIT_REPEAT / 100 * WIDTH * HEIGHT / 4);
}

/* --- other orders, other bands ---------------------------------------------- */

void test_any_bands_and_any_list_give_the_same_frame(void)
{
    const uint32_t rounds = UNIT_REPEAT / 100;
    uint32_t spilled = 0, held = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        const uint32_t workspace_size = unit_random() % 4 ? sizeof pieces : unit_random() % 3000;
        fxl_pose pose = shuffle();
        start_with(0, &choice_tree, workspace_size);
        draw(whole, &pose);
        fxl_counters counters = renderer.workspace.counters;
        start_with((uint32_t)unit_between(0, WORDS), &choice_tree, workspace_size);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        for (uint32_t row = 0, rows; row < HEIGHT; row += rows) {
            rows = 1 + unit_random() % (HEIGHT - row);
            draw_rows(other, row, rows);
        }
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        spilled += renderer.workspace.counters.spilled > 0;
        held += renderer.workspace.counters.spilled == 0;
        counters.spilled = renderer.workspace.counters.spilled;
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
    }
    TEST_ASSERT_TRUE(spilled > rounds / 20 && held > rounds / 20);
}

/* bsp 2.3 */
void test_near_to_far_is_the_reverse_of_far_to_near(void)
{
    choice reverse = choice_tree;
    reverse.target = painter_under(BACKGROUND);
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        const uint32_t workspace_size = unit_random() % 4 ? sizeof pieces : unit_random() % 3000;
        fxl_pose pose = shuffle();
        start_with(0, &choice_tree, workspace_size);
        draw(whole, &pose);
        const uint32_t unsplit = bsp_workspace()->unsplit;
        start_with(round % 2 ? WORDS : 0, &reverse, workspace_size);
        draw(other, &pose);
        TEST_ASSERT_EQUAL_UINT32(unsplit, bsp_workspace()->unsplit);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* Cut or not, a pixel of a convex object is drawn once: no gap, and nothing twice. */
/* bsp 1.2, 3.4, 3.5, 3.2b-c, 3.3b */
void test_pieces_leave_no_gap_and_do_not_overlap(void)
{
    choice count_all = choice_tree;
    uint32_t covered = 0, most = 0;
    count_all.target = painter_counting(times, WIDTH, 6); /* colours of objects that move */
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        fxl_pose pose = shuffle();
        made->tiny->instances[2].centre = (fxl_point){Q16(100), 0, Q16(-100)};
        start_with(0, &count_all, 0);
        memset(times, 0, sizeof times);
        draw(other, &pose);
        memcpy(whole, times, sizeof times);
        /* What the list holds is not drawn again with the rest. */
        start_with((uint32_t)unit_between(0, WORDS / 4), &count_all, sizeof pieces);
        memset(times, 0, sizeof times);
        draw(other, &pose);
        most = bsp_workspace()->used > most ? bsp_workspace()->used : most;
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            TEST_ASSERT_TRUE(times[i] <= 1 && whole[i] <= 1);
            /* At its outline a vertex that was rounded may take or give a pixel. */
            if (times[i] != whole[i]) {
                made->tiny->instances[1].centre = (fxl_point){Q16(100), 0, Q16(-100)};
                TEST_ASSERT_TRUE(bsp_look(made, &pose, i % WIDTH, i / WIDTH).margin < 1e-4);
                made->tiny->instances[1].centre = (fxl_point){0, 0, Q16(10)};
            }
            covered += times[i];
        }
    }
    TEST_ASSERT_TRUE(covered > UNIT_REPEAT / 100);
    TEST_ASSERT_TRUE(most > 20 * sizeof(fxl_point)); /* it was cut */
}

/* --- room -------------------------------------------------------------------- */

/* Byte by byte more: nothing is written behind it, and what has no room is counted and whole. */
/* bsp 3.7a, 3.7c */
void test_any_room_for_pieces(void)
{
    uint32_t last = 2;
    fxl_pose pose = {{Q16(-3), Q16(2), Q16(5)}, DEGREES(30), DEGREES(-18), 0};
    made = bsp_make();
    bsp_tilt(made, unit_random(), unit_random(), unit_random());
    made->tiny->instances[0].centre = (fxl_point){Q16(0.75), Q16(0.5), Q16(9.5)};
    made->tiny->instances[2].centre = (fxl_point){Q16(-0.5), Q16(-0.75), Q16(10.25)};
    start_with(0, &choice_tree, sizeof pieces);
    draw(whole, &pose);
    const uint32_t used = bsp_workspace()->used;
    TEST_ASSERT_TRUE(used > 0 && used <= sizeof pieces);
    for (uint32_t bytes = 0; bytes <= used + 8; bytes += 1 + bytes % 7) {
        memset(pieces, 0xA5, sizeof pieces);
        start_with(0, &choice_tree, bytes);
        draw(other, &pose);
        TEST_ASSERT_TRUE(bsp_workspace()->unsplit <= last);
        last = bsp_workspace()->unsplit;
        TEST_ASSERT_TRUE(bsp_workspace()->used <= bytes);
        TEST_ASSERT_TRUE(last > 0 || memcmp(whole, other, sizeof whole) == 0);
        for (uint32_t i = (bytes + 3) / 4 * 4; i < sizeof pieces; i++) {
            TEST_ASSERT_EQUAL_UINT8(0xA5, ((uint8_t *)pieces)[i]);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, last);
    for (uint32_t less = 0; less < 2; less++) { /* what was used is the least that will do */
        start_with(0, &choice_tree, used - less);
        draw(other, &pose);
        TEST_ASSERT_EQUAL(less, bsp_workspace()->unsplit > 0);
    }
    start_with(0, &choice_tree, 0);
    draw(other, &pose);
    TEST_ASSERT_EQUAL_UINT32(2, bsp_workspace()->unsplit);
}

void test_room_for_the_walk(void)
{
    made = bsp_make();
    start_with(0, &choice_tree, 0);
    const uint32_t needed = choice_tree.order->memory_size(&made->tiny->scene);
    TEST_ASSERT_EQUAL_UINT32(sizeof(fxl_bsp_workspace) + 8 + 4 * BSP_NODES + 2 * 12, needed);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, choice_take(&renderer, &choice_tree, room, needed - 1));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, choice_take(&renderer, &choice_tree, NULL, needed));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, room, needed));
    made->tiny->instances[0].layer = made->tiny->instances[2].layer = 1; /* nothing moves */
    TEST_ASSERT_EQUAL_UINT32(sizeof(fxl_bsp_workspace) + 4,
                             choice_tree.order->memory_size(&made->tiny->scene));
    made->tiny->scene.bsp_nodes = NULL;
    TEST_ASSERT_EQUAL_UINT32(0, choice_tree.order->memory_size(&made->tiny->scene));
}

/* --- counting, and scenes of another kind ------------------------------------- */

/* bsp 4.2 */
void test_counters_are_those_of_any_method(void)
{
    uint32_t drawn = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        fxl_pose pose = shuffle();
        pose.yaw += round % 3 == 0 ? (fxl_angle)unit_random() : 0;
        start_with(0, &choice_sorted, 0);
        draw(other, &pose);
        fxl_counters counters = renderer.workspace.counters;
        start_with(0, &choice_tree, round % 2 ? sizeof pieces : 0);
        draw(whole, &pose);
        TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
        counters.spilled = renderer.workspace.counters.spilled; /* each piece by itself */
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        drawn += counters.drawn;
    }
    TEST_ASSERT_TRUE(drawn > UNIT_REPEAT / 100);
}

/* The result that a face's second polygon has in the test below. */
static fxl_clip_result second;

static fxl_clip_result end_with_second(const fxl_model_view *model_view, fxl_clipper_work *work,
                                       fxl_screen_polygon *screen)
{
    (void)model_view;
    (void)work;
    (void)screen;
    return second;
}

/* A face whose second polygon is refused is refused; one that has none is drawn. Each is counted
 * once, as by any method, whether it is cut into pieces or not. */
/* bsp 4.2 */
void test_a_face_whose_second_polygon_is_refused(void)
{
    static const fxl_clipper clipper = {.clip = fxl_clip_by_view, .next = end_with_second};
    static const fxl_clip_result ends[] = {FXL_CLIP_OUTSIDE, FXL_CLIP_DEGENERATE, FXL_CLIP_CAPACITY,
                                           FXL_CLIP_RANGE};
    uint32_t refused = 0, drawn = 0, pieces_refused = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 200; round++) {
        const uint32_t size = round % 8 < 4 ? sizeof pieces : 0;
        fxl_pose pose = shuffle();
        second = ends[round % 4];
        start_with(0, &choice_sorted, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &clipper, NULL, 0));
        draw(other, &pose);
        fxl_counters counters = renderer.workspace.counters;
        start_with(0, &choice_tree, size);
        draw(whole, &pose);
        start_with(0, &choice_tree, size);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &clipper, NULL, 0));
        draw(other, &pose);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        counters.spilled = renderer.workspace.counters.spilled; /* each piece by itself */
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        if (size == 0 || round % 4 < 2) { /* pieces alone are counted here */
            TEST_ASSERT_EQUAL_UINT32(0, bsp_workspace()->refused);
        }
        pieces_refused += bsp_workspace()->refused;
        refused += counters.refused;
        drawn += counters.drawn;
    }
    TEST_ASSERT_TRUE(refused > UNIT_REPEAT / 200 && drawn > UNIT_REPEAT / 200);
    TEST_ASSERT_TRUE(pieces_refused > UNIT_REPEAT / 200);
}

/* bsp 2.1c */
void test_without_a_tree_it_is_drawn_by_distance(void)
{
    fxl_pose pose = shuffle();
    for (uint32_t i = 0; i < 20; i++, pose = shuffle()) {
        start_with(0, &choice_sorted, 0);
        draw(whole, &pose);
        made->tiny->scene.bsp_nodes = NULL;
        made->tiny->scene.bsp_node_count = made->tiny->scene.bsp_instance = 0;
        start_with(0, &choice_tree, 0);
        draw(other, &pose);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* The tree's object behind the eye, one that moves before it; and layers below and above. */
/* bsp 2.1a, 2.1c */
void test_other_layers_and_a_tree_out_of_sight(void)
{
    const fxl_pose pose = {{0, 0, Q16(14)}, 0, 0, 0};
    made = bsp_make();
    made->tiny->instances[0].centre = (fxl_point){0, 0, Q16(18)};
    made->tiny->instances[2].centre = (fxl_point){0, 0, Q16(24)};
    made->tiny->instances[2].layer = 1; /* over the nearer one */
    start_with(0, &choice_tree, sizeof pieces);
    draw(whole, &pose);
    TEST_ASSERT_EQUAL_UINT8(5, whole[WIDTH * HEIGHT / 2 + WIDTH / 2]);
    TEST_ASSERT_EQUAL_UINT32(18, renderer.workspace.counters.in);
    TEST_ASSERT_EQUAL_UINT32(2, renderer.workspace.counters.drawn);
    made->tiny->instances[2].centre.z = Q16(17); /* now nearer, and under */
    made->tiny->instances[2].layer = 0;
    made->tiny->instances[0].layer = 2;
    made->tiny->instances[0].centre.x = Q16(0.5);
    start_with(0, &choice_tree, sizeof pieces);
    draw(whole, &pose);
    TEST_ASSERT_EQUAL_UINT32(2, renderer.workspace.counters.drawn);
}
