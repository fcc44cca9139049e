/* SPDX-License-Identifier: MIT */
/* What changed from one frame to the next: a picture that is built up from the boxes alone equals
 * the frame drawn whole. docs/extras/changed.md. */
#include "changed_unit.h"

#ifndef CHANGED_STEPS
#define CHANGED_STEPS (UNIT_REPEAT / 100) /* of all episodes; a campaign has more */
#endif

enum {
    STEPS = 25,       /* of an episode */
    NEAR_WIDTH = 768, /* of the second test: a long focal length */
    NEAR_HEIGHT = 4
};

static uint16_t whole[CHANGED_HEIGHT * CHANGED_WIDTH], built[CHANGED_HEIGHT * CHANGED_WIDTH];
static uint64_t core_room[1024];
static fxl_workspace core;
static bool has_overlay;
static fxl_screen_box overlay;

/* --- a step --------------------------------------------------------------------------------- */

/* What the changed_renderer itself answers the whole frame for. */
static void change_frame(void)
{
    switch (unit_between(0, 3)) {
    case 0:
        changed_eye = changed_random_eye();
        break;
    case 1:
        changed_renderer.frame.background ^= 3;
        break;
    default:
        changed_attach((uint32_t)unit_between(0, CHANGED_THINGS - 1), unit_between(0, 1) != 0);
    }
}

static fxl_band band_of(uint16_t *pixels, const fxl_screen_box *box)
{
    const uint16_t width = changed_renderer.frame.view.lens.width;
    const size_t first = (size_t)box->first_row * width + box->first_column;
    const bool wide = changed_into->target->pixel_bits == 16;
    return (fxl_band){.pixels = wide ? (uint8_t *)&pixels[first] : (uint8_t *)pixels + first,
                      .width = width,
                      .stride = width,
                      .first_row = box->first_row,
                      .rows = box->rows,
                      .palette = wide ? changed_colours : NULL,
                      .first_column = box->first_column,
                      .columns = box->columns};
}

/* By the changed_renderer, or by another core. */
static void draw_box(uint16_t *pixels, const fxl_screen_box *box, bool by_core)
{
    const fxl_band band = band_of(pixels, box);
    fxl_frame_fill(&changed_renderer, &band, changed_renderer.frame.background);
    TEST_ASSERT_EQUAL(FXL_OK, by_core ? fxl_frame_draw_with(&changed_renderer, &core, &band)
                                      : fxl_frame_draw(&changed_renderer, &band));
    if (has_overlay) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_draw_rectangle(&band, overlay.first_column, overlay.first_row,
                                                     overlay.columns, overlay.rows, 33));
    }
}

/* An overlay that comes, moves or goes, and pixels of a sprite that are rewritten. */
static void change_others(bool rewrites)
{
    if (rewrites) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add_model(&changed, &changed_renderer, 2));
    }
    if (unit_between(0, 7) == 0) {
        if (has_overlay) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add(&changed, &overlay));
        }
        has_overlay = !has_overlay;
        overlay =
            (fxl_screen_box){(uint16_t)unit_between(0, 30), 7, (uint16_t)unit_between(0, 30), 5};
        if (has_overlay) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add(&changed, &overlay));
        }
    }
}

static void expect_same_picture(void)
{
    const fxl_screen_box all = {0, CHANGED_WIDTH, 0, CHANGED_HEIGHT};
    const bool two =
        unit_between(0, 3) == 0 && fxl_workspace_size(&changed_renderer) <= sizeof core_room;
    if (two) {
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_workspace_init(&core, &changed_renderer, core_room, sizeof core_room));
    }
    draw_box(whole, &all, false);
    TEST_ASSERT_LESS_OR_EQUAL(FXL_CHANGED_BOXES_MAX, changed.count);
    for (uint32_t i = 0; i < changed.count; i++) {
        draw_box(built, &changed.boxes[i], two && i % 2 != 0);
    }
    TEST_ASSERT_EQUAL_MEMORY(whole, built,
                             CHANGED_WIDTH * CHANGED_HEIGHT *
                                 (changed_into->target->pixel_bits == 16 ? 2u : 1u));
}

static uint64_t sent;
static uint32_t wholes;

static void step(void)
{
    static const uint8_t steps[] = {0, 1, 2, 4, 8};
    const bool rewrites = unit_between(0, 9) == 0;
    for (int32_t i = unit_between(0, 2); i > 0; i--) {
        changed_change_world();
    }
    if (unit_between(0, 3) == 0) {
        changed_change_billboards();
    }
    if (rewrites) {
        changed_sprite_pixels[unit_between(0, 1)][unit_between(0, 19)] ^= 5;
    }
    if (unit_between(0, 19) == 0) {
        change_frame();
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
    change_others(rewrites);
    if (unit_between(0, 2) == 0) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_widen(&changed, steps[unit_between(0, 4)],
                                                    steps[unit_between(1, 4)]));
    }
    expect_same_picture();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    wholes += changed.whole;
    for (uint32_t i = 0; i < changed.count; i++) {
        sent += (uint64_t)changed.boxes[i].columns * changed.boxes[i].rows;
    }
}

