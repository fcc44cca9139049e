/* SPDX-License-Identifier: MIT */
/* One frame, whatever the bands and the size of the list; and the list itself: what goes in comes
 * out, in order, where its rows are asked for. Small enough for a board with 8 KB of RAM. */
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/clippers.h"
#include "unit.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    FACES = 18,
    WORDS = FACES / 2 * FXL_DISPLAY_LIST_WORDS(6) /* more than half the faces never face the eye */
};

static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT];
static uint32_t frame_list[WORDS];
static fxl_draw_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static tiny_scene *tiny;

static void start(uint32_t words, const fxl_clipper *clipper)
{
    const fxl_memory memory = {
        order, TINY_INSTANCES + 6, words > 0 ? frame_list : NULL, words, NULL, 0};
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
/* SPEC 4.10c, 4.11j, 7.3b, accuracy 1.1s */
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
/* SPEC 4.11i, 7.3a, 7.3c */
void test_what_does_not_fit_is_counted(void)
{
    fxl_pose pose = {{Q16(2), Q16(2), Q16(-3)}, DEGREES(-20), DEGREES(-20), 0};
    fxl_counters counters = draw_whole(&pose, &fxl_clipper_view);
    TEST_ASSERT_TRUE(counters.spilled > 3);
    static uint32_t longest[WORDS];
    start(WORDS, &fxl_clipper_view);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    draw_rows(other, 8, 8);
    memcpy(longest, frame_list, sizeof longest);
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
        /* None that would fit is behind one that does not. */
        TEST_ASSERT_EQUAL(0, memcmp(longest, frame_list, renderer.frame.display_list.used * 4));
        TEST_ASSERT_TRUE(held > 0 || words < FXL_DISPLAY_LIST_WORDS(4));
    }
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.spilled);
}

static uint32_t times_asked;

static fxl_clip_result counting_clipper(const fxl_model_view *model_view, const fxl_face *face,
                                        fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    times_asked++;
    return fxl_clip_by_view(model_view, face, work, screen);
}

static const fxl_clipper counting = {.clip = counting_clipper};

/* With a list that holds the frame, no band looks at the scene again. */
/* SPEC 7.5b */
void test_a_band_does_not_walk_the_scene_again(void)
{
    fxl_pose pose = {{Q16(2), Q16(2), Q16(-3)}, DEGREES(-20), DEGREES(-20), 0};
    fxl_counters counters = draw_whole(&pose, &fxl_clipper_view);
    start(WORDS, &counting);
    times_asked = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, times_asked);
    memset(tiny->vertices, 0, sizeof tiny->vertices);
    memset(tiny->faces, 0, sizeof tiny->faces);
    memset(tiny->instances, 0, sizeof tiny->instances);
    for (uint32_t row = 0; row < HEIGHT; row++) {
        draw_rows(other, row, 1);
    }
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
    TEST_ASSERT_EQUAL_UINT32(counters.in - counters.backfacing, times_asked);
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
/* SPEC 7.2b-c */
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

enum {
    LIST_WORDS = 300,
    RECORDS_MAX = LIST_WORDS / FXL_DISPLAY_LIST_WORDS(3),
    SENTINEL = 0x5A5A5A5A
};

static uint32_t list_words[LIST_WORDS + 1];

typedef struct {
    fxl_screen_polygon polygon;
    fxl_rows rows;
} sample;

/* A sample is a function of its number and the round: nothing needs to be kept. */
static sample make_sample(uint32_t number, uint32_t round)
{
    sample made;
    uint32_t bits = (number + 1) * 2654435761u ^ round * 40503u;
    made.polygon.colour = (uint8_t)bits;
    made.polygon.kind = (uint8_t)(bits >> 16);
    made.polygon.shade = (uint8_t)(bits >> 24);
    made.polygon.count = (uint8_t)(3 + (bits >> 8) % (FXL_POLYGON_CAPACITY - 2));
    for (uint32_t i = 0; i < made.polygon.count; i++) {
        int32_t spread = (int32_t)(bits * (2 * i + 1));
        made.polygon.points[i].x = spread % (FXL_SCREEN_COORDINATE_MAX + 1);
        made.polygon.points[i].y = ~spread % (FXL_SCREEN_COORDINATE_MAX + 1);
    }
    made.rows.first = (uint16_t)((bits >> 4) % FXL_SCREEN_MAX);
    made.rows.end =
        (uint16_t)(made.rows.first + 1 + (bits >> 14) % (FXL_SCREEN_MAX - made.rows.first));
    return made;
}

static fxl_display_list list_of(uint32_t capacity)
{
    fxl_display_list list = {list_words, capacity, 0};
    for (uint32_t i = 0; i <= LIST_WORDS; i++) {
        list_words[i] = SENTINEL;
    }
    return list;
}

/* Appends samples until one does not fit; answers how many went in. */
static uint32_t fill(fxl_display_list *list, uint32_t round)
{
    uint32_t count = 0;
    for (;;) {
        sample next = make_sample(count, round);
        uint32_t needed = FXL_DISPLAY_LIST_WORDS((uint32_t)next.polygon.count), used = list->used;
        bool fits = needed <= list->capacity - used;
        TEST_ASSERT_EQUAL(fits, fxl_display_list_append(list, &next.polygon, next.rows));
        TEST_ASSERT_EQUAL_UINT32(fits ? used + needed : used, list->used);
        if (!fits) {
            return count;
        }
        count++;
    }
}

