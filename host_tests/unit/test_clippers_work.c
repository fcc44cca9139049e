/* SPDX-License-Identifier: MIT */
/* What the clippers count, and faces that need no plane. */
#include "clip_unit.h"
#include "polygon_face.h"
#include "clippers_list.h"

enum {
    WIDTH = 48,
    HEIGHT = 32
};

static fxl_clipper_workspace workspace;
static fxl_clipper_work work;
static polygon_face face;
static fxl_screen_polygon screen;

/* About the view's axis; the first corner and the other two have depths of their own. */
static fxl_polygon triangle(const fxl_view *view, fxl_q16_16 first, fxl_q16_16 others)
{
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(view, 0, Q16(0.25), first);
    polygon.vertices[1].position = clip_place(view, Q16(0.25), Q16(-0.25), others);
    polygon.vertices[2].position = clip_place(view, Q16(-0.25), Q16(-0.25), others);
    return polygon;
}

static void set_face(const fxl_polygon *polygon, fxl_view *view, void *clipper_workspace)
{
    polygon_face_set(&face, polygon, view, 4);
    face.model_view.clipper_workspace = clipper_workspace;
}

static fxl_clip_result clip_by(const fxl_clipper *clipper)
{
    return clipper->clip(&face.model_view, &face.face, &work, &screen);
}

/* Each vertex of the cache holds its place on the screen. */
static void expect_projected(void)
{
    for (uint32_t i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL_HEX8(0, face.seen[i].clip_flags);
        TEST_ASSERT_EQUAL_MEMORY(&screen.points[i], &face.seen[i].screen, sizeof screen.points[i]);
    }
}

/* The clippers of the view and of the world count where they are given an account. */
/* clippers 4.2b */
void test_all_count_what_they_work_out(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_clip_stats account = {0, 0, 0};
    fxl_polygon polygon = triangle(&view, Q16(2), Q16(-2));
    fxl_view_set_world_frustum(&view);
    for (int which = 0; which < 2; which++) {
        set_face(&polygon, &view, &account);
        fxl_clip_result result = (which == 0 ? fxl_clip_by_view : fxl_clip_by_world)(
            &face.model_view, &face.face, &work, &screen);
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, result);
        TEST_ASSERT_TRUE(account.intersections >= 2 && account.distances >= 3);
        account = (fxl_clip_stats){0, 0, 0};
    }
}

/* A face behind the eye is measured by the near plane alone, which no edge crosses. */
void test_what_is_outside_has_no_intersections(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_clip_stats account = {0, 0, 0};
    fxl_polygon polygon = triangle(&view, Q16(-2), Q16(-2));
    fxl_view_set_world_frustum(&view);
    set_face(&polygon, &view, &account);
    TEST_ASSERT_EQUAL(FXL_CLIP_OUTSIDE,
                      fxl_clip_by_world(&face.model_view, &face.face, &work, &screen));
    TEST_ASSERT_EQUAL_UINT32(3, account.distances);
    TEST_ASSERT_EQUAL_UINT32(0, account.intersections);
}

/* place clipper: the workspace that spoil breaks */
/* Half-spaces measure a vertex by all planes, once, and not where no plane can matter. */
void test_half_spaces_measure_a_vertex_once(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_polygon polygon = triangle(&view, Q16(2), Q16(2));
    memset(&workspace, 0, fxl_clipper_half_spaces.workspace_size);
    for (int planes = 1; planes >= 0; planes--) {
        workspace.stats = (fxl_clip_stats){0, 0, 0};
        set_face(&polygon, &view, &workspace);
        face.model_view.planes = planes ? FXL_PLANES_ALL : 0;
        for (int again = 0; again < 2; again++) {
            TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_by(&fxl_clipper_half_spaces));
            TEST_ASSERT_EQUAL_UINT32(planes ? 3 * FXL_PLANE_COUNT : 0, workspace.stats.distances);
            TEST_ASSERT_EQUAL_UINT32(0, workspace.stats.intersections);
        }
    }
}

/* Each vertex beside the screen is tried against the guard band. For the clipper that cuts by the
 * left side too, one beyond that side alone is not tried; then the left plane measures all three.
 */
