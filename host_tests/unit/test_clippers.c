/* SPDX-License-Identifier: MIT */
/* The family's clippers under the treaty, face by face. */
#include <stdlib.h>

#include "clip_unit.h"
#include "polygon_face.h"
#include "clippers_list.h"
#include "unit.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    GUARD = 64,
    PIECES = 48
};

/* Room and what must not be touched behind it. */
static struct {
    fxl_clipper_workspace workspace;
    uint8_t guard[GUARD];
} guarded;

static bool is_kept(fxl_clip_result result)
{
    return result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT || result == FXL_CLIP_BETWEEN;
}

static fxl_view random_view(void)
{
    return clip_random_view(WIDTH, HEIGHT);
}

/* What a clipper gives for a face. */
static fxl_screen_polygon got[PIECES];

/* The face's polygons of the screen, by a cleared room; of what are more than PIECES the
 * last. Answers how many there were. */
static int take(const fxl_clipper *clipper, const fxl_polygon *polygon, fxl_view *view,
                fxl_clip_result *result)
{
    static fxl_clipper_work work;
    static polygon_face face;
    int count = 0;
    memset(&guarded.workspace, 0, clipper->workspace_size);
    polygon_face_set(&face, polygon, view, (uint32_t)unit_between(1, 8));
    face.model_view.clipper_workspace = &guarded.workspace;
    *result = clipper->clip(&face.model_view, &face.face, &work, &got[0]);
    fxl_clip_result now = *result;
    while (is_kept(now)) {
        count++;
        fxl_screen_polygon *screen = &got[count < PIECES ? count : PIECES - 1];
        now = clipper->next != NULL ? clipper->next(&face.model_view, &work, screen)
                                    : FXL_CLIP_OUTSIDE;
    }
    return count;
}

/* Twice the area, in 2^-32 square pixels: coordinates below 2^28. */
static int64_t area_of(const fxl_screen_polygon *polygon)
{
    int64_t area = 0;
    for (int i = 0; i < polygon->count; i++) {
        fxl_screen_point a = polygon->points[i], b = polygon->points[(i + 1) % polygon->count];
        area += (int64_t)a.x * b.y - (int64_t)b.x * a.y;
    }
    return area;
}

/* What a polygon inside is for the precise clipper it is for all, but that triangles
 * come one by one and the normalised frustum has roundings of its own. */
/* clippers 4.3b */
void test_a_polygon_inside_is_projected(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    fxl_screen_polygon expected;
    int inside = 0;
    for (int round = 0; round < UNIT_REPEAT / 8; round++) {
        fxl_view view = random_view();
        fxl_polygon polygon = clip_random_face(&view);
        polygon_face_set(&face, &polygon, &view, 8);
        fxl_clip_result wanted = fxl_clip_by_view(&face.model_view, &face.face, &work, &expected);
        if (wanted != FXL_CLIP_INSIDE && wanted != FXL_CLIP_BETWEEN) {
            continue;
        }
        inside++;
        for (int which = 0; which < CLIPPERS; which++) {
            fxl_clip_result result;
            int count = take(clippers[which], &polygon, &view, &result);
            bool fan = clippers[which] == &fxl_clipper_triangles;
            TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, result);
            TEST_ASSERT_EQUAL(fan ? polygon.count - 2 : 1, count);
            TEST_ASSERT_EQUAL(polygon.colour, got[count - 1].colour);
            for (int i = 0; i < expected.count; i++) {
                fxl_screen_point point = fan && i > 1   ? got[i - 2].points[2]
                                         : fan && i > 0 ? got[0].points[1]
                                                        : got[0].points[i];
                TEST_ASSERT_INT32_WITHIN(which < 2 ? 1 : 0, expected.points[i].x, point.x);
                TEST_ASSERT_INT32_WITHIN(which < 2 ? 1 : 0, expected.points[i].y, point.y);
            }
        }
    }
    TEST_ASSERT_TRUE(inside > UNIT_REPEAT / 80);
}

