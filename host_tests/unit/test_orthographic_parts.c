/* SPDX-License-Identifier: MIT */
/* Where a point is on the screen of an orthographic lens, whose centre may be anywhere, and pictures of
 * parts of a screen. */

#include "draw/stages.h"
#include "orthographic_unit.h"
#include "scene/lens.h"
#include "tiny_frames.h"

static int64_t absolute(int64_t value)
{
    return value < 0 ? -value : value;
}

/* floor(scale across / 2^46 + 1/2) by words, as the definition has it. */
static int64_t rounded(int32_t scale, int64_t across)
{
    const int64_t high = (across >> 31) * scale, low = (across & 0x7FFFFFFF) * scale;
    return (high + (low >> 31) + (1 << 14)) >> 15;
}

/* Away from the middle of the screen, often by less than a pixel. */
static fxl_lens off_centre_lens(void)
{
    fxl_lens lens = orthographic_any_lens();
    const int32_t reach = 1 << unit_between(1, 17) /* of 1/512 pixel */;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_lens_set_centre(&lens, lens.centre_x + unit_between(-reach, reach) * 512,
                                          lens.centre_y + unit_between(-reach, reach) * 512));
    return lens;
}

/* A pose is refused if the eye would be beyond the world: then that is near. */
static void expect_refusal(const fxl_lens *lens, const fxl_pose *pose)
{
    const int64_t x = absolute(lens->centre_x - lens->width * 32768),
                  y = absolute(lens->centre_y - lens->height * 32768);
    const int64_t reach = (x + y) * 65536 / lens->focal + 2;
    TEST_ASSERT_TRUE(absolute(pose->position.x) + reach > FXL_COORDINATE_MAX ||
                     absolute(pose->position.y) + reach > FXL_COORDINATE_MAX ||
                     absolute(pose->position.z) + reach > FXL_COORDINATE_MAX);
}

/* A point that is `seen` from the pose's eye. Answers whether it is on the screen. */
static bool expect_place(const fxl_view *view, const fxl_point *point, const fxl_view_point *seen)
{
    const fxl_lens *lens = &view->lens;
    const int64_t x = lens->centre_x + rounded(lens->focal, seen->x);
    const int64_t y = lens->centre_y - rounded(lens->focal, seen->y);
    const int64_t most = 4095 * 65536;
    const bool fits = absolute(x) <= most && absolute(y) <= most;
    fxl_view_point drawn;
    fxl_screen_point screen = {7, 7};
    fxl_screen_place place;
    fxl_transform_point(&view->camera, point, &drawn);
    TEST_ASSERT_EQUAL_INT64(seen->z - (int64_t)lens->near_z * FXL_Q2_30_ONE,
                            drawn.z - view->view_frustum.near_z);
    TEST_ASSERT_EQUAL_INT64(seen->z - (int64_t)lens->far_z * FXL_Q2_30_ONE,
                            drawn.z - view->view_frustum.far_z);
    TEST_ASSERT_EQUAL(fits ? FXL_OK : FXL_E_RANGE, fxl_project_orthographic(view, &drawn, &screen));
    TEST_ASSERT_EQUAL_INT32(fits ? x : 7, screen.x);
    TEST_ASSERT_EQUAL_INT32(fits ? y : 7, screen.y);

    TEST_ASSERT_EQUAL(FXL_OK, fxl_find_on_screen(view, point, &place));
    TEST_ASSERT_EQUAL(seen->z < (int64_t)lens->near_z * FXL_Q2_30_ONE,
                      place.place == FXL_POINT_NEAR);
    if (place.place != FXL_POINT_VISIBLE) {
        return false;
    }
    TEST_ASSERT_TRUE(seen->z <= (int64_t)lens->far_z * FXL_Q2_30_ONE);
    TEST_ASSERT_EQUAL_INT32(x, place.at.x);
    TEST_ASSERT_EQUAL_INT32(y, place.at.y);
    return true;
}

/* What is straight ahead of the moved eye is in the middle of the screen, nearly, and surfaces know
 * where. */
static void expect_middle(const fxl_view *view)
{
    const fxl_lens *lens = &view->lens;
    const fxl_view_point ahead = {0, 0, 0};
    fxl_screen_point screen;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_orthographic(view, &ahead, &screen));
    TEST_ASSERT_TRUE(absolute(screen.x - lens->width * 32768) <= 1 + lens->focal / 32768 &&
                     absolute(screen.y - lens->height * 32768) <= 1 + lens->focal / 32768);
    TEST_ASSERT_INT_WITHIN(1, screen.x, view->projection.centre_x);
    TEST_ASSERT_INT_WITHIN(1, screen.y, view->projection.centre_y);
}

