/* SPDX-License-Identifier: MIT */
/* Polygons of the screen clipped to a rectangle: by hand, and any convex ones against the exact
 * outline. */
#include "clip_unit.h"
#include "wide.h"
#include "study/rectangle.h"

static struct {
    fxl_rectangle_work work;
    uint8_t guard[64];
} room;
static const fxl_screen_polygon *result;

/* 10..50 across, 20..40 down. */
static const fxl_rectangle window = {Q16(10), Q16(20), Q16(50), Q16(40)};

static fxl_screen_polygon flat(const int *numbers, size_t count)
{
    fxl_screen_polygon polygon = {.colour = 7, .count = (uint8_t)count};
    for (size_t i = 0; i < count; i++) {
        polygon.points[i] = (fxl_screen_point){numbers[2 * i] * 65536, numbers[2 * i + 1] * 65536};
    }
    return polygon;
}
#define FLAT(...) flat((const int[]){__VA_ARGS__}, sizeof((const int[]){__VA_ARGS__}) / 8)

static fxl_clip_result clip(const fxl_screen_polygon *polygon)
{
    result = polygon;
    return fxl_clip_to_rectangle(polygon, &window, &room.work, &result);
}

void test_inside_and_on_the_borders_is_the_input(void)
{
    const fxl_screen_polygon inside = FLAT(12, 22, 48, 22, 30, 38),
                             whole = FLAT(10, 20, 50, 20, 50, 40, 10, 40);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&inside));
    TEST_ASSERT_EQUAL_PTR(&inside, result);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&whole));
    TEST_ASSERT_EQUAL_PTR(&whole, result);
}

/* Outside one border, across another. */
/* clippers 3.5a */
void test_outside_one_border_is_nothing(void)
{
    const fxl_screen_polygon shapes[] = {FLAT(0, 10, 9, 10, 9, 30), FLAT(51, 10, 60, 10, 60, 30),
                                         FLAT(0, 10, 30, 10, 30, 19), FLAT(0, 41, 30, 41, 30, 50)};
    for (int i = 0; i < 4; i++) {
        memset(&room.work, 0x5A, sizeof room.work);
        TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&shapes[i]));
        TEST_ASSERT_NULL(result);
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room.work.polygons, sizeof room.work.polygons);
    }
    const fxl_screen_polygon past_a_corner = FLAT(0, 24, 18, 6, 0, 6);
    TEST_ASSERT_TRUE(clip(&past_a_corner) != FXL_CLIP_CUT);
    TEST_ASSERT_NULL(result);
}

static void expect(const fxl_screen_polygon *polygon, const fxl_screen_polygon *wanted)
{
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(polygon));
    TEST_ASSERT_EQUAL(wanted->count, result->count);
    TEST_ASSERT_EQUAL(7, result->colour);
    TEST_ASSERT_EQUAL(FXL_POLYGON_FLAT, result->kind);
    bool same = false;
    for (uint32_t first = 0; first < wanted->count; first++) {
        bool equal = true;
        for (uint32_t i = 0; i < wanted->count; i++) {
            const fxl_screen_point *a = &result->points[i];
            const fxl_screen_point *b = &wanted->points[(first + i) % wanted->count];
            equal = equal && a->x == b->x && a->y == b->y;
        }
        same = same || equal;
    }
    TEST_ASSERT_TRUE(same);
}
#define EXPECT(polygon, ...) \
    do { \
        const fxl_screen_polygon wanted = FLAT(__VA_ARGS__); \
        expect(polygon, &wanted); \
    } while (0)

/* clippers 3.5a-b */
void test_each_border_cuts(void)
{
    fxl_screen_polygon at = FLAT(6, 24, 14, 24, 14, 32, 6, 32);
    EXPECT(&at, 10, 24, 14, 24, 14, 32, 10, 32);
    at = FLAT(46, 24, 54, 24, 54, 32, 46, 32);
    EXPECT(&at, 46, 24, 50, 24, 50, 32, 46, 32);
    at = FLAT(16, 16, 24, 16, 24, 24, 16, 24);
    EXPECT(&at, 16, 20, 24, 20, 24, 24, 16, 24);
    at = FLAT(16, 36, 24, 36, 24, 44, 16, 44);
    EXPECT(&at, 16, 36, 24, 36, 24, 40, 16, 40);
    at = FLAT(0, 30, 20, 20, 20, 40); /* slanted edges */
    EXPECT(&at, 10, 25, 20, 20, 20, 40, 10, 35);
}

