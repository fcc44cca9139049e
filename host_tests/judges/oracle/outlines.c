/* SPDX-License-Identifier: MIT */
#include "oracle/outlines.h"

#include <math.h>

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/cover.h"

enum {
    ANYWHERE,
    HALVES,
    NEAR_CENTRES,
    ABOUT_SCREEN,
    ROUND,
    THROUGH_CENTRES,
    SQUARE,
    SLIVER,
    ENDS,
    KINDS
};

typedef struct {
    oracle_random *random;
    int width, height;
} outline_maker;

static int64_t limited(int64_t coordinate)
{
    return coordinate < -FXL_SCREEN_COORDINATE_MAX  ? -FXL_SCREEN_COORDINATE_MAX
           : coordinate > FXL_SCREEN_COORDINATE_MAX ? FXL_SCREEN_COORDINATE_MAX
                                                    : coordinate;
}

static int64_t about(oracle_random *random, int size)
{
    return oracle_between(random, -4 * 65536, (size + 4) * 65536);
}

/* place fill-rule: random corners on pixel centres, where ties are */
static int64_t centre(oracle_random *random, int size)
{
    return oracle_between(random, -1, size) * 65536 + 32768;
}

static int64_t end(oracle_random *random, int size)
{
    switch (oracle_below(random, 4)) {
    case 0:
        return FXL_SCREEN_COORDINATE_MAX - oracle_between(random, 0, 2);
    case 1:
        return -FXL_SCREEN_COORDINATE_MAX + oracle_between(random, 0, 2);
    default:
        return about(random, size);
    }
}

static int64_t coordinate(oracle_random *random, int kind, int size)
{
    switch (kind) {
    case ANYWHERE:
        return oracle_between(random, -FXL_SCREEN_COORDINATE_MAX, FXL_SCREEN_COORDINATE_MAX);
    case HALVES:
        return oracle_between(random, -4, 2 * size + 4) * 32768;
    case NEAR_CENTRES:
        return centre(random, size) + oracle_between(random, -1, 1);
    case ENDS:
        return end(random, size);
    default:
        return about(random, size);
    }
}

/* Two points on the line through two centres, an integer number of steps outside them. */
static void through_centres(const outline_maker *maker, oracle_spot *a, oracle_spot *b)
{
    oracle_spot p = {centre(maker->random, maker->width), centre(maker->random, maker->height)};
    oracle_spot q = {centre(maker->random, maker->width), centre(maker->random, maker->height)};
    int64_t back = oracle_between(maker->random, 0, 2), on = oracle_between(maker->random, 1, 3);
    *a = (oracle_spot){p.x - back * (q.x - p.x), p.y - back * (q.y - p.y)};
    *b = (oracle_spot){p.x + on * (q.x - p.x), p.y + on * (q.y - p.y)};
}

static void make_round(const outline_maker *maker, oracle_spot *points, int count)
{
    double x = oracle_uniform(maker->random, 0, maker->width);
    double y = oracle_uniform(maker->random, 0, maker->height);
    double wide = oracle_spread(maker->random, 1e-4, 2.0 * maker->width);
    double high = oracle_spread(maker->random, 1e-4, 2.0 * maker->height);
    double turn = oracle_uniform(maker->random, 0, 6.28);
    for (int i = 0; i < count; i++) {
        double angle = turn + 6.283185307179586 * i / count;
        points[i].x = (int64_t)floor((x + wide * cos(angle)) * 65536 + 0.5);
        points[i].y = (int64_t)floor((y + high * sin(angle)) * 65536 + 0.5);
    }
    /* Points on an edge, rounded, bend it either way. */
    if (oracle_below(maker->random, 2)) {
        for (int i = 1; i + 1 < count; i += 2) {
            points[i].x = (points[i - 1].x + points[i + 1].x) >> 1;
            points[i].y = (points[i - 1].y + points[i + 1].y) >> 1;
        }
    }
}

static void make(const outline_maker *maker, int kind, oracle_spot *points, int count)
{
    oracle_random *random = maker->random;
    if (kind == ROUND) {
        make_round(maker, points, count);
        return;
    }
    for (int i = 0; i < count; i++) {
        points[i].x = coordinate(random, kind, maker->width);
        points[i].y = coordinate(random, kind, maker->height);
        if (kind == THROUGH_CENTRES && i % 2 == 0 && i + 1 < count) {
            through_centres(maker, &points[i], &points[i + 1]);
            i++;
        } else if (kind == SQUARE && i > 0) {
            *(i % 2 ? &points[i].x : &points[i].y) = i % 2 ? points[i - 1].x : points[i - 1].y;
        } else if (kind == SLIVER && i > 1) {
            points[i].x = points[i - 2].x + oracle_between(random, -3, 3);
            points[i].y = points[i - 2].y + oracle_between(random, -3, 3);
        }
    }
}

void oracle_outline_generate(oracle_random *random, int width, int height, oracle_input *input)
{
    outline_maker maker = {random, width, height};
    oracle_spot points[FXL_POLYGON_CAPACITY];
    int most = oracle_below(random, 4) ? 6 : FXL_POLYGON_CAPACITY;
    int count = (int)oracle_between(random, 3, most);
    input->kind = (int)oracle_below(random, KINDS);
    make(&maker, input->kind, points, count);
    /* Repeated vertices. */
    if (oracle_below(random, 8) == 0) {
        points[count - 1] = points[oracle_below(random, (uint32_t)count)];
    }
    oracle_put(input, count);
    for (int i = 0; i < count; i++) {
        oracle_put(input, limited(points[i].x));
        oracle_put(input, limited(points[i].y));
    }
}
