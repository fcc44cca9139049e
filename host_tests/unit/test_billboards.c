/* SPDX-License-Identifier: MIT */
/* Billboards, against their definition in double (docs/extras/billboards.md). */
#include <math.h>

#include "frame_bands.h"
#include "tiny_frames.h"

enum {
    BACKGROUND = 250
};

static board_scene scene;
static uint8_t whole[BOARD_SCENE_HEIGHT][BOARD_SCENE_WIDTH];
static uint8_t other[BOARD_SCENE_HEIGHT][BOARD_SCENE_WIDTH];
static fxl_workspace second;
static fxl_placement placements[1];

void setUp(void)
{
    board_scene_make(&scene);
}

static void draw(uint8_t frame[BOARD_SCENE_HEIGHT][BOARD_SCENE_WIDTH], uint16_t step,
                 fxl_workspace *by)
{
    for (uint16_t row = 0; row < BOARD_SCENE_HEIGHT; row = (uint16_t)(row + step)) {
        frame_draw_band(&scene.renderer, by, frame[0], row, step, BACKGROUND);
    }
}

static void draw_frame(const fxl_pose *pose, uint32_t words)
{
    board_scene_start(&scene, words);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&scene.renderer, pose));
    draw(whole, BOARD_SCENE_HEIGHT, &scene.renderer.workspace);
}

static fxl_pose ahead(fxl_q16_16 z)
{
    const fxl_pose pose = {{0, 0, z}, 0, 0, 0};
    return pose;
}

static fxl_pose any_pose(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(8));
    pose.yaw = DEGREES(1) * (fxl_angle)unit_between(-60, 60);
    pose.pitch = DEGREES(1) * (fxl_angle)unit_between(-30, 30);
    return pose;
}

/* --- the definition ----------------------------------------------------------------------- */

typedef struct {
    double left, top, right, bottom, depth;
} rectangle;

static double along(const fxl_direction *axis, const fxl_point *a, const fxl_point *b)
{
    return ((double)axis->x * (a->x - b->x) + (double)axis->y * (a->y - b->y) +
            (double)axis->z * (a->z - b->z)) /
           (FXL_Q2_30_ONE * 65536.0);
}

/* Where the sprite of instance 1 is on the screen, in pixels. */
static rectangle exact_rectangle(double scale)
{
    const fxl_view *view = &scene.renderer.frame.view;
    const fxl_point *centre = &scene.tiny->instances[1].centre, *eye = &view->camera.position;
    const double x = along(&view->camera.axes.right, centre, eye);
    const double y = along(&view->camera.axes.up, centre, eye);
    const double z = along(&view->camera.axes.forward, centre, eye);
    const double focal = view->lens.focal / 65536.0, unit = scale / 65536;
    rectangle at;
    at.depth = z;
    at.left = BOARD_SCENE_WIDTH / 2.0 + focal * (x - scene.board.anchor_x * unit) / z;
    at.right = BOARD_SCENE_WIDTH / 2.0 +
               focal * (x + (scene.board.width - scene.board.anchor_x) * unit) / z;
    at.top = BOARD_SCENE_HEIGHT / 2.0 -
             focal * (y + (scene.board.height - scene.board.anchor_y) * unit) / z;
    at.bottom = BOARD_SCENE_HEIGHT / 2.0 - focal * (y - scene.board.anchor_y * unit) / z;
    return at;
}

/* Every pixel of a frame without cubes. Returns how many were sure and show the sprite. */
static uint32_t expect_sprite(double scale)
{
    const rectangle at = exact_rectangle(scale);
    const bool is_there = at.depth >= 0.0626 && at.depth <= 999 && fabs(at.left) < 4095 &&
                          fabs(at.right) < 4095 && fabs(at.top) < 4095 && fabs(at.bottom) < 4095;
    uint32_t shown = 0;
    for (int y = 0; y < BOARD_SCENE_HEIGHT; y++) {
        for (int x = 0; x < BOARD_SCENE_WIDTH; x++) {
            const int u = exact_sprite_texel(x + 0.5, at.left, at.right, BOARD_SPRITE_WIDTH);
            const int v = exact_sprite_texel(y + 0.5, at.top, at.bottom, BOARD_SPRITE_HEIGHT);
            int expected = BACKGROUND;
            if (is_there && (u == -2 || v == -2)) {
                continue;
            }
            if (is_there && u >= 0 && v >= 0) {
                expected = scene.texels[v * BOARD_SPRITE_WIDTH + u];
                shown++;
            }
            TEST_ASSERT_EQUAL(expected, whole[y][x]);
        }
    }
    return shown;
}

