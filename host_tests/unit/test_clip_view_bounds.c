/* SPDX-License-Identifier: MIT */
/* Distances and new vertices of the view against exact arithmetic, over the
 * whole range. */
#include "clip_unit.h"
#include "unit.h"
#include "wide.h"

static fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
static fxl_clip_view_work work;

static fxl_view_point random_point(unsigned bits)
{
    return (fxl_view_point){unit_wide(bits), unit_wide(bits), unit_wide(bits)};
}

static fxl_view_vertex random_vertex(unsigned bits)
{
    return (fxl_view_vertex){random_point(bits)};
}

/* A frustum whose six planes all pass through what so many bits can reach. */
static fxl_view_frustum random_frustum(unsigned bits)
{
    fxl_lens lens = unit_any_lens();
    fxl_view_frustum frustum;
    fxl_view_frustum_from_lens(&lens, &frustum);
    if (bits < 61) {
        frustum.inset = unit_random() % 2 ? 0 : frustum.inset >> (61 - bits);
        frustum.near_z = unit_wide(bits);
        frustum.far_z = unit_wide(bits);
    }
    return frustum;
}

/* 2^30 times the exact distance. */
static wide exact_distance(const fxl_view_frustum *f, int plane, const fxl_view_point *p)
{
    const int64_t one = (int64_t)1 << 30;
    if (plane == FXL_PLANE_NEAR || plane == FXL_PLANE_FAR) {
        return plane == FXL_PLANE_NEAR
                   ? wide_difference(wide_product(p->z, one), wide_product(f->near_z, one))
                   : wide_difference(wide_product(f->far_z, one), wide_product(p->z, one));
    }
    bool sideways = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_RIGHT;
    bool low = plane == FXL_PLANE_LEFT || plane == FXL_PLANE_BOTTOM;
    wide side = wide_product(sideways ? f->x_side : f->y_side, sideways ? p->x : p->y);
    wide along = wide_product(sideways ? f->x_depth : f->y_depth, p->z);
    wide sum = low ? wide_sum(along, side) : wide_difference(along, side);
    return wide_difference(sum, wide_product(f->inset, one));
}

static void expect_distance(const fxl_view_frustum *frustum, int plane, const fxl_view_point *point)
{
    const int64_t one = (int64_t)1 << 30;
    fxl_q18_46 distance = fxl_view_distance(frustum, plane, point);
    wide above =
        wide_difference(exact_distance(frustum, plane, point), wide_product(distance, one));
    int64_t rest;
    TEST_ASSERT_TRUE(wide_narrow(above, &rest));
    TEST_ASSERT_TRUE_MESSAGE(rest >= 0 && rest < one, "not the exact distance, rounded downward");
}

void test_distances_are_exact_but_for_the_last_unit(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        unsigned bits = (unsigned)unit_between(1, 61);
        fxl_view_frustum frustum = random_frustum(bits);
        fxl_view_point point = random_point(bits);
        expect_distance(&frustum, i % FXL_PLANE_COUNT, &point);
    }
}

/* Points next to a side plane: 2^-30 of a unit decides. */
void test_the_sign_is_right_next_to_a_plane(void)
{
    static const int sides[] = {FXL_PLANE_LEFT, FXL_PLANE_RIGHT, FXL_PLANE_BOTTOM, FXL_PLANE_TOP};
    int exact_zeros = 0, outside = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_view_frustum frustum = random_frustum(40);
        int plane = sides[i % 4];
        bool sideways = i % 4 < 2;
        fxl_q2_30 side = sideways ? frustum.x_side : frustum.y_side;
        fxl_q2_30 depth = sideways ? frustum.x_depth : frustum.y_depth;
        int64_t scale = unit_wide(30), nudge = unit_between(-1, 1);
        /* side across + depth along = 0 for (-depth, side); up to 2^60. */
        int64_t across = -depth * scale + nudge, along = side * scale;
        across = i % 2 ? -across : across;
        fxl_view_point point = {across, across, along};
        frustum.inset = 0;
        expect_distance(&frustum, plane, &point);
        fxl_q18_46 distance = fxl_view_distance(&frustum, plane, &point);
        TEST_ASSERT_EQUAL(nudge < 0, distance < 0);
        TEST_ASSERT_TRUE(distance >= -1 && distance <= 1);
        exact_zeros += nudge == 0;
        outside += distance < 0;
    }
    TEST_ASSERT_TRUE(exact_zeros > UNIT_REPEAT / 6 && outside > UNIT_REPEAT / 6);
}

/* Fractions low / whole .. high / whole of an edge. */
typedef struct {
    int64_t low, high, whole;
} fractions;

