/* SPDX-License-Identifier: MIT */
/* Turned instances in whole frames: among a tree, in reach of a beam, and with clippers that work
 * from points of the world; and frames with placements that are refused. */
#include "bsp_scene.h"
#include "choices.h"
#include "clippers_list.h"
#include "frame_bands.h"
#include "scene/placement_code.h"
#include "view/placement.h"
#include "tiny.h"
#include "tiny_frames.h"

/* Among a tree, in reach of a beam, and with clippers that work from points of the world, a turned
 * instance is drawn as a model of the rounded points would be. */

enum {
    WIDTH = 48,
    HEIGHT = 32,
    BACKGROUND = 200,
    WORDS = 400,
    ORDER = TINY_INSTANCES + 6,
    TURNED = 2, /* the instance that is turned */
    METHODS = 3
};

static FXL_ALIGN_8 fxl_clipper_workspace clipper_room;
static uint64_t bsp_room[64], pieces[768], light_room[600];
static uint8_t frames[2][WIDTH * HEIGHT], lit[256];
static uint32_t list[WORDS];
static fxl_draw_entry order[ORDER];
static fxl_renderer renderer;
static fxl_placement placement;

/* The scene with a model of the rounded points in place of the placement. */
static struct {
    fxl_point vertices[24];
    uint16_t indices[72];
    fxl_face faces[18];
    fxl_model models[3];
    fxl_instance instances[TINY_INSTANCES];
    fxl_scene scene;
} baked;

static const fxl_point window[] = {{Q16(-0.6), Q16(5), Q16(-0.7)},
                                   {Q16(0.5), Q16(5), Q16(-0.8)},
                                   {Q16(0.7), Q16(5), Q16(0.4)},
                                   {Q16(-0.4), Q16(5), Q16(0.6)}};
static fxl_beam beam;

static void bake(const tiny_scene *tiny)
{
    const fxl_model *model = &tiny->models[0];
    const fxl_point nowhere = {0, 0, 0};
    memcpy(baked.vertices, tiny->vertices, sizeof tiny->vertices);
    memcpy(baked.indices, tiny->corners, sizeof tiny->corners);
    memcpy(baked.indices + 48, tiny->corners, 24 * sizeof *baked.indices);
    memcpy(baked.faces, tiny->faces, sizeof tiny->faces);
    memcpy(baked.models, tiny->models, sizeof tiny->models);
    memcpy(baked.instances, tiny->instances, sizeof tiny->instances);
    for (uint32_t i = 0; i < 8; i++) {
        fxl_placement_point(&placement, &nowhere, &tiny->vertices[i], &baked.vertices[16 + i]);
    }
    for (uint32_t i = 0; i < 6; i++) {
        baked.faces[12 + i] = tiny->faces[i];
        fxl_face_take_indices(&baked.faces[12 + i], baked.indices, 48 + 4 * i);
        fxl_placement_direction(&placement, &tiny->faces[i].normal, &baked.faces[12 + i].normal);
    }
    baked.models[2] = *model;
    baked.models[2].first_vertex = 16;
    baked.models[2].first_face = 12;
    baked.models[2].radius = fxl_placement_radius(&placement, model->radius);
    baked.instances[TURNED].model = 2;
    baked.scene = tiny->scene;
    baked.scene.vertices = baked.vertices;
    baked.scene.indices = baked.indices;
    baked.scene.faces = baked.faces;
    baked.scene.models = baked.models;
    baked.scene.instances = baked.instances;
    baked.scene.vertex_count = 24;
    baked.scene.index_count = 72;
    baked.scene.face_count = 18;
    baked.scene.model_count = 3;
    baked.scene.placements = NULL;
}

/* Method 0 sorts; 1 has a tree; 2 has no memory for the pieces of its tree. */
static void draw(fxl_scene *scene, const fxl_clipper *clipper, int method, bool is_lit,
                 const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    fxl_scene_fault fault = {"", 0};
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    const fxl_memory memory = {order, ORDER, list, (uint32_t)unit_between(0, WORDS), NULL, 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check_all(scene, &fault), fault.what);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, &clipper_room,
                                                       clipper->workspace_size));
    if (method > 0) {
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, bsp_room, sizeof bsp_room));
        fxl_bsp_workspace *workspace = renderer.order_memory;
        workspace->pieces = method == 1 ? pieces : NULL;
        workspace->pieces_size = method == 1 ? sizeof pieces : 0;
    }
    if (is_lit) {
        const fxl_beam_set beams = {&beam, 1, lit};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_beams(&renderer, &beams, light_room, sizeof light_room));
    }
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

