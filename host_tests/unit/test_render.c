/* SPDX-License-Identifier: MIT */
#include "frame_bands.h"
#include "tiny_frames.h"
#include "choices.h"
#include "tiny.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    BACKGROUND = 200,
    LIST_WORDS = 18 * FXL_DISPLAY_LIST_WORDS(8) /* all faces of the scene, whole or cut */
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static fxl_draw_entry order[2][64];
static uint32_t list[2][LIST_WORDS];
static fxl_renderer renderers[2];

static tiny_scene *start(int which)
{
    tiny_scene *tiny = tiny_make();
    const fxl_memory memory = {order[which], 64, list[which], LIST_WORDS, NULL, 0};
    tiny_start(&renderers[which], tiny, WIDTH, HEIGHT, &memory);
    TEST_ASSERT_TRUE(tiny->scene.draw_list_needed <= 64);
    return tiny;
}

static void draw_rows(fxl_renderer *renderer, uint8_t *frame, uint16_t first, uint16_t rows)
{
    frame_draw_band(renderer, &renderer->workspace, frame, first, rows, BACKGROUND);
}

static void draw_whole(fxl_renderer *renderer, const fxl_pose *pose, uint8_t *frame)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(renderer, pose));
    draw_rows(renderer, frame, 0, HEIGHT);
}

/* Around the three cubes, some of them behind the eye. */
static fxl_pose pose_number(int number)
{
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-6)}, 0, 0, 0};
    pose.position.z += number * Q16(0.7);
    pose.position.x += (number % 5 - 2) * Q16(1.1);
    pose.yaw = (uint32_t)number * DEGREES(7);
    pose.pitch = (uint32_t)number * DEGREES(3) - DEGREES(20);
    pose.roll = (uint32_t)number * DEGREES(11);
    return pose;
}

static uint32_t accounted(const fxl_counters *c)
{
    return c->backfacing + c->outside + c->degenerate + c->refused + c->drawn;
}

/* Colours of the cube are 1 + the number of the face. Faces 0 and 1 lie side by side here, so that both are seen at once. */
/* SPEC 6.2 */
void test_faces_of_a_convex_model_come_by_number(void)
{
    const fxl_rows all = {0, HEIGHT};
    tiny_scene *tiny = start(0);
    uint32_t pairs = 0;
    const fxl_face opposite = tiny->faces[1];
    tiny->faces[1] = tiny->faces[2];
    tiny->faces[2] = opposite;
    tiny->faces[1].material = 2;
    tiny->faces[2].material = 3;
    tiny->scene.instance_count = 1;
    for (int number = 0; number < 4; number++) { /* from above four of its corners */
        fxl_pose pose = {
            {number < 2 ? Q16(-3) : Q16(3), Q16(3), number % 3 == 0 ? Q16(-3) : Q16(3)},
            (uint32_t)number * DEGREES(90) + DEGREES(45),
            0u - DEGREES(35),
            0};
        const fxl_display_list *drawn = &renderers[0].frame.display_list;
        const fxl_screen_polygon *record;
        uint32_t place = 0, before = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
        while ((record = fxl_display_list_next(drawn, all, &place)) != NULL) {
            TEST_ASSERT_TRUE(record->colour > before);
            pairs += before > 0;
            before = record->colour;
        }
    }
    TEST_ASSERT_EQUAL_UINT32(4 * 2, pairs); /* three faces each */
}

void test_a_cube_ahead_is_a_square(void)
{
    start(0);
    fxl_pose pose = {{0, 0, Q16(-7)}, 0, 0, 0};
    draw_whole(&renderers[0], &pose, whole);
    /* The front of the cube stands at z = -1, 6 before the eye, and is 2 wide:
     * 2 * 24 / 6 = 8 pixels about the middle. */
    for (int y = 12; y < 20; y++) {
        for (int x = 20; x < 28; x++) {
            TEST_ASSERT_EQUAL(5, whole[y * WIDTH + x]);
        }
        TEST_ASSERT_TRUE(whole[y * WIDTH + 19] != 5);
        TEST_ASSERT_TRUE(whole[y * WIDTH + 28] != 5);
    }
    TEST_ASSERT_EQUAL(BACKGROUND, whole[0]);
}

/* The farther cubes' front sides are at z = 9 and 11. Looking along +x from
 * the left, the sides -x appear. */
