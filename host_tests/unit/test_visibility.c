/* SPDX-License-Identifier: MIT */
/* What hides what: front to back is back to front turned round, and the picture the same. */
#include "../../lib/draw/submit.h"
#include "../../lib/raster/fill.h"
#include "choices.h"
#include "painters.h"
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/targets.h"

enum {
    WIDTH = 16,
    HEIGHT = 24,
    BACKGROUND = 200,
    ORDER = TINY_INSTANCES + 6,
    LIST_WORDS = 9 * FXL_DISPLAY_LIST_WORDS(6),
    INTERVALS = 80 /* more than a frame of the tests ever wants */
};

/* What a frame is drawn with. */
typedef struct {
    const choice *hidden;
    uint32_t words, intervals;
} way;

static uint64_t room[FXL_SPAN_BUFFER_BYTES(HEIGHT, INTERVALS) / 8 + 1];
static uint8_t frames[2][HEIGHT * WIDTH], writes[HEIGHT * WIDTH];
static uint32_t list[LIST_WORDS];
static fxl_draw_entry order[ORDER];
static fxl_renderer renderer;
static tiny_scene *tiny;

static void start(const way *by)
{
    const fxl_memory memory = {order, ORDER, list, by->words, NULL, 0};
    tiny = tiny_make();
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, by->hidden, room,
                                          FXL_SPAN_BUFFER_BYTES(HEIGHT, by->intervals)));
}

static void draw_rows(uint8_t *frame, uint32_t first, uint32_t rows)
{
    frame_draw_band(&renderer, &renderer.workspace, frame, first, rows, BACKGROUND);
}

/* In bands of so many rows. */
static fxl_counters draw(const way *by, const fxl_pose *pose, uint8_t *frame, uint32_t rows)
{
    start(by);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    memset(frame, 0, HEIGHT * WIDTH);
    frame_draw_bands(&renderer, frame, rows, BACKGROUND);
    return renderer.workspace.counters;
}

/* Counters that every method has in common. */
static void expect_counters(const fxl_counters *a, const fxl_counters *b)
{
    TEST_ASSERT_EQUAL_UINT32(a->in, b->in);
    TEST_ASSERT_EQUAL_UINT32(a->backfacing, b->backfacing);
    TEST_ASSERT_EQUAL_UINT32(a->outside, b->outside);
    TEST_ASSERT_EQUAL_UINT32(a->drawn, b->drawn);
    TEST_ASSERT_EQUAL_UINT32(a->clipped, b->clipped);
}

/* Any list, any bands, any pool. */
void test_the_span_buffer_draws_the_same_picture(void)
{
    static const choice *const methods[] = {&choice_spans, &choice_spans_box};
    const uint32_t rounds = UNIT_REPEAT / 100;
    uint32_t split = 0, drawn = 0, spilled = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        const way sorted = {&choice_sorted, 0, 0};
        const way spans = {methods[round % 2],
                           (uint32_t)unit_between(0, round % 3 ? LIST_WORDS : 30),
                           (uint32_t)unit_between(FXL_SPAN_BUFFER_ROW(WIDTH), 12)};
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw(&sorted, &pose, frames[0], HEIGHT);
        fxl_counters counters = draw(&spans, &pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        expect_counters(&expected, &counters);
        TEST_ASSERT_EQUAL_UINT32(0, expected.split_bands);
        split += counters.split_bands;
        spilled += counters.spilled > 0;
        drawn += counters.drawn;
    }
    TEST_ASSERT_TRUE(split > rounds / 20 && spilled > rounds / 4 && drawn > rounds);
}

/* Counted as they are written: each covered pixel once, others never. */
/* spans 2.2c */
void test_each_pixel_is_written_once(void)
{
    const uint32_t rounds = UNIT_REPEAT / 200;
    uint32_t covered = 0, over = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        const way sorted = {&choice_sorted, 0, 0};
        fxl_pose pose = tiny_pose_before();
        (void)draw(&sorted, &pose, frames[0], HEIGHT);
        const way spans = {counted_begin(writes, frames[1], sizeof writes),
                           round % 2 ? LIST_WORDS : 0, INTERVALS};
        fxl_counters counters = draw(&spans, &pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        TEST_ASSERT_EQUAL_UINT32(0, counters.split_bands);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        for (uint32_t i = 0; i < HEIGHT * WIDTH; i++) {
            TEST_ASSERT_EQUAL(frames[0][i] != BACKGROUND, writes[i]);
            covered += writes[i];
        }
        over += counters.drawn > 3;
    }
    TEST_ASSERT_TRUE(covered > rounds * WIDTH && over > rounds / 10);
}