/* orthographic 1.2a, 1.2c, 1.2f, 2.6a, 2.6b, 2.7a, 2.1e, 2.1f */
void test_each_product_is_rounded_once(void)
{
    uint32_t on_screen = 0, refused = 0;
    for (int round = 0; round < UNIT_REPEAT; round++) {
        const fxl_lens lens = round % 2 != 0 ? off_centre_lens() : orthographic_any_lens();
        const fxl_pose pose = unit_pose();
        const fxl_point point = unit_point(FXL_COORDINATE_MAX);
        fxl_camera camera;
        fxl_view view, before;
        fxl_view_point seen;
        memset(&view, 0x5A, sizeof view);
        fxl_view_set_lens(&view, &lens);
        before = view;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        if (fxl_view_set_pose(&view, &pose) != FXL_OK) {
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_view_set_pose(&view, &pose));
            TEST_ASSERT_EQUAL_MEMORY(&before, &view, sizeof view);
            expect_refusal(&lens, &pose);
            refused++;
            continue;
        }
        fxl_transform_point(&camera, &point, &seen);
        on_screen += expect_place(&view, &point, &seen);
        expect_middle(&view);
    }
    TEST_ASSERT_TRUE(on_screen > 0 && refused > 0);
}

/* --- parts ----------------------------------------------------------------------------------- */

enum {
    WIDTH = 64,
    HEIGHT = 48,
    BACKGROUND = 250
};

static uint8_t whole[HEIGHT][WIDTH], part[HEIGHT][WIDTH];
static fxl_draw_entry order[64];

static void draw(const tiny_scene *tiny, const fxl_lens *lens, const fxl_pose *pose,
                 uint8_t frame[HEIGHT][WIDTH])
{
    static fxl_renderer renderer;
    const fxl_memory memory = {order, 64, NULL, 0, NULL, 0};
    memset(frame, BACKGROUND, WIDTH * HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, pose, frame[0], WIDTH));
}

/* A part that may lie beyond the screen shows what the whole shows there. Only where a face is cut
 * may a pixel differ whose centre is near an edge. */
/* orthographic 1.2d, 1.2e */
void test_parts_show_what_the_whole_shows(void)
{
    uint32_t compared = 0, different = 0;
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        tiny_scene *tiny = tiny_make();
        fxl_pose pose = tiny_pose_before();
        fxl_lens lens, cut;
        pose.roll = unit_random();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_lens_orthographic(WIDTH, HEIGHT, unit_between(Q16(2), Q16(30)),
                                                unit_between(4096, Q16(12)), Q16(100), &lens));
        const int16_t x = (int16_t)unit_between(-20, WIDTH - 1);
        const int16_t y = (int16_t)unit_between(-20, HEIGHT - 1);
        const uint16_t width = (uint16_t)unit_between(20, WIDTH);
        const uint16_t height = (uint16_t)unit_between(20, HEIGHT);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_of_part(&lens, x, y, width, height, &cut));
        draw(tiny, &lens, &pose, whole);
        draw(tiny, &cut, &pose, part);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                if (x + column >= 0 && x + column < WIDTH && y + row >= 0 && y + row < HEIGHT) {
                    compared += whole[y + row][x + column] != BACKGROUND;
                    different += whole[y + row][x + column] != part[row][column];
                }
            }
        }
    }
    TEST_ASSERT_TRUE(compared > 1000);
    TEST_ASSERT_EQUAL_UINT32(0, different);
}

/* The sentence of a frame that is refused names its cause. */
/* orthographic 1.2f */
void test_a_pose_whose_middle_is_beyond_the_world_is_explained(void)
{
    static fxl_renderer renderer;
    const fxl_memory memory = {order, 64, NULL, 0, NULL, 0};
    tiny_scene *tiny = tiny_make();
    fxl_pose pose = {{FXL_COORDINATE_MAX, 0, 0}, 0, 0, 0};
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_orthographic(WIDTH, HEIGHT, Q16(4), 4096, Q16(100), &lens));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, 0, lens.centre_y));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_render(&renderer, &pose, whole[0], WIDTH));
    const char *sentence = fxl_render_explain(&renderer, &pose, whole[0], WIDTH, NULL);
    TEST_ASSERT_NOT_NULL(sentence);
    TEST_ASSERT_NOT_NULL(strstr(sentence, "middle of the screen of an orthographic lens"));
    pose.position.x -= Q16(8);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, whole[0], WIDTH));
    TEST_ASSERT_NULL(fxl_render_explain(&renderer, &pose, whole[0], WIDTH, NULL));
}
