/* SPDX-License-Identifier: MIT */
/* The orthographic lens: its planes and projection by exact integers, which faces and in which order
 * they come, depths against double, and what it does not go with. Frames are judged elsewhere. */
#include <math.h>

#include "choices.h"
#include "fixel/lines.h"
#include "frame_bands.h"
#include "orthographic_unit.h"
#include "paint/depth_code.h"
#include "scene/lens.h"
#include "study/clippers.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "view/placement.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    PIXELS = WIDTH * HEIGHT,
    BACKGROUND = 200,
    LIST_WORDS = 40 * FXL_DISPLAY_LIST_WORDS(8)
};

static fxl_draw_entry order[64];
static uint32_t list[LIST_WORDS];
static fxl_cached_vertex cache[9];
static uint64_t room[1024];
static uint8_t frames[2][PIXELS];
static fxl_renderer renderer;
static fxl_placement placements[TINY_INSTANCES];
static tiny_scene *tiny;
static const fxl_line_counters *line_counters;

/* orthographic 1.1a-f, 1.2c */
void test_a_lens_is_taken_within_its_range(void)
{
    const struct {
        int32_t width, height, scale, near_z, far_z;
        fxl_status status;
    } cases[] = {{48, 32, 4096, 256, 257, FXL_OK},
                 {1024, 1024, 4096 * 65536, 256, 32767 * 65536, FXL_OK},
                 {48, 32, 4095, 256, 257, FXL_E_RANGE},
                 {48, 32, 4096 * 65536 + 1, 256, 257, FXL_E_RANGE},
                 {48, 32, -65536, 256, 257, FXL_E_RANGE},
                 {48, 32, 65536, 255, 257, FXL_E_RANGE},
                 {48, 32, 65536, 256, 256, FXL_E_RANGE},
                 {0, 32, 65536, 256, 257, FXL_E_RANGE},
                 {48, 1025, 65536, 256, 257, FXL_E_RANGE}};
    for (uint32_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        fxl_lens lens, before;
        memset(&lens, 0x5A, sizeof lens);
        before = lens;
        TEST_ASSERT_EQUAL(cases[i].status,
                          fxl_lens_orthographic((uint16_t)cases[i].width, (uint16_t)cases[i].height,
                                                cases[i].scale, cases[i].near_z, cases[i].far_z,
                                                &lens));
        if (cases[i].status != FXL_OK) {
            TEST_ASSERT_EQUAL_MEMORY(&before, &lens, sizeof lens);
            continue;
        }
        TEST_ASSERT_TRUE(fxl_lens_is_valid(&lens));
        before = lens;
        for (int side = -1; side <= 1; side += 2) {
            const int32_t x = before.centre_x + side * 98304 * 1024;
            const int32_t y = before.centre_y + side * 98304 * 1024;
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_set_centre(&lens, x + side, y));
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_lens_set_centre(&lens, x, y + side));
            TEST_ASSERT_EQUAL_MEMORY(&before, &lens, sizeof lens);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, x, y));
            TEST_ASSERT_TRUE(lens.centre_x == x && lens.centre_y == y);
            TEST_ASSERT_EQUAL_PTR(&fxl_orthographic, lens.off_centre);
            lens = before;
        }
        lens.inset = 1;
        TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
    }
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lens_orthographic(48, 32, 65536, 256, 257, NULL));
}

/* A point is outside of a side if it is more than 1/65536 pixel outside of the screen, and not if it
 * is so far inside. */
/* orthographic 2.1a-d, 2.2a */
void test_planes_are_the_borders_of_the_screen(void)
{
    for (int round = 0; round < UNIT_REPEAT; round++) {
        const fxl_lens lens = orthographic_any_lens();
        const double scale = lens.focal / 65536.0 * 0x1p-46;
        fxl_view view;
        fxl_view_set_lens(&view, &lens);
        const double half_x = lens.width / 2.0 / scale, half_y = lens.height / 2.0 / scale;
        const fxl_view_point at = {
            (int64_t)(unit_between(-70000, 70000) / 65536.0 * half_x) + unit_between(-9, 9),
            (int64_t)(unit_between(-70000, 70000) / 65536.0 * half_y) + unit_between(-9, 9),
            unit_between(0, 1) ? (int64_t)lens.near_z * FXL_Q2_30_ONE - unit_between(0, 1)
                               : (int64_t)lens.far_z * FXL_Q2_30_ONE + unit_between(0, 1)};
        const unsigned outside = fxl_outcode(&view.view_frustum, FXL_PLANES_ALL, &at);
        const double x = (double)at.x * scale, y = (double)at.y * scale;
        const double beyond[4] = {-x - lens.width / 2.0, x - lens.width / 2.0,
                                  -y - lens.height / 2.0, y - lens.height / 2.0};
        TEST_ASSERT_EQUAL((at.z < (int64_t)lens.near_z * FXL_Q2_30_ONE) << FXL_PLANE_NEAR |
                              (at.z > (int64_t)lens.far_z * FXL_Q2_30_ONE) << FXL_PLANE_FAR,
                          outside & 3u);
        for (unsigned i = 0; i < 4; i++) {
            if (fabs(beyond[i]) > 0x1p-16) {
                TEST_ASSERT_EQUAL(beyond[i] > 0, outside >> (FXL_PLANE_LEFT + i) & 1u);
            }
        }
    }
}

