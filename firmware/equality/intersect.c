/* SPDX-License-Identifier: MIT */
/* Compares the place where an edge crosses a plane. */

#include "clip/intersection.h"
#include "equality.h"
#include "sides.h"

#define DISTANCE_MAX   (((uint64_t)1 << 62) - 1)
#define COORDINATE_MAX (((uint64_t)1 << 61) - 1)

static void compare(const fxl_view_point *from, const fxl_view_point *to, uint64_t inside,
                    uint64_t outside)
{
    const fxl_q18_46 distances[] = {(fxl_q18_46)inside, -(fxl_q18_46)outside};
    fxl_view_point core, portable;
    fxl_intersect_edge(from, to, &distances[0], &distances[1], &core);
    portable_intersect_edge(from, to, &distances[0], &distances[1], &portable);
    equality_case(core.x == portable.x && core.y == portable.y && core.z == portable.z);
}

static int64_t any_coordinate(void)
{
    const int64_t value = (int64_t)(any_length() & COORDINATE_MAX);
    return any_32() & 1024u ? -value : value;
}

static void any_point(fxl_view_point *point)
{
    point->x = any_coordinate();
    point->y = any_coordinate();
    point->z = any_coordinate();
}

/* Not 0. */
static uint64_t any_distance(void)
{
    const uint64_t distance = any_length() & DISTANCE_MAX;
    return distance == 0 ? 1 : distance;
}

static void test_with(uint64_t inside, uint64_t outside)
{
    fxl_view_point from, to;
    any_point(&from);
    any_point(&to);
    compare(&from, &to, inside, outside);
}

/* Distances of a few bits beside powers of two; then any. In every fourth input the outside is so
 * far that the digits of the fraction are those of a quotient that is nearly whole. */
void test_intersect(uint32_t rounds)
{
    for (uint32_t i = 0; i < BOUNDARY_32_COUNT; i++) {
        for (uint32_t j = 0; j < BOUNDARY_32_COUNT; j++) {
            const uint64_t inside = boundary_32(i), outside = boundary_32(j);
            if (inside != 0 && outside != 0) {
                test_with(inside, outside);
                test_with(inside << 30, outside);
                test_with(inside, outside << 30);
            }
        }
    }
    for (uint32_t round = 0; round < rounds; round++) {
        const uint64_t inside = any_distance();
        const uint64_t parts = 1 + (any_32() >> 8);
        const uint64_t outside = inside * (parts - 1) + (any_32() >> 30);
        const bool is_near = round % 4 == 0 && inside < DISTANCE_MAX / parts - 4 && outside != 0;
        test_with(inside, is_near ? outside : any_distance());
    }
}
