/* SPDX-License-Identifier: MIT */
/* Two polygons that share an edge leave no gap and draw no pixel twice: on the
 * screen at any 16.16 position, and through the whole pipeline where the
 * frustum cuts the shared edge. */
#include <math.h>

#include "watertight.h"

enum {
    WIDTH = WATERTIGHT_WIDTH,
    HEIGHT = WATERTIGHT_HEIGHT
};

static void expect_watertight(const fxl_screen_polygon *first, const fxl_screen_polygon *second)
{
    static fxl_screen_polygon both[2];
    both[0] = *first;
    both[1] = *second;
    watertight_expect(both, 1, 2);
}

/* Anywhere, on a centre, on a half pixel, on a quarter. */
static fxl_screen_point random_point(void)
{
    static const int32_t grids[] = {1, 1, 1, 65536, 32768, 16384};
    int32_t grid = grids[unit_random() % 6];
    int32_t offset = grid == 65536 ? 32768 : 0;
    return (fxl_screen_point){
        unit_between(-4 * 65536 / grid, (WIDTH + 4) * 65536 / grid) * grid + offset,
        unit_between(-4 * 65536 / grid, (HEIGHT + 4) * 65536 / grid) * grid + offset};
}

static fxl_screen_polygon triangle(fxl_screen_point a, fxl_screen_point b, fxl_screen_point c)
{
    return (fxl_screen_polygon){.colour = 1, .count = 3, .points = {a, b, c}};
}

void test_two_triangles(void)
{
    int judged = 0;
    while (judged < UNIT_REPEAT) {
        fxl_screen_point a = random_point(), b = random_point();
        fxl_screen_polygon first = triangle(a, b, random_point());
        fxl_screen_polygon second = triangle(b, a, random_point());
        int64_t areas[2] = {watertight_area(&first), watertight_area(&second)};
        if ((areas[0] <= 0 || areas[1] <= 0) && (areas[0] >= 0 || areas[1] >= 0)) {
            continue; /* the same side of the edge, or no area at all */
        }
        expect_watertight(&first, &second);
        judged++;
    }
}

/* A convex polygon, rounded to 16.16 and so perhaps slightly concave, cut from
 * corner to corner. */
void test_a_polygon_cut_by_a_chord(void)
{
    for (int round = 0; round < UNIT_REPEAT; round++) {
        fxl_screen_polygon first = {.colour = 1}, second = {.colour = 2};
        int count = unit_between(4, FXL_POLYGON_CAPACITY < 16 ? FXL_POLYGON_CAPACITY : 16);
        int chord = unit_between(2, count - 2);
        double x = unit_between(0, WIDTH * 1000) / 1000.0;
        double y = unit_between(0, HEIGHT * 1000) / 1000.0;
        double wide = unit_between(1, 12000) / 1000.0, high = unit_between(1, 12000) / 1000.0;
        double turn = unit_between(0, 6283) / 1000.0;
        for (int i = 0; i < count; i++) {
            double angle = turn + i * 6.283185307179586 / count;
            fxl_screen_point corner = {(fxl_q16_16)floor((x + wide * cos(angle)) * 65536.0 + 0.5),
                                       (fxl_q16_16)floor((y + high * sin(angle)) * 65536.0 + 0.5)};
            if (i <= chord) {
                first.points[first.count++] = corner;
            }
            if (i == 0 || i >= chord) {
                second.points[second.count++] = corner;
            }
        }
        expect_watertight(&first, &second);
    }
}

static void expect_through(const fxl_clipper *clipper)
{
    static fxl_screen_polygon screens[2];
    watertight_expect_through(clipper, NULL, UNIT_REPEAT / 4, screens, 2);
}

void test_through_the_frustum_of_the_view(void)
{
    expect_through(&fxl_clipper_view);
}

void test_through_the_frustum_of_the_world(void)
{
    expect_through(&fxl_clipper_world);
}

void test_through_the_frustum_of_the_view_turned_and_scaled(void)
{
    static fxl_screen_polygon screens[2];
    watertight_expect_turned(&fxl_clipper_view, UNIT_REPEAT / 4, screens, 2);
}
