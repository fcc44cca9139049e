/* SPDX-License-Identifier: MIT */
/* Faces of which several polygons come: by their clipper, by their walk, by light. Counted
 * once, and in the list wholly or not at all. */
#include "../../lib/draw/submit.h"
#include "choices.h"
#include "frame_bands.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    LIT = 100, /* is added to a colour */
    ORDER = TINY_INSTANCES + 6,
    LIST_WORDS = 240
};

static uint8_t frames[2][HEIGHT * WIDTH];
static uint32_t list[LIST_WORDS];
static fxl_draw_entry order[ORDER];
static fxl_renderer renderer;

static void start(uint32_t words)
{
    const fxl_memory memory = {order, ORDER, list, words, NULL, 0};
    tiny_scene *tiny = tiny_make();
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

/* In bands of so many rows, by what the renderer was told. */
static fxl_counters draw(const fxl_pose *pose, uint8_t *frame, uint32_t rows)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
    return renderer.workspace.counters;
}

static fxl_counters draw_plainly(const fxl_pose *pose)
{
    start(0);
    return draw(pose, frames[0], HEIGHT);
}

static void expect_counters(const fxl_counters *expected, const fxl_counters *found)
{
    TEST_ASSERT_EQUAL_UINT32(expected->in, found->in);
    TEST_ASSERT_EQUAL_UINT32(expected->backfacing, found->backfacing);
    TEST_ASSERT_EQUAL_UINT32(expected->outside, found->outside);
    TEST_ASSERT_EQUAL_UINT32(expected->drawn, found->drawn);
    TEST_ASSERT_EQUAL_UINT32(expected->clipped, found->clipped);
    TEST_ASSERT_EQUAL_UINT32(expected->refused, found->refused);
}

/* How much of the list was in use at each face's beginning. */
static uint32_t begins[32], begin_count;

static void note_begin(void)
{
    begins[begin_count++ % 32] = renderer.frame.display_list.used;
}

static bool is_begin(uint32_t used)
{
    bool found = used == 0;
    for (uint32_t i = 0; i < begin_count && i < 32; i++) {
        found = found || begins[i] == used;
    }
    return found;
}

/* A clipper that gives a fan of triangles, one at a time. */
static fxl_screen_polygon fan;
static uint8_t fan_next;
static fxl_clip_result fan_result;
static const fxl_clip_result *spoilt; /* what it says after a face's first triangle, or null */

static fxl_clip_result next_of_fan(const fxl_model_view *model_view, fxl_clipper_work *work,
                                   fxl_screen_polygon *screen)
{
    (void)model_view;
    memset(work, 0x5A, sizeof *work);
    if (fan_next + 1 >= fan.count) {
        return FXL_CLIP_OUTSIDE;
    }
    if (spoilt != NULL && fan_next > 1) {
        return *spoilt;
    }
    screen->colour = fan.colour;
    screen->count = 3;
    screen->points[0] = fan.points[0];
    screen->points[1] = fan.points[fan_next];
    screen->points[2] = fan.points[fan_next + 1];
    fan_next++;
    return fan_result;
}

static fxl_clip_result clip_into_fan(const fxl_model_view *model_view, const fxl_face *face,
                                     fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    note_begin();
    fan_result = fxl_clip_by_view(model_view, face, work, &fan);
    if (fan_result != FXL_CLIP_INSIDE && fan_result != FXL_CLIP_CUT) {
        return fan_result;
    }
    fan_next = 1;
    return next_of_fan(model_view, work, screen);
}

static const fxl_clipper fan_clipper = {.clip = clip_into_fan, .next = next_of_fan};

/* SPEC 7.3a-b */
void test_a_clipper_may_give_several_polygons(void)
{
    uint32_t full = 0, several = 0;
    spoilt = NULL;
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw_plainly(&pose);
        start(LIST_WORDS);
        begin_count = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fan_clipper, NULL, 0));
        fxl_counters found = draw(&pose, frames[1], HEIGHT);
        expect_counters(&expected, &found);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        const uint32_t all = renderer.frame.display_list.used, faces = begin_count;
        uint32_t words = (uint32_t)unit_between(0, (int32_t)all);
        start(words);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fan_clipper, NULL, 0));
        found = draw(&pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        begin_count = faces;
        TEST_ASSERT_TRUE(renderer.frame.display_list.used == all ||
                         is_begin(renderer.frame.display_list.used));
        expect_counters(&expected, &found);
        TEST_ASSERT_TRUE(found.spilled <= expected.spilled);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        full += found.spilled > 0;
        several += all > found.drawn * FXL_DISPLAY_LIST_WORDS(3);
    }
    TEST_ASSERT_TRUE(full > UNIT_REPEAT / 1000 && several > UNIT_REPEAT / 1000);
}

