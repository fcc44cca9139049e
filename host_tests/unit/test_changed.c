/* SPDX-License-Identifier: MIT */
/* What changed from one frame to the next: a picture that is built up from the boxes alone equals
 * the frame drawn whole. docs/extras/changed.md. */
#include "changed_unit.h"

#if !defined UNIT_ON_TARGET
#include <stdlib.h>
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

/* By the changed_renderer, or by another core. */
static void draw_box(uint16_t *pixels, const fxl_screen_box *box, bool by_core)
{
    const fxl_band band = changed_draw(pixels, box, by_core ? &core : NULL);
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

static uint32_t pixels_of_boxes(void)
{
    uint32_t pixels = 0;
    for (uint32_t i = 0; i < changed.count; i++) {
        pixels += (uint32_t)changed.boxes[i].columns * changed.boxes[i].rows;
    }
    return pixels;
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
    sent += pixels_of_boxes();
}

static fxl_lens orthographic_lens(fxl_q16_16 scale)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_orthographic(CHANGED_WIDTH, CHANGED_HEIGHT, scale, Q16(0.25),
                                                    Q16(60), &lens));
    return lens;
}

/* Of all episodes. On the host the environment may ask for more, of another seed (tools/fixel/check/changed.py). */
static uint32_t wanted_steps(void)
{
#if !defined UNIT_ON_TARGET
    const char *steps = getenv("FIXEL_CHANGED_STEPS"), *seed = getenv("FIXEL_CHANGED_SEED");
    if (steps != NULL && seed != NULL) {
        unit_seed((uint32_t)strtoul(seed, NULL, 10));
        return (uint32_t)strtoul(steps, NULL, 10);
    }
#endif
    return UNIT_REPEAT / 100;
}

/* With an eye, off-centre or orthographic. */
static fxl_lens any_lens(void)
{
    fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    switch (unit_between(0, 3)) {
    case 0:
        return orthographic_lens(unit_between(Q16(1), Q16(6)));
    case 1:
        lens.inset = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, unit_between(0, Q16(CHANGED_WIDTH)),
                                                      unit_between(0, Q16(CHANGED_HEIGHT))));
        break;
    default:
        break;
    }
    return lens;
}

/* changed 1.1a-c, 1.2a-c, 1.3a-c, 1.4a-b, 1.5a, 2.1a-b, 2.1g, 2.3a-b, 2.4a, 3.2a-b */
void test_the_boxes_hold_every_pixel_that_changed(void)
{
    uint32_t steps = 0;
    const uint32_t wanted = wanted_steps();
    while (steps < wanted) {
        const fxl_lens lens = any_lens();
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
static void place_near_cube(const fxl_point *at, fxl_q16_16 scale, fxl_angle yaw)
{
    const fxl_instance cube = {*at, 0, 0, 0};
    fxl_placement placement = {.scale = scale};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(yaw, 0, 0, &placement.orientation));
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
        place_near_cube(&at, unit_between(FXL_SCALE_MIN, 2 * FXL_SCALE_MIN),
                        (fxl_angle)unit_random());
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

/* A cube whose margin is as large as the screen: it is near, and the scene has a large tree. */
/* changed 2.1e */
void test_a_margin_may_be_larger_than_the_screen(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(FXL_SCREEN_MAX, NEAR_HEIGHT, DEGREES(10) + 1,
                                                FXL_NEAR_MIN, Q16(9), 0, &lens));
    changed_start_plain(&changed_palette, &lens, false, 0);
    changed_eye = (fxl_pose){{0, 0, 0}, 0, 0, 0};
    for (uint32_t is_near = 0; is_near < 2; is_near++) {
        const fxl_point at = {0, 0, is_near ? 3000 : 20000};
        place_near_cube(&at, FXL_SCALE_MIN, 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
        changed.count = 0;
        changed_world.scene.bsp_node_count = FXL_BSP_DEPTH_MAX;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_add_model(&changed, &changed_renderer, 0));
        changed_world.scene.bsp_node_count = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
        TEST_ASSERT_EQUAL(1, changed.count);
        TEST_ASSERT_EQUAL(is_near, changed.boxes[0].columns == FXL_SCREEN_MAX);
    }
}

/* --- worlds that are followed by some lens, with some things attached --------------------------- */

/* Steps of worlds in which the eye stands. attach: after each start. Answers the pixels of all boxes but
 * those of whole frames, a frame on average, in per cent. */
static uint32_t follow(const fxl_lens *lens, void (*attach)(uint32_t episode))
{
    uint32_t frames = 0;
    uint64_t pixels = 0;
    has_overlay = false;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200; i++) {
        if (i % 8 == 0) {
            changed_start_plain(&changed_targets[i / 8 % CHANGED_TARGETS], lens, false, 0);
            attach(i / 8);
            changed_eye = changed_random_eye();
        }
        changed_change_world();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
        expect_same_picture();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
        frames += !changed.whole;
        pixels += changed.whole ? 0 : pixels_of_boxes();
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 750, frames);
    return (uint32_t)(pixels * 100 / ((uint64_t)frames * CHANGED_WIDTH * CHANGED_HEIGHT));
}