/* billboards 2.1a-b, 3.1a-b */
void test_a_pixel_shows_the_texel_at_its_centre(void)
{
    uint32_t shown = 0;
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    for (uint32_t i = 0; i < UNIT_REPEAT / 100; i++) {
        fxl_pose pose = any_pose();
        pose.position.z = unit_between(-Q16(40), Q16(9.8));
        pose.roll = unit_random();
        draw_frame(&pose, i % 2 * BOARD_LIST_WORDS);
        shown += expect_sprite(1);
    }
    TEST_ASSERT_TRUE(shown > UNIT_REPEAT / 30);
}

/* Each coordinate is rounded once, on the screen: near by, half of 1/65536 of a unit in the view
 * would move it by more. */
/* billboards 2.1a */
void test_corners_are_those_of_the_exact_centre(void)
{
    uint32_t close = 0;
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    for (uint32_t i = 0; i < UNIT_REPEAT / 50; i++) {
        fxl_pose pose = any_pose();
        uint32_t place = 0;
        pose.position.z = unit_between(Q16(6), Q16(9.8));
        draw_frame(&pose, BOARD_LIST_WORDS);
        const fxl_screen_polygon *of = fxl_display_list_next(
            &scene.renderer.frame.display_list, (fxl_rows){0, BOARD_SCENE_HEIGHT}, &place);
        if (of != NULL) {
            const rectangle at = exact_rectangle(1);
            TEST_ASSERT_NEAR(at.left * 65536, of->points[0].x, 0.51);
            TEST_ASSERT_NEAR(at.top * 65536, of->points[0].y, 0.51);
            TEST_ASSERT_NEAR(at.right * 65536, of->points[1].x, 0.51);
            TEST_ASSERT_NEAR(at.bottom * 65536, of->points[1].y, 0.51);
            close += at.depth * 65536 < scene.renderer.frame.view.lens.focal;
        }
    }
    TEST_ASSERT_TRUE(close > UNIT_REPEAT / 500);
}

/* The scale of a placement is that of the sprite; where it turns to does not matter. */
/* billboards 2.1a */
void test_a_turned_instance_scales_its_sprite(void)
{
    const fxl_pose pose = ahead(Q16(-9));
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    scene.tiny->scene.placements = placements;
    scene.tiny->scene.placement_code = &fxl_turned_instances;
    placements[0] = (fxl_placement){FXL_ORIENTATION_NONE, Q16(2.5)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_orientation_from_angles(DEGREES(40), DEGREES(10), 0,
                                                          &placements[0].orientation));
    draw_frame(&pose, 0);
    TEST_ASSERT_TRUE(expect_sprite(2.5) > 40);
}

/* --- order, key, formats ---------------------------------------------------------------------- */

static uint32_t count_sprite(uint8_t frame[BOARD_SCENE_HEIGHT][BOARD_SCENE_WIDTH])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < BOARD_SCENE_WIDTH * BOARD_SCENE_HEIGHT; i++) {
        count += frame[i / BOARD_SCENE_WIDTH][i % BOARD_SCENE_WIDTH] >= 100 &&
                 frame[i / BOARD_SCENE_WIDTH][i % BOARD_SCENE_WIDTH] < BACKGROUND;
    }
    return count;
}

/* The cube at the origin is before the sprite at z = 10 for one eye and behind it for the other. */
/* billboards 1.2a */
void test_what_is_nearer_covers_what_is_farther(void)
{
    fxl_pose pose = ahead(Q16(-4));
    scene.board = (fxl_billboard){&scene.sprite, Q16(14), Q16(9), Q16(7), Q16(4.5)};
    draw_frame(&pose, 0);
    TEST_ASSERT_TRUE(whole[BOARD_SCENE_HEIGHT / 2][BOARD_SCENE_WIDTH / 2] <= 6); /* the cube */
    TEST_ASSERT_TRUE(count_sprite(whole) > 0);
    pose = ahead(Q16(14));
    pose.yaw = DEGREES(180);
    draw_frame(&pose, 0);
    TEST_ASSERT_EQUAL(
        scene.texels[BOARD_SPRITE_HEIGHT / 2 * BOARD_SPRITE_WIDTH + BOARD_SPRITE_WIDTH / 2],
        whole[BOARD_SCENE_HEIGHT / 2][BOARD_SCENE_WIDTH / 2]);
    /* A layer comes before the distance. */
    scene.tiny->instances[1].layer = 1;
    pose = ahead(Q16(-4));
    draw_frame(&pose, 0);
    TEST_ASSERT_TRUE(whole[BOARD_SCENE_HEIGHT / 2][BOARD_SCENE_WIDTH / 2] >= 100);
}