static bool is_in_sight(void)
{
    for (uint32_t i = 0; i < renderer.frame.visible_count; i++) {
        if (renderer.frame.draw_list[i].index == TURNED) {
            return true;
        }
    }
    return false;
}

/* The tree's cube at z = 10, or about the origin where the beam is. */
static tiny_scene *make(void)
{
    const fxl_point lamp = {Q16(0.3), Q16(90), Q16(-3)};
    tiny_scene *tiny = bsp_make()->tiny;
    for (int i = 0; i < 256; i++) {
        lit[i] = (uint8_t)(i + 100);
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beam));
    placement = unit_placement();
    placement.scale = unit_between(Q16(0.25), Q16(3));
    tiny->instances[TURNED].centre = unit_point(Q16(3));
    tiny->instances[TURNED].centre.z += Q16(10) * unit_between(0, 1);
    tiny->scene.placements = &placement;
    tiny->scene.first_turned = TURNED;
    tiny->scene.placement_code = &fxl_turned_instances;
    bake(tiny);
    return tiny;
}

static fxl_pose any_pose(void)
{
    fxl_pose pose = {unit_point(Q16(3)), unit_random(), unit_random(), unit_random()};
    pose.position.z += Q16(5) * unit_between(0, 2);
    return pose;
}

/* SPEC 8.4a, 8.5a, 8.5c-f, 8.5h, 8.5l */
void test_rounded_instances_are_those_of_a_baked_model(void)
{
    uint32_t rounded = 0, exact = 0, drawn = 0, spilled = 0;
    for (int round = 0; round < UNIT_REPEAT / 50; round++) {
        tiny_scene *tiny = make();
        const fxl_pose pose = any_pose();
        const int method = unit_between(0, METHODS - 1);
        const bool is_lit = unit_between(0, 1);
        const int which = unit_between(0, CLIPPERS + 1);
        const fxl_clipper *clipper = which < CLIPPERS    ? clippers[which]
                                     : which == CLIPPERS ? &fxl_clipper_view
                                                         : &fxl_clipper_world;
        draw(&baked.scene, clipper, method, is_lit, &pose, HEIGHT, frames[0]);
        fxl_counters expected = renderer.workspace.counters;
        const bool is_reached = is_lit && fxl_beam_reaches(&beam, &baked.instances[TURNED].centre,
                                                           baked.models[2].radius);
        draw(&tiny->scene, clipper, method, is_lit, &pose, (uint32_t)unit_between(1, HEIGHT),
             frames[1]);
        fxl_counters counters = renderer.workspace.counters;
        spilled += counters.spilled > 0;
        const bool is_rounded = method > 0 || is_reached || clipper->by_points != NULL;
        TEST_ASSERT_EQUAL_UINT16(is_rounded && is_in_sight(), counters.rounded);
        if (is_rounded) {
            TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], sizeof frames[0]);
            expected.spilled = counters.spilled = counters.rounded = 0;
            TEST_ASSERT_EQUAL_MEMORY(&expected, &counters, sizeof counters);
            rounded++;
        } else {
            exact++;
        }
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            drawn += frames[1][i] != BACKGROUND;
        }
    }
    TEST_ASSERT_TRUE(rounded > UNIT_REPEAT / 100 && exact > UNIT_REPEAT / 1000);
    TEST_ASSERT_TRUE(drawn > UNIT_REPEAT && spilled > UNIT_REPEAT / 1000);
}

/* A tree is over an instance that stands still. */
/* Close by, where a unit of rounding is a part of a pixel. Which faces are seen is not rounded. */
/* SPEC 8.5j */
void test_a_wireframe_has_rounded_points(void)
{
    static fxl_wire wire;
    uint32_t equal = 0, drawn = 0;
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        tiny_scene *tiny = make();
        const fxl_pose pose = {{unit_between(-600, 600), unit_between(-600, 600), 0}, 0, 0, 0};
        fxl_scene *const scenes[] = {&baked.scene, &tiny->scene};
        const fxl_band band = {
            .pixels = frames[0], .width = WIDTH, .stride = WIDTH, .rows = HEIGHT};
        placement.scale = FXL_SCALE_MIN;
        tiny->instances[TURNED].centre = (fxl_point){0, 0, 5000};
        bake(tiny);
        for (int i = 0; i < 2; i++) {
            fxl_band of = band;
            of.pixels = frames[i];
            memset(frames[i], 0, sizeof frames[i]);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(scenes[i], NULL));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, scenes[i], &lens, fxl_line_by_planes));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
            TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &of));
        }
        equal += memcmp(frames[0], frames[1], sizeof frames[0]) == 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            drawn += frames[1][i] != 0;
        }
    }
    TEST_ASSERT_TRUE(equal > UNIT_REPEAT * 95 / 10000 && drawn > UNIT_REPEAT / 10);
}