/* SPEC 1.1a, 1.1d */
void test_right_appears_right_and_up_appears_up(void)
{
    tiny_scene *tiny = start(0);
    fxl_pose pose = {{0, 0, Q16(-7)}, 0, 0, 0};
    tiny->instances[0].centre = (fxl_point){Q16(4), Q16(3), 0};
    tiny->instances[1].centre = (fxl_point){Q16(-4), Q16(-3), 0};
    tiny->instances[2].centre = (fxl_point){0, 0, Q16(-400)};
    draw_whole(&renderers[0], &pose, whole);
    TEST_ASSERT_EQUAL(5, whole[4 * WIDTH + 40]);
    TEST_ASSERT_EQUAL(15, whole[27 * WIDTH + 8]);
    TEST_ASSERT_EQUAL(BACKGROUND, whole[27 * WIDTH + 40]);
    TEST_ASSERT_EQUAL(BACKGROUND, whole[4 * WIDTH + 8]);
}

/* SPEC 4.9b */
void test_nearer_hides_farther_and_layers_come_first(void)
{
    tiny_scene *tiny = start(0);
    fxl_pose pose = {{0, 0, Q16(-7)}, 0, 0, 0};
    draw_whole(&renderers[0], &pose, whole);
    TEST_ASSERT_EQUAL(5, whole[16 * WIDTH + 24]);
    tiny->instances[1].layer = 1;
    draw_whole(&renderers[0], &pose, whole);
    TEST_ASSERT_EQUAL(15, whole[16 * WIDTH + 24]);
}

/* SPEC 4.10a, 4.10c */
void test_bands_of_any_height_give_the_same_pixels(void)
{
    start(0);
    for (int number = 0; number < 20; number++) {
        fxl_pose pose = pose_number(number);
        draw_whole(&renderers[0], &pose, whole);
        fxl_counters counters = renderers[0].workspace.counters;
        for (uint16_t height = 1; height <= HEIGHT; height = (uint16_t)(height + 3)) {
            memset(other, 0, sizeof other);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
            for (uint16_t first = 0; first < HEIGHT; first = (uint16_t)(first + height)) {
                uint16_t rows = first + height > HEIGHT ? (uint16_t)(HEIGHT - first) : height;
                draw_rows(&renderers[0], other, first, rows);
            }
            TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
            TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].workspace.counters, sizeof counters);
        }
    }
}

/* What the list holds is counted by begin, the rest by the first band. */
/* SPEC 7.5b */
void test_bands_in_any_order_count_once(void)
{
    start(0);
    fxl_pose pose = pose_number(3);
    draw_whole(&renderers[0], &pose, whole);
    fxl_counters counters = renderers[0].workspace.counters;
    for (uint32_t words = 0; words <= LIST_WORDS; words += FXL_DISPLAY_LIST_WORDS(4)) {
        renderers[0].frame.display_list.capacity = words;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
        TEST_ASSERT_TRUE(renderers[0].workspace.counters.in <= counters.in);
        draw_rows(&renderers[0], other, 20, 12);
        counters.spilled = renderers[0].workspace.counters.spilled;
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].workspace.counters, sizeof counters);
        draw_rows(&renderers[0], other, 0, 7);
        draw_rows(&renderers[0], other, 7, 13);
        draw_rows(&renderers[0], other, 0, 7);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].workspace.counters, sizeof counters);
    }
    TEST_ASSERT_EQUAL_UINT32(0, counters.spilled);
}

void test_a_wider_stride_gives_the_same_pixels(void)
{
    static uint8_t wide[(WIDTH + 5) * HEIGHT];
    start(0);
    fxl_pose pose = pose_number(4);
    draw_whole(&renderers[0], &pose, whole);
    memset(wide, 0x5A, sizeof wide);
    fxl_band band = {
        .pixels = wide, .width = WIDTH, .stride = WIDTH + 5, .first_row = 0, .rows = HEIGHT};
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderers[0], &band));
    for (int y = 0; y < HEIGHT; y++) {
        TEST_ASSERT_EQUAL_MEMORY(whole + y * WIDTH, wide + y * (WIDTH + 5), WIDTH);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, wide + y * (WIDTH + 5) + WIDTH, 5);
    }
}

/* SPEC 4.11a-b */
void test_every_polygon_is_accounted_for(void)
{
    uint32_t drawn = 0, clipped = 0, outside = 0, backfacing = 0;
    start(0);
    for (int number = 0; number < 60; number++) {
        fxl_pose pose = pose_number(number);
        draw_whole(&renderers[0], &pose, whole);
        const fxl_counters *c = &renderers[0].workspace.counters;
        TEST_ASSERT_EQUAL_UINT32(18, c->in);
        TEST_ASSERT_EQUAL_UINT32(c->in, accounted(c));
        TEST_ASSERT_TRUE(c->clipped <= c->drawn);
        drawn += c->drawn;
        clipped += c->clipped;
        outside += c->outside;
        backfacing += c->backfacing;
    }
    TEST_ASSERT_TRUE(drawn > 50 && clipped > 10 && outside > 50 && backfacing > 50);
}