/* billboards 3.2a */
void test_the_key_is_not_drawn(void)
{
    const fxl_pose pose = ahead(Q16(5));
    scene.tiny->instances[0].centre.z = Q16(30); /* behind */
    scene.sprite.key =
        scene.texels[BOARD_SPRITE_HEIGHT / 2 * BOARD_SPRITE_WIDTH + BOARD_SPRITE_WIDTH / 2];
    draw_frame(&pose, 0);
    TEST_ASSERT_TRUE(whole[BOARD_SCENE_HEIGHT / 2][BOARD_SCENE_WIDTH / 2] <= 6);
    TEST_ASSERT_TRUE(count_sprite(whole) > 0);
}

/* The same picture in 1, 4 and 8 bits. */
/* billboards 3.2b */
void test_sprites_of_every_format(void)
{
    static const uint8_t one[] = {0xA0, 0x40}, four[] = {0x10, 0x10, 0x01, 0x00},
                         eight[] = {1, 0, 1, 0, 1, 0}, colours[16] = {120, 130};
    const fxl_pose pose = ahead(Q16(7));
    scene.sprite.width = 3;
    scene.sprite.height = 2;
    scene.sprite.colours = colours;
    scene.sprite.pixels = one;
    scene.sprite.bits = 1;
    draw_frame(&pose, 0);
    memcpy(other, whole, sizeof whole);
    TEST_ASSERT_EQUAL(130, whole[BOARD_SCENE_HEIGHT / 2][BOARD_SCENE_WIDTH / 2]);
    TEST_ASSERT_EQUAL(120, whole[BOARD_SCENE_HEIGHT / 2 - 1][BOARD_SCENE_WIDTH / 2]);
    scene.sprite.pixels = four;
    scene.sprite.bits = 4;
    draw_frame(&pose, BOARD_LIST_WORDS);
    TEST_ASSERT_EQUAL_MEMORY(other, whole, sizeof whole);
    scene.sprite.pixels = eight;
    scene.sprite.bits = 8;
    draw_frame(&pose, 0);
    TEST_ASSERT_EQUAL_MEMORY(other, whole, sizeof whole);
}

/* --- bands, lists, cores ---------------------------------------------------------------------- */

/* billboards 4.1a, 4.1c */
void test_bands_lists_and_workspaces_change_no_pixel(void)
{
    const uint16_t steps[] = {1, 2, 3, 8, 12};
    uint32_t spilled = 0, listed = 0, shown = 0;
    scene.sprite.key = 103;
    for (uint32_t i = 0; i < UNIT_REPEAT / 100; i++) {
        const fxl_pose pose = any_pose();
        draw_frame(&pose, BOARD_LIST_WORDS);
        fxl_counters all = scene.renderer.workspace.counters;
        TEST_ASSERT_EQUAL_UINT32(13, all.in);
        TEST_ASSERT_EQUAL_UINT32(13, all.backfacing + all.outside + all.degenerate + all.drawn +
                                         all.refused);
        shown += count_sprite(whole);
        board_scene_start(&scene, unit_random() % BOARD_LIST_WORDS);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&scene.renderer, &pose));
        draw(other, steps[unit_random() % 5], &scene.renderer.workspace);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        spilled += scene.renderer.workspace.counters.spilled;
        listed += scene.renderer.frame.display_list.used;
        all.spilled = scene.renderer.workspace.counters.spilled;
        TEST_ASSERT_EQUAL_MEMORY(&all, &scene.renderer.workspace.counters, sizeof all);
    }
    TEST_ASSERT_TRUE(spilled > 0 && listed > 0 && shown > 0);
}

/* billboards 4.1a */
void test_another_core_draws_a_band(void)
{
    const fxl_pose pose = ahead(Q16(-4));
    static FXL_ALIGN_8 uint8_t memory[512];
    draw_frame(&pose, 0);
    TEST_ASSERT_TRUE(fxl_workspace_size(&scene.renderer) <= sizeof memory);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&second, &scene.renderer, memory, sizeof memory));
    draw(other, 8, &second);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    /* Attached by another record, as often as before. */
    static fxl_billboards others;
    const fxl_band band = UNIT_BAND(other[0], BOARD_SCENE_WIDTH, 0, 8);
    const fxl_memory tables = {scene.order, TINY_INSTANCES, NULL, 0, NULL, 0};
    for (int i = 0; i < 2; i++) {
        tiny_start(&scene.renderer, scene.tiny, BOARD_SCENE_WIDTH, BOARD_SCENE_HEIGHT, &tables);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&scene.renderer,
                                                        i == 0 ? &scene.billboards : &others,
                                                        &scene.set, FXL_SPRITES_OF(fxl_palette)));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&scene.renderer, &pose));
        TEST_ASSERT_EQUAL(i == 0 ? FXL_OK : FXL_E_ORDER,
                          fxl_frame_draw_with(&scene.renderer, &second, &band));
    }
}

