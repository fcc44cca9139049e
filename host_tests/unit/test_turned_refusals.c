/* SPDX-License-Identifier: MIT */
/* A frame with placements that fxl_frame_begin refuses. The placements may have any values then, so
 * no call may read them: the frame before has ended. */
#include "frame_bands.h"
#include "placements.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 40 * FXL_DISPLAY_LIST_WORDS(8)
};

static uint8_t frames[2][PIXELS];
static fxl_draw_entry order[64];
static uint32_t list[LIST_WORDS];
static fxl_cached_vertex cache[9];
static fxl_renderer renderer;
static fxl_placement placements[TINY_INSTANCES];
static tiny_scene *tiny;

/* The tiny scene, of which the instances from first on are turned, in a list of so many words. */
static void start(uint32_t first, uint32_t list_words)
{
    const fxl_memory memory = {order, 64, list, list_words, cache, 9};
    tiny = tiny_make();
    tiny_place_from(tiny, placements, first);
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

static void draw(const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

static void expect_refused(fxl_status status)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-5)}};
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(status, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
}

/* A refused frame has ended the frame before: no call reads the placements. */
static void expect_ended(void)
{
    const fxl_band band = {
        .pixels = frames[1], .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT};
    fxl_picked picked;
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pick_face(&renderer, WIDTH / 2, HEIGHT / 2, &picked));
    for (int i = 0; i < PIXELS; i++) {
        TEST_ASSERT_EQUAL_UINT8(BACKGROUND, frames[1][i]);
    }
}

/* Instance 2 of a frame that was drawn gets a placement and a centre. The next frame is refused.
 * The table stays as it is while the frame before is asked for. */
static void expect_refused_and_ended(const fxl_placement *bad, fxl_q16_16 centre_x,
                                     fxl_status status)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    fxl_instance *instance = &tiny->instances[2];
    const fxl_placement good = placements[1];
    const fxl_q16_16 good_x = instance->centre.x;
    draw(&pose, HEIGHT, frames[0]);
    placements[1] = *bad;
    instance->centre.x = centre_x;
    expect_refused(status);
    expect_ended();
    placements[1] = good;
    instance->centre.x = good_x;
    expect_ended();
    draw(&pose, HEIGHT, frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
}

/* Lists that hold none, some and all polygons of the frame. */
/* SPEC 8.1 */
void test_a_bad_placement_ends_the_frame_before(void)
{
    static const fxl_q16_16 scales[] = {0,
                                        -5,
                                        -FXL_Q16_16_ONE,
                                        FXL_SCALE_MIN - 1,
                                        FXL_SCALE_MAX + 1,
                                        FXL_UNITS(20000),
                                        INT32_MAX,
                                        INT32_MIN};
    static const uint32_t words[] = {0, 60, LIST_WORDS};
    for (uint32_t k = 0; k < 3; k++) {
        start(1, words[k]);
        const fxl_placement good = placements[1];
        const fxl_q16_16 x = tiny->instances[2].centre.x;
        for (uint32_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
            const fxl_placement scaled = {good.orientation, scales[i]};
            expect_refused_and_ended(&scaled, x, FXL_E_RANGE);
        }
        fxl_placement bad = good;
        bad.orientation.y.y -= 1 << 10;
        expect_refused_and_ended(&bad, x, FXL_E_PLACEMENT);
        bad.orientation.x = (fxl_direction){INT32_MIN, INT32_MIN, INT32_MIN};
        bad.orientation.z = bad.orientation.y = bad.orientation.x;
        expect_refused_and_ended(&bad, x, FXL_E_PLACEMENT);
        const fxl_placement large = {good.orientation, Q16(200)};
        expect_refused_and_ended(&large, Q16(8000), FXL_E_RANGE);
        expect_refused_and_ended(&good, INT32_MAX, FXL_E_RANGE);
        expect_refused_and_ended(&good, INT32_MIN, FXL_E_RANGE);
    }
}

/* A frame that is refused for another reason may have bad placements, too. */
void test_any_refused_frame_with_placements_ends_the_frame_before(void)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    start(1, 0);
    const fxl_placement good = placements[1];
    draw(&pose, HEIGHT, frames[0]);
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderer, &far_away));
    expect_ended();
    placements[1] = good;
    draw(&pose, HEIGHT, frames[0]);
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(&renderer, NULL));
    expect_ended();
    placements[1] = good;
    draw(&pose, HEIGHT, frames[0]);
    placements[1].scale = 0;
    tiny->scene.instance_count = renderer.instance_capacity + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&renderer, &pose));
    expect_ended();
}

/* Where no placement is read, the frame before stays current. */
void test_a_refused_frame_without_placements_leaves_the_frame_before(void)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    start(TINY_INSTANCES, 0);
    draw(&pose, HEIGHT, frames[0]);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderer, &far_away));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(&renderer, NULL));
    tiny->scene.instance_count = renderer.instance_capacity + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&renderer, &pose));
    frame_draw_bands(&renderer, frames[1], HEIGHT, BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
}

/* A scene with placements must name the code that draws them. */
void test_placements_without_their_code_are_refused(void)
{
    start(1, 0);
    const fxl_placement_code *const code = tiny->scene.placement_code;
    tiny->scene.placement_code = NULL;
    expect_refused(FXL_E_ORDER);
    expect_ended();
    tiny->scene.placement_code = code;
}

static void expect_no_lines(fxl_wire *wire)
{
    const fxl_band band = {
        .pixels = frames[1], .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT};
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_wire_draw(wire, &band));
}

/* A wireframe reads the placements as it draws, whatever the reason for which the frame was
 * refused. */
void test_a_refused_wireframe(void)
{
    static fxl_wire wire;
    static const fxl_q16_16 scales[] = {0, -5, FXL_UNITS(20000), INT32_MAX};
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    const fxl_band band = {
        .pixels = frames[0], .width = WIDTH, .stride = WIDTH, .first_row = 0, .rows = HEIGHT};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    start(1, 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_codes));
    for (uint32_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        placements[1].scale = FXL_Q16_16_ONE;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
        placements[1].scale = scales[i];
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &pose));
        expect_no_lines(&wire);
    }
    placements[1].scale = FXL_Q16_16_ONE;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &far_away));
    expect_no_lines(&wire);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_wire_begin(&wire, &pose));
    expect_no_lines(&wire);
    start(TINY_INSTANCES, 0); /* without placements the frame before stays */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &far_away));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
}
