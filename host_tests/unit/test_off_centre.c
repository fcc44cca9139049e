/* SPDX-License-Identifier: MIT */
/* Lenses whose centre is not the middle of the screen, and their views. */
#include <math.h>

#include "unit.h"

static fxl_lens centred_lens(uint16_t width, uint16_t height)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_lens_from_fov(width, height, FXL_ANGLE_QUARTER, Q16(0.25), Q16(500), 0, &lens));
    return lens;
}

/* Any lens with any centre in range; half of them at an end of the range. */
static fxl_lens any_off_centre_lens(void)
{
    for (;;) {
        fxl_lens lens = unit_any_lens();
        lens.inset = 0;
        const int32_t x = lens.width * 98304, y = lens.height * 98304;
        const int32_t most = 4 * lens.focal;
        const int32_t end_x = x < most ? x : most, end_y = y < most ? y : most;
        const int32_t offset_x = unit_random() % 4 ? unit_between(-end_x, end_x) : end_x;
        const int32_t offset_y = unit_random() % 4 ? unit_between(-end_y, end_y) : -end_y;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, lens.width * 32768 + offset_x,
                                                      lens.height * 32768 + offset_y));
        if (lens.off_centre != NULL) {
            return lens;
        }
    }
}

/* Member by member: there may be bytes between them. */
static void expect_lens(const fxl_lens *expected, const fxl_lens *lens)
{
    TEST_ASSERT_EQUAL(expected->width, lens->width);
    TEST_ASSERT_EQUAL(expected->height, lens->height);
    TEST_ASSERT_EQUAL_INT32(expected->focal, lens->focal);
    TEST_ASSERT_EQUAL_INT32(expected->near_z, lens->near_z);
    TEST_ASSERT_EQUAL_INT32(expected->far_z, lens->far_z);
    TEST_ASSERT_EQUAL_INT32(expected->inset, lens->inset);
    TEST_ASSERT_EQUAL_INT32(expected->centre_x, lens->centre_x);
    TEST_ASSERT_EQUAL_INT32(expected->centre_y, lens->centre_y);
    TEST_ASSERT_EQUAL_PTR(expected->off_centre, lens->off_centre);
}

static fxl_status try_centre(const fxl_lens *lens, int64_t x, int64_t y)
{
    fxl_lens moved = *lens;
    const fxl_status status = fxl_lens_set_centre(&moved, (fxl_q16_16)x, (fxl_q16_16)y);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(lens, &moved, sizeof moved);
    }
    TEST_ASSERT_TRUE(fxl_lens_is_valid(&moved));
    return status;
}

/* SPEC 3.1l */
void test_a_centre_is_taken_within_its_range(void)
{
    const fxl_lens lens = centred_lens(320, 240); /* focal 160: four of them are 640 pixels */
    TEST_ASSERT_EQUAL(FXL_OK, try_centre(&lens, Q16(0), Q16(240)));
    TEST_ASSERT_EQUAL(FXL_OK, try_centre(&lens, Q16(640), Q16(480)));
    TEST_ASSERT_EQUAL(FXL_OK, try_centre(&lens, Q16(-320), Q16(-240)));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(640) + 1, Q16(480)));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(640), Q16(480) + 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(-320) - 1, Q16(0)));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(0), Q16(-240) - 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, INT32_MIN, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, 0, INT32_MAX));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lens_set_centre(NULL, 0, 0));
}

/* SPEC 3.1l */
void test_a_centre_is_at_most_four_focal_lengths_away(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(320, 240, FXL_FOV_MAX, Q16(1), Q16(9), 0, &lens));
    const int32_t most = 4 * lens.focal; /* 171 pixels */
    TEST_ASSERT_EQUAL(FXL_OK, try_centre(&lens, Q16(160) + most, Q16(120) - most));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(160) + most + 1, Q16(120)));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(160), Q16(120) - most - 1));
}

void test_an_inset_and_a_moved_centre_exclude_each_other(void)
{
    const fxl_lens lens = unit_lens(320, 240);
    TEST_ASSERT_TRUE(lens.inset > 0);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_centre(&lens, Q16(161), Q16(120)));
    TEST_ASSERT_EQUAL(FXL_OK, try_centre(&lens, Q16(160), Q16(120)));
}