/* Refused counts once, and before anything else; what has too few corners does not. */
/* beams 4.2c-f */
void test_the_worst_of_a_faces_polygons_counts(void)
{
    static const fxl_clip_result worst[] = {FXL_CLIP_RANGE, FXL_CLIP_CAPACITY, FXL_CLIP_DEGENERATE};
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    fxl_counters expected = draw_plainly(&pose);
    TEST_ASSERT_TRUE(expected.drawn > 0 && expected.refused == 0);
    for (int i = 0; i < 3; i++) {
        start(i == 0 ? LIST_WORDS : 0);
        spoilt = &worst[i];
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fan_clipper, NULL, 0));
        fxl_counters found = draw(&pose, frames[1], HEIGHT);
        TEST_ASSERT_EQUAL_UINT32(i < 2 ? expected.drawn : 0, found.refused);
        TEST_ASSERT_EQUAL_UINT32(i < 2 ? 0 : expected.drawn, found.drawn);
        TEST_ASSERT_EQUAL_UINT32(expected.in, found.in);
        TEST_ASSERT_EQUAL_UINT32(i < 2 ? 0 : expected.spilled, found.spilled);
    }
    spoilt = NULL;
}

/* A walk that gives each face that faces the eye as two loose triangles and a rest. */
static bool give_in_pieces(const fxl_traversal *traversal, const fxl_instance *instance,
                           const fxl_face *face)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_model *model = &scene->models[instance->model];
    fxl_point corners[FXL_FACE_VERTICES_MAX];
    fxl_pieces pieces;
    for (uint32_t i = 0; i < face->count; i++) {
        corners[i] =
            scene->vertices[model->first_vertex + fxl_face_indices(scene->indices, face)[i]];
        corners[i].x += instance->centre.x;
        corners[i].y += instance->centre.y;
        corners[i].z += instance->centre.z;
    }
    fxl_pieces_begin(&pieces, traversal);
    for (uint32_t i = 1; i + 1 < face->count; i++) {
        const fxl_point triangle[] = {corners[0], corners[i], corners[i + 1]};
        if (!fxl_submit_piece(&pieces, triangle, 3, face->material)) {
            break;
        }
    }
    return fxl_pieces_end(&pieces);
}

static bool walk_in_pieces(const fxl_traversal *traversal)
{
    const fxl_scene *scene = traversal->renderer->scene;
    for (; traversal->resume->instances < traversal->renderer->frame.visible_count;
         traversal->resume->instances++) {
        const fxl_instance *instance =
            &scene->instances[traversal->renderer->frame.draw_list[traversal->resume->instances]
                                  .index];
        const fxl_model *model = &scene->models[instance->model];
        for (; traversal->resume->faces < model->face_count; traversal->resume->faces++) {
            const fxl_face *face = &scene->faces[model->first_face + traversal->resume->faces];
            bool front = fxl_face_is_front(scene, instance, face,
                                           &traversal->renderer->frame.view.camera.position);
            if (traversal->band == NULL) {
                note_begin();
            }
            if (front && !give_in_pieces(traversal, instance, face)) {
                return false;
            }
            traversal->counters->in += 1;
            traversal->counters->backfacing += !front;
        }
        traversal->resume->faces = 0;
    }
    return true;
}

/* beams 4.2a, SPEC 7.3a-b */
void test_a_face_in_pieces_counts_once(void)
{
    static choice in_pieces;
    uint32_t full = 0;
    in_pieces = choice_sorted;
    static const fxl_order by_pieces = {.submit = walk_in_pieces};
    in_pieces.order = &by_pieces;
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw_plainly(&pose);
        start((uint32_t)unit_between(0, LIST_WORDS));
        begin_count = 0;
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &in_pieces, NULL, 0));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_TRUE(renderer.frame.resume.instances == renderer.frame.visible_count ||
                         begins[(begin_count - 1) % 32] == renderer.frame.display_list.used);
        fxl_counters found = draw(&pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        expect_counters(&expected, &found);
        TEST_ASSERT_TRUE(found.spilled <= expected.spilled);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        full += found.spilled > 0 && renderer.frame.display_list.used > 0;
    }
    TEST_ASSERT_TRUE(full > UNIT_REPEAT / 2000);
}

/* Light on the first object alone, which it splits along a diagonal. */
static uint32_t asked;

static bool reaches(const fxl_shader *light, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)light;
    asked++;
    TEST_ASSERT_TRUE(scene == renderer.scene);
    return instance->centre.z == 0;
}

static bool split(const fxl_shader *light, fxl_pieces *pieces, const fxl_face *face,
                  const fxl_point *points, uint32_t count)
{
    const fxl_point first[] = {points[0], points[1], points[2]};
    const fxl_point second[] = {points[0], points[2], points[3]};
    TEST_ASSERT_TRUE(count == 4 && light == renderer.shader);
    return fxl_submit_piece(pieces, first, 3, (uint8_t)(face->material + LIT)) &&
           fxl_submit_piece(pieces, second, 3, face->material);
}

