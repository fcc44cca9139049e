/* SPDX-License-Identifier: MIT */
/* What is compared from one frame to the next, and how boxes are joined. docs/extras/changed.md. */
#include "changed_unit.h"

/* --- boxes -------------------------------------------------------------------------------------- */

/* changed 2.2a */
void test_a_clipper_of_another_rounding_has_the_whole_screen(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    fxl_clipper other = fxl_clipper_view;
    const fxl_point near_by = {Q16(1), 0, 0};
    for (uint32_t is_other = 0; is_other < 2; is_other++) {
        changed_start_plain(&changed_palette, &lens, false, 0);
        changed_eye = (fxl_pose){{0, 0, -Q16(6)}, 0, 0, 0};
        if (is_other) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&changed_renderer, &other, NULL, 0));
        }
        for (uint32_t i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
            (void)fxl_world_move(&changed_world, changed_handles[0], &near_by);
        }
        TEST_ASSERT_EQUAL(1, changed.count);
        TEST_ASSERT_EQUAL(is_other, changed.whole);
    }
}

/* A cube that is partly behind the eye has a box of its own, unless its vertices are too far beside. */
/* changed 2.4b */
void test_which_cubes_have_the_whole_screen_with_an_orthographic_lens(void)
{
    const fxl_point near_by = {256, 0, 0};
    for (uint32_t is_large = 0; is_large < 2; is_large++) {
        fxl_lens lens;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_orthographic(CHANGED_WIDTH, CHANGED_HEIGHT,
                                                is_large ? FXL_ORTHOGRAPHIC_SCALE_MAX : Q16(4),
                                                Q16(0.25), Q16(60), &lens));
        changed_start_plain(&changed_palette, &lens, false, 0);
        changed_eye = (fxl_pose){{0, 0, 0}, 0, 0, 0};
        for (uint32_t i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&changed_world, changed_handles[0], &near_by));
        }
        TEST_ASSERT_EQUAL(1, changed.count);
        TEST_ASSERT_EQUAL(is_large, changed.boxes[0].columns == CHANGED_WIDTH &&
                                        changed.boxes[0].rows == CHANGED_HEIGHT);
    }
}

/* The columns of the sorted cube at a depth from the eye, as if the scene had so many nodes. */
static uint32_t columns_of_cube(fxl_q16_16 depth, uint32_t nodes)
{
    const uint32_t real = changed_world.scene.bsp_node_count;
    changed_eye = (fxl_pose){changed_world.scene.instances[1].centre, 0, 0, 0};
    changed_eye.position.z -= Q16(1) + depth;
    for (uint32_t twice = 0; twice < 2; twice++) { /* nothing changed for the second */
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    }
    TEST_ASSERT_EQUAL(0, changed.count);
    changed_world.scene.bsp_node_count = nodes;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add_model(&changed, &changed_renderer, 1));
    changed_world.scene.bsp_node_count = real;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    return changed.boxes[0].columns;
}

/* Of more nodes of a tree than an instance passes, those that it passes count. */
/* changed 2.1e */
void test_a_tree_of_any_size_has_a_margin(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    changed_start_plain(&changed_palette, &lens, true, 4096);
    const uint32_t most = columns_of_cube(Q16(1.25), FXL_BSP_DEPTH_MAX);
    TEST_ASSERT_LESS_THAN(most, columns_of_cube(Q16(1.25), 6));
    TEST_ASSERT_EQUAL(most, columns_of_cube(Q16(1.25), 60000));
    TEST_ASSERT_EQUAL(CHANGED_WIDTH,
                      columns_of_cube(2000, FXL_BSP_DEPTH_MAX)); /* nearer than 2 K units */
}

/* changed 3.1a-b */
void test_four_boxes_are_joined_where_they_grow_least(void)
{
    static const fxl_screen_box added[] = {
        {0, 4, 0, 4}, {40, 4, 0, 4}, {0, 4, 30, 4}, {40, 4, 30, 4}, {6, 2, 0, 4}};
    static const fxl_screen_box apart = {20, 4, 16, 2};
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    changed_start_plain(&changed_palette, &lens, false, 0);
    for (uint32_t i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    }
    for (uint32_t i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL(i, changed.count);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add(&changed, &added[i]));
    }
    TEST_ASSERT_EQUAL(4, changed.count); /* the last one to the first: 8 columns of 4 rows */
    TEST_ASSERT_TRUE(changed.boxes[0].first_column == 0 && changed.boxes[0].columns == 8 &&
                     changed.boxes[0].rows == 4);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add(&changed, &added[1]));
    TEST_ASSERT_EQUAL(4, changed.count); /* it was there */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add(&changed, &apart));
    TEST_ASSERT_EQUAL(4, changed.count); /* two are joined, and it takes the place of one */
    TEST_ASSERT_EQUAL(34, changed.boxes[1].rows);
    TEST_ASSERT_EQUAL_MEMORY(&apart, &changed.boxes[3], sizeof apart);
}

/* --- what is compared --------------------------------------------------------------------------- */

static void find_next(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
}