void test_the_middle_is_a_centred_lens(void)
{
    const fxl_lens lens = centred_lens(33, 21);
    fxl_lens moved = lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&moved, Q16(16.5) + 1, Q16(10.5)));
    TEST_ASSERT_NOT_NULL(moved.off_centre);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&moved, Q16(16.5), Q16(10.5)));
    expect_lens(&lens, &moved);
}

void test_a_centre_that_no_function_set_is_not_valid(void)
{
    fxl_lens lens = centred_lens(320, 240);
    lens.centre_x += 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
    lens.centre_x -= 1;
    lens.centre_y -= 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
    lens = centred_lens(320, 240);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, 0, 0));
    lens.inset = 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
    lens.inset = 0;
    lens.centre_y = Q16(240 + 240) + 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
}

/* --- parts and windows ------------------------------------------------------------------ */

void test_a_part_keeps_the_perspective(void)
{
    const fxl_lens whole = centred_lens(320, 240);
    fxl_lens part, again;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&whole, 200, -10, 100, 90, &part));
    TEST_ASSERT_EQUAL(100, part.width);
    TEST_ASSERT_EQUAL(90, part.height);
    TEST_ASSERT_EQUAL_INT32(whole.focal, part.focal);
    TEST_ASSERT_EQUAL_INT32(whole.near_z, part.near_z);
    TEST_ASSERT_EQUAL_INT32(whole.far_z, part.far_z);
    TEST_ASSERT_EQUAL_INT32(Q16(-40), part.centre_x);
    TEST_ASSERT_EQUAL_INT32(Q16(130), part.centre_y);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&part, -200, 10, 320, 0, &again));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&part, -200, 10, 320, 240, &again));
    expect_lens(&whole, &again);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&whole, 160, 120, 160, 120, &part));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&part, 0, 0, 100, 100, &part));
    TEST_ASSERT_EQUAL(100, part.width);
}

void test_parts_out_of_range_are_refused(void)
{
    const fxl_lens whole = centred_lens(320, 240);
    fxl_lens part, before;
    memset(&part, 0x5A, sizeof part);
    before = part;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lens_of_part(NULL, 0, 0, 9, 9, &part));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lens_of_part(&whole, 0, 0, 9, 9, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, 0, 0, 0, 9, &part));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, 0, 0, 9, 0, &part));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, 0, 0, UINT16_MAX, 9, &part));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, INT16_MIN, 0, 99, 99, &part));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, 0, INT16_MAX, 99, 99, &part));
    /* 160 / 20 is 8 widths. */
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_of_part(&whole, 150, 110, 20, 20, &part));
    TEST_ASSERT_EQUAL_MEMORY(&before, &part, sizeof part);
}

void test_a_window_is_a_lens(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_window(300, Q16(-1), Q16(2), Q16(-1), Q16(0.5), Q16(2),
                                                   Q16(90), &lens));
    TEST_ASSERT_EQUAL(300, lens.width);
    TEST_ASSERT_EQUAL(150, lens.height);
    TEST_ASSERT_EQUAL_INT32(Q16(200), lens.focal);
    TEST_ASSERT_EQUAL_INT32(Q16(100), lens.centre_x);
    TEST_ASSERT_EQUAL_INT32(Q16(50), lens.centre_y);
    TEST_ASSERT_EQUAL_INT32(Q16(2), lens.near_z);
    TEST_ASSERT_EQUAL_INT32(Q16(90), lens.far_z);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_window(FXL_SCREEN_MAX, Q16(-1), Q16(1), Q16(-0.5),
                                                   Q16(0.5), Q16(1), Q16(9), &lens));
    TEST_ASSERT_EQUAL(FXL_SCREEN_MAX, lens.width);
    TEST_ASSERT_TRUE(fxl_lens_is_valid(&lens));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_window(320, Q16(-2), Q16(2), Q16(-1.5), Q16(1.5),
                                                   Q16(2), Q16(90), &lens));
    TEST_ASSERT_NULL(lens.off_centre);
}