/* Of which fraction of the way from a to b a coordinate may be: within a unit. */
static fractions fractions_of(int64_t from, int64_t to, int64_t at)
{
    int64_t way = to - from, part = at - from;
    if (way < 0) {
        way = -way;
        part = -part;
    }
    return (fractions){part - 1, part + 1, way};
}

/* On the edge from a to b: all coordinates at one fraction, 0..1. */
static bool on_edge(const fxl_view_vertex *a, const fxl_view_vertex *b, const fxl_view_vertex *v)
{
    const fractions all[] = {fractions_of(a->position.x, b->position.x, v->position.x),
                             fractions_of(a->position.y, b->position.y, v->position.y),
                             fractions_of(a->position.z, b->position.z, v->position.z),
                             {0, 1, 1}};
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 4; k++) {
            if (wide_compare(wide_product(all[i].low, all[k].whole),
                             wide_product(all[k].high, all[i].whole)) > 0) {
                return false;
            }
        }
    }
    return true;
}

/* Every vertex of a cut is one of before, inside, or a crossing within its
 * bounds. Answers how many crossings. */
static int expect_bounds(const fxl_view_polygon *in, const fxl_view_frustum *frustum, int plane,
                         const fxl_view_polygon *out)
{
    int crossings = 0;
    for (int k = 0; k < out->count; k++) {
        const fxl_view_vertex *v = &out->vertices[k];
        fxl_q18_46 distance = fxl_view_distance(frustum, plane, &v->position);
        if (plane_has_vertex(in->vertices, in->count, sizeof *v, v)) {
            TEST_ASSERT_TRUE(distance >= 0);
            continue;
        }
        bool found = false;
        for (int e = 0; e < in->count && !found; e++) {
            found = on_edge(&in->vertices[e], &in->vertices[(e + 1) % in->count], v);
        }
        TEST_ASSERT_TRUE_MESSAGE(found, "a vertex off every edge");
        TEST_ASSERT_TRUE_MESSAGE(distance >= -3 && distance <= 3, "off the plane");
        crossings++;
    }
    return crossings;
}

static fxl_view_polygon random_triangle(unsigned bits)
{
    fxl_view_polygon polygon;
    memset(&polygon, 0, sizeof polygon);
    polygon.count = 3;
    for (int k = 0; k < 3; k++) {
        polygon.vertices[k] = random_vertex(bits);
    }
    return polygon;
}

/* SPEC 4.7i, accuracy 1.1q */
void test_a_new_vertex_is_within_its_bounds(void)
{
    int crossings = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        unsigned bits = i % 2 ? 61 : (unsigned)unit_between(3, 60);
        fxl_view_frustum frustum = random_frustum(bits);
        fxl_view_polygon polygon = random_triangle(bits), out;
        int plane = i / 2 % FXL_PLANE_COUNT;
        if (fxl_clip_view_to_plane(&polygon, &frustum, plane, &out, distances) == FXL_CLIP_CUT) {
            crossings += expect_bounds(&polygon, &frustum, plane, &out);
        }
    }
    TEST_ASSERT_TRUE_MESSAGE(crossings > UNIT_REPEAT / 2, "too few edges were cut");
}

/* The two neighbours walk the edge a-b in opposite directions; the vertex that
 * neither had before must be one and the same. */
void test_neighbours_get_the_same_vertex(void)
{
    int cut = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        unsigned bits = i % 2 ? 61 : (unsigned)unit_between(8, 60);
        int plane = i / 2 % FXL_PLANE_COUNT;
        fxl_view_frustum frustum = random_frustum(bits);
        fxl_view_polygon first = random_triangle(bits), second = random_triangle(bits), outs[2];
        fxl_view_vertex a = first.vertices[0], b = first.vertices[1];
        second.vertices[0] = b;
        second.vertices[1] = a;
        fxl_q18_46 at_a = fxl_view_distance(&frustum, plane, &a.position);
        fxl_q18_46 at_b = fxl_view_distance(&frustum, plane, &b.position);
        if ((at_a < 0) == (at_b < 0) || at_a == 0 || at_b == 0 ||
            fxl_clip_view_to_plane(&first, &frustum, plane, &outs[0], distances) != FXL_CLIP_CUT ||
            fxl_clip_view_to_plane(&second, &frustum, plane, &outs[1], distances) != FXL_CLIP_CUT) {
            continue;
        }
        EXPECT_SHARED_CROSSING(outs, a, b, at_a > 0);
        cut++;
    }
    TEST_ASSERT_TRUE(cut > UNIT_REPEAT / 4);
}