/* --- frames ---------------------------------------------------------------------------------- */

static fxl_lens tiny_lens(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_lens_orthographic(WIDTH, HEIGHT, Q16(3), Q16(0.0625), Q16(100), &lens));
    return lens;
}

/* The tiny scene, of which the instances from first on are turned. */
static void start(uint32_t first, uint32_t list_words)
{
    const fxl_memory memory = {order, 64, list, list_words, cache, 9};
    const fxl_lens lens = tiny_lens();
    fxl_scene_fault fault = {"", 0};
    tiny = tiny_make();
    tiny_place_from(tiny, placements, first);
    for (uint32_t i = first; i < TINY_INSTANCES; i++) {
        placements[i - first].orientation = unit_orientation();
        placements[i - first].scale = unit_between(Q16(0.25), Q16(2));
    }
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check(&tiny->scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
}

static bool is_front(uint32_t instance, const fxl_face *face, const fxl_direction *forward)
{
    const fxl_scene *scene = &tiny->scene;
    int64_t ahead[3] = {forward->x, forward->y, forward->z};
    if (scene->placements != NULL && instance >= scene->first_turned) {
        const fxl_orientation *of = &placements[instance - scene->first_turned].orientation;
        const fxl_direction rows[3] = {of->x, of->y, of->z};
        int64_t sums[3] = {1 << 29, 1 << 29, 1 << 29};
        for (int i = 0; i < 3; i++) {
            sums[0] += ahead[i] * rows[i].x;
            sums[1] += ahead[i] * rows[i].y;
            sums[2] += ahead[i] * rows[i].z;
        }
        for (int i = 0; i < 3; i++) {
            ahead[i] = sums[i] >> 30;
        }
    }
    return face->normal.x * ahead[0] + face->normal.y * ahead[1] + face->normal.z * ahead[2] < 0;
}

static int64_t depth_of(uint32_t instance)
{
    const fxl_camera *camera = &renderer.frame.view.camera;
    const fxl_point *centre = &tiny->scene.instances[instance].centre;
    return (int64_t)camera->axes.forward.x * (centre->x - camera->position.x) +
           (int64_t)camera->axes.forward.y * (centre->y - camera->position.y) +
           (int64_t)camera->axes.forward.z * (centre->z - camera->position.z);
}

/* A line on each face of the cubes, and on no other. */
static void attach_a_line_a_face(void)
{
    static fxl_line lines[12];
    static uint32_t map[3];
    static fxl_lines attached;
    const fxl_line_set set = {lines, 12, map};
    uint32_t count = 0;
    for (uint32_t m = 0; m < 2; m++) {
        const fxl_model *model = &tiny->models[m];
        map[m] = count;
        for (uint32_t i = 0; i < model->face_count; i++) {
            const uint16_t *corners = fxl_face_indices(tiny->corners, &tiny->faces[model->first_face + i]);
            lines[count++] = (fxl_line){corners[0], corners[1], {(uint16_t)(i + 1), 0}, 100, 1, 0};
        }
    }
    map[2] = count;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
    line_counters = &attached.counters;
}

/* A wireframe of the same pose has the edges of so many faces. */
static void expect_wireframe(const fxl_pose *pose, uint32_t faces)
{
    const fxl_band band = UNIT_BAND(frames[0], WIDTH, 0, HEIGHT);
    fxl_wire wire;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &renderer.frame.view.lens, fxl_line_by_planes));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, pose));
    memset(frames[0], BACKGROUND, PIXELS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
    TEST_ASSERT_EQUAL_UINT32(4 * faces, wire.counters.in);
}