void test_a_window_may_have_the_least_and_the_most_pixels(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(
        FXL_OK, fxl_lens_from_window(1, Q16(-1), Q16(1), Q16(-1), Q16(1), Q16(1), Q16(9), &lens));
    TEST_ASSERT_EQUAL(1, lens.width);
    TEST_ASSERT_EQUAL(1, lens.height);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_window(64, Q16(-1), Q16(1), Q16(-16), Q16(16), Q16(1),
                                                   Q16(9), &lens));
    TEST_ASSERT_EQUAL(FXL_SCREEN_MAX, lens.height);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_from_window(64, Q16(-1), Q16(1), Q16(-16), Q16(16.02),
                                                        Q16(1), Q16(9), &lens));
}

void test_windows_out_of_range_are_refused(void)
{
    const struct {
        int width;
        double left, right, bottom, top, near, far;
    } cases[] = {
        {0, -1, 1, -1, 1, 1, 9},           {1025, -1, 1, -1, 1, 1, 9},
        {64, 1, 1, -1, 1, 1, 9},           {64, 1, -1, -1, 1, 1, 9},
        {64, -1, 1, 1, 1, 1, 9},           {64, -1, 1, 1, -1, 1, 9},
        {64, -1, 1, -1, 1, 0, 9},          {64, -1, 1, -1, 1, -1, 9},
        {64, -1, 1, -1, 1, 9, 9},          {64, -1, 1, -1, 1, 1, 32767.5},
        {64, -1, 1, -1, 1, 17, 99},        {64, -1, 1, -1, 1, 12, 99},
        {64, -1, 1, -1, 1, 0.25, 9},       {64, -5, -3, -1, 1, 1, 9},
        {64, 2.1, 4.1, -1, 1, 1, 9},       {64, -1, 1, -17, 16, 1, 9},
        {64, -1, 1, -0.015, 0, 1, 9},      {64, -1, 1, 70, 71, 1, 99},
        {64, -8191.5, 8191, -1, 1, 9, 99}, {64, -8191, 8191.5, -1, 1, 9, 99},
        {64, -1, 1, -8191.5, 1, 9, 99},    {64, -1, 1, 1, 8191.5, 9, 99},
        {1025, -1, 1, -0.5, 0.5, 1, 9},
    };
    fxl_lens lens, before;
    memset(&lens, 0x5A, sizeof lens);
    before = lens;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        TEST_ASSERT_EQUAL(FXL_E_RANGE,
                          fxl_lens_from_window((uint16_t)cases[i].width, Q16(cases[i].left),
                                               Q16(cases[i].right), Q16(cases[i].bottom),
                                               Q16(cases[i].top), Q16(cases[i].near),
                                               Q16(cases[i].far), &lens));
        TEST_ASSERT_EQUAL_MEMORY(&before, &lens, sizeof lens);
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lens_from_window(64, -1, 1, -1, 1, 1, 9, NULL));
}

/* --- views ------------------------------------------------------------------------------ */

static double along(const fxl_direction *axis, const fxl_point *point)
{
    return ((double)axis->x * point->x + (double)axis->y * point->y + (double)axis->z * point->z) /
           1073741824.0;
}

/* from + distance along a direction, if that is in the world. */
static bool move(const fxl_point *from, const fxl_direction *way, double distance, fxl_point *to)
{
    const double unit = distance / 1073741824.0, most = FXL_COORDINATE_MAX;
    const double x = from->x + unit * way->x, y = from->y + unit * way->y,
                 z = from->z + unit * way->z;
    *to = (fxl_point){(int32_t)fmin(fmax(x, -most), most), (int32_t)fmin(fmax(y, -most), most),
                      (int32_t)fmin(fmax(z, -most), most)};
    return fabs(x) < most && fabs(y) < most && fabs(z) < most;
}

/* A point before the eye that the lens sees, or whose place is beside the screen. */
static bool point_in_sight(const fxl_lens *lens, const fxl_camera *camera, fxl_point *point)
{
    const double depth = unit_between(Q16(1), Q16(500));
    const double x = unit_between(-6553, 72089) * (double)lens->width - lens->centre_x;
    const double y = lens->centre_y - unit_between(-6553, 72089) * (double)lens->height;
    return move(&camera->position, &camera->axes.right, x / lens->focal * depth, point) &&
           move(point, &camera->axes.up, y / lens->focal * depth, point) &&
           move(point, &camera->axes.forward, depth, point);
}

static fxl_view view;
static fxl_camera unsheared;