/* SPEC 4.11b-c, 4.11g-h */
void test_counters_of_a_view_worked_out_by_hand(void)
{
    start(0);
    fxl_pose pose = {{0, 0, Q16(-7)}, 0, 0, 0};
    draw_whole(&renderers[0], &pose, whole);
    const fxl_counters *c = &renderers[0].workspace.counters;
    /* Of cubes 0 and 1 the front faces; of cube 2, at (5, 1, 12), the front and
     * the left: its bottom, at y = 0, is edge-on. */
    TEST_ASSERT_EQUAL_UINT32(18, c->in);
    TEST_ASSERT_EQUAL_UINT32(4, c->drawn);
    TEST_ASSERT_EQUAL_UINT32(14, c->backfacing);
    TEST_ASSERT_EQUAL_UINT32(0, c->clipped);
}

static uint8_t again[WIDTH * HEIGHT], last[WIDTH * HEIGHT];

void test_two_renderers_do_not_disturb_each_other(void)
{
    fxl_pose poses[2] = {pose_number(2), pose_number(5)};
    start(0);
    start(1);
    draw_whole(&renderers[0], &poses[0], whole);
    draw_whole(&renderers[1], &poses[1], other);
    TEST_ASSERT_TRUE(memcmp(whole, other, sizeof whole) != 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &poses[0]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[1], &poses[1]));
    for (uint16_t first = 0; first < HEIGHT; first = (uint16_t)(first + 4)) {
        draw_rows(&renderers[0], again, first, 4);
        draw_rows(&renderers[1], last, first, 4);
    }
    TEST_ASSERT_EQUAL_MEMORY(whole, again, sizeof whole);
    TEST_ASSERT_EQUAL_MEMORY(other, last, sizeof other);
}

static void expect_untouched(const uint8_t *frame, uint8_t value)
{
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        TEST_ASSERT_EQUAL_HEX8(value, frame[i]);
    }
}

/* SPEC 4.1a, 4.11k */
void test_drawing_before_a_frame_has_begun_is_refused(void)
{
    start(0);
    memset(whole, 0x5A, sizeof whole);
    fxl_band band = UNIT_BAND(whole, WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderers[0], &band));
    expect_untouched(whole, 0x5A);
    TEST_ASSERT_EQUAL_UINT32(1, renderers[0].workspace.counters.refused_calls);
    fxl_pose pose = pose_number(0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    TEST_ASSERT_EQUAL_UINT32(1, renderers[0].workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL_UINT32(18, renderers[0].workspace.counters.in);
}

void test_a_bare_renderer_wants_a_clipper_and_a_method(void)
{
    fxl_renderer *renderer = &renderers[0];
    start(0);
    const fxl_pose pose = pose_number(0);
    const fxl_memory memory = {order[0], 64, list[0], LIST_WORDS, NULL, 0};
    const fxl_lens lens = renderer->frame.view.lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_bare(renderer, renderer->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_begin(renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(renderer, &choice_sorted, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_begin(renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(renderer, &fxl_clipper_view, NULL, 0));
    TEST_ASSERT_EQUAL_UINT32(2, renderer->workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(18, renderer->workspace.counters.in);
}

/* SPEC 3.2, 3.1d */
void test_a_pose_out_of_range_leaves_the_frame_before(void)
{
    start(0);
    fxl_pose pose = pose_number(2), far = pose;
    draw_whole(&renderers[0], &pose, whole);
    far.position.x = FXL_COORDINATE_MAX + 1;
    fxl_counters counters = renderers[0].workspace.counters;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderers[0], &far));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(&renderers[0], NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(NULL, &pose));
    counters.refused_calls += 2;
    TEST_ASSERT_EQUAL_MEMORY(&counters, &renderers[0].workspace.counters, sizeof counters);
    draw_rows(&renderers[0], other, 0, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
}

static void expect_band_refused(fxl_status status, fxl_band band, uint32_t refused_calls)
{
    memset(other, 0x5A, sizeof other);
    TEST_ASSERT_EQUAL(status, fxl_frame_draw(&renderers[0], &band));
    expect_untouched(other, 0x5A);
    TEST_ASSERT_EQUAL_UINT32(refused_calls, renderers[0].workspace.counters.refused_calls);
}

/* SPEC 3.2 */
void test_a_band_of_another_screen_is_refused(void)
{
    start(0);
    fxl_pose pose = pose_number(2);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderers[0], &pose));
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){.pixels = other, .width = WIDTH - 1, .stride = WIDTH, .first_row = 0, .rows = 4},
        1);
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){.pixels = other, .width = WIDTH, .stride = WIDTH - 1, .first_row = 0, .rows = 4},
        2);
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){
            .pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = HEIGHT, .rows = 1},
        3);
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){
            .pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = 1, .rows = HEIGHT},
        4);
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){.pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = 65535, .rows = 1},
        5);
    expect_band_refused(
        FXL_E_RANGE,
        (fxl_band){.pixels = other, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = 0}, 6);
    expect_band_refused(
        FXL_E_ARGUMENT,
        (fxl_band){.pixels = NULL, .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = 4}, 7);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw(&renderers[0], NULL));
    TEST_ASSERT_EQUAL(
        FXL_E_ARGUMENT,
        fxl_frame_draw(
            NULL,
            &(fxl_band){.pixels = other, .width = 48, .stride = 48, .first_row = 0, .rows = 4}));
}