/* The list of one method is the other's, backwards. */
/* SPEC 6.4a-c */
void test_front_to_back_is_the_exact_reverse(void)
{
    enum {
        MOST = 24
    };
    static fxl_screen_point firsts[MOST];
    uint32_t compared = 0;
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        const way sorted = {&choice_sorted, LIST_WORDS, 0};
        const way spans = {&choice_spans, LIST_WORDS, INTERVALS};
        const fxl_rows all = {0, HEIGHT};
        fxl_pose pose = tiny_pose_before();
        const fxl_screen_polygon *record;
        uint32_t count = 0, place = 0;
        start(&sorted);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        const fxl_display_list *drawn = &renderer.frame.display_list;
        while ((record = fxl_display_list_next(drawn, all, &place)) != NULL) {
            firsts[count++] = record->points[0];
        }
        start(&spans);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        compared += count > 1;
        for (place = 0; (record = fxl_display_list_next(drawn, all, &place)) != NULL;) {
            TEST_ASSERT_TRUE(count > 0);
            TEST_ASSERT_EQUAL_MEMORY(&firsts[--count], &record->points[0], sizeof firsts[0]);
        }
        TEST_ASSERT_EQUAL_UINT32(0, count);
    }
    TEST_ASSERT_TRUE(compared > UNIT_REPEAT / 400);
}

/* The least pool splits bands, a larger one fewer, and the picture stays. */
/* spans 3.1a, 3.2a-c */
void test_a_full_pool_splits_the_band(void)
{
    const way sorted = {&choice_sorted, 0, 0};
    const uint32_t rounds = UNIT_REPEAT / 100;
    uint32_t split = 0, twice = 0;
    for (uint32_t round = 0; round < rounds; round++) {
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw(&sorted, &pose, frames[0], HEIGHT);
        uint32_t before = UINT32_MAX;
        for (uint32_t intervals = FXL_SPAN_BUFFER_ROW(WIDTH); intervals < 2 * HEIGHT;
             intervals *= 2) {
            const way spans = {&choice_spans, 0, intervals};
            fxl_counters counters = draw(&spans, &pose, frames[1], HEIGHT);
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
            TEST_ASSERT_TRUE(counters.split_bands <= before);
            before = counters.split_bands;
            split += before > 0;
            twice += before > 1;
            counters.split_bands = 0;
            TEST_ASSERT_EQUAL_MEMORY(&expected, &counters, sizeof counters);
        }
    }
    TEST_ASSERT_TRUE(split > rounds / 10 && twice > rounds / 50);
}

/* As many splits as it can count, and one more. */
void test_the_count_of_splits_ends(void)
{
    const way spans = {&choice_spans, 0, FXL_SPAN_BUFFER_ROW(WIDTH)};
    bool split = false;
    for (uint32_t round = 0; round < 100 && !split; round++) {
        fxl_pose pose = tiny_pose_before();
        split = draw(&spans, &pose, frames[0], HEIGHT).split_bands > 1;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        renderer.workspace.counters.split_bands = UINT16_MAX - 1;
        frame_draw_bands(&renderer, frames[1], HEIGHT, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    }
    TEST_ASSERT_TRUE(split);
    TEST_ASSERT_EQUAL_UINT32(UINT16_MAX, renderer.workspace.counters.split_bands);
}

/* Refused: too little room, none, or at an odd place; the renderer goes on as it was. */
/* spans 3.3b */
void test_refusals(void)
{
    const way sorted = {&choice_sorted, 0, 0};
    const uint32_t least = FXL_SPAN_BUFFER_BYTES_LEAST(WIDTH, HEIGHT);
    fxl_pose pose = tiny_pose_before();
    fxl_counters counters = draw(&sorted, &pose, frames[0], HEIGHT);
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_palette_spans);
    config.depth = room;
    config.depth_size = least;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_choose(NULL, &config));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_choose(&renderer, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, choice_take(&renderer, &choice_spans, NULL, least));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
                      choice_take(&renderer, &choice_spans, (uint8_t *)room + 4, least));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, choice_take(&renderer, &choice_spans, room, least - 1));
    counters.refused_calls = 4;
    TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
    TEST_ASSERT_TRUE(renderer.target == &fxl_palette && renderer.order == &fxl_by_distance);
    draw_rows(frames[1], 0, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_spans, room, least));
    const fxl_band band = UNIT_BAND(frames[1], WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    draw_rows(frames[1], 0, HEIGHT);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_sorted, NULL, 0));
}