static void attach_some(uint32_t episode)
{
    const uint32_t round = episode / CHANGED_TARGETS;
    changed_attach(0, round % 2 == 0);             /* surfaces */
    changed_attach(CHANGED_BEAMS, round % 2 != 0); /* which round points in the world */
    changed_attach(3, true);                       /* billboards */
}

/* changed 2.2a, 2.4a */
void test_an_orthographic_lens_builds_the_same_picture(void)
{
    const fxl_lens near_by = orthographic_lens(Q16(3)), large = orthographic_lens(Q16(700));
    TEST_ASSERT_LESS_THAN(40, follow(&near_by, attach_some));
    (void)follow(&large, attach_some);
}

/* A cube comes to the tree's and goes, so that there is memory for the pieces of another one or not. */
/* changed 1.5a */
void test_what_shares_the_memory_for_pieces_changes_with_it(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    const fxl_point away = {Q16(300), 0, 0};
    has_overlay = false;
    for (uint32_t i = 0; i < UNIT_REPEAT / 200; i++) {
        if (i % 8 == 0) {
            changed_start_plain(&changed_palette, &lens, true, 640 + i / 8 % 64 * 32);
            changed_eye = changed_random_eye();
        }
        const fxl_point *tree =
            &changed_world.scene.instances[changed_world.scene.bsp_instance].centre;
        for (uint32_t cube = 0; cube <= 2; cube += 2) {
            const fxl_point near_by = {tree->x + unit_between(-Q16(1.5), Q16(1.5)),
                                       tree->y + unit_between(-Q16(1.5), Q16(1.5)),
                                       tree->z + unit_between(-Q16(1.5), Q16(1.5))};
            if (cube == 0 || i % 8 == 0) {
                TEST_ASSERT_EQUAL(FXL_OK,
                                  fxl_world_move(&changed_world, changed_handles[cube],
                                                 cube == 0 && i % 2 != 0 ? &away : &near_by));
            }
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&changed_renderer, &changed_eye));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_changed_find(&changed, &changed_renderer));
        expect_same_picture();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_end(&changed_renderer));
    }
}

static void attach_lines(uint32_t episode)
{
    changed_attach(0, episode / CHANGED_TARGETS % 2 == 0); /* surfaces */
    changed_attach(3, episode / CHANGED_TARGETS % 2 == 0); /* billboards */
    changed_attach(CHANGED_LINES, true);
}

/* Lines reach beyond the vertices by half of their width. */
/* changed 2.1h */
void test_a_box_holds_lines_over_a_model(void)
{
    const fxl_lens lens = unit_lens(CHANGED_WIDTH, CHANGED_HEIGHT);
    TEST_ASSERT_LESS_THAN(100, follow(&lens, attach_lines));
}