/* SPEC 8.5i, formats 1.9d */
void test_the_instance_of_a_tree_is_not_turned(void)
{
    static fxl_placement placements[TINY_INSTANCES];
    tiny_scene *tiny = make();
    fxl_scene_fault fault = {"", 0};
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        placements[i] = (fxl_placement)FXL_PLACEMENT_NONE;
    }
    tiny->scene.placements = placements;
    tiny->scene.first_turned = 1;
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_scene_check_all(&tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING("BSP tree", fault.what);
    tiny->scene.first_turned = 2;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, &fault));
}

/* SPEC 8.5l */
void test_each_turned_instance_in_sight_is_counted(void)
{
    static const fxl_q16_16 places[] = {0, Q16(40), Q16(-500)}; /* the last is behind the eye */
    const fxl_pose pose = {.position = {0, 0, Q16(-30)}};
    for (uint32_t first = 0; first <= TINY_INSTANCES; first++) {
        tiny_scene *of = tiny_make();
        static fxl_placement none[TINY_INSTANCES];
        uint32_t expected = 0;
        tiny_place_from(of, none, first);
        for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
            of->instances[i].centre = (fxl_point){0, 0, places[i % 3]};
            expected += i >= first && i % 3 < 2;
        }
        draw(&of->scene, &fxl_clipper_world, 0, false, &pose, HEIGHT, frames[0]);
        TEST_ASSERT_EQUAL_UINT16(expected, renderer.workspace.counters.rounded);
    }
}

/* A frame with placements that fxl_frame_begin refuses. The placements may have any values then, so
 * no call may read them: the frame before has ended. */

enum {
    PIXELS = WIDTH * HEIGHT,
    LIST_WORDS = 40 * FXL_DISPLAY_LIST_WORDS(8)
};

static fxl_draw_entry entries[64];
static uint32_t refused_list[LIST_WORDS];
static fxl_cached_vertex cache[9];
static fxl_placement placements[TINY_INSTANCES];
static tiny_scene *tiny;

/* The tiny scene, of which the instances from first on are turned, in a refused_list of so many
 * words. */
static void start_refused(uint32_t first, uint32_t list_words)
{
    const fxl_memory memory = {entries, 64, refused_list, list_words, cache, 9};
    tiny = tiny_make();
    tiny_place_from(tiny, placements, first);
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

static void draw_turned(const fxl_pose *pose, uint32_t rows, uint8_t *frame)
{
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
}

static void expect_refused(fxl_status status)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-5)}};
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(status, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
}

/* A refused frame has ended the frame before: no call reads the placements. */
static void expect_ended(void)
{
    const fxl_band band = UNIT_BAND(frames[1], WIDTH, 0, HEIGHT);
    fxl_picked picked;
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw(&renderer, &band));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_pick_face(&renderer, WIDTH / 2, HEIGHT / 2, &picked));
    for (int i = 0; i < PIXELS; i++) {
        TEST_ASSERT_EQUAL_UINT8(BACKGROUND, frames[1][i]);
    }
}

/* Instance 2 of a frame that was drawn gets a placement and a centre. The next frame is refused.
 * The table stays as it is while the frame before is asked for. */
static void expect_refused_and_ended(const fxl_placement *bad, fxl_q16_16 centre_x,
                                     fxl_status status)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    fxl_instance *instance = &tiny->instances[2];
    const fxl_placement good = placements[1];
    const fxl_q16_16 good_x = instance->centre.x;
    draw_turned(&pose, HEIGHT, frames[0]);
    placements[1] = *bad;
    instance->centre.x = centre_x;
    expect_refused(status);
    expect_ended();
    placements[1] = good;
    instance->centre.x = good_x;
    expect_ended();
    draw_turned(&pose, HEIGHT, frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
}