/* Of a cube that no plane cuts all faces are counted as backfacing or drawn; so are lines that lie on one face. */
/* orthographic 2.3a, 2.3b, 2.4a, 2.4b, 2.5a, 2.5c, 2.12a, 2.13 */
void test_faces_and_instances_come_by_forward(void)
{
    uint32_t fronts = 0;
    for (int round = 0; round < UNIT_REPEAT / 20; round++) {
        const fxl_pose pose = tiny_pose_before();
        uint32_t backs = 0;
        start((uint32_t)unit_between(0, TINY_INSTANCES), LIST_WORDS);
        attach_a_line_a_face();
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        const fxl_frame *frame = &renderer.frame;
        for (uint32_t i = 0; i < frame->visible_count; i++) {
            const uint32_t number = frame->draw_list[i].index;
            const fxl_model *model = &tiny->scene.models[tiny->scene.instances[number].model];
            for (uint32_t k = 0; k < model->face_count; k++) {
                backs += !is_front(number, &tiny->scene.faces[model->first_face + k],
                                   &frame->view.camera.axes.forward);
            }
            if (i > 0) {
                TEST_ASSERT_TRUE(depth_of(frame->draw_list[i - 1].index) >= depth_of(number));
            }
        }
        TEST_ASSERT_EQUAL_UINT32(backs, renderer.workspace.counters.backfacing);
        TEST_ASSERT_EQUAL_UINT32(backs, line_counters->backfacing);
        expect_wireframe(&pose, 6 * frame->visible_count - backs);
        fronts += renderer.workspace.counters.drawn;
    }
    TEST_ASSERT_TRUE(fronts > 0);
}

/* What lines and picks ask of a face, where camera and instances are turned, in sight or not. */
/* orthographic 2.3a, 2.3b, 2.4a */
void test_a_face_is_asked_whether_it_is_a_front(void)
{
    uint32_t fronts = 0, turned = 0;
    for (int round = 0; round < UNIT_REPEAT / 20; round++) {
        const fxl_pose pose = unit_pose();
        start((uint32_t)unit_between(0, TINY_INSTANCES - 1), 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        const fxl_camera *camera = &renderer.frame.view.camera;
        for (uint32_t number = 0; number < TINY_INSTANCES; number++) {
            const fxl_face *face = &tiny->faces[unit_between(0, 11)];
            const bool expected = is_front(number, face, &camera->axes.forward);
            TEST_ASSERT_EQUAL(expected, fxl_orthographic.orthographic->face_is_front(&renderer.frame.view, &tiny->scene, number, face));
            fronts += expected;
            turned += expected && number >= tiny->scene.first_turned;
        }
    }
    TEST_ASSERT_TRUE(fronts > turned && turned > 0);
}

/* A renderer of any target, whole and in bands, shows one picture, and a pick names its faces, which
 * are fronts. */
/* orthographic 1.3a, 2.4a */
void test_bands_and_picks_are_of_the_frame(void)
{
    static const choice *const choices[] = {&choice_sorted, &choice_depth_16, &choice_depth_32};
    uint32_t drawn = 0;
    for (int round = 0; round < UNIT_REPEAT / 500; round++) {
        const fxl_pose pose = tiny_pose_before();
        const uint32_t seed = unit_random();
        const choice *pair = choices[round % 3];
        for (int i = 0; i < 2; i++) {
            unit_seed(seed | 1);
            start((uint32_t)round % 4u, i == 0 ? 0 : LIST_WORDS);
            TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, pair, room, sizeof room));
            frame_draw_pose(&renderer, &pose, frames[i], i == 0 ? HEIGHT : 5, BACKGROUND);
        }
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
        for (int i = 0; i < 20; i++) {
            const uint16_t x = (uint16_t)unit_between(0, WIDTH - 1);
            const uint16_t y = (uint16_t)unit_between(0, HEIGHT - 1);
            fxl_picked picked;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderer, x, y, &picked));
            const uint8_t pixel = frames[1][y * WIDTH + x];
            drawn += pixel != BACKGROUND;
            TEST_ASSERT_EQUAL(pixel == BACKGROUND, picked.instance == FXL_PICK_NONE);
            if (pixel != BACKGROUND) {
                const fxl_scene *scene = &tiny->scene;
                const fxl_model *model = &scene->models[scene->instances[picked.instance].model];
                TEST_ASSERT_EQUAL_HEX8(pixel, picked.colour);
                TEST_ASSERT_TRUE(is_front(picked.instance,
                                          &scene->faces[model->first_face + picked.face],
                                          &renderer.frame.view.camera.axes.forward));
            }
        }
    }
    TEST_ASSERT_TRUE(drawn > 0);
}

