/* SPDX-License-Identifier: MIT */
/* Both line clippers, which must answer alike. */
#include "clip_shapes.h"
#include "wide.h"

typedef bool (*clipper)(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);
static const clipper both[] = {fxl_line_by_planes, fxl_line_by_codes};

/* 90 degrees both ways, near 1, far 100. */
static fxl_volume square(void)
{
    fxl_volume volume;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_volume_from_window(Q16(-1), Q16(1), Q16(-1), Q16(1), Q16(1),
                                                     Q16(100), &volume));
    return volume;
}

static fxl_clip_line line_of(int x0, int y0, int z0, int x1, int y1, int z1)
{
    fxl_clip_line line;
    memset(&line, 0, sizeof line);
    line.from.position = (fxl_view_point){V(x0), V(y0), V(z0)};
    line.to.position = (fxl_view_point){V(x1), V(y1), V(z1)};
    line.carried = 1;
    line.from.carried[0] = 0;
    line.to.carried[0] = Q16(64);
    return line;
}

void test_inside_is_left_alone(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        fxl_clip_line line = line_of(-10, -10, 10, 10, 10, 10), before = line;
        uint32_t intersections = 0;
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&before, &line, sizeof line);
        TEST_ASSERT_EQUAL(0, intersections);
    }
}

void test_outside_one_plane_is_nothing(void)
{
    fxl_volume volume = square();
    const fxl_clip_line lines[] = {line_of(-20, 0, 10, -30, 5, 10), line_of(20, 0, 10, 30, 5, 10),
                                   line_of(0, -20, 10, 5, -30, 10), line_of(0, 20, 10, 5, 30, 10),
                                   line_of(0, 0, 0, 0, 0, -9),      line_of(0, 0, 101, 5, 5, 200)};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 2; k++) {
            fxl_clip_line line = lines[i];
            uint32_t intersections = 0;
            TEST_ASSERT_FALSE(both[k](&line, &volume, &intersections));
            TEST_ASSERT_EQUAL(0, intersections);
        }
    }
}

/* Past the corner of the screen, outside of no one plane. */
void test_past_a_corner_is_nothing(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        fxl_clip_line line = line_of(-30, 0, 10, 0, 20, 10);
        uint32_t intersections = 0;
        TEST_ASSERT_FALSE(both[k](&line, &volume, &intersections));
    }
}

static void expect_ends(const fxl_clip_line *line, int x0, int x1, double u0, double u1)
{
    TEST_ASSERT_NEAR(line->from.position.x, V(x0), 3);
    TEST_ASSERT_NEAR(line->to.position.x, V(x1), 3);
    TEST_ASSERT_NEAR(line->from.carried[0], u0 * 65536, 1);
    TEST_ASSERT_NEAR(line->to.carried[0], u1 * 65536, 1);
}

/* clippers 1.2 */
void test_an_end_is_moved_and_what_it_carries(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line line = line_of(0, 3, 10, 40, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, 0, 10, 0, 16);
        line = line_of(40, 3, 10, 0, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, 10, 0, 48, 64);
        line = line_of(-20, 3, 10, 20, 3, 10);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        expect_ends(&line, -10, 10, 16, 48);
        TEST_ASSERT_EQUAL(4, intersections);
    }
}

/* Beside a plane and along it, the left one (x = -z): a line parallel to it lies
 * inside or outside as a whole, one that lies in it is inside, and any other
 * meets it in one point. */
void test_a_line_and_a_plane(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line apart = line_of(-11, 0, 10, -21, 0, 20),
                      within = line_of(-9, 0, 10, -19, 0, 20);
        fxl_clip_line along = line_of(-10, 0, 10, -20, 0, 20),
                      across = line_of(-9, 0, 10, -13, 0, 10);
        const fxl_clip_line within_before = within, along_before = along;
        TEST_ASSERT_FALSE(both[k](&apart, &volume, &intersections));
        TEST_ASSERT_TRUE(both[k](&within, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&within_before, &within, sizeof within);
        TEST_ASSERT_TRUE(both[k](&along, &volume, &intersections));
        TEST_ASSERT_EQUAL_MEMORY(&along_before, &along, sizeof along);
        TEST_ASSERT_EQUAL(0, intersections);
        TEST_ASSERT_TRUE(both[k](&across, &volume, &intersections));
        TEST_ASSERT_EQUAL(1, intersections);
        expect_ends(&across, -9, -10, 0, 16);
    }
}

/* From behind the eye through the volume and out beyond far. */
void test_through_near_and_far(void)
{
    fxl_volume volume = square();
    for (int k = 0; k < 2; k++) {
        uint32_t intersections = 0;
        fxl_clip_line line = line_of(0, 0, -100, 0, 0, 300);
        TEST_ASSERT_TRUE(both[k](&line, &volume, &intersections));
        TEST_ASSERT_NEAR(line.from.position.z, V(1), 3);
        TEST_ASSERT_NEAR(line.to.position.z, V(100), 3);
    }
}

static bool close(const fxl_view_point *a, const fxl_view_point *b, int64_t units)
{
    int64_t x = a->x - b->x, y = a->y - b->y, z = a->z - b->z;
    return x <= units && x >= -units && y <= units && y >= -units && z <= units && z >= -units;
}

/* Within rounding of a plane all the way: also one that touches a corner. */
static bool runs_along(const fxl_clip_line *line, const fxl_volume *volume)
{
    bool along = false;
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_q18_46 from = fxl_half_space_distance(&volume->planes[i], &line->from.position);
        fxl_q18_46 to = fxl_half_space_distance(&volume->planes[i], &line->to.position);
        along = along || (from >= -8 && from <= 8 && to >= -8 && to <= 8);
    }
    return along;
}

/* Anywhere in range: both answer alike but for rounding, by codes with no more
 * intersections, and neither goes on for ever. */
void test_both_answer_alike(void)
{
    fxl_volume volume = square();
    int kept = 0, moved = 0, unlike = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        unsigned bits = (unsigned)unit_between(44, 61);
        fxl_clip_line line[2];
        uint32_t intersections[2] = {0, 0};
        memset(&line[0], 0, sizeof line[0]);
        line[0].from.position = (fxl_view_point){unit_wide(bits), unit_wide(bits), unit_wide(bits)};
        line[0].to.position = (fxl_view_point){unit_wide(bits), unit_wide(bits), unit_wide(bits)};
        line[1] = line[0];
        bool seen = fxl_line_by_planes(&line[0], &volume, &intersections[0]);
        bool also = fxl_line_by_codes(&line[1], &volume, &intersections[1]);
        TEST_ASSERT_TRUE(intersections[1] <= intersections[0]);
        if (seen && also) {
            kept++;
            moved += intersections[0] > 0;
            /* A line nearly along a plane moves further along it than a unit. */
            unlike += !close(&line[0].from.position, &line[1].from.position, 1 << 16);
            unlike += !close(&line[0].to.position, &line[1].to.position, 1 << 16);
        } else if (seen || also) {
            unlike += !runs_along(&line[seen ? 0 : 1], &volume);
        }
    }
    TEST_ASSERT_TRUE(kept > UNIT_REPEAT / 50 && moved > UNIT_REPEAT / 100);
    TEST_ASSERT_EQUAL(0, unlike);
}