/* A frame that has begun as another one than the frame before did. */
static void expect_whole(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    TEST_ASSERT_TRUE(changed.whole);
}

/* changed 1.3a */
void test_each_part_of_the_frame_before_is_compared(void)
{
#define PART(member) offsetof(fxl_changed, member)
    static const size_t parts[] = {PART(scene),
                                   PART(frame),
                                   PART(settings_number),
                                   PART(set),
                                   PART(billboards),
                                   PART(models),
                                   PART(background),
                                   PART(lens.width),
                                   PART(lens.height),
                                   PART(lens.focal),
                                   PART(lens.near_z),
                                   PART(lens.far_z),
                                   PART(lens.inset),
                                   PART(lens.centre_x),
                                   PART(lens.centre_y),
                                   PART(lens.off_centre),
                                   PART(camera.axes.right.y),
                                   PART(camera.axes.right.z),
                                   PART(camera.axes.up.x),
                                   PART(camera.axes.forward.x),
                                   PART(camera.position.y)};
#undef PART
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    changed_start_plain(&changed_palette, &lens, false, 0);
    changed_attach(3, true); /* billboards */
    for (uint32_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        find_next();
        find_next();
        TEST_ASSERT_EQUAL(0, changed.count);
        ((uint8_t *)&changed)[parts[i]] ^= 1;
        find_next();
        TEST_ASSERT_TRUE_MESSAGE(changed.whole, "a part that no one compares");
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
    changed.frame = UINT32_MAX; /* the frames have been counted round */
    changed_renderer.frame.view.frame = 0;
    expect_whole();
    changed.settings_number = changed_renderer.workspace.settings_number = UINT32_MAX;
    changed_renderer.frame.view.frame = changed.frame + 1;
    expect_whole();
}

/* The same record again counts as another one, and so does none. Where two do not go together none of them
 * is attached. */
/* changed 1.3b */
void test_what_is_attached_or_detached_changes_the_whole_frame(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    for (uint32_t i = 0; i < 2 * CHANGED_THINGS; i++) {
        changed_start_plain(&changed_targets[i / CHANGED_THINGS], &lens, false, 0);
        for (uint32_t way = 0; way < 4; way++) { /* neither, attached, again, detached */
            if (way > 0) {
                changed_attach(i % CHANGED_THINGS, way < 3);
            }
            find_next();
            TEST_ASSERT_TRUE(changed.whole);
            find_next();
            TEST_ASSERT_EQUAL(0, changed.count);
        }
    }
}

/* changed 1.3a */
void test_another_scale_of_an_orthographic_lens_changes_the_whole_frame(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    changed_start_plain(&changed_palette, &lens, false, 0);
    for (int32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&changed_renderer, Q16(3) + i));
        find_next();
        TEST_ASSERT_TRUE(changed.whole);
        find_next();
        TEST_ASSERT_EQUAL(0, changed.count);
    }
}

static void change_billboard(uint32_t part)
{
    static fxl_sprite same;
    fxl_billboard *board = &changed_boards[0];
    fxl_sprite *sprite = &changed_sprites[0];
    switch (part) {
    case 0:
        board->height = Q16(2);
        break;
    case 1:
        board->anchor_x = Q16(0.5);
        break;
    case 2:
        board->anchor_y = Q16(0.5);
        break;
    case 3:
        sprite->colours = changed_sprite_pixels[1];
        break;
    case 4:
        sprite->width = 4;
        break;
    case 5:
        sprite->height = 3;
        break;
    case 6:
        sprite->bits = 4;
        break;
    case 7:
        sprite->key = 3;
        break;
    default:
        same = *sprite;
        board->sprite = &same;
    }
}

/* changed 1.2a-b */
void test_each_part_of_a_thing_is_compared(void)
{
    const fxl_point near_by = {Q16(1), 0, 0};
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    fxl_placement placement = {
        {{FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, {0, 0, FXL_Q2_30_ONE}}, FXL_Q16_16_ONE};
    fxl_q2_30 *const turns[] = {&placement.orientation.x.x, &placement.orientation.y.y,
                                &placement.orientation.z.z};
    changed_start_plain(&changed_palette, &lens, false, 0);
    changed_attach(3, true); /* billboards */
    changed_eye = (fxl_pose){{0, 0, -Q16(6)}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_model(&changed_world, changed_handles[0], 2));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_move(&changed_world, changed_handles[0], &near_by));
    find_next();
    for (uint32_t part = 0; part < 9; part++) {
        change_billboard(part);
        find_next();
        TEST_ASSERT_EQUAL(1, changed.count);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_world_set_model(&changed_world, changed_handles[0], 0));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_world_set_placement(&changed_world, changed_handles[0], &placement));
    find_next();
    find_next();
    TEST_ASSERT_EQUAL(0, changed.count);
    for (uint32_t row = 0; row < 3; row++) {
        *turns[row] -= 1;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_world_set_placement(&changed_world, changed_handles[0], &placement));
        find_next();
        TEST_ASSERT_EQUAL(1, changed.count);
    }
}