void test_the_guard_band_is_counted(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    const fxl_clip_stats *stats = &workspace.stats;
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(&view, Q16(-40), 0, Q16(10));
    polygon.vertices[1].position = clip_place(&view, 0, Q16(40), Q16(10));
    polygon.vertices[2].position = clip_place(&view, Q16(40), Q16(-1), Q16(10));
    for (int left = 0; left < 2; left++) {
        const fxl_clipper *clipper = left ? &fxl_clipper_left : &fxl_clipper_near;
        memset(&workspace, 0, clipper->workspace_size);
        set_face(&polygon, &view, &workspace);
        TEST_ASSERT_EQUAL(left ? FXL_CLIP_CUT : FXL_CLIP_INSIDE, clip_by(clipper));
        TEST_ASSERT_EQUAL_UINT32(left ? 2 * FXL_PLANE_COUNT + 3 : 3 * FXL_PLANE_COUNT,
                                 stats->distances);
        TEST_ASSERT_EQUAL_UINT32(left ? 2 : 0, stats->intersections);
    }
}

/* A vertex beyond the guard band is tried against it, then all three vertices against all planes;
 * then the left plane, which alone has one outside, measures all three. */
/* clippers 4.4 */
void test_what_is_beyond_the_guard_band_is_counted(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_polygon polygon = {.colour = 3, .count = 3};
    polygon.vertices[0].position = clip_place(&view, Q16(-3000), 0, Q16(10));
    polygon.vertices[1].position = clip_place(&view, 0, Q16(1), Q16(10));
    polygon.vertices[2].position = clip_place(&view, 0, Q16(-1), Q16(10));
    memset(&workspace, 0, fxl_clipper_near.workspace_size);
    set_face(&polygon, &view, &workspace);
    TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip_by(&fxl_clipper_near));
    TEST_ASSERT_EQUAL_UINT32((1 + 3) * FXL_PLANE_COUNT + 3, workspace.stats.distances);
    TEST_ASSERT_EQUAL_UINT32(2, workspace.stats.intersections);
}

/* A face that claims to need no plane is projected as it is. With a vertex behind the eye it cannot
 * be, and is refused; before the eye it is kept, and then each vertex of the cache holds its place
 * on the screen. */
void test_a_face_without_planes_is_projected_or_refused(void)
{
    static const fxl_clipper *const whole[] = {&fxl_clipper_world, &fxl_clipper_half_spaces,
                                               &fxl_clipper_normalised, &fxl_clipper_once};
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_view_set_world_frustum(&view);
    for (int which = 0; which < 4; which++) {
        for (int behind = 0; behind <= 3; behind++) { /* the last of the cases: none is behind */
            fxl_polygon polygon = triangle(&view, Q16(2), Q16(2));
            if (behind < 3) {
                polygon.vertices[behind].position = clip_place(&view, 0, 0, Q16(-2));
            }
            memset(&workspace, 0, whole[which]->workspace_size);
            set_face(&polygon, &view, whole[which]->workspace_size > 0 ? &workspace : NULL);
            face.model_view.planes = 0;
            TEST_ASSERT_EQUAL(behind < 3 ? FXL_CLIP_RANGE : FXL_CLIP_INSIDE, clip_by(whole[which]));
        }
        expect_projected();
    }
}

/* A vertex that is in sight is projected for the first face that has it: then the cache holds its
 * place on the screen, whichever clipper it is. */
void test_vertices_in_sight_are_projected_once(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_polygon polygon = triangle(&view, Q16(2), Q16(2));
    fxl_view_set_world_frustum(&view);
    for (int which = 0; which < CLIPPERS + 2; which++) {
        const fxl_clipper *clipper = clipper_number(which);
        memset(&workspace, 0, sizeof workspace);
        set_face(&polygon, &view, &workspace);
        TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_by(clipper));
        expect_projected();
    }
}

/* Spoils the planes that a clipper has in its workspace, so that every point is outside. */
static void spoil(const fxl_clipper *clipper)
{
    const fxl_half_space nothing = {{0, 0, 0}, -1};
    fxl_volume *volume =
        clipper == &fxl_clipper_triangles ? &workspace.fan.volume : &workspace.volume.volume;
    if (clipper == &fxl_clipper_once) {
        workspace.once.frustum.near_z = INT64_MAX / 4;
    } else if (clipper == &fxl_clipper_normalised) {
        workspace.normalised.frustum.near_z = INT64_MAX / 4;
    } else {
        for (int i = 0; i < FXL_PLANE_COUNT; i++) {
            volume->planes[i] = nothing;
        }
    }
}

/* A clipper makes its planes for the first face of a frame, and uses them for the others: spoilt,
 * they leave nothing of a face that crosses near, until the next frame. */