static void look(const fxl_lens *lens)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(1000));
    fxl_view_set_lens(&view, lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &unsheared));
}

/* The place on the screen is centre + focal X / Z. The rows are within 3.4 units of 2^-30 of the
 * exact ones, of the camera that they are made from, so a coordinate is within that times the sum
 * of the point's coordinates. */
/* SPEC 4.2e, 4.2j-k, accuracy 1.1d */
void test_points_lie_where_the_moved_centre_says(void)
{
    int measured = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_lens lens = any_off_centre_lens();
        look(&lens);
        fxl_point point;
        fxl_view_point at;
        fxl_screen_point screen;
        if (!point_in_sight(&lens, &unsheared, &point)) {
            continue;
        }
        fxl_transform_point(&view.camera, &point, &at);
        if (fxl_project_visible(&view.projection, &at, &screen) != FXL_OK) {
            continue;
        }
        fxl_point from_eye = {point.x - view.camera.position.x, point.y - view.camera.position.y,
                              point.z - view.camera.position.z};
        const double z = along(&unsheared.axes.forward, &from_eye);
        const double x = lens.centre_x + lens.focal * (along(&unsheared.axes.right, &from_eye) / z);
        const double y = lens.centre_y - lens.focal * (along(&unsheared.axes.up, &from_eye) / z);
        const double sum =
            fabs((double)from_eye.x) + fabs((double)from_eye.y) + fabs((double)from_eye.z);
        const double bound = 0.6 + view.projection.factor / 4.0 * 0.6 / 1073741824.0 * sum / z;
        TEST_ASSERT_NEAR(screen.x, x, bound);
        TEST_ASSERT_NEAR(screen.y, y, bound);
        measured++;
    }
    TEST_ASSERT_TRUE(measured > UNIT_REPEAT / 20);
}

/* All that the stages require of a camera and a frustum. */
/* SPEC 4.2n, 4.3l */
void test_no_row_and_no_normal_is_longer_than_one(void)
{
    const double one = 1073741824.0 * 1073741824.0 * (1 + 0x1p-28);
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_lens lens = any_off_centre_lens();
        look(&lens);
        const fxl_direction *rows[3] = {&view.camera.axes.right, &view.camera.axes.up,
                                        &view.camera.axes.forward};
        for (int row = 0; row < 3; row++) {
            const double x = rows[row]->x, y = rows[row]->y, z = rows[row]->z;
            TEST_ASSERT_TRUE(x * x + y * y + z * z <= one);
        }
        TEST_ASSERT_EQUAL_MEMORY(&unsheared.axes.forward, &view.camera.axes.forward,
                                 sizeof(fxl_direction));
        fxl_view_set_world_frustum(&view);
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            const fxl_direction *normal = &view.frustum.planes[plane].normal;
            const double x = normal->x, y = normal->y, z = normal->z;
            TEST_ASSERT_TRUE(x * x + y * y + z * z <= one);
        }
        TEST_ASSERT_TRUE(fxl_view_drawn_focal(&view) >= lens.focal);
        TEST_ASSERT_TRUE(view.view_frustum.x_side > 0 && view.view_frustum.y_side > 0);
    }
}

/* Which planes a point is outside of is told by its place on the screen, where that is farther than
 * an eighth of a pixel from a border. */
/* SPEC 4.3e-f */
void test_planes_stand_on_the_borders_of_the_screen(void)
{
    int outside = 0, inside = 0;
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_lens lens = any_off_centre_lens();
        look(&lens);
        fxl_view_set_world_frustum(&view);
        fxl_point point;
        fxl_view_point at;
        fxl_screen_point screen;
        /* Lenses of usual aspects: of others the 2.30 integers of a plane are coarser. */
        if (!point_in_sight(&lens, &unsheared, &point) || lens.height > 2 * lens.width ||
            lens.width > 8 * lens.height) {
            continue;
        }
        fxl_transform_point(&view.camera, &point, &at);
        if (fxl_project_visible(&view.projection, &at, &screen) != FXL_OK) {
            continue;
        }
        const int32_t in[4] = {screen.x, lens.width * 65536 - screen.x,
                               lens.height * 65536 - screen.y, screen.y};
        const unsigned code = fxl_outcode(&view.view_frustum, FXL_PLANES_ALL, &at);
        for (int side = 0; side < 4; side++) {
            if (in[side] > 8192 || in[side] < -8192) {
                const int plane = FXL_PLANE_LEFT + side;
                TEST_ASSERT_EQUAL(in[side] < 0, (code >> plane & 1u) != 0);
                TEST_ASSERT_EQUAL(in[side] < 0,
                                  fxl_plane_distance(&view.frustum.planes[plane], &point) < 0);
                outside += in[side] < 0;
                inside += in[side] > 0;
            }
        }
    }
    TEST_ASSERT_TRUE(outside > UNIT_REPEAT / 100 && inside > UNIT_REPEAT / 100);
}

