/* SPDX-License-Identifier: MIT */
/* A renderer with a light: what lies in the beam is lit, all else is as before, in bands as
 * whole, and no pixel between lit and dark is left out or drawn twice. */
#include "../../lib/paint/lit_pieces.h"
#include "choices.h"
#include "frame_bands.h"
#include "painters.h"
#include "tiny.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 32,
    WORDS = 700,
    WORKSPACE = 4608,
    PIECES = 160
};

static tiny_scene *tiny;
static fxl_renderer renderer;
static fxl_draw_entry order[32];
static uint32_t list[WORDS];
static uint64_t room[WORKSPACE / 8];
static uint8_t whole[WIDTH * HEIGHT], other[WIDTH * HEIGHT], drawn[WIDTH * HEIGHT];
static uint8_t lit[256], same[256];

/* A shaft over the first cube that no face's edge runs along. */
static const fxl_point window[] = {{Q16(-0.6), Q16(5), Q16(-0.7)},
                                   {Q16(0.5), Q16(5), Q16(-0.8)},
                                   {Q16(0.7), Q16(5), Q16(0.4)},
                                   {Q16(-0.4), Q16(5), Q16(0.6)}};
static fxl_beam beams[2];

static void make(uint32_t words)
{
    const fxl_point lamp = {Q16(0.3), Q16(90), Q16(-3)};
    const fxl_direction slanted = {0, Q30(-0.6), Q30(0.8)};
    const fxl_memory memory = {order, 32, list, words, NULL, 0};
    tiny = tiny_make();
    for (int i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + 100);
        same[i] = (uint8_t)i;
    }
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beams[0]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&slanted, window, 4, &beams[1]));
}

static void light(uint32_t count, const uint8_t *colours)
{
    const fxl_beam_set set = {beams, count, colours};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_beams(&renderer, count > 0 ? &set : NULL, room, sizeof room));
}

/* Towards the first cube from somewhere about it. */
static fxl_pose any_pose(void)
{
    const fxl_angle yaw = unit_random();
    fxl_pose pose = {{0, 0, 0}, yaw, DEGREES(unit_between(-60, 20)), unit_random() % 2 ? 0 : yaw};
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    int32_t back = unit_between(2, 5);
    pose.position =
        (fxl_point){-camera.axes.forward.x / 16384 * back, -camera.axes.forward.y / 16384 * back,
                    -camera.axes.forward.z / 16384 * back};
    return pose;
}

static int differing(const uint8_t *a, const uint8_t *b)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        count += a[i] != b[i];
    }
    return count;
}

static int lit_pixels(const uint8_t *pixels)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        count += pixels[i] > 100;
    }
    return count;
}

/* From above: the lid is lit in its middle, its border is not, and dark is what was there. */
/* beams 2.1a-c */
void test_what_lies_in_the_beam_is_lit(void)
{
    const fxl_pose above = {{0, Q16(4), 0}, 0, DEGREES(-90), 0};
    make(WORDS);
    frame_draw_pose(&renderer, &above, whole, HEIGHT, 0);
    light(1, lit);
    frame_draw_pose(&renderer, &above, other, HEIGHT, 0);
    int bright = lit_pixels(other);
    TEST_ASSERT_TRUE(bright > 30 && bright < 200);
    TEST_ASSERT_EQUAL_HEX8(104, other[HEIGHT / 2 * WIDTH + WIDTH / 2]);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        TEST_ASSERT_TRUE(other[i] == whole[i] || other[i] == lit[whole[i]]);
    }
    light(0, NULL);
    frame_draw_pose(&renderer, &above, other, HEIGHT, 0);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
}