/* --- what is counted -------------------------------------------------------------------------- */

/* billboards 2.2a-c, 2.3a-b */
void test_near_far_and_sides_leave_sprites_out(void)
{
    static const struct {
        fxl_q16_16 x, y, z;
        uint32_t drawn, outside, refused;
    } cases[] = {{0, 0, Q16(9.937), 1, 0, 0},      /* just beyond the near plane of 1/16 */
                 {0, 0, Q16(9.9375) - 4, 1, 0, 0}, /* on it, with the inset of 4 */
                 {0, 0, Q16(9.9375) - 3, 0, 1, 0}, {0, 0, Q16(9.94), 0, 1, 0}, /* nearer */
                 {0, 0, Q16(11), 0, 1, 0},                                     /* behind the eye */
                 {0, 0, Q16(-989), 1, 0, 0},     /* before far, 1000 */
                 {0, 0, Q16(-990) + 4, 1, 0, 0}, /* on it */
                 {0, 0, Q16(-990) + 3, 0, 1, 0},   {0, 0, Q16(-990.5), 0, 1, 0}, /* beyond */
                 {Q16(12.1), 0, 0, 0, 1, 0}, /* its right side is beside the left border */
                 {Q16(11.9), 0, 0, 1, 0, 0}, /* it is on the screen */
                 {0, Q16(-9.1), 0, 0, 1, 0}};
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    for (uint32_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const fxl_pose pose = {{cases[i].x, cases[i].y, cases[i].z}, 0, 0, 0};
        draw_frame(&pose, 0);
        TEST_ASSERT_EQUAL_UINT32(cases[i].drawn, scene.renderer.workspace.counters.drawn);
        TEST_ASSERT_EQUAL_UINT32(cases[i].outside, scene.renderer.workspace.counters.outside);
        TEST_ASSERT_EQUAL_UINT32(cases[i].refused, scene.renderer.workspace.counters.refused);
        TEST_ASSERT_EQUAL_UINT32(0, scene.renderer.workspace.counters.clipped);
        TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.in);
    }
    /* Its corners are far beside the screen, within 4095 pixels; then beyond. */
    scene.board = (fxl_billboard){&scene.sprite, Q16(17), Q16(3), Q16(8.5), Q16(1.5)};
    const fxl_pose close = ahead(Q16(9.937));
    draw_frame(&close, 0);
    TEST_ASSERT_EQUAL_UINT32(0, scene.renderer.workspace.counters.refused); /* 16 * 8.5 / 0.063 */
    TEST_ASSERT_EQUAL_UINT32(BOARD_SCENE_WIDTH * BOARD_SCENE_HEIGHT, count_sprite(whole));
    scene.board.width = Q16(40);
    scene.board.anchor_x = Q16(20);
    scene.tiny->models[1].radius = Q16(21);
    draw_frame(&close, 0);
    TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.refused);
    TEST_ASSERT_EQUAL_UINT32(0, count_sprite(whole));
}

/* As far beside the eye as a centre can be, with a side that goes on from there: beyond what is
 * projected. And one whose left side is projected, and whose right side is not. */
void test_a_side_that_is_too_far_is_refused(void)
{
    const fxl_q16_16 far = Q16(8188), size = Q16(8000);
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    scene.board = (fxl_billboard){&scene.sprite, Q16(40), Q16(3), Q16(2), Q16(1.5)};
    scene.tiny->models[1].radius = Q16(41);
    const fxl_pose close = ahead(Q16(9.937));
    draw_frame(&close, 0);
    TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.refused);
    scene.tiny->models[1].radius = Q16(28000); /* as if it reached the screen */
    scene.tiny->instances[1].centre = (fxl_point){far, far, far};
    for (uint32_t turn = 0; turn < 4; turn++) {
        /* The view's right, or its up, is the diagonal of the world, or its opposite. */
        const fxl_pose pose = {{-far, -far, -far - Q16(2)},
                               (fxl_angle)-DEGREES(45),
                               0,
                               DEGREES(35) + DEGREES(1) / 4 + turn * FXL_ANGLE_QUARTER};
        scene.board = (fxl_billboard){&scene.sprite, Q16(1), Q16(1), 0, 0};
        draw_frame(&pose, 0);
        TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.in);
        TEST_ASSERT_EQUAL_UINT32(
            1, scene.renderer.workspace.counters.refused); /* beyond 4095 pixels */
        for (uint32_t anchored = 0; anchored < 2; anchored++) {
            const fxl_q16_16 anchor = anchored != 0 ? size : 0;
            scene.board = (fxl_billboard){&scene.sprite, size, size, anchor, anchor};
            draw_frame(&pose, 0);
            TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.refused);
        }
    }
}

