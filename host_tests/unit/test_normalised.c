/* SPDX-License-Identifier: MIT */
/* The normalised frustum: its matrix, its planes and what it cuts. */
#include "../../lib/clip/intersection.h"
#include "clip_unit.h"
#include "study/clip_polygon.h"

/* One room for all tests: some boards have 16 KB. */
static struct {
    fxl_clip_workspace workspace;
    uint8_t guard[64];
} guarded;
static fxl_clip_workspace *const workspace = &guarded.workspace;

static fxl_camera straight(void)
{
    fxl_camera camera;
    fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    return camera;
}

/* 90 degrees both ways, near 1/16, far 1000, without an inset. */
static fxl_normalised square(void)
{
    fxl_camera camera = straight();
    fxl_lens lens = unit_lens(64, 64);
    fxl_normalised frustum;
    lens.inset = 0;
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    return frustum;
}

static fxl_clip_result clip(const fxl_varying_polygon *polygon, const fxl_varying_polygon **result)
{
    fxl_normalised frustum = square();
    workspace->stats = (fxl_clip_stats){0, 0, 0};
    return fxl_clip_normalised(polygon, &frustum, workspace, result);
}

/* With factors of 1 and axes of the world, a point is where it lies from the eye. */
void test_a_point_is_seen_from_the_eye(void)
{
    fxl_normalised frustum = square();
    frustum.eye = (fxl_point){Q16(3), Q16(-5), Q16(7)};
    for (int i = 0; i < 100; i++) {
        const fxl_point point = unit_point(FXL_COORDINATE_MAX);
        const int64_t unit = (int64_t)1 << 30;
        fxl_view_point seen = {0, 0, 0};
        fxl_point from_eye;
        fxl_subtract(&point, &frustum.eye, &from_eye);
        fxl_normalised_from_eye(&frustum, &from_eye, &seen);
        TEST_ASSERT_TRUE(seen.x == ((int64_t)point.x - Q16(3)) * unit);
        TEST_ASSERT_TRUE(seen.y == ((int64_t)point.y + Q16(5)) * unit);
        TEST_ASSERT_TRUE(seen.z == ((int64_t)point.z - Q16(7)) * unit);
    }
}

void test_ninety_degrees_change_nothing(void)
{
    fxl_camera camera = straight();
    fxl_normalised frustum = square();
    TEST_ASSERT_EQUAL_MEMORY(&camera.axes.right, &frustum.x.direction, sizeof camera.axes.right);
    TEST_ASSERT_EQUAL_MEMORY(&camera.axes.up, &frustum.y.direction, sizeof camera.axes.up);
    TEST_ASSERT_EQUAL_MEMORY(&camera.axes.forward, &frustum.z.direction,
                             sizeof camera.axes.forward);
    TEST_ASSERT_EQUAL(0, frustum.x.shift + frustum.y.shift + frustum.z.shift);
    TEST_ASSERT_TRUE(frustum.near_z == V(1) / 16 && frustum.far_z == V(1000));
    TEST_ASSERT_TRUE(frustum.x_inset == 0 && frustum.y_inset == 0);
}

static void expect_row(const fxl_direction *axis, const fxl_normalised_row *row, double factor)
{
    double scale = factor * (double)((int64_t)1 << row->shift);
    TEST_ASSERT_TRUE(scale > 0.499999 && scale < 1.000001);
    TEST_ASSERT_NEAR(row->direction.x, axis->x * scale, 1.1);
    TEST_ASSERT_NEAR(row->direction.y, axis->y * scale, 1.1);
    TEST_ASSERT_NEAR(row->direction.z, axis->z * scale, 1.1);
}