/* Two renderers, two methods, frame about. */
void test_two_renderers_do_not_know_of_each_other(void)
{
    static fxl_renderer other;
    static fxl_draw_entry others[ORDER];
    const way spans = {&choice_spans, 0, FXL_SPAN_BUFFER_ROW(WIDTH)};
    const fxl_memory memory = {others, ORDER, NULL, 0, NULL, 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    start(&spans);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&other, &tiny->scene, &lens, &memory));
    for (int round = 0; round < 20; round++) {
        fxl_pose pose = tiny_pose_before();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&other, &pose));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        frame_draw_band(&other, &other.workspace, frames[0], 0, HEIGHT / 2, BACKGROUND);
        draw_rows(frames[1], 0, HEIGHT);
        frame_draw_band(&other, &other.workspace, frames[0], HEIGHT / 2, HEIGHT / 2, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    }
}

/* A renderer may be moved within a frame, whatever it hides with. */
void test_a_renderer_is_moved_within_a_frame(void)
{
    static fxl_renderer moved;
    const way ways[] = {{&choice_spans, 0, FXL_SPAN_BUFFER_ROW(WIDTH)},
                        {&choice_spans, LIST_WORDS, FXL_SPAN_BUFFER_ROW(WIDTH)},
                        {&choice_box, LIST_WORDS, 0}};
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_pose pose = tiny_pose_before();
        (void)draw(&ways[i], &pose, frames[0], HEIGHT);
        start(&ways[i]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        draw_rows(frames[1], 0, HEIGHT / 2);
        moved = renderer;
        memset(&renderer, 0x5A, sizeof renderer);
        frame_draw_band(&moved, &moved.workspace, frames[1], HEIGHT / 2, HEIGHT / 2, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &renderer, sizeof renderer);
    }
}

/* Testing every pixel of a polygon's box draws the same picture. */
void test_boxes_draw_the_same_picture(void)
{
    const way sorted = {&choice_sorted, LIST_WORDS, 0};
    for (int round = 0; round < UNIT_REPEAT / 1000; round++) {
        const way boxes = {&choice_box, (uint32_t)unit_between(0, LIST_WORDS), 0};
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw(&sorted, &pose, frames[0], HEIGHT);
        fxl_counters counters = draw(&boxes, &pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        expect_counters(&expected, &counters);
    }
}

/* The rows of each band, or part of one, that was begun. */
static uint32_t begun[64], begun_count, rows_at_most;

static void note_rows(const fxl_renderer *of, fxl_workspace *workspace, const fxl_band *band)
{
    (void)of;
    (void)workspace;
    begun[begun_count++ % 64] = band->rows;
}

static fxl_status draw_noted_rows(const fxl_renderer *of, fxl_workspace *workspace,
                                  const fxl_band *band)
{
    return fxl_band_split_draw(of, workspace, band, note_rows);
}

static bool is_low_enough(fxl_workspace *by, const fxl_screen_polygon *polygon,
                          const fxl_band *band)
{
    (void)by;
    (void)polygon;
    return band->rows <= rows_at_most;
}

/* A target without room halves what is left of the band's part until there is room, the upper half
 * the larger. Each halving is counted. */
/* spans 3.1b-c */
void test_how_a_band_is_halved(void)
{
    static const fxl_target picky = {.pixel_bits = 8,
                                     .fill = fxl_fill_band_palette,
                                     .draw_band = draw_noted_rows,
                                     .flat = is_low_enough};
    static choice method;
    static const uint32_t rows[][20] = {
        {16, 8, 4, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
        {16, 8, 4, 2, 2, 2, 2, 2, 2, 2, 2},
        {15, 8, 4, 4, 4, 3},
        {7, 4, 2, 2, 2, 1},
        {3, 2, 1, 1, 1},
        {3}};
    static const uint32_t most[] = {1, 2, 4, 2, 1, 3}, halvings[] = {4, 3, 2, 2, 2, 0};
    const way sorted = {&choice_sorted, 0, 0};
    const fxl_pose pose = {{0, 0, Q16(-1.5)}, 0, 0, 0}; /* a face over all of the screen */
    method = choice_sorted;
    method.target = &picky;
    for (int i = 0; i < 6; i++) {
        start(&sorted);
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &method, NULL, 0));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        begun_count = 0;
        rows_at_most = most[i];
        const fxl_band band = UNIT_BAND(frames[1], WIDTH, 1, (uint16_t)rows[i][0]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_EQUAL_UINT32(halvings[i], renderer.workspace.counters.split_bands);
        uint32_t done = 0;
        for (uint32_t k = 0; k < begun_count; k++) {
            TEST_ASSERT_TRUE(k < 20);
            TEST_ASSERT_EQUAL_UINT32(rows[i][k], begun[k]);
            done += begun[k] <= rows_at_most ? begun[k] : 0;
        }
        TEST_ASSERT_EQUAL_UINT32(rows[i][0], done);
    }
}