/* The planes of a lens as half-spaces are the planes of the view: the same bits. */
/* clippers 7.1n */
void test_half_spaces_cut_as_the_view_does(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    fxl_screen_polygon expected;
    int cut = 0;
    for (int round = 0; round < UNIT_REPEAT / 4; round++) {
        fxl_view view = random_view();
        fxl_polygon polygon = clip_random_face(&view);
        fxl_clip_result result;
        polygon_face_set(&face, &polygon, &view, 8);
        fxl_clip_result wanted = fxl_clip_by_view(&face.model_view, &face.face, &work, &expected);
        take(&fxl_clipper_half_spaces, &polygon, &view, &result);
        TEST_ASSERT_EQUAL(wanted == FXL_CLIP_BETWEEN ? FXL_CLIP_INSIDE : wanted, result);
        if (is_kept(result)) {
            TEST_ASSERT_EQUAL(expected.count, got[0].count);
            TEST_ASSERT_EQUAL_MEMORY(expected.points, got[0].points,
                                     expected.count * sizeof expected.points[0]);
        }
        cut += result == FXL_CLIP_CUT;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 40);
}

/* The pieces of a face cover what is seen of it, no more and no less: areas add up, to
 * within some units along every border, or what units of the world are there where a
 * face of more vertices than three is as flat as those allow. */
/* clippers 4.4d */
void test_triangles_add_up(void)
{
    static fxl_clipper_work work;
    static polygon_face face;
    static fxl_screen_polygon expected;
    int cut = 0;
    for (int round = 0; round < UNIT_REPEAT / 4; round++) {
        fxl_view view = random_view();
        view.view_frustum.inset = 0; /* the borders are where the screen ends */
        fxl_polygon polygon = clip_random_face(&view);
        fxl_clip_result result;
        polygon_face_set(&face, &polygon, &view, 8);
        fxl_clip_result wanted = fxl_clip_by_view(&face.model_view, &face.face, &work, &expected);
        int count = take(&fxl_clipper_triangles, &polygon, &view, &result);
        int64_t area = 0;
        TEST_ASSERT_TRUE(count <= PIECES);
        for (int i = 0; i < count; i++) {
            TEST_ASSERT_EQUAL(3, got[i].count);
            for (int k = 0; k < 3; k++) {
                TEST_ASSERT_TRUE(got[i].points[k].x >= 0 && got[i].points[k].x <= WIDTH * 65536 &&
                                 got[i].points[k].y >= 0 && got[i].points[k].y <= HEIGHT * 65536);
            }
            area += area_of(&got[i]);
        }
        int64_t whole = is_kept(wanted) ? area_of(&expected) : 0;
        const int64_t along = 2 * (WIDTH + HEIGHT) * (polygon.count == 3 ? 4 : 400);
        TEST_ASSERT_TRUE(llabs(area - whole) < along * 65536);
        cut += result == FXL_CLIP_CUT;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 40);
}

/* What is beyond the sides is left to the scan while it can hold it. */
/* clippers 4.4b */
void test_near_leaves_the_sides_alone(void)
{
    fxl_view view = random_view();
    fxl_clip_result result;
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(&view, Q16(-40), 0, Q16(10));
    polygon.vertices[1].position = clip_place(&view, 0, Q16(40), Q16(10));
    polygon.vertices[2].position = clip_place(&view, Q16(40), Q16(-1), Q16(10));
    take(&fxl_clipper_near, &polygon, &view, &result);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, result);
    TEST_ASSERT_EQUAL(3, got[0].count);
    TEST_ASSERT_TRUE(got[0].points[0].x < 0 && got[0].points[2].x > WIDTH * 65536);
    take(&fxl_clipper_left, &polygon, &view, &result);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, result);
    TEST_ASSERT_EQUAL(4, got[0].count);
    for (int i = 0; i < got[0].count; i++) {
        TEST_ASSERT_TRUE(got[0].points[i].x >= 0);
    }
    /* As far off as the world reaches, beside the eye: what a screen could not hold. */
    polygon.vertices[2].position = clip_place(&view, Q16(4000), Q16(-1), Q16(0.25));
    for (int which = 0; which < CLIPPERS; which++) {
        int count = take(clippers[which], &polygon, &view, &result);
        TEST_ASSERT_TRUE(count > 0);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < got[i].count; k++) {
                TEST_ASSERT_INT32_WITHIN(3600 * 65536, 0, got[i].points[k].x);
                TEST_ASSERT_INT32_WITHIN(3600 * 65536, 0, got[i].points[k].y);
            }
        }
    }
}