void test_what_surrounds_the_rectangle_becomes_it(void)
{
    const fxl_screen_polygon around = FLAT(-100, -100, 200, -100, 200, 200, -100, 200),
                             slanted = FLAT(30, -100, 200, 30, 30, 200, -100, 30);
    EXPECT(&around, 10, 20, 50, 20, 50, 40, 10, 40);
    EXPECT(&slanted, 10, 20, 50, 20, 50, 40, 10, 40);
}

void test_a_touch_is_degenerate(void)
{
    const fxl_screen_polygon touch = FLAT(10, 30, 0, 35, 0, 25), side = FLAT(10, 24, 10, 30, 0, 27);
    TEST_ASSERT_EQUAL(FXL_CLIP_DEGENERATE, clip(&touch));
    TEST_ASSERT_NULL(result);
    TEST_ASSERT_EQUAL(FXL_CLIP_DEGENERATE, clip(&side));
    TEST_ASSERT_NULL(result);
}

/* Teeth through the left border: each adds two vertices and takes one. */
void test_more_than_the_capacity_is_refused(void)
{
    int full = 0, refused = 0;
    memset(room.guard, 0x5A, sizeof room.guard);
    for (uint32_t n = 0; n < UNIT_REPEAT / 10; n++) {
        fxl_screen_polygon polygon = {.colour = 7};
        uint32_t left = 0;
        polygon.count = (uint8_t)unit_between(FXL_POLYGON_CAPACITY / 2, FXL_POLYGON_CAPACITY);
        for (uint32_t i = 0; i < polygon.count; i++) {
            polygon.points[i] = (fxl_screen_point){unit_random() % 2 ? Q16(0) : Q16(20),
                                                   Q16(22) + (int32_t)i * 16384};
        }
        for (uint32_t i = 0; i < polygon.count; i++) {
            const bool inside = polygon.points[i].x != 0;
            left += (uint32_t)inside + (inside != (polygon.points[(i + 1) % polygon.count].x != 0));
        }
        const fxl_clip_result cut = clip(&polygon);
        TEST_ASSERT_EQUAL(left > FXL_POLYGON_CAPACITY, cut == FXL_CLIP_CAPACITY);
        TEST_ASSERT_EQUAL(cut == FXL_CLIP_CUT || cut == FXL_CLIP_INSIDE, result != NULL);
        if (cut == FXL_CLIP_CUT) {
            TEST_ASSERT_EQUAL_UINT32(left, result->count);
        }
        full += left == FXL_POLYGON_CAPACITY && cut == FXL_CLIP_CUT;
        refused += left == FXL_POLYGON_CAPACITY + 1;
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room.guard, sizeof room.guard);
    }
    TEST_ASSERT_TRUE(full > 0 && refused > 0);
}

/* A convex polygon: vertices of an octagon, stretched, anywhere. */
static fxl_screen_polygon any_convex(fxl_q16_16 size)
{
    static const int cosines[8] = {10, 7, 0, -7, -10, -7, 0, 7};
    const fxl_q16_16 x = unit_between(-size, size), y = unit_between(-size, size);
    const fxl_q16_16 wide_by = unit_between(1, size), high = unit_between(1, size);
    fxl_screen_polygon polygon = {.colour = 7};
    for (int i = 0; i < 8; i++) {
        if (unit_random() % 4 != 0 || i < 3) {
            polygon.points[polygon.count++] =
                (fxl_screen_point){(fxl_q16_16)(x + (int64_t)wide_by * cosines[i] / 10),
                                   (fxl_q16_16)(y + (int64_t)high * cosines[(i + 6) % 8] / 10)};
        }
    }
    return polygon;
}

/* Twice the area of the triangle a, b, c: how far c is from the line through a and b, times the
 * distance of these two. Differences are below 2^29. */
static int64_t turn(const fxl_screen_point *a, const fxl_screen_point *b, const fxl_screen_point *c)
{
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(c->x - a->x) * (b->y - a->y);
}

static int64_t length_of(int64_t a, int64_t b)
{
    a = a < 0 ? -a : a;
    b = b < 0 ? -b : b;
    return a > b ? a : b; /* at most the length, and at least 0.7 of it */
}

/* Within 2 units of the polygon: 2 units times the length of the edge is at most 3 times the longer
 * of its extents. */