/* The depth of a face's plane at any pixel of the screen, where that is between near and far. */
/* orthographic 2.11a */
void test_depths_are_linear_between_near_and_far(void)
{
    uint32_t checked = 0;
    for (int round = 0; round < UNIT_REPEAT / 10; round++) {
        const fxl_lens lens = orthographic_any_lens();
        const fxl_pose pose = unit_pose();
        const fxl_point corner = unit_point(FXL_COORDINATE_MAX);
        fxl_face face = {.normal = unit_direction(), .count = 3, .indices = {0, 0, 0}};
        fxl_vertex_cache own;
        fxl_model_view model_view;
        fxl_view view;
        fxl_depth_plane plane;
        fxl_view_set_lens(&view, &lens);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
        fxl_vertex_cache_init(&own, NULL, 0);
        fxl_model_view_of_polygon(&model_view, &corner, &view, &own);
        lens.off_centre->orthographic->find_depth(&model_view, &face, &plane);
        const fxl_axes *axes = &view.camera.axes;
        const fxl_direction *rows[3] = {&axes->right, &axes->up, &axes->forward};
        fxl_view_point p;
        double n[3];
        fxl_transform_point(&view.camera, &corner, &p);
        for (int i = 0; i < 3; i++) {
            n[i] = ((double)rows[i]->x * face.normal.x + (double)rows[i]->y * face.normal.y +
                    (double)rows[i]->z * face.normal.z) *
                   0x1p-60;
        }
        if (n[2] > -0.01) {
            continue;
        }
        const double scale = lens.focal / 65536.0, range = (lens.far_z - lens.near_z) / 65536.0;
        const int x = unit_between(0, lens.width - 1), y = unit_between(0, lens.height - 1);
        const double across = (x + 0.5 - lens.width / 2.0) / scale - (double)p.x * 0x1p-46,
                     upright = (lens.height / 2.0 - y - 0.5) / scale - (double)p.y * 0x1p-46;
        const double z = (double)p.z * 0x1p-46 - (n[0] * across + n[1] * upright) / n[2];
        const double expected = 1 - (z - lens.near_z / 65536.0) / (2 * range);
        if (expected < 0.5 || expected > 1) {
            continue;
        }
        checked++;
        const int64_t found =
            plane.gradient.at + plane.gradient.along * x + plane.gradient.down * y;
        /* Of all that is added up, and of what the normal's 30 bits move the plane. */
        const double far_away = fabs(across) + fabs(upright) + fabs(z) + lens.near_z / 65536.0;
        TEST_ASSERT_TRUE(fabs(ldexp((double)found, -plane.one) - expected) <
                         0x1p-26 + 0x1p-24 * far_away / range / -n[2]);
    }
    TEST_ASSERT_TRUE(checked > 0);
}

/* The depth of a face through a corner, seen straight ahead from the origin. */
static fxl_depth_plane depth_of_face(fxl_q16_16 scale, fxl_q16_16 near_z, fxl_q16_16 far_z,
                                     fxl_point corner, fxl_direction normal)
{
    const fxl_pose pose = {{0, 0, 0}, 0, 0, 0};
    fxl_face face = {.normal = normal, .count = 3, .indices = {0, 0, 0}};
    fxl_lens lens;
    fxl_vertex_cache own;
    fxl_model_view model_view;
    fxl_view view;
    fxl_depth_plane plane;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_orthographic(WIDTH, HEIGHT, scale, near_z, far_z, &lens));
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    fxl_vertex_cache_init(&own, NULL, 0);
    fxl_model_view_of_polygon(&model_view, &corner, &view, &own);
    lens.off_centre->orthographic->find_depth(&model_view, &face, &plane);
    return plane;
}

/* Faces that are seen edge-on, or nearly so, are at infinity, and a slope that no pixel can notice
 * is none. */