/* Before near, though between the sides: all cut it off there. */
/* clippers 4.4c */
void test_near_is_always_cut(void)
{
    fxl_view view = random_view();
    fxl_clip_result result;
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(&view, 0, 0, view.lens.near_z * 3 / 4);
    polygon.vertices[1].position = clip_place(&view, Q16(0.5), Q16(-0.5), Q16(2));
    polygon.vertices[2].position = clip_place(&view, Q16(-0.5), Q16(-0.5), Q16(2));
    for (int which = 0; which < CLIPPERS; which++) {
        int count = take(clippers[which], &polygon, &view, &result);
        bool fan = clippers[which] == &fxl_clipper_triangles;
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, result);
        TEST_ASSERT_EQUAL(fan ? 2 : 1, count);
        TEST_ASSERT_EQUAL(fan ? 3 : 4, got[0].count);
    }
}

/* 31 or 32 vertices, every second one behind the eye. */
void test_the_capacity_is_never_overrun(void)
{
    fxl_view view = random_view();
    fxl_polygon polygon = {.colour = 3, .count = FXL_POLYGON_CAPACITY};
    for (int i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        polygon.vertices[i].position =
            clip_place(&view, Q16(0.01) * i, 0, i % 2 ? Q16(-1) : Q16(2));
    }
    for (int which = 0; which < CLIPPERS; which++) {
        fxl_clip_result result;
        memset(guarded.guard, 0x5A, GUARD);
        take(clippers[which], &polygon, &view, &result);
        bool fan = clippers[which] == &fxl_clipper_triangles;
        if (clippers[which] != &fxl_clipper_once) { /* which says nothing about such */
            TEST_ASSERT_EQUAL(fan, is_kept(result) || result == FXL_CLIP_OUTSIDE);
            TEST_ASSERT_TRUE(fan || result == FXL_CLIP_CAPACITY);
        }
        TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, guarded.guard, GUARD);
    }
}

/* One vertex a hundredth of a unit inside of near, between two that are outside: off, the
 * rule leaves a sliver; on, nothing. */
void test_the_sliver_rule_is_an_option(void)
{
    fxl_view view = random_view();
    static fxl_clipper_work work;
    static polygon_face face;
    fxl_screen_polygon screen;
    fxl_q16_16 near = view.lens.near_z + view.lens.inset;
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(&view, 0, Q16(0.01), near + Q16(0.01));
    polygon.vertices[1].position = clip_place(&view, Q16(0.01), Q16(-0.01), near - Q16(0.5));
    polygon.vertices[2].position = clip_place(&view, Q16(-0.01), Q16(-0.01), near - Q16(0.5));
    for (int which = 0; which < CLIPPERS; which++) {
        for (int on = 0; on < 2; on++) {
            fxl_clip_stats *account = &guarded.workspace.stats;
            memset(&guarded.workspace, 0, clippers[which]->workspace_size);
            account->sliver = on ? (fxl_q18_46)1 << 40 : 0; /* 1/64 unit */
            polygon_face_set(&face, &polygon, &view, 4);
            face.model_view.clipper_workspace = &guarded.workspace;
            fxl_clip_result result =
                clippers[which]->clip(&face.model_view, &face.face, &work, &screen);
            TEST_ASSERT_EQUAL(!on, is_kept(result));
            TEST_ASSERT_EQUAL_UINT32(on ? 0 : 2, account->intersections);
        }
    }
}

/* The straight corner of a quadrangle makes a triangle of no area, which is left out. The two
 * others are given. */
/* clippers 4.4f */
void test_a_triangle_without_area_is_left_out(void)
{
    fxl_view view;
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    fxl_clip_result result;
    static const fxl_point across[] = {
        {0, Q16(1), 0}, {Q16(1), Q16(1), 0}, {Q16(2), Q16(1), 0}, {Q16(2), 0, 0}, {0, 0, 0}};
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    for (int first = 0; first < 5; first++) {
        fxl_polygon polygon = {.colour = 3, .count = 5};
        for (int i = 0; i < 5; i++) {
            polygon.vertices[i].position = across[(first + i) % 5];
            polygon.vertices[i].position.z = Q16(8);
        }
        const int count = take(&fxl_clipper_triangles, &polygon, &view, &result);
        TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, result);
        /* About any corner but those of the straight side's ends, all three have an area. */
        TEST_ASSERT_EQUAL(first == 0 || first == 2 ? 2 : 3, count);
        int64_t area = 0;
        for (int i = 0; i < count; i++) {
            TEST_ASSERT_TRUE(area_of(&got[i]) != 0);
            area += area_of(&got[i]);
        }
        /* 6 by 3 pixels: 24 pixels of focal length, 8 units away. */
        TEST_ASSERT_TRUE(area == (int64_t)2 * 6 * 3 * 65536 * 65536);
    }
}