/* Any lens and pose: the factors of the definition. */
/* clippers 2.2b, 2.2d, 2.2k */
void test_rows_are_the_definition(void)
{
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        fxl_pose pose = unit_pose();
        fxl_lens lens = unit_any_lens();
        fxl_camera camera;
        fxl_normalised frustum;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        fxl_normalised_from_camera(&camera, &lens, &frustum);
        TEST_ASSERT_EQUAL_MEMORY(&pose.position, &frustum.eye, sizeof frustum.eye);
        double x = lens.focal / (lens.width * 32768.0), y = lens.focal / (lens.height * 32768.0);
        double largest = x > y ? x : y;
        largest = largest > 1 ? exp2(ceil(log2(largest))) : 1;
        expect_row(&camera.axes.right, &frustum.x, x / largest);
        expect_row(&camera.axes.up, &frustum.y, y / largest);
        expect_row(&camera.axes.forward, &frustum.z, 1 / largest);
        double near = (lens.near_z + lens.inset) * (double)(1 << 30) / largest;
        double far = ((double)lens.far_z - lens.inset) * (double)(1 << 30) / largest;
        TEST_ASSERT_NEAR(frustum.near_z, near, 0.51 + near / (1 << 30));
        TEST_ASSERT_NEAR(frustum.far_z, far, 0.51 + far / (1 << 30));
    }
}

/* Factors of few bits are exact: 3/4 and 1/2 for a focal length of 3/4 of the screen's width. */
/* clippers 2.2d */
void test_simple_factors_are_exact(void)
{
    const fxl_camera camera = straight();
    const fxl_direction right = {FXL_Q2_30_ONE / 4 * 3, 0, 0}, up = {0, FXL_Q2_30_ONE / 4 * 3, 0};
    const fxl_direction forward = {0, 0, FXL_Q2_30_ONE};
    fxl_lens lens = unit_lens(64, 64);
    fxl_normalised frustum;
    lens.focal = Q16(48);
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    TEST_ASSERT_EQUAL_MEMORY(&right, &frustum.x.direction, sizeof right);
    TEST_ASSERT_EQUAL_MEMORY(&up, &frustum.y.direction, sizeof up);
    TEST_ASSERT_EQUAL_MEMORY(&forward, &frustum.z.direction, sizeof forward);
    TEST_ASSERT_EQUAL(0, frustum.x.shift);
    TEST_ASSERT_EQUAL(0, frustum.y.shift);
    TEST_ASSERT_EQUAL(1, frustum.z.shift);
    /* Turned round, right and forward are negative: no rounding moves them either. */
    const fxl_pose behind = {{0, 0, 0}, 2 * FXL_ANGLE_QUARTER, 0, 0};
    fxl_camera turned;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&behind, &turned));
    fxl_normalised_from_camera(&turned, &lens, &frustum);
    TEST_ASSERT_EQUAL_INT32(-right.x, frustum.x.direction.x);
    TEST_ASSERT_EQUAL_INT32(up.y, frustum.y.direction.y);
    TEST_ASSERT_EQUAL_INT32(-forward.z, frustum.z.direction.z);
    lens.focal = Q16(24); /* 3/4 and 1: nothing is made smaller but across */
    fxl_normalised_from_camera(&camera, &lens, &frustum);
    TEST_ASSERT_EQUAL_MEMORY(&right, &frustum.x.direction, sizeof right);
    TEST_ASSERT_EQUAL_MEMORY(&up, &frustum.y.direction, sizeof up);
    TEST_ASSERT_EQUAL_MEMORY(&forward, &frustum.z.direction, sizeof forward);
    TEST_ASSERT_EQUAL(0, frustum.x.shift + frustum.y.shift + frustum.z.shift);
}

/* A point that lies the inset inside the plane by the unit vectors of the view. */
/* clippers 2.2h */
void test_insets_are_distances_along_the_normal(void)
{
    for (int i = 0; i < UNIT_REPEAT / 50; i++) {
        fxl_camera camera = straight();
        fxl_lens lens = unit_any_lens();
        fxl_normalised frustum;
        fxl_view_frustum sides;
        if (lens.height > 2 * lens.width || lens.width > 4 * lens.height) {
            continue;
        }
        fxl_normalised_from_camera(&camera, &lens, &frustum);
        fxl_view_frustum_from_lens(&lens, &sides);
        double z = frustum.z.direction.z / 1073741824.0 / (double)(1 << frustum.z.shift);
        double inset = (double)lens.inset * (1 << 30);
        double x = inset * z / (sides.x_depth / 1073741824.0);
        double y = inset * z / (sides.y_depth / 1073741824.0);
        TEST_ASSERT_NEAR(frustum.x_inset, x, 1 + x / (1 << 25));
        TEST_ASSERT_NEAR(frustum.y_inset, y, 1 + y / (1 << 25));
    }
}

/* Codes by compares are the signs of the distances, to the last unit and at the
 * range's ends. */