/* A second beam falls beside the cube, and its light is no shadow of the first. */
/* beams 2.1b */
void test_what_one_beam_lights_stays_lit(void)
{
    const fxl_pose above = {{0, Q16(4), 0}, 0, DEGREES(-90), 0};
    const fxl_direction down = {0, -FXL_Q2_30_ONE, 0};
    fxl_point beside[4];
    make(WORDS);
    light(1, lit);
    frame_draw_pose(&renderer, &above, whole, HEIGHT, 0);
    for (int i = 0; i < 4; i++) {
        beside[i] = (fxl_point){window[i].x + Q16(40), window[i].y, window[i].z + Q16(40)};
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&down, beside, 4, &beams[1]));
    light(2, lit);
    frame_draw_pose(&renderer, &above, other, HEIGHT, 0);
    TEST_ASSERT_TRUE(lit_pixels(whole) > 30);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
}

/* Under the lid the beam passes through faces that are turned away from the lamp. */
/* beams 2.1a, 2.1c */
void test_what_is_turned_away_stays_dark(void)
{
    const fxl_pose below = {{0, Q16(-4), 0}, 0, DEGREES(90), 0};
    make(WORDS);
    light(1, lit);
    frame_draw_pose(&renderer, &below, other, HEIGHT, 0);
    TEST_ASSERT_EQUAL(0, lit_pixels(other));
    TEST_ASSERT_EQUAL_HEX8(3, other[HEIGHT / 2 * WIDTH + WIDTH / 2]);
}

void test_bands_and_lists_give_the_same_pixels(void)
{
    int bright = 0;
    for (int i = 0; i < UNIT_REPEAT / 200; i++) {
        const fxl_pose pose = any_pose();
        const uint32_t count = 1 + unit_random() % 2;
        make(WORDS);
        light(count, lit);
        frame_draw_pose(&renderer, &pose, whole, HEIGHT, 0);
        fxl_counters counters = renderer.workspace.counters;
        make((uint32_t)unit_between(0, WORDS));
        light(count, lit);
        frame_draw_pose(&renderer, &pose, other, (uint32_t)unit_between(1, HEIGHT), 0);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        counters.spilled = renderer.workspace.counters.spilled;
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        TEST_ASSERT_EQUAL_UINT32(counters.in, counters.backfacing + counters.outside +
                                                  counters.degenerate + counters.refused +
                                                  counters.drawn);
        bright += lit_pixels(whole) > 0;
    }
    TEST_ASSERT_TRUE(bright > UNIT_REPEAT / 800);
}

/* One cube alone, so that no pixel is painted twice without light. With light there may be
 * neither gaps nor pixels painted twice, but for a centre within a hair of the cube's outline,
 * which a crossing half a unit of 1/65536 beside it lets in or out. */
void test_no_pixel_is_left_out_or_painted_twice(void)
{
    int moved = 0, pixels = 0;
    for (int i = 0; i < UNIT_REPEAT / 100; i++) {
        const fxl_pose pose = any_pose();
        make(0);
        tiny->instances[1].centre.y = tiny->instances[2].centre.y = Q16(-7000);
        choice method = choice_sorted;
        method.target = painter_counting(drawn, WIDTH, 255);
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &method, NULL, 0));
        memset(drawn, 0, sizeof drawn);
        frame_draw_pose(&renderer, &pose, whole, HEIGHT, 0);
        memcpy(whole, drawn, sizeof whole);
        light(1 + unit_random() % 2, lit);
        memset(drawn, 0, sizeof drawn);
        frame_draw_pose(&renderer, &pose, other, HEIGHT, 0);
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            TEST_ASSERT_TRUE(drawn[k] <= 1);
            pixels += drawn[k];
        }
        moved += differing(whole, drawn);
    }
    TEST_ASSERT_TRUE(pixels > UNIT_REPEAT / 10);
    TEST_ASSERT_TRUE(moved <= 1);
}

/* A clipper that writes down which pieces it got, by colour and a sum of their corners, and draws
 * none. */
static uint32_t taken[PIECES], taken_count;