static const fxl_shader_code splitting = {.reaches = reaches,
                                          .face = fxl_submit_split_face,
                                          .split = split,
                                          .in_world = &fxl_rounded_faces};

void test_light_splits_the_faces_that_it_reaches(void)
{
    fxl_shader light = {NULL, FXL_SHADER_BEAMS, &splitting};
    uint32_t lit = 0, dark = 0;
    asked = 0;
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        fxl_pose pose = tiny_pose_before();
        fxl_counters expected = draw_plainly(&pose);
        start((uint32_t)unit_between(0, LIST_WORDS));
        renderer.shader = &light;
        fxl_counters found = draw(&pose, frames[1], (uint32_t)unit_between(1, HEIGHT));
        expect_counters(&expected, &found);
        for (uint32_t i = 0; i < HEIGHT * WIDTH; i++) {
            bool is_lit = frames[1][i] >= LIT && frames[1][i] != BACKGROUND;
            TEST_ASSERT_EQUAL(frames[0][i], frames[1][i] - (is_lit ? LIT : 0));
            TEST_ASSERT_TRUE(!is_lit || frames[0][i] <= 6);
            lit += is_lit;
            dark += frames[1][i] <= 6;
        }
    }
    TEST_ASSERT_TRUE(lit > UNIT_REPEAT / 50 && dark > UNIT_REPEAT / 50 && asked > 0);
}

/* A clipper that notes the planes of the pieces: their vertices are not the scene's. */
static uint32_t pieces_seen, planes_seen;

static fxl_clip_result note_planes(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const fxl_point *scene = renderer.scene->vertices;
    if (model_view->vertices != scene && model_view->vertices != scene + 8) {
        pieces_seen++;
        planes_seen |= model_view->planes;
    }
    return fxl_clip_by_view(model_view, face, work, screen);
}

/* A piece needs the planes of its face: none where the instance's sphere is inside all of them. */
void test_pieces_need_the_planes_of_their_face(void)
{
    static const fxl_clipper noting = {.clip = note_planes};
    fxl_shader light = {NULL, FXL_SHADER_BEAMS, &splitting};
    const fxl_pose inside = {{0, 0, Q16(-6)}, 0, 0, 0},
                   across = {{0, 0, Q16(-3)}, DEGREES(45), 0, 0};
    for (int i = 0; i < 2; i++) {
        start(LIST_WORDS);
        renderer.shader = &light;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &noting, NULL, 0));
        pieces_seen = planes_seen = 0;
        (void)draw(i == 0 ? &inside : &across, frames[1], HEIGHT);
        TEST_ASSERT_TRUE(pieces_seen > 0);
        TEST_ASSERT_EQUAL(i == 0, planes_seen == 0);
        TEST_ASSERT_TRUE(planes_seen != FXL_PLANES_ALL);
    }
}

/* A clipper with room: zeroed when it is set, reached by the view, in the frame's number. */
static fxl_clip_result clip_with_workspace(const fxl_model_view *model_view, const fxl_face *face,
                                           fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    uint32_t *room = model_view->clipper_workspace;
    TEST_ASSERT_TRUE(model_view->view->frame != 0);
    if (room[0] != model_view->view->frame) {
        room[0] = model_view->view->frame;
        room[1]++;
    }
    return fxl_clip_by_view(model_view, face, work, screen);
}

void test_a_clippers_room(void)
{
    static const fxl_clipper roomy = {.clip = clip_with_workspace, .workspace_size = 16};
    static uint64_t room[2];
    uint32_t *const words = (uint32_t *)(void *)room;
    fxl_pose pose = {{Q16(0.5), Q16(0.25), Q16(-4)}, 0, 0, 0};
    fxl_counters expected = draw_plainly(&pose);
    memset(room, 0x5A, sizeof room);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_clipper(NULL, &roomy, room, 16));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_clipper(&renderer, NULL, room, 16));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_renderer_set_clipper(&renderer, &roomy, NULL, 16));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_renderer_set_clipper(&renderer, &roomy, words + 1, 16));
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_renderer_set_clipper(&renderer, &roomy, room, 15));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, room, sizeof room);
    TEST_ASSERT_EQUAL_UINT32(5 - 1, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_TRUE(renderer.clipper == &fxl_clipper_view);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &roomy, room, 16));
    TEST_ASSERT_EACH_EQUAL_HEX8(0, room, sizeof room);
    const fxl_band band = UNIT_BAND(frames[1], WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    for (uint32_t frame = 1; frame < 4; frame++) {
        fxl_counters found = draw(&pose, frames[1], 5);
        expect_counters(&expected, &found);
        TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
        TEST_ASSERT_EQUAL_UINT32(frame, words[1]);
    }
}