static bool is_within(const fxl_screen_polygon *polygon, const fxl_screen_point *at)
{
    for (uint32_t i = 0; i < polygon->count; i++) {
        const fxl_screen_point *a = &polygon->points[i];
        const fxl_screen_point *b = &polygon->points[i + 1 == polygon->count ? 0 : i + 1];
        if (turn(a, b, at) < -3 * length_of((int64_t)b->x - a->x, (int64_t)b->y - a->y)) {
            return false;
        }
    }
    return true;
}

/* Every vertex of the result lies in the rectangle, exactly, and in the polygon, to within the
 * bound; and what the result leaves out, the rectangle or the polygon leaves out: each point of a
 * grid within both, by more than the bound, is within the result. */
/* clippers 3.5c-d */
void test_any_convex_polygon(void)
{
    int cut_count = 0;
    for (int n = 0; n < UNIT_REPEAT / 20; n++) {
        const fxl_q16_16 size = n % 2 ? Q16(2000) : Q16(60);
        const fxl_screen_polygon polygon = any_convex(size);
        fxl_rectangle to = {unit_between(-size, size), unit_between(-size, size), 0, 0};
        to.right = unit_between(to.left, size);
        to.bottom = unit_between(to.top, size);
        const fxl_clip_result cut = fxl_clip_to_rectangle(&polygon, &to, &room.work, &result);
        TEST_ASSERT_TRUE(cut != FXL_CLIP_CAPACITY);
        for (uint32_t i = 0; result != NULL && i < result->count; i++) {
            const fxl_screen_point *at = &result->points[i];
            TEST_ASSERT_TRUE(at->x >= to.left && at->x <= to.right);
            TEST_ASSERT_TRUE(at->y >= to.top && at->y <= to.bottom);
            TEST_ASSERT_TRUE(is_within(&polygon, at));
        }
        cut_count += cut == FXL_CLIP_CUT;
        for (int k = 0; k < 4; k++) {
            const fxl_screen_point at = {unit_between(to.left, to.right),
                                         unit_between(to.top, to.bottom)};
            bool deep = true; /* in the polygon, by 4 units at least */
            for (uint32_t i = 0; i < polygon.count; i++) {
                const fxl_screen_point *a = &polygon.points[i];
                const fxl_screen_point *b = &polygon.points[i + 1 == polygon.count ? 0 : i + 1];
                deep = deep &&
                       turn(a, b, &at) > 6 * length_of((int64_t)b->x - a->x, (int64_t)b->y - a->y);
            }
            TEST_ASSERT_TRUE(!deep || (result != NULL && is_within(result, &at)));
        }
    }
    TEST_ASSERT_TRUE(cut_count > UNIT_REPEAT / 100);
}

/* Two polygons that share an edge share the vertices that the borders make on it. */
void test_neighbours_get_the_same_vertices(void)
{
    static fxl_rectangle_work other;
    int shared = 0;
    for (int n = 0; n < UNIT_REPEAT / 20; n++) {
        fxl_screen_point at[4];
        for (int i = 0; i < 4; i++) {
            at[i] = (fxl_screen_point){unit_between(Q16(-40), Q16(100)),
                                       unit_between(Q16(-40), Q16(100))};
        }
        const fxl_screen_polygon first = {.count = 3, .points = {at[0], at[1], at[2]}};
        const fxl_screen_polygon second = {.count = 3, .points = {at[1], at[0], at[3]}};
        const fxl_screen_polygon *a, *b;
        if (fxl_clip_to_rectangle(&first, &window, &room.work, &a) != FXL_CLIP_CUT ||
            fxl_clip_to_rectangle(&second, &window, &other, &b) != FXL_CLIP_CUT) {
            continue;
        }
        /* Each vertex of the one within a unit of the edge's line is one of the other, if the other
         * has one so near. */
        for (uint32_t i = 0; i < a->count; i++) {
            for (uint32_t k = 0; k < b->count; k++) {
                const fxl_screen_point *p = &a->points[i], *q = &b->points[k];
                const int64_t reach = length_of((int64_t)p->x - q->x, (int64_t)p->y - q->y);
                const int64_t edge =
                    length_of((int64_t)at[1].x - at[0].x, (int64_t)at[1].y - at[0].y);
                const int64_t p_off = turn(&at[0], &at[1], p), q_off = turn(&at[0], &at[1], q);
                if (reach <= 4 && p_off >= -edge && p_off <= edge && q_off >= -edge &&
                    q_off <= edge) {
                    TEST_ASSERT_EQUAL(0, reach);
                    shared++;
                }
            }
        }
    }
    TEST_ASSERT_TRUE(shared > UNIT_REPEAT / 100);
}