/* orthographic 2.11a */
void test_depths_of_faces_at_the_limits(void)
{
    const struct {
        fxl_direction normal;
        fxl_q16_16 far_z;
        bool is_seen;
    } cases[] = {{{0, 0, -FXL_Q2_30_ONE}, FXL_FAR_MAX, true},
                 {{4, 4, -FXL_Q2_30_ONE}, FXL_FAR_MAX, true},
                 {{FXL_Q2_30_ONE, 0, -1}, 2 * FXL_NEAR_MIN, false},
                 {{FXL_Q2_30_ONE, 0, -1}, Q16(2), false},
                 {{0, FXL_Q2_30_ONE, -1}, Q16(2), false}};
    const fxl_point corner = {0, 0, Q16(1)};
    for (uint32_t i = 0; i < 5; i++) {
        const bool is_seen = cases[i].is_seen;
        const fxl_depth_plane plane =
            depth_of_face(is_seen ? FXL_ORTHOGRAPHIC_SCALE_MAX : FXL_ORTHOGRAPHIC_SCALE_MIN,
                          FXL_NEAR_MIN, cases[i].far_z, corner, cases[i].normal);
        TEST_ASSERT_EQUAL(is_seen, plane.one != 0);
        TEST_ASSERT_TRUE(plane.gradient.along == 0 && plane.gradient.down == 0);
    }
}

/* A depth that changes by 100 a column has its place, 20 columns beside the middle of the screen. */
/* orthographic 2.11a */
void test_a_steep_face_has_its_depth_where_it_is(void)
{
    const fxl_point corner = {Q16(320), 0, Q16(1)};
    const fxl_direction normal = {759250125, 0, -759250125};
    const fxl_depth_plane plane = depth_of_face(Q16(0.0625), Q16(1), Q16(1.08), corner, normal);
    const int64_t twice =
        2 * plane.gradient.at + (43 + 44) * plane.gradient.along; /* between these columns */
    TEST_ASSERT_TRUE(fabs(ldexp((double)twice, -plane.one - 1) - 1) < 0x1p-12);
    TEST_ASSERT_TRUE(fabs(ldexp((double)plane.gradient.along, -plane.one) + 100) < 0.1);
    TEST_ASSERT_EQUAL_INT64(0, plane.gradient.down);
}

/* The sequence of faces is the same where no bounds of faces are known. */
/* orthographic 2.5a */
void test_faces_without_bounds_come_in_the_same_sequence(void)
{
    for (int round = 0; round < UNIT_REPEAT / 2000 + 2; round++) {
        const fxl_pose pose = tiny_pose_about();
        start(TINY_INSTANCES, LIST_WORDS);
        for (uint32_t i = 0; i < 2; i++) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frames[i], WIDTH));
            tiny->scene.face_bounds = NULL;
            tiny->scene.face_bounds_count = 0;
        }
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
    }
}

/* --- what is refused --------------------------------------------------------------------------- */

static void expect_conflict(const fxl_pose *pose, const char *first, const char *second)
{
    const char *names[2];
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_begin(&renderer, pose));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    TEST_ASSERT_EQUAL_STRING(first, names[0]);
    TEST_ASSERT_EQUAL_STRING(second, names[1]);
    const char *sentence = fxl_render_explain(&renderer, pose, frames[0], WIDTH, NULL);
    TEST_ASSERT_NOT_NULL(sentence);
    TEST_ASSERT_NOT_NULL(strstr(sentence, first));
    TEST_ASSERT_NOT_NULL(strstr(sentence, second));
}

/* orthographic 1.3a, 1.3b */
void test_what_does_not_go_with_the_lens_is_refused(void)
{
    const fxl_pose pose = tiny_pose_before();
    fxl_config config;
    static fxl_outlines outlines;
    const fxl_outline_style style = {.line = 77};
    start(TINY_INSTANCES, LIST_WORDS);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_world, NULL, 0));
    expect_conflict(&pose, "an orthographic lens", "a clipper of the study");
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_view, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, room, sizeof room));
    expect_conflict(&pose, "the order by tree", "an orthographic lens");

    config = fxl_config_default(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_orthographic(NULL, Q16(3)));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &tiny->scene, &config, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_renderer_set_orthographic(&renderer, 4095));
    TEST_ASSERT_NULL(renderer.frame.view.lens.off_centre);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(3)));
    TEST_ASSERT_EQUAL(Q16(3), renderer.frame.view.lens.focal);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_set_orthographic(&renderer, Q16(3)));
    const fxl_memory memory = {order, 64, NULL, 0, NULL, 0};
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_bare(&renderer, &tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(3))); /* no target */
    TEST_ASSERT_TRUE(renderer.clipper == NULL && renderer.order == NULL);
    memset(&renderer, 0, sizeof renderer);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_renderer_set_orthographic(&renderer, Q16(3)));
}