/* The word in front of a polygon has its rows. */
static void expect_record(const sample *want, const fxl_screen_polygon *got)
{
    const uint32_t rows = ((const uint32_t *)(const void *)got)[-1];
    TEST_ASSERT_EQUAL(want->rows.first, (uint16_t)rows);
    TEST_ASSERT_EQUAL(want->rows.end, rows >> 16);
    TEST_ASSERT_EQUAL(want->polygon.colour, got->colour);
    TEST_ASSERT_EQUAL(want->polygon.count, got->count);
    TEST_ASSERT_EQUAL(want->polygon.kind, got->kind);
    TEST_ASSERT_EQUAL(want->polygon.shade, got->shade);
    TEST_ASSERT_EQUAL_MEMORY(want->polygon.points, got->points,
                             want->polygon.count * sizeof want->polygon.points[0]);
}

/* By the definition: one row at least that both have. */
static bool share_a_row(fxl_rows a, fxl_rows b)
{
    for (uint32_t row = a.first; row < a.end; row++) {
        if (row >= b.first && row < b.end) {
            return true;
        }
    }
    return false;
}

static void expect_contents(const fxl_display_list *list, uint32_t count, uint32_t round,
                            fxl_rows asked)
{
    uint32_t place = 0;
    for (uint32_t number = 0; number < count; number++) {
        sample want = make_sample(number, round);
        if (share_a_row(want.rows, asked)) {
            const fxl_screen_polygon *got = fxl_display_list_next(list, asked, &place);
            TEST_ASSERT_NOT_NULL(got);
            expect_record(&want, got);
        }
    }
    TEST_ASSERT_NULL(fxl_display_list_next(list, asked, &place));
    TEST_ASSERT_EQUAL_UINT32(list->used, place);
}

/* Lists of every size, and any rows: none, one, a band, all. */
/* SPEC 7.4 */
void test_records_come_back_in_order_where_rows_meet(void)
{
    uint32_t most = 0;
    for (uint32_t round = 0; round < UNIT_REPEAT / 100; round++) {
        uint32_t capacity =
            round % 2 && round < LIST_WORDS ? round : (uint32_t)unit_between(0, LIST_WORDS);
        fxl_display_list list = list_of(capacity);
        uint32_t count = fill(&list, round);
        uint16_t first = (uint16_t)unit_between(0, FXL_SCREEN_MAX - 1);
        uint16_t end = (uint16_t)(first + unit_between(1, unit_random() % 2 ? 8 : 400));
        expect_contents(&list, count, round, (fxl_rows){0, FXL_SCREEN_MAX});
        expect_contents(&list, count, round, (fxl_rows){first, end});
        for (uint32_t i = list.used; i <= LIST_WORDS; i++) {
            TEST_ASSERT_EQUAL_HEX32(SENTINEL, list_words[i]);
        }
        most = count > most ? count : most;
    }
    TEST_ASSERT_TRUE(most > 5 && most <= RECORDS_MAX);
}

/* A band begins where a polygon ends, or ends where it begins: they share no row. */
/* SPEC 7.4 */
void test_rows_that_only_touch_do_not_meet(void)
{
    fxl_display_list list = list_of(LIST_WORDS);
    sample one = make_sample(0, 0);
    one.rows = (fxl_rows){8, 16};
    TEST_ASSERT_TRUE(fxl_display_list_append(&list, &one.polygon, one.rows));
    const struct {
        fxl_rows asked;
        bool meets;
    } cases[] = {{{0, 8}, false}, {{16, 24}, false}, {{0, 9}, true},  {{15, 16}, true},
                 {{8, 9}, true},  {{10, 11}, true},  {{0, 24}, true}, {{8, 16}, true}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint32_t place = 0;
        TEST_ASSERT_EQUAL(cases[i].meets,
                          fxl_display_list_next(&list, cases[i].asked, &place) != NULL);
    }
}

/* SPEC 7.2a */
void test_the_last_word_is_used_and_none_behind_it(void)
{
    for (uint8_t count = 3; count <= FXL_POLYGON_CAPACITY; count++) {
        uint32_t needed = FXL_DISPLAY_LIST_WORDS((uint32_t)count);
        sample one = make_sample(count, 7);
        one.polygon.count = count;
        for (uint32_t i = 0; i < count; i++) {
            one.polygon.points[i] = (fxl_screen_point){-(int32_t)i, (int32_t)i};
        }
        fxl_display_list list = list_of(needed - 1);
        TEST_ASSERT_FALSE(fxl_display_list_append(&list, &one.polygon, one.rows));
        TEST_ASSERT_EQUAL_UINT32(0, list.used);
        list.capacity = needed;
        TEST_ASSERT_TRUE(fxl_display_list_append(&list, &one.polygon, one.rows));
        TEST_ASSERT_FALSE(fxl_display_list_append(&list, &one.polygon, one.rows));
        TEST_ASSERT_EQUAL_UINT32(needed, list.used);
        TEST_ASSERT_EQUAL_HEX32(SENTINEL, list_words[needed]);
    }
}

/* SPEC 7.5a */
void test_a_list_without_memory_is_full_and_empty(void)
{
    fxl_display_list list = {NULL, 0, 0};
    sample one = make_sample(0, 0);
    uint32_t place = 0;
    TEST_ASSERT_FALSE(fxl_display_list_append(&list, &one.polygon, one.rows));
    TEST_ASSERT_NULL(fxl_display_list_next(&list, (fxl_rows){0, FXL_SCREEN_MAX}, &place));
}