/* A sprite of less than a pixel shows where it covers a pixel's centre. */
/* billboards 2.2 */
void test_a_sprite_far_away_covers_a_pixel_or_none(void)
{
    uint32_t shown = 0;
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    for (uint32_t i = 0; i < UNIT_REPEAT / 300; i++) {
        const fxl_pose pose = {
            {unit_between(-Q16(9), Q16(9)), unit_between(-Q16(9), Q16(9)), Q16(-90)}, 0, 0, 0};
        draw_frame(&pose, i % 2 * BOARD_LIST_WORDS);
        TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.drawn);
        const uint32_t pixels = count_sprite(whole);
        TEST_ASSERT_TRUE(pixels <= 1);
        shown += pixels;
    }
    TEST_ASSERT_TRUE(shown > 0 && shown < UNIT_REPEAT / 300);
}

/* A sprite that is high and narrow: between the centres of two columns, and half a pixel beside that. */
/* billboards 3.1a */
void test_a_sprite_between_two_columns_shows_nothing(void)
{
    scene.tiny->scene.instances = &scene.tiny->instances[1];
    scene.tiny->scene.instance_count = 1;
    scene.board = (fxl_billboard){&scene.sprite, Q16(0.25), Q16(3), Q16(0.125), Q16(1.5)};
    for (uint32_t i = 0; i < 4; i++) {
        fxl_pose pose = ahead(Q16(0));
        pose.position.x =
            i < 2 ? 0 : Q16(10) / BOARD_SCENE_WIDTH; /* 10 ahead a pixel is 20 / width */
        draw_frame(&pose, i % 2 * BOARD_LIST_WORDS);
        TEST_ASSERT_EQUAL_UINT32(1, scene.renderer.workspace.counters.drawn);
        const uint32_t pixels = count_sprite(whole);
        TEST_ASSERT_TRUE(i < 2 ? pixels == 0 : pixels > 3 && pixels < BOARD_SCENE_HEIGHT);
    }
}

/* The picture of a moved centre is that of the middle, moved by as much, in whole pixels here. */
/* billboards 2.1d */
void test_an_off_centre_lens_shows_the_same_sprite(void)
{
    uint32_t shown = 0, differing = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = any_pose();
        const int dx = unit_between(-BOARD_SCENE_WIDTH, BOARD_SCENE_WIDTH),
                  dy = unit_between(-BOARD_SCENE_HEIGHT, BOARD_SCENE_HEIGHT);
        fxl_lens lens;
        const fxl_memory memory = {scene.order, TINY_INSTANCES, NULL, 0, NULL, 0};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_from_fov(BOARD_SCENE_WIDTH, BOARD_SCENE_HEIGHT,
                                            FXL_ANGLE_QUARTER, Q16(0.0625), Q16(1000), 0, &lens));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene.tiny->scene, NULL));
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_renderer_init_with(&scene.renderer, &scene.tiny->scene, &lens, &memory));
        TEST_ASSERT_EQUAL(FXL_OK, board_scene_attach(&scene));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&scene.renderer, &pose));
        draw(whole, BOARD_SCENE_HEIGHT, &scene.renderer.workspace);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_centre(
                                      &scene.renderer, Q16(BOARD_SCENE_WIDTH / 2) + dx * 65536,
                                      Q16(BOARD_SCENE_HEIGHT / 2) + dy * 65536));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&scene.renderer, &pose));
        draw(other, BOARD_SCENE_HEIGHT, &scene.renderer.workspace);
        for (int y = dy > 0 ? dy : 0; y < BOARD_SCENE_HEIGHT && y - dy < BOARD_SCENE_HEIGHT; y++) {
            for (int x = dx > 0 ? dx : 0; x < BOARD_SCENE_WIDTH && x - dx < BOARD_SCENE_WIDTH;
                 x++) {
                shown += other[y][x] >= 100 && other[y][x] < BACKGROUND;
                differing += other[y][x] != whole[y - dy][x - dx];
            }
        }
    }
    TEST_ASSERT_TRUE(shown > UNIT_REPEAT / 100);
    TEST_ASSERT_TRUE(differing <= shown / 1000);
}
