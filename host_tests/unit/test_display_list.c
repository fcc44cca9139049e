/* SPDX-License-Identifier: MIT */
/* The list: what goes in comes out, in order, where its rows are asked for. */
#include "unit.h"

enum {
    WORDS = 300,
    RECORDS_MAX = WORDS / FXL_DISPLAY_LIST_WORDS(3),
    SENTINEL = 0x5A5A5A5A
};

static uint32_t words[WORDS + 1];

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
    fxl_display_list list = {words, capacity, 0};
    for (uint32_t i = 0; i <= WORDS; i++) {
        words[i] = SENTINEL;
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
        uint32_t capacity = round % 2 && round < WORDS ? round : (uint32_t)unit_between(0, WORDS);
        fxl_display_list list = list_of(capacity);
        uint32_t count = fill(&list, round);
        uint16_t first = (uint16_t)unit_between(0, FXL_SCREEN_MAX - 1);
        uint16_t end = (uint16_t)(first + unit_between(1, unit_random() % 2 ? 8 : 400));
        expect_contents(&list, count, round, (fxl_rows){0, FXL_SCREEN_MAX});
        expect_contents(&list, count, round, (fxl_rows){first, end});
        for (uint32_t i = list.used; i <= WORDS; i++) {
            TEST_ASSERT_EQUAL_HEX32(SENTINEL, words[i]);
        }
        most = count > most ? count : most;
    }
    TEST_ASSERT_TRUE(most > 5 && most <= RECORDS_MAX);
}

/* A band begins where a polygon ends, or ends where it begins: they share no row. */
/* SPEC 7.4 */
void test_rows_that_only_touch_do_not_meet(void)
{
    fxl_display_list list = list_of(WORDS);
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

/* SPEC 7.2 */
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
        TEST_ASSERT_EQUAL_HEX32(SENTINEL, words[needed]);
    }
}

/* SPEC 7.5 */
void test_a_list_without_memory_is_full_and_empty(void)
{
    fxl_display_list list = {NULL, 0, 0};
    sample one = make_sample(0, 0);
    uint32_t place = 0;
    TEST_ASSERT_FALSE(fxl_display_list_append(&list, &one.polygon, one.rows));
    TEST_ASSERT_NULL(fxl_display_list_next(&list, (fxl_rows){0, FXL_SCREEN_MAX}, &place));
}