/* clippers 2.2f */
void test_codes_are_the_signs_of_the_distances(void)
{
    const int64_t end = ((int64_t)1 << 61) - 1;
    uint32_t seen = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_normalised frustum = square();
        unsigned bits = (unsigned)unit_between(2, 61);
        frustum.x_inset = unit_random() % 2 ? 0 : (int64_t)unit_random() << 14;
        frustum.near_z = unit_wide(bits);
        frustum.far_z = unit_wide(bits);
        fxl_view_point point = {unit_wide(bits), unit_wide(bits), unit_wide(bits)};
        if (i % 4 == 0) { /* next to a side */
            point.x = point.z + unit_between(-1, 1);
            point.y = unit_between(-1, 1) - point.z;
            point.x = point.x > end ? end : point.x;
        }
        uint32_t code = fxl_normalised_code(&frustum, &point);
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            bool outside = fxl_normalised_distance(&frustum, plane, &point) < 0;
            TEST_ASSERT_EQUAL(outside, code >> plane & 1u);
        }
        seen |= code;
    }
    TEST_ASSERT_EQUAL((1 << FXL_PLANE_COUNT) - 1, seen);
}

/* The planes as the header states them, term by term. */
void test_distances_are_the_definition(void)
{
    const fxl_normalised frustum = {
        .x_inset = 100, .y_inset = 3000, .near_z = 50000, .far_z = 700000};
    const fxl_view_point at = {11, 1300, 17000};
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_LEFT, &at) == 17000 + 11 - 100);
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_RIGHT, &at) == 17000 - 11 - 100);
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_BOTTOM, &at) ==
                     17000 + 1300 - 3000);
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_TOP, &at) == 17000 - 1300 - 3000);
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_NEAR, &at) == 17000 - 50000);
    TEST_ASSERT_TRUE(fxl_normalised_distance(&frustum, FXL_PLANE_FAR, &at) == 700000 - 17000);
}

void test_inside_is_the_input_itself(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(-5, -5, 10, -5, 5, 10, 5, 5, 10, 5, -5, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&polygon, &result));
    TEST_ASSERT_EQUAL_PTR(&polygon, result);
    polygon = SHAPE(-10, -10, 10, -10, 10, 10, 10, 10, 10, 10, -10, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip(&polygon, &result)); /* on the planes */
    TEST_ASSERT_EQUAL(0, workspace->stats.intersections);
}

void test_outside_one_plane_is_rejected_by_codes(void)
{
    const fxl_varying_polygon *result;
    static const int numbers[6][9] = {
        {-50, -5, 10, -50, 5, 10, -11, 0, 10}, {50, -5, 10, 50, 5, 10, 11, 0, 10},
        {-5, -50, 10, 5, -50, 10, 0, -11, 10}, {-5, 50, 10, 5, 50, 10, 0, 11, 10},
        {-5, -5, -10, 5, -5, -10, 0, 5, 0},    {-5, -5, 1001, 5, -5, 1001, 0, 5, 2000}};
    for (int i = 0; i < 6; i++) {
        fxl_varying_polygon polygon = clip_shape(numbers[i], 3);
        TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE, clip(&polygon, &result));
        TEST_ASSERT_NULL(result);
        TEST_ASSERT_EQUAL(0, workspace->stats.intersections);
    }
}

/* A square's right half hangs out; what rides along is halved as well. */
void test_a_square_is_halved(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(0, -5, 10, 0, 5, 10, 20, 5, 10, 20, -5, 10);
    fxl_varying_polygon expected = SHAPE(0, -5, 10, 0, 5, 10, 10, 5, 10, 10, -5, 10);
    expected.vertices[2].carried[1] = Q16(1.5);
    expected.vertices[3].carried[1] = Q16(1.5);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_TRUE(clip_same(&expected, result));
    TEST_ASSERT_EQUAL(2, workspace->stats.intersections);
}

/* A wall about all of the screen becomes the screen. */
void test_a_wall_becomes_the_screen(void)
{
    const fxl_varying_polygon *result;
    fxl_varying_polygon polygon = SHAPE(-30, -30, 10, -30, 30, 10, 30, 30, 10, 30, -30, 10);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip(&polygon, &result));
    TEST_ASSERT_EQUAL(4, result->count);
    for (int i = 0; i < 4; i++) {
        const fxl_view_point *at = &result->vertices[i].position;
        TEST_ASSERT_NEAR(at->x < 0 ? -at->x : at->x, V(10), 3);
        TEST_ASSERT_NEAR(at->y < 0 ? -at->y : at->y, V(10), 3);
        TEST_ASSERT_TRUE(at->z == V(10));
    }
}