/* changed 1.1a-c, 1.2a-c, 1.3a-c, 1.4a-b, 1.5a, 2.1a-b, 2.1g, 2.3a-b, 3.2a-b */
void test_the_boxes_hold_every_pixel_that_changed(void)
{
    uint32_t steps = 0;
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    while (steps < CHANGED_STEPS) {
        changed_start(&lens);
        has_overlay = false;
        for (uint32_t i = 0; i < STEPS; i++, steps++) {
            step();
        }
    }
    TEST_ASSERT_LESS_THAN(steps / 2, wholes);
    TEST_ASSERT_LESS_THAN(
        60, (uint32_t)(sent * 100 / ((uint64_t)steps * CHANGED_WIDTH * CHANGED_HEIGHT)));
}

/* --- one instance, by any lens ----------------------------------------------------------------- */

/* A small upright cube near the changed_eye, split by a beam: its points are rounded in the world. Its upright
 * edges cross the few rows of the screen. */
static void place_near_cube(fxl_point *at)
{
    const fxl_instance cube = {*at, 0, 0, 0};
    fxl_placement placement = {.scale = unit_between(FXL_SCALE_MIN, 2 * FXL_SCALE_MIN)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles((fxl_angle)unit_random(), 0, 0,
                                                          &placement.orientation));
    while (changed_world.scene.instance_count > 0) {
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_world_remove(&changed_world, fxl_world_handle_at(&changed_world, 0)));
    }
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_world_spawn(&changed_world, &cube, &placement, &changed_handles[0]));
}

static void start_near(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(NEAR_WIDTH, NEAR_HEIGHT, DEGREES(10) + 1,
                                                FXL_NEAR_MIN, Q16(9), 0, &lens));
    changed_start_plain(&changed_palette, &lens, false, 0);
    changed_attach(CHANGED_BEAMS, true);
    changed_renderer.frame.background = 0;
    has_overlay = false;
}

/* Counts the pixels that show something, each of which must be in the one box. */
static uint32_t count_shown(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < NEAR_WIDTH * NEAR_HEIGHT; i++) {
        const uint32_t x = i % NEAR_WIDTH - changed.boxes[0].first_column;
        const uint32_t y = i / NEAR_WIDTH - changed.boxes[0].first_row;
        if (((const uint8_t *)whole)[i] != 0) {
            TEST_ASSERT_TRUE(changed.count == 1 && x < changed.boxes[0].columns &&
                             y < changed.boxes[0].rows);
            count++;
        }
    }
    return count;
}

/* changed 2.1e-f */
void test_a_box_holds_points_that_are_rounded_in_the_world(void)
{
    const fxl_screen_box all = {0, NEAR_WIDTH, 0, NEAR_HEIGHT};
    uint32_t shown = 0, parts = 0;
    start_near();
    for (uint32_t i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_point at = {unit_between(-600, 600), unit_between(-300, 300), unit_between(500, 20000)};
        changed_eye = (fxl_pose){{0, 0, 0}, (fxl_angle)unit_random(), 0, 0};
        const fxl_q2_30 sine = fxl_sin(changed_eye.yaw), cosine = fxl_cos(changed_eye.yaw);
        at = (fxl_point){(fxl_q16_16)(((int64_t)at.z * sine + (int64_t)at.x * cosine) >> 30), at.y,
                         (fxl_q16_16)(((int64_t)at.z * cosine - (int64_t)at.x * sine) >> 30)};
        place_near_cube(&at);
        for (uint32_t twice = 0; twice < 2; twice++) { /* the second has the same changed_eye */
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
            if (twice == 0) {
                TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
            }
        }
        TEST_ASSERT_EQUAL(0, changed.count);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add_model(&changed, &changed_renderer, 0));
        draw_box(whole, &all, false);
        shown += count_shown() > 0;
        parts += changed.count == 1 && changed.boxes[0].columns < NEAR_WIDTH;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 200, shown);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 400, parts);
}

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

/* changed 2.2a */
void test_an_orthographic_lens_builds_the_same_picture(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_orthographic(CHANGED_WIDTH, CHANGED_HEIGHT, Q16(3),
                                                    Q16(0.25), Q16(60), &lens));
    has_overlay = false;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200; i++) {
        if (i % 8 == 0) {
            changed_start_plain(&changed_targets[i / 8 % CHANGED_TARGETS], &lens, false, 0);
            changed_attach(0, i / 48 % 2 == 0); /* surfaces */
            changed_attach(3, true);            /* billboards */
            changed_eye = changed_random_eye();
        }
        changed_change_world();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
        expect_same_picture();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    }
}

/* Lines reach beyond the vertices by half of their width. */
/* changed 2.1h */
void test_a_box_holds_lines_over_a_model(void)
{
    static const fxl_line lines[] = {
        {0, 7, {0, 0}, 9, 16, 0}, {1, 1, {0, 0}, 10, 13, 0}, {2, 4, {5, 2}, 11, 3, 0}};
    static const uint32_t line_map[CHANGED_MODELS + 1] = {0, 3, 3, 3};
    static const fxl_line_set set = {lines, 3, line_map};
    static fxl_lines attached;
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    has_overlay = false;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200; i++) {
        if (i % 8 == 0) {
            changed_start_plain(&changed_targets[i / 8 % CHANGED_TARGETS], &lens, false, 0);
            changed_attach(0, i / 48 % 2 == 0); /* surfaces */
            changed_attach(3, i / 48 % 2 == 0); /* billboards */
            TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&changed_renderer, &attached, &set));
            changed_eye = changed_random_eye();
        }
        changed_change_world();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
        expect_same_picture();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    }
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
