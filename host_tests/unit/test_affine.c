/* SPDX-License-Identifier: MIT */
/* Corners whose attributes become linear on the screen: all on it, or none of them changes. */
#include "clip_views.h"
#include "paint/gradients.h"

enum {
    WIDTH = 40,
    HEIGHT = 30
};

static fxl_view view;

/* A corner at a point of the screen, in pixels, so far away. */
static fxl_view_point corner_at(double x, double y, double depth)
{
    const double focal = view.lens.focal / 65536.0, one = 70368744177664.0; /* 2^46 */
    return (fxl_view_point){(fxl_q18_46)((x - WIDTH / 2) * depth / focal * one),
                            (fxl_q18_46)((HEIGHT / 2 - y) * depth / focal * one),
                            (fxl_q18_46)(depth * one)};
}

static fxl_gradient_corners corners_with(double x, double y)
{
    fxl_gradient_corners face;
    memset(&face, 0, sizeof face);
    face.corners[0] = corner_at(10, 8, 3);
    face.corners[1] = corner_at(25, 12, 5);
    face.corners[2] = corner_at(x, y, 7);
    return face;
}

static bool becomes_affine(fxl_gradient_corners face)
{
    const fxl_gradient_corners before = face;
    fxl_corners_make_affine(&face, &view);
    const bool is_changed = memcmp(&before, &face, sizeof face) != 0;
    for (int i = 0; is_changed && i < 3; i++) {
        fxl_screen_point point;
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_project_visible(&view.projection, &before.corners[i], &point));
        TEST_ASSERT_TRUE(face.corners[i].x == point.x - WIDTH * 32768);
        TEST_ASSERT_TRUE(face.corners[i].y == HEIGHT * 32768 - point.y);
        TEST_ASSERT_TRUE(face.corners[i].z == view.lens.focal);
    }
    return is_changed;
}

void setUp(void)
{
    view = clip_random_view(WIDTH, HEIGHT);
}

void tearDown(void)
{
}

/* SPEC 9.3 */
void test_a_corner_beyond_any_side_leaves_all_as_they_are(void)
{
    for (int i = 0; i < 50; i++) {
        setUp();
        TEST_ASSERT_TRUE(becomes_affine(corners_with(5, 25)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(0, 15))); /* on the border */
        TEST_ASSERT_TRUE(becomes_affine(corners_with(WIDTH, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, 0)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, HEIGHT)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(0.01, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(WIDTH - 0.01, 15)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, 0.01)));
        TEST_ASSERT_TRUE(becomes_affine(corners_with(20, HEIGHT - 0.01)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(-0.01, 15)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(WIDTH + 0.01, 15)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(20, -0.01)));
        TEST_ASSERT_FALSE(becomes_affine(corners_with(20, HEIGHT + 0.01)));
    }
}

/* SPEC 9.3 */
void test_a_corner_that_has_no_place_on_the_screen_leaves_all_as_they_are(void)
{
    fxl_gradient_corners face = corners_with(5, 25);
    face.corners[1].z = -face.corners[1].z;
    TEST_ASSERT_FALSE(becomes_affine(face));
    face.corners[1].z = 0;
    TEST_ASSERT_FALSE(becomes_affine(face));
}

/* SPEC 9.3 */
void test_corners_on_one_line_stay(void)
{
    fxl_gradient_corners face = corners_with(5, 25);
    face.corners[2] = face.corners[0];
    TEST_ASSERT_FALSE(becomes_affine(face));
}

/* Right angles, with a side along either axis, at any corner: not on one line. */
/* SPEC 9.3 */
void test_corners_with_sides_along_the_axes(void)
{
    static const uint8_t at[4][2] = {{10, 8}, {25, 8}, {25, 20}, {10, 20}};
    for (int first = 0; first < 4; first++) {
        for (int step = 1; step < 4; step += 2) {
            fxl_gradient_corners face = corners_with(5, 25);
            for (int i = 0; i < 3; i++) {
                const uint8_t *of = at[(first + i * step) % 4];
                face.corners[i] = corner_at(of[0], of[1], 3 + i);
            }
            TEST_ASSERT_TRUE(becomes_affine(face));
        }
    }
}