/* Touching a plane from outside leaves a point or a line. */
/* clippers 1.3 */
void test_what_is_left_of_a_touch_is_degenerate(void)
{
    const fxl_varying_polygon *result;
    static const int numbers[2][9] = {{10, 0, 10, 20, 5, 10, 20, -5, 10},
                                      {10, -5, 10, 10, 5, 10, 20, 0, 10}};
    for (int i = 0; i < 2; i++) {
        fxl_varying_polygon polygon = clip_shape(numbers[i], 3);
        TEST_ASSERT_EQUAL(FXL_CLIP_DEGENERATE, clip(&polygon, &result));
        TEST_ASSERT_NULL(result);
    }
}

void test_the_capacity_is_never_overrun(void)
{
    const fxl_varying_polygon *result;
    memset(guarded.guard, 0x5A, sizeof guarded.guard);
    fxl_normalised frustum = square();
    int refused = 0;
    for (uint8_t count = 4; count <= FXL_POLYGON_CAPACITY; count++) {
        fxl_varying_polygon polygon = clip_saw(count, 50);
        guarded.workspace.stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_result cut = fxl_clip_normalised(&polygon, &frustum, &guarded.workspace, &result);
        TEST_ASSERT_EQUAL(cut == FXL_CLIP_CUT, result != NULL);
        refused += cut == FXL_CLIP_CAPACITY;
    }
    TEST_ASSERT_TRUE(refused > 0);
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, guarded.guard, sizeof guarded.guard);
}

/* The sliver rule: a corner that pokes in by less than the rule minds. */
/* clippers 3.3a */
void test_a_sliver_is_refused_where_asked(void)
{
    const fxl_varying_polygon *result;
    fxl_normalised frustum = square();
    /* Second vertex one unit inside of the right plane, between two outside. */
    fxl_varying_polygon polygon = SHAPE(20, 5, 10, 9, 0, 10, 20, -5, 10);
    workspace->stats = (fxl_clip_stats){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_normalised(&polygon, &frustum, workspace, &result));
    workspace->stats = (fxl_clip_stats){V(2), 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE,
                      fxl_clip_normalised(&polygon, &frustum, workspace, &result));
    workspace->stats.sliver = V(1); /* not less than it minds */
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_normalised(&polygon, &frustum, workspace, &result));
}

/* The sliver rule for any ring of distances, by its definition: after a vertex that counts as
 * outside, one that is inside by less than the sliver does too, all the way round. */
/* clippers 3.3b */
void test_the_sliver_rule_goes_all_the_way_round(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const uint32_t count = (uint32_t)unit_between(1, i % 8 ? 6 : FXL_POLYGON_CAPACITY);
        const fxl_q18_46 sliver = unit_between(0, 3);
        fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
        bool inside[FXL_POLYGON_CAPACITY];
        for (uint32_t k = 0; k < count; k++) {
            distances[k] = unit_between(i % 3 ? -1 : 0, i % 2 ? 3 : 1);
            inside[k] = distances[k] >= 0;
        }
        for (uint32_t k = 0; k < 2 * count; k++) {
            const uint32_t at = (k + 1) % count;
            inside[at] = inside[at] && (inside[k % count] || distances[at] >= sliver);
        }
        const uint32_t bits = fxl_inside_bits(distances, count, sliver);
        for (uint32_t k = 0; k < 32; k++) {
            TEST_ASSERT_EQUAL(k < count && inside[k], bits >> k & 1u);
        }
    }
}

/* Barely in after being out counts as out, and stands for the crossing; barely in
 * after being in counts as in. */