void test_a_renderer_needs_what_the_scene_needs(void)
{
    static fxl_renderer renderer, before;
    tiny_scene *tiny = start(0);
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const uint32_t needed = tiny->scene.draw_list_needed;
    const fxl_memory memory = {order[0], needed, list[0], LIST_WORDS, NULL, 0};
    const fxl_memory too_little = {order[0], needed - 1, list[0], LIST_WORDS, NULL, 0};
    const fxl_memory no_order = {NULL, needed, list[0], LIST_WORDS, NULL, 0};
    const fxl_memory no_list = {order[0], needed, NULL, 1, NULL, 0};
    const fxl_memory no_cache = {order[0], needed, NULL, 0, NULL, 1};
    memset(&renderer, 0x5A, sizeof renderer);
    memcpy(&before, &renderer, sizeof before);
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES + 6, needed);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                      fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &too_little));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init_with(&renderer, NULL, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_init_with(&renderer, &tiny->scene, NULL, &memory));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &no_order));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &no_list));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &no_cache));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_init_with(NULL, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL_MEMORY(&before, &renderer, sizeof before);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
}

void test_a_scene_that_was_not_checked_is_refused(void)
{
    static fxl_renderer renderer;
    tiny_scene *tiny = tiny_make();
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order[0], 64, list[0], LIST_WORDS, NULL, 0};
    tiny->scene.draw_list_needed = 0;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    tiny->scene.instance_count = tiny->scene.draw_list_needed + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY,
                      fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
}

/* Objects may come and go as far as the order table has room beside the faces of a model. */
void test_more_objects_than_the_order_has_room_for_are_refused(void)
{
    static fxl_renderer renderer, before;
    static fxl_instance instances[TINY_INSTANCES + 2];
    tiny_scene *tiny = tiny_make();
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_pose pose = pose_number(0);
    for (uint32_t i = 0; i < TINY_INSTANCES + 2; i++) {
        instances[i] = tiny->scene.instances[i % TINY_INSTANCES];
    }
    tiny->scene.instances = instances;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    const fxl_memory memory = {
        order[0], tiny->scene.draw_list_needed + 1, list[0], LIST_WORDS, NULL, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    tiny->scene.instance_count = TINY_INSTANCES + 1;
    draw_whole(&renderer, &pose, whole);
    memcpy(&before, &renderer, sizeof before);
    tiny->scene.instance_count = TINY_INSTANCES + 2;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&renderer, &pose));
    before.workspace.counters.refused_calls += 1;
    TEST_ASSERT_EQUAL_MEMORY(&before, &renderer, sizeof before);
    tiny->scene.instance_count = TINY_INSTANCES;
    draw_whole(&renderer, &pose, whole);
}

/* Frozen: every core and every compiler draws these frames, bit for bit. If a
 * change to the law makes them differ, look at the pictures before writing
 * down a new number. */
/* SPEC 4.1a */
void test_frozen_frames(void)
{
    uint32_t crcs[16];
    start(0);
    for (int number = 0; number < 16; number++) {
        fxl_pose pose = pose_number(number);
        draw_whole(&renderers[0], &pose, whole);
        crcs[number] = unit_crc32(whole, sizeof whole);
    }
    TEST_ASSERT_EQUAL_HEX32(0x0E0708F9u, crcs[0]);
    TEST_ASSERT_EQUAL_HEX32(0x26A4F74Du, crcs[3]);
    TEST_ASSERT_EQUAL_HEX32(0x44D1D7BBu, crcs[6]);
    TEST_ASSERT_EQUAL_HEX32(0x3CE5F5EFu, unit_crc32((const uint8_t *)crcs, sizeof crcs));
}