/* How far off the screen's border, half units of 1/65536 pixel from the middle, a plane
 * may stand whose two components err by a unit of 2^-30, and a unit for the
 * projection. */
static int32_t off_screen(int32_t half, fxl_q2_30 side, fxl_q2_30 depth)
{
    return 1 + (int32_t)(half * (1.0 / side + 1.0 / depth));
}

/* What is left of a polygon lies in the frustum and projects onto the screen. */
static void expect_on_screen(const fxl_lens *lens, const fxl_view_frustum *frustum,
                             const fxl_view_polygon *polygon)
{
    int32_t half_width = lens->width * 32768, half_height = lens->height * 32768;
    int32_t off_x = off_screen(half_width, frustum->x_side, frustum->x_depth);
    int32_t off_y = off_screen(half_height, frustum->y_side, frustum->y_depth);
    /* Without an inset too: no centre of a pixel lies there, and no coordinate leaves the
     * range of the scan between two chains. */
    TEST_ASSERT_TRUE(off_x < 128 && off_y < 128);
    for (int i = 0; i < polygon->count; i++) {
        const fxl_view_point *point = &polygon->vertices[i].position;
        fxl_screen_point screen;
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            TEST_ASSERT_TRUE(fxl_view_distance(frustum, plane, point) >= -6);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_project_point(lens, point, &screen));
        TEST_ASSERT_INT32_WITHIN(half_width + off_x, half_width, screen.x);
        TEST_ASSERT_INT32_WITHIN(half_height + off_y, half_height, screen.y);
    }
}

/* A coordinate whose mirror image in the eye is in range, with 9 to spare. */
static fxl_q16_16 opposite_in_range(fxl_q16_16 eye)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_q16_16 workspace = end - (eye < 0 ? -eye : eye);
    return workspace > 9 ? eye + unit_between(9 - workspace, workspace - 9) : eye;
}

static fxl_q16_16 within_range(fxl_q16_16 value)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    return value > end ? end : value < -end ? -end : value;
}

/* From world to screen at the ends of the range: the eye at one end of it, and
 * vertices at any, or an edge that passes the eye within the width of a hair. */
static fxl_polygon far_polygon(const fxl_point *eye)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_polygon polygon = {.colour = 1, .count = 3};
    for (int i = 0; i < 3; i++) {
        polygon.vertices[i].position = unit_point(end);
    }
    uint32_t kind = unit_random() % 3;
    if (kind == 0) { /* corners of the world */
        for (int i = 0; i < 3; i++) {
            uint32_t corner = unit_random();
            polygon.vertices[i].position = (fxl_point){
                corner & 1 ? end : -end, corner & 2 ? end : -end, corner & 4 ? end : -end};
        }
    } else if (kind == 1) { /* an edge through the eye, but for a few units */
        fxl_point *a = &polygon.vertices[0].position, *b = &polygon.vertices[1].position;
        a->x = opposite_in_range(eye->x);
        a->y = opposite_in_range(eye->y);
        a->z = opposite_in_range(eye->z);
        fxl_point off = unit_point(9);
        *b = (fxl_point){within_range(2 * eye->x - a->x + off.x),
                         within_range(2 * eye->y - a->y + off.y),
                         within_range(2 * eye->z - a->z + off.z)};
    }
    return polygon;
}

void test_from_any_place_to_the_screen(void)
{
    int cut = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        fxl_camera camera;
        fxl_view_frustum frustum;
        fxl_lens lens = unit_any_lens();
        if (unit_random() % 4 == 0) {
            lens.inset = 0;
            lens.near_z = FXL_NEAR_MIN;
        }
        if (unit_random() % 2 == 0) {
            pose.position = unit_point(Q16(10));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        fxl_view_frustum_from_lens(&lens, &frustum);
        fxl_polygon polygon = far_polygon(&pose.position);
        static fxl_view_polygon view;
        const fxl_view_polygon *result;
        clip_see_polygon(&camera, &polygon, &view);
        fxl_clip_result outcome =
            fxl_clip_view_by_planes(&view, &frustum, FXL_PLANES_ALL, &work, NULL, &result);
        TEST_ASSERT_EQUAL(outcome == FXL_CLIP_INSIDE || outcome == FXL_CLIP_CUT, result != NULL);
        TEST_ASSERT_TRUE(outcome != FXL_CLIP_CAPACITY);
        if (result) {
            expect_on_screen(&lens, &frustum, result);
            cut += outcome == FXL_CLIP_CUT;
        }
    }
    TEST_ASSERT_TRUE_MESSAGE(cut > UNIT_REPEAT / 20, "too few were cut");
}