/* clippers 3.3b */
void test_a_barely_inside_vertex_stands_for_the_crossing(void)
{
    const fxl_varying_polygon *result;
    fxl_normalised frustum = square();
    fxl_varying_polygon polygon = SHAPE(20, 5, 10, 9, 5, 10, 0, 0, 10, 9, -5, 10);
    fxl_varying_polygon expected = SHAPE(9, 5, 10, 0, 0, 10, 9, -5, 10, 10, -4, 10);
    workspace->stats = (fxl_clip_stats){V(2), 0, 0};
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, fxl_clip_normalised(&polygon, &frustum, workspace, &result));
    TEST_ASSERT_EQUAL(4, result->count);
    TEST_ASSERT_EQUAL(1, workspace->stats.intersections);
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_MEMORY(&expected.vertices[i].position, &result->vertices[i].position,
                                 sizeof(fxl_view_point));
    }
    TEST_ASSERT_NEAR(result->vertices[3].position.x, V(10), 3);
}

/* No vertex leaves the box about the input, what it carries neither, and each lies
 * on the frustum or inside: 3 units for its own plane, 3 more for each later one,
 * which moves along edges that are as far off. */
static void expect_held(const fxl_normalised *frustum, const fxl_varying_polygon *in,
                        const fxl_varying_polygon *out)
{
    for (int i = 0; i < out->count; i++) {
        const fxl_varying_vertex *vertex = &out->vertices[i];
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            TEST_ASSERT_TRUE(fxl_normalised_distance(frustum, plane, &vertex->position) >= -9);
        }
        for (int k = 0; k < in->carried; k++) {
            fxl_q16_16 low = INT32_MAX, high = INT32_MIN;
            for (int n = 0; n < in->count; n++) {
                low = in->vertices[n].carried[k] < low ? in->vertices[n].carried[k] : low;
                high = in->vertices[n].carried[k] > high ? in->vertices[n].carried[k] : high;
            }
            TEST_ASSERT_TRUE(vertex->carried[k] >= low && vertex->carried[k] <= high);
        }
    }
}

void test_results_lie_within_the_frustum(void)
{
    int cuts = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        fxl_camera camera = straight();
        fxl_lens lens = unit_any_lens();
        fxl_normalised frustum;
        const fxl_varying_polygon *result;
        fxl_normalised_from_camera(&camera, &lens, &frustum);
        fxl_varying_polygon polygon = clip_random_shape((unsigned)unit_between(40, 61));
        workspace->stats = (fxl_clip_stats){0, 0, 0};
        fxl_clip_result cut = fxl_clip_normalised(&polygon, &frustum, workspace, &result);
        TEST_ASSERT_TRUE(cut != FXL_CLIP_CAPACITY);
        if (cut == FXL_CLIP_CUT) {
            expect_held(&frustum, &polygon, result);
            cuts++;
        }
    }
    TEST_ASSERT_TRUE(cuts > UNIT_REPEAT / 100);
}

void test_projection_spans_the_screen(void)
{
    fxl_normalised frustum = square();
    fxl_screen_point at;
    fxl_view_point point = {V(-10), V(10), V(10)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_normalised_project(&frustum, &point, &at));
    TEST_ASSERT_TRUE(at.x == 0 && at.y == 0);
    point = (fxl_view_point){V(5), V(-10), V(10)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_normalised_project(&frustum, &point, &at));
    TEST_ASSERT_TRUE(at.x == Q16(48) && at.y == Q16(64));
    point = (fxl_view_point){0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_normalised_project(&frustum, &point, &at));
    point = (fxl_view_point){((int64_t)1 << 61) - 1, 0, 1};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_normalised_project(&frustum, &point, &at));
    point = (fxl_view_point){0, 1 - ((int64_t)1 << 61), 1};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_normalised_project(&frustum, &point, &at));
    /* 32 pixels and 32 x / z are 4095 where x is 4063 for a depth of 32. */
    point = (fxl_view_point){V(4063), V(-4063), V(32)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_normalised_project(&frustum, &point, &at));
    TEST_ASSERT_TRUE(at.x == FXL_SCREEN_COORDINATE_MAX && at.y == FXL_SCREEN_COORDINATE_MAX);
    point.x = V(4063) + V(1) / 256;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_normalised_project(&frustum, &point, &at));
    point = (fxl_view_point){V(4063), V(-4063) - V(1) / 256, V(32)};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_normalised_project(&frustum, &point, &at));
    point = (fxl_view_point){1, -1, 1}; /* depths below 31 bits */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_normalised_project(&frustum, &point, &at));
    TEST_ASSERT_TRUE(at.x == Q16(64) && at.y == Q16(64));
}