/* Lists that hold none, some and all polygons of the frame. */
/* SPEC 8.1a, 8.1d */
void test_a_bad_placement_ends_the_frame_before(void)
{
    static const fxl_q16_16 scales[] = {0,
                                        -5,
                                        -FXL_Q16_16_ONE,
                                        FXL_SCALE_MIN - 1,
                                        FXL_SCALE_MAX + 1,
                                        FXL_UNITS(20000),
                                        INT32_MAX,
                                        INT32_MIN};
    static const uint32_t words[] = {0, 60, LIST_WORDS};
    for (uint32_t k = 0; k < 3; k++) {
        start_refused(1, words[k]);
        const fxl_placement good = placements[1];
        const fxl_q16_16 x = tiny->instances[2].centre.x;
        for (uint32_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
            const fxl_placement scaled = {good.orientation, scales[i]};
            expect_refused_and_ended(&scaled, x, FXL_E_RANGE);
        }
        fxl_placement bad = good;
        bad.orientation.y.y -= 1 << 10;
        expect_refused_and_ended(&bad, x, FXL_E_PLACEMENT);
        bad.orientation.x = (fxl_direction){INT32_MIN, INT32_MIN, INT32_MIN};
        bad.orientation.z = bad.orientation.y = bad.orientation.x;
        expect_refused_and_ended(&bad, x, FXL_E_PLACEMENT);
        const fxl_placement large = {good.orientation, Q16(200)};
        expect_refused_and_ended(&large, Q16(8000), FXL_E_RANGE);
        expect_refused_and_ended(&good, INT32_MAX, FXL_E_RANGE);
        expect_refused_and_ended(&good, INT32_MIN, FXL_E_RANGE);
    }
}

/* A frame that is refused for another reason may have bad placements, too. */
void test_any_refused_frame_with_placements_ends_the_frame_before(void)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    start_refused(1, 0);
    const fxl_placement good = placements[1];
    draw_turned(&pose, HEIGHT, frames[0]);
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderer, &far_away));
    expect_ended();
    placements[1] = good;
    draw_turned(&pose, HEIGHT, frames[0]);
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(&renderer, NULL));
    expect_ended();
    placements[1] = good;
    draw_turned(&pose, HEIGHT, frames[0]);
    placements[1].scale = 0;
    tiny->scene.instance_count = renderer.instance_capacity + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&renderer, &pose));
    expect_ended();
}

/* Where no placement is read, the frame before stays current. */
void test_a_refused_frame_without_placements_leaves_the_frame_before(void)
{
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    start_refused(TINY_INSTANCES, 0);
    draw_turned(&pose, HEIGHT, frames[0]);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_begin(&renderer, &far_away));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_begin(&renderer, NULL));
    tiny->scene.instance_count = renderer.instance_capacity + 1;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_begin(&renderer, &pose));
    frame_draw_bands(&renderer, frames[1], HEIGHT, BACKGROUND);
    TEST_ASSERT_EQUAL_MEMORY(frames[0], frames[1], PIXELS);
}

/* A scene with placements must name the code that draws them. */
void test_placements_without_their_code_are_refused(void)
{
    start_refused(1, 0);
    const fxl_placement_code *const code = tiny->scene.placement_code;
    tiny->scene.placement_code = NULL;
    expect_refused(FXL_E_ORDER);
    expect_ended();
    tiny->scene.placement_code = code;
}

static void expect_no_lines(fxl_wire *wire)
{
    const fxl_band band = UNIT_BAND(frames[1], WIDTH, 0, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_wire_draw(wire, &band));
}

/* A wireframe reads the placements as it draws, whatever the reason for which the frame was
 * refused. */
void test_a_refused_wireframe(void)
{
    static fxl_wire wire;
    static const fxl_q16_16 scales[] = {0, -5, FXL_UNITS(20000), INT32_MAX};
    const fxl_pose pose = {.position = {0, 0, Q16(-6)}};
    const fxl_pose far_away = {.position = {0, 0, INT32_MAX}};
    const fxl_band band = UNIT_BAND(frames[0], WIDTH, 0, HEIGHT);
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    start_refused(1, 0);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_codes));
    for (uint32_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        placements[1].scale = FXL_Q16_16_ONE;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
        placements[1].scale = scales[i];
        TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &pose));
        expect_no_lines(&wire);
    }
    placements[1].scale = FXL_Q16_16_ONE;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &far_away));
    expect_no_lines(&wire);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    placements[1].orientation.x.x = 0;
    TEST_ASSERT_EQUAL(FXL_E_PLACEMENT, fxl_wire_begin(&wire, &pose));
    expect_no_lines(&wire);
    start_refused(TINY_INSTANCES, 0); /* without placements the frame before stays */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_init(&wire, &tiny->scene, &lens, fxl_line_by_codes));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_begin(&wire, &pose));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_wire_begin(&wire, &far_away));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_wire_draw(&wire, &band));
}