static fxl_clip_result take_down(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    uint32_t sum = face->count;
    (void)work;
    (void)screen;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_point *point =
            &model_view->vertices[fxl_face_indices(model_view->indices, face)[i]];
        sum = sum * 31u + (uint32_t)point->x * 7u + (uint32_t)point->y * 5u + (uint32_t)point->z;
    }
    TEST_ASSERT_TRUE(taken_count < PIECES);
    taken[taken_count++] = sum << 8 | face->material;
    return FXL_CLIP_OUTSIDE;
}

/* The pieces of a frame, in the order in which the clipper gets them. */
static void take_pieces(const fxl_pose *pose, bool is_near_first)
{
    static const fxl_clipper watching = {.clip = take_down};
    choice method = choice_sorted;
    make(0);
    if (is_near_first) {
        method.target = painter_under(0);
    }
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &method, NULL, 0));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &watching, NULL, 0));
    light(2, lit);
    taken_count = 0;
    frame_draw_pose(&renderer, pose, whole, HEIGHT, 0);
}

/* Near to far, the pieces of a face, and the faces, come in the exact reverse. */
/* beams 4.1b */
void test_near_to_far_is_the_reverse(void)
{
    static uint32_t forward[PIECES];
    uint32_t longest = 0;
    for (int round = 0; round < UNIT_REPEAT / 500 + 4; round++) {
        const fxl_pose pose = any_pose();
        uint32_t run = 0;
        take_pieces(&pose, false);
        const uint32_t count = taken_count;
        for (uint32_t i = 0; i < count; i++) {
            forward[i] = taken[i];
            run = i > 0 && taken[i] % 256 % 100 == taken[i - 1] % 256 % 100 ? run + 1 : 0;
            longest = run > longest ? run : longest;
        }
        take_pieces(&pose, true);
        TEST_ASSERT_EQUAL_UINT32(count, taken_count);
        for (uint32_t i = 0; i < count; i++) {
            TEST_ASSERT_EQUAL_HEX32(forward[count - 1 - i], taken[i]);
        }
    }
    TEST_ASSERT_TRUE(longest >= 3); /* a face of four pieces */
}

/* Near to far, the pieces of a face are drawn as far to near. */
/* beams 4.1b */
void test_near_to_far_gives_the_same_pixels(void)
{
    choice reverse = choice_sorted;
    int bright = 0;
    reverse.target = painter_under(0);
    for (int i = 0; i < UNIT_REPEAT / 200; i++) {
        const fxl_pose pose = any_pose();
        make(0);
        light(1u + (uint32_t)i % 2, lit);
        frame_draw_pose(&renderer, &pose, whole, HEIGHT, 0);
        make(0);
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &reverse, NULL, 0));
        light(1u + (uint32_t)i % 2, lit);
        frame_draw_pose(&renderer, &pose, other, HEIGHT, 0);
        TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
        bright += lit_pixels(whole) > 0;
    }
    TEST_ASSERT_TRUE(bright > UNIT_REPEAT / 3000);
}

void test_what_makes_no_light_is_refused(void)
{
    make(WORDS);
    const uint32_t needed = fxl_beam_light_workspace_size(beams, 2);
    TEST_ASSERT_TRUE(needed > 0 && needed <= sizeof room);
    TEST_ASSERT_EQUAL(0, fxl_beam_light_workspace_size(NULL, 2));
    fxl_beam_set set = {beams, 1, lit};
    const fxl_beam_set no_beams = {NULL, 1, lit}, no_colours = {beams, 1, NULL};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_beams(NULL, &set, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_beams(&renderer, &no_beams, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_beams(&renderer, &no_colours, room, sizeof room));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_beams(&renderer, &set, NULL, sizeof room));
    for (int off = 1; off < 8; off *= 2) {
        TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_attach_beams(&renderer, &set, (uint8_t *)room + off,
                                                            (uint32_t)(WORKSPACE - off)));
    }
    set.count = FXL_BEAMS_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_attach_beams(&renderer, &set, room, sizeof room));
    set.count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_attach_beams(&renderer, &set, room, sizeof room));
    set.count = 2;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_attach_beams(&renderer, &set, room, needed - 1));
    TEST_ASSERT_EQUAL_UINT32(9, renderer.workspace.counters.refused_calls);
    TEST_ASSERT_NULL(renderer.shader);
    beams[1].plane_count = 0;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_attach_beams(&renderer, &set, room, sizeof room));
    set.count = 1;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &set, room, sizeof room));
    TEST_ASSERT_NOT_NULL(renderer.shader);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, NULL, NULL, 0));
    TEST_ASSERT_NULL(renderer.shader);
}

