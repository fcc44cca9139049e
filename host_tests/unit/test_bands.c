/* SPDX-License-Identifier: MIT */
/* One frame, whatever the bands and whatever the list's size. Small enough for
 * a board with 8 KB of RAM. */
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/clippers.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    FACES = 18,
    WORDS = FACES / 2 * FXL_DISPLAY_LIST_WORDS(6) /* more than half the faces never face the eye */
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static uint32_t list[WORDS];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static tiny_scene *tiny;

static void start(uint32_t words, const fxl_clipper *clipper)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, words > 0 ? list : NULL, words, NULL, 0};
    tiny = tiny_make();
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, NULL, 0));
}

static void draw_rows(uint8_t *frame, uint32_t first, uint32_t rows)
{
    frame_draw_band(&renderer, &renderer.workspace, frame, first, rows, BACKGROUND);
}

/* The whole frame into `whole`, without a list. */
static fxl_counters draw_whole(const fxl_pose *pose, const fxl_clipper *clipper)
{
    start(0, clipper);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    draw_rows(whole, 0, HEIGHT);
    return renderer.workspace.counters;
}

/* Every row once, in bands of any height; downward, upward, or each twice. */
static void draw_in_bands(void)
{
    uint32_t ends[HEIGHT + 1] = {0}, bands = 0;
    while (ends[bands] < HEIGHT) {
        uint32_t left = HEIGHT - ends[bands];
        ends[bands + 1] = ends[bands] + 1 + unit_random() % left;
        bands++;
    }
    uint32_t upward = unit_random() % 2, times = 1 + unit_random() % 2;
    for (uint32_t i = 0; i < bands * times; i++) {
        uint32_t band = upward ? bands - 1 - i % bands : i % bands;
        draw_rows(other, ends[band], ends[band + 1] - ends[band]);
    }
}

/* The property that bands and lists stand on. */
/* SPEC 4.10 */
void test_any_bands_and_any_list_give_the_same_frame(void)
{
    const uint32_t rounds = UNIT_REPEAT / 20;
    uint32_t drawn = 0, spilled = 0, held = 0, full = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        const fxl_clipper *clipper = unit_random() % 4 ? &fxl_clipper_view : &fxl_clipper_world;
        fxl_pose pose = tiny_pose_about();
        fxl_counters counters = draw_whole(&pose, clipper);
        uint32_t without = counters.spilled;
        start((uint32_t)unit_between(0, unit_random() % 2 ? WORDS : WORDS / 4), clipper);
        memset(other, 0, sizeof other);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        draw_in_bands();
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        counters.spilled = renderer.workspace.counters.spilled;
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        TEST_ASSERT_TRUE(counters.spilled <= without && without <= counters.drawn);
        drawn += counters.drawn;
        spilled += counters.spilled;
        full += counters.spilled > 0 && counters.spilled < without;
        held += without > 0 && counters.spilled == 0;
    }
    TEST_ASSERT_TRUE(drawn > rounds && spilled > rounds / 10);
    TEST_ASSERT_TRUE(held > rounds / 20 && full > rounds / 20);
}

/* Word by word more: what is in the list and what spills add up. */
/* SPEC 4.11, 7.3 */
void test_what_does_not_fit_is_counted(void)
{
    fxl_pose pose = {{Q16(2), Q16(2), Q16(-3)}, DEGREES(-20), DEGREES(-20), 0};
    fxl_counters counters = draw_whole(&pose, &fxl_clipper_view);
    TEST_ASSERT_TRUE(counters.spilled > 3);
    for (uint32_t words = 0; words <= WORDS; words++) {
        uint32_t place = 0, held = 0;
        start(words, &fxl_clipper_view);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        if (words == 0 || FXL_IS_SMALL) { /* otherwise begin has counted them */
            TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.spilled);
        }
        draw_rows(other, 8, 8);
        while (fxl_display_list_next(&renderer.frame.display_list, (fxl_rows){0, HEIGHT}, &place)) {
            held++;
        }
        TEST_ASSERT_EQUAL_UINT32(counters.spilled, held + renderer.workspace.counters.spilled);
        TEST_ASSERT_TRUE(held > 0 || words < FXL_DISPLAY_LIST_WORDS(4));
    }
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.spilled);
}

static uint32_t asked;

static fxl_clip_result counting_clipper(const fxl_model_view *model_view, const fxl_face *face,
                                        fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    asked++;
    return fxl_clip_by_view(model_view, face, work, screen);
}

static const fxl_clipper counting = {.clip = counting_clipper};

/* With a list that holds the frame, no band looks at the scene again. */
/* SPEC 7.5 */
void test_a_band_does_not_walk_the_scene_again(void)
{
    fxl_pose pose = {{Q16(2), Q16(2), Q16(-3)}, DEGREES(-20), DEGREES(-20), 0};
    fxl_counters counters = draw_whole(&pose, &fxl_clipper_view);
    start(WORDS, &counting);
    asked = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, asked);
    memset(tiny->vertices, 0, sizeof tiny->vertices);
    memset(tiny->faces, 0, sizeof tiny->faces);
    memset(tiny->instances, 0, sizeof tiny->instances);
    for (uint32_t row = 0; row < HEIGHT; row++) {
        draw_rows(other, row, 1);
    }
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, asked);
}

/* A refused frame leaves the list as it leaves the rest. */
void test_a_refused_frame_keeps_the_list(void)
{
    fxl_pose pose = {{Q16(2), Q16(2), Q16(-3)}, DEGREES(-20), DEGREES(-20), 0}, far = pose;
    (void)draw_whole(&pose, &fxl_clipper_view);
    for (uint32_t words = 0; words <= WORDS; words += WORDS / 3) {
        start(words, &fxl_clipper_view);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        draw_rows(other, 0, 5);
        far.position.x = FXL_COORDINATE_MAX + 1;
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderer, &far));
        draw_rows(other, 5, HEIGHT - 5);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    }
}

/* A polygon between two rows of centres takes no place, but is counted as drawn. */
/* SPEC 7.2 */
void test_a_polygon_on_no_row_takes_no_record(void)
{
    start(WORDS, &fxl_clipper_view);
    fxl_pose pose = {{0, 0, Q16(-7)}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    uint32_t drawn = renderer.workspace.counters.drawn, used = renderer.frame.display_list.used;
    /* The front of the first cube, 6 before the eye: 12 / 6 of a pixel high where
     * it was 4, about row 8, and so about the edge of two rows. */
    for (int v = 0; v < 8; v++) {
        tiny->vertices[v].y = v & 2 ? Q16(0.2) : Q16(-0.2);
    }
    tiny->instances[2].centre = (fxl_point){0, 0, Q16(-400)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(2, renderer.workspace.counters.drawn);
    TEST_ASSERT_EQUAL_UINT32(FXL_DISPLAY_LIST_WORDS(4), renderer.frame.display_list.used);
    TEST_ASSERT_TRUE(drawn > 2 && used > FXL_DISPLAY_LIST_WORDS(4));
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.spilled);
}