/* clippers 4.2c */
void test_planes_are_made_once_a_frame(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_polygon polygon = triangle(&view, Q16(2), Q16(-2));
    for (int which = 0; which < CLIPPERS; which++) {
        const fxl_clipper *clipper = clippers[which];
        memset(&workspace, 0, clipper->workspace_size);
        for (int time = 0; time < 3; time++) {
            set_face(&polygon, &view, &workspace);
            view.frame += time == 2;
            TEST_ASSERT_EQUAL(time == 1 ? FXL_CLIP_OUTSIDE : FXL_CLIP_CUT, clip_by(clipper));
            spoil(clipper);
        }
    }
}

/* The near plane alone, which a face crosses: all clippers cut it there. */
void test_the_near_plane_alone(void)
{
    fxl_view view = clip_random_view(WIDTH, HEIGHT);
    fxl_polygon polygon = triangle(&view, Q16(2), Q16(2));
    polygon.vertices[1].position = clip_place(&view, 0, 0, Q16(0.03));
    fxl_view_set_world_frustum(&view);
    for (int which = 0; which < CLIPPERS + 2; which++) {
        const fxl_clipper *clipper = clipper_number(which);
        memset(&workspace, 0, sizeof workspace);
        set_face(&polygon, &view, &workspace);
        face.model_view.planes = 1u << FXL_PLANE_NEAR;
        TEST_ASSERT_EQUAL(FXL_CLIP_CUT, clip_by(clipper));
        TEST_ASSERT_TRUE(workspace.stats.intersections >= 2);
    }
}

/* The integers of a side plane are coarse where the screen is high and wide in angle: a vertex that is inside of the lower and the
 * upper one may lie beside the screen, by 24 units of 1/65536 pixel. What is drawn of its face does not. */
void test_triangles_of_a_vertex_rounded_off_the_screen_end_at_its_border(void)
{
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_lens lens;
    fxl_view view;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_lens_from_fov(1, 845, FXL_FOV_MAX, Q16(0.125), Q16(100), 0, &lens));
    lens.focal = 8923;
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    for (int side = 1; side >= -1; side -= 2) {
        const fxl_q16_16 border = side * 260198256, depth = 83851;
        const fxl_polygon polygon = {.colour = 3,
                                     .count = 3,
                                     .vertices = {{{0, border, depth}, 0, 0},
                                                  {{side * Q16(0.25), 0, depth}, 0, 0},
                                                  {{0, border / 2, depth}, 0, 0}}};
        memset(&workspace, 0, sizeof workspace);
        set_face(&polygon, &view, &workspace);
        TEST_ASSERT_EQUAL(FXL_CLIP_INSIDE, clip_by(&fxl_clipper_triangles));
        TEST_ASSERT_EQUAL_HEX8(0, face.seen[0].clip_flags);
        TEST_ASSERT_EQUAL_INT32(side > 0 ? -24 : Q16(845) + 24, face.seen[0].screen.y);
        do {
            for (uint32_t i = 0; i < screen.count; i++) {
                TEST_ASSERT_TRUE(screen.points[i].y >= 0 && screen.points[i].y <= Q16(845));
            }
        } while (fxl_clipper_triangles.next(&face.model_view, &work, &screen) == FXL_CLIP_INSIDE);
    }
}

/* As the clipper of a renderer: the setting is the caller's and outlasts the frame. */
void test_a_renderer_s_triangles_keep_the_rule_of_the_borders(void)
{
    fxl_fan_workspace *fan = &workspace.fan;
    const fxl_lens lens = unit_lens(64, 48);
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_view view;
    /* A corner a quarter of a pixel left of the right border, the others beyond it. */
    const fxl_polygon polygon = {.colour = 3,
                                 .count = 3,
                                 .vertices = {{{Q16(140), Q16(20), Q16(128)}, 0, 0},
                                              {{Q16(140), Q16(-20), Q16(128)}, 0, 0},
                                              {{Q16(127), 0, Q16(128)}, 0, 0}}};
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    memset(fan, 0, sizeof *fan);
    for (int i = 0; i < 4; i++) {
        const bool on = i >= 2;
        fan->clip.screen_sliver = on ? Q16(0.5) : 0;
        view.frame = (uint32_t)(1 + i);
        set_face(&polygon, &view, fan);
        TEST_ASSERT_EQUAL(on ? FXL_CLIP_OUTSIDE : FXL_CLIP_CUT, clip_by(&fxl_clipper_triangles));
        TEST_ASSERT_EQUAL_INT32(on ? Q16(0.5) : 0, fan->clip.screen_sliver);
    }
}