/* A sphere with a point inside the frustum is not rejected, and a plane that the test leaves out
 * has no point of the sphere outside. */
void test_the_sphere_test_stays_conservative(void)
{
    int rejected = 0, left_out = 0;
    for (int i = 0; i < UNIT_REPEAT / 5; i++) {
        const fxl_lens lens = any_off_centre_lens();
        look(&lens);
        const fxl_q16_16 radius = unit_between(0, Q16(unit_random() % 2 ? 1 : 100));
        const fxl_direction way = unit_direction();
        const double distance = (double)radius * (unit_random() % 4 ? 1 : unit_between(0, 3));
        fxl_point point, centre;
        if (!point_in_sight(&lens, &unsheared, &point) || !move(&point, &way, distance, &centre)) {
            continue;
        }
        const uint32_t planes =
            fxl_sphere_planes(&view.camera, &view.view_frustum, &centre, radius);
        rejected += planes == FXL_SPHERE_OUTSIDE;
        if (distance > radius) {
            continue;
        }
        fxl_view_point at;
        fxl_transform_point(&view.camera, &point, &at);
        const unsigned code = fxl_outcode(&view.view_frustum, FXL_PLANES_ALL, &at);
        TEST_ASSERT_TRUE(code != 0 || planes != FXL_SPHERE_OUTSIDE);
        if (planes != FXL_SPHERE_OUTSIDE) {
            TEST_ASSERT_EQUAL_HEX32(0, code & ~planes);
            left_out += planes != FXL_PLANES_ALL;
        }
    }
    TEST_ASSERT_TRUE(rejected > UNIT_REPEAT / 100 && left_out > UNIT_REPEAT / 100);
}

void test_a_centred_view_has_the_lens_as_it_is(void)
{
    const fxl_lens lens = unit_lens(48, 32);
    fxl_view_set_lens(&view, &lens);
    const fxl_lens drawn = fxl_view_drawn_lens(&view);
    expect_lens(&lens, &drawn);
    TEST_ASSERT_EQUAL_INT32(lens.focal, fxl_view_drawn_focal(&view));
}

/* SPEC 4.2l */
void test_a_moved_view_is_drawn_with_a_centred_lens(void)
{
    const fxl_lens lens = any_off_centre_lens();
    fxl_view_set_lens(&view, &lens);
    expect_lens(&lens, &view.lens);
    const fxl_lens drawn = fxl_view_drawn_lens(&view);
    TEST_ASSERT_NULL(drawn.off_centre);
    TEST_ASSERT_EQUAL_INT32(lens.width * 32768, drawn.centre_x);
    TEST_ASSERT_EQUAL_INT32(lens.height * 32768, drawn.centre_y);
}

/* F = l + l / 2^25 + 2, where l is the whole number nearest to the root. */
/* SPEC 4.2h */
void test_the_focal_length_that_a_moved_view_is_drawn_with(void)
{
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        const fxl_lens lens = any_off_centre_lens();
        fxl_view_set_lens(&view, &lens);
        const int64_t x = lens.centre_x - lens.width * 32768,
                      y = lens.centre_y - lens.height * 32768,
                      square = (int64_t)lens.focal * lens.focal + (x * x > y * y ? x * x : y * y);
        int64_t length = (int64_t)(sqrt((double)square) + 0.5);
        while ((2 * length - 1) * (2 * length - 1) > 4 * square) {
            length--;
        }
        while ((2 * length + 1) * (2 * length + 1) < 4 * square) {
            length++;
        }
        TEST_ASSERT_EQUAL_INT32(length + (length >> 25) + 2, fxl_view_drawn_focal(&view));
    }
}