/* A comb whose teeth all cross two sides of the beam: its parts need more corners than there is
 * memory for. The loader does not check that faces are convex. Such a face is drawn whole and
 * dark, and counts as refused. */
/* beams 4.4a */
void test_what_has_no_room_is_drawn_dark(void)
{
    static fxl_point comb[FXL_FACE_VERTICES_MAX - 5];
    static uint16_t corners[FXL_FACE_VERTICES_MAX - 5];
    const fxl_pose above = {{0, Q16(6), 0}, 0, DEGREES(-90), 0};
    const uint32_t count = FXL_FACE_VERTICES_MAX - 5;
    for (uint32_t i = 0; i < count; i++) {
        corners[i] = (uint16_t)i;
        comb[i] = (fxl_point){Q16(-0.3) + (int32_t)i * 2000, 0, i % 2 ? Q16(2) : Q16(-2)};
    }
    make(WORDS);
    tiny->models[0].vertex_count = count;
    tiny->models[0].face_count = 1;
    tiny->models[0].radius = Q16(4);
    tiny->faces[0].normal = (fxl_direction){0, FXL_Q2_30_ONE, 0};
    tiny->faces[0].count = (uint8_t)count;
    fxl_face_take_indices(&tiny->faces[0], corners, 0);
    fxl_scene *scene = &tiny->scene;
    scene->vertices = comb;
    scene->indices = corners;
    scene->instance_count = scene->model_count = scene->face_count = 1;
    scene->vertex_count = scene->index_count = count;
    scene->face_bounds = NULL;
    scene->face_bounds_count = 0;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(scene, NULL));
    frame_draw_pose(&renderer, &above, whole, HEIGHT, 0);
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.drawn);
    TEST_ASSERT_NOT_NULL(memchr(whole, 1, sizeof whole));
    light(1, lit);
    frame_draw_pose(&renderer, &above, other, HEIGHT, 0);
    TEST_ASSERT_EQUAL_UINT32(0, renderer.workspace.counters.drawn);
    TEST_ASSERT_EQUAL_UINT32(1, renderer.workspace.counters.refused);
    TEST_ASSERT_EQUAL_MEMORY(whole, other, sizeof whole);
}

/* 15 vertices and 5 planes fit, 16 and twice 5 more do not. */
void test_a_face_of_too_many_corners_is_refused(void)
{
    make(WORDS);
    TEST_ASSERT_TRUE(fxl_beams_fit(beams, 1, FXL_FACE_VERTICES_MAX - 5));
    TEST_ASSERT_FALSE(fxl_beams_fit(beams, 1, FXL_FACE_VERTICES_MAX - 4));
    TEST_ASSERT_TRUE(fxl_beams_fit(beams, 2, FXL_FACE_VERTICES_MAX - 15));
    TEST_ASSERT_FALSE(fxl_beams_fit(beams, 2, FXL_FACE_VERTICES_MAX - 14));
    TEST_ASSERT_EQUAL_UINT32(0, fxl_beam_light_workspace_size(beams, 0));
#ifdef UNIT_ON_TARGET /* beams.h says so */
    static const uint8_t planes[] = {4, 5, 8};
    static const uint32_t rooms[] = {1296, 1384, 1600};
    for (int i = 0; i < 3; i++) {
        beams[0].plane_count = planes[i];
        TEST_ASSERT_EQUAL_UINT32(rooms[i], fxl_beam_light_workspace_size(beams, 1));
    }
#endif
}

/* Beams that leave room for triangles alone: a face of four corners is refused wherever it is. */
/* beams 4.3a */
void test_every_face_must_fit_the_beams(void)
{
    static fxl_beam narrow[2];
    const fxl_beam_set set = {narrow, 2, lit};
    narrow[1].plane_count = (uint8_t)((FXL_FACE_VERTICES_MAX - 3) / 3); /* each adds two vertices */
    narrow[0].plane_count = (uint8_t)(FXL_FACE_VERTICES_MAX - 3 - 2 * narrow[1].plane_count);
    for (uint32_t i = 0; i < FXL_BEAM_PLANES_MAX; i++) {
        for (uint32_t b = 0; b < 2; b++) {
            narrow[b].planes[i].normal.x = i < narrow[b].plane_count ? FXL_Q2_30_ONE : 0;
        }
    }
    make(0);
    const uint32_t size = fxl_beam_light_workspace_size(narrow, 2); /* nothing is drawn there */
    for (uint32_t larger = 0; larger < 12; larger++) {
        for (uint32_t i = 0; i < 12; i++) {
            tiny->faces[i].count = i == larger ? 4 : 3;
        }
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_attach_beams(&renderer, &set, room, size));
    }
    TEST_ASSERT_EQUAL_UINT32(12, renderer.workspace.counters.refused_calls);
    /* The face after those of the scene need not fit. */
    tiny->scene.face_count = 11;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_beams(&renderer, &set, room, size));
}

/* No memory is of use for beams that would cut a triangle into polygons of too many vertices. Each
 * plane of the first beam adds a vertex at most, each plane of the other beams two. */
/* beams 4.3 */
void test_beams_that_leave_no_room_for_a_triangle(void)
{
    static fxl_beam several[FXL_BEAMS_MAX + 1];
    for (uint8_t first = 1; first <= FXL_BEAM_PLANES_MAX; first++) {
        for (uint8_t second = 1; second <= FXL_BEAM_PLANES_MAX; second++) {
            several[0].plane_count = first;
            several[1].plane_count = second;
            several[2].plane_count = 1;
            TEST_ASSERT_EQUAL(3 + first + 2 * second <= FXL_FACE_VERTICES_MAX,
                              fxl_beam_light_workspace_size(several, 2) > 0);
            TEST_ASSERT_EQUAL(3 + first + 2 * (second + 1) <= FXL_FACE_VERTICES_MAX,
                              fxl_beam_light_workspace_size(several, 3) > 0);
        }
    }
    for (uint32_t count = 0; count <= FXL_BEAMS_MAX + 1; count++) { /* of a plane each, they fit */
        several[count > 0 ? count - 1 : 0].plane_count = 1;
        TEST_ASSERT_EQUAL(count >= 1 && count <= FXL_BEAMS_MAX,
                          fxl_beam_light_workspace_size(several, count) > 0);
    }
}

/* The workspace holds the tables of a face's pieces and one outline, each rounded up to 8 bytes,
 * and the records beside them. */
void test_the_workspace_holds_the_tables(void)
{
    make(0);
    for (uint32_t count = 1; count <= 2; count++) {
        const size_t corners = fxl_lit_corners_needed(beams, count);
        const size_t tables = corners * (sizeof(fxl_point) + sizeof(uint16_t)) +
                              fxl_lit_pieces_needed(beams, count) * sizeof(fxl_lit_piece) +
                              FXL_POLYGON_CAPACITY * sizeof(fxl_point) + sizeof(fxl_lit_pieces);
        const size_t size = fxl_beam_light_workspace_size(beams, count);
        TEST_ASSERT_TRUE(size > tables && size <= tables + 16 * sizeof(void *) + 6 * 7);
        TEST_ASSERT_EQUAL(0, size % 8);
    }
}
