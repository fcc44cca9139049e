/* SPDX-License-Identifier: MIT */
/* Frames of moving cubes, by every way to draw them, and what was counted, are the same on every
 * core: hashes on record, as in test_surface_hashes.c. */
#include "bsp_scene.h"
#include "choices.h"
#include "tiny.h"
#include "frame_bands.h"
#include "study/study.h"

enum {
    FRAMES = 60, /* of each kind */
    WIDTH = 48,
    HEIGHT = 32,
    BACKGROUND = 200,
    LIST_WORDS = 24 * FXL_DISPLAY_LIST_WORDS(8),
    ORDER = TINY_INSTANCES + 6,
    ROOM = FXL_SPAN_BUFFER_BYTES(HEIGHT, 60) + 1024,
    LEVELS = 8
};

static uint8_t frame[HEIGHT * WIDTH], ramp[FXL_LIGHT_RAMP_BYTES(LEVELS)], lit[256], texels[6 * 5];
static uint32_t list[LIST_WORDS];
static fxl_draw_entry order[ORDER];
static fxl_cached_vertex cache[8];
static fxl_renderer renderer;
static FXL_ALIGN_8 fxl_clipper_workspace clipper_room;
static FXL_ALIGN_8 uint8_t room[ROOM], pieces[3072], beam_room[4608];
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32)];
static fxl_outlines outlines;
static fxl_light light;
static fxl_billboards billboards;
static fxl_sprite sprite;
static fxl_billboard board;
static fxl_billboard_set set;
static fxl_placement placements[2];
static fxl_beam beams[2];
static bsp_scene *made;

void setUp(void)
{
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(i + 29 * (i / 256));
    }
    for (uint32_t i = 0; i < sizeof lit; i++) {
        lit[i] = (uint8_t)(i + 100);
    }
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(30 + i);
    }
}

/* What a kind of frames has. */
enum {
    TREE = 1,
    CLUSTERED = 2,
    PLACEMENT = 4,
    BILLBOARD = 8,
    BEAMS = 16,
    LIGHT = 32,
    OFF_CENTRE = 64,
    OUTLINES = 128
};

/* Instance 2 is turned and scaled, and so is instance 1 where it has no tree. */
static void make_placements(fxl_scene *scene)
{
    scene->placements = placements;
    scene->first_turned = scene->bsp_nodes != NULL ? 2 : 1;
    scene->placement_code = &fxl_turned_instances;
    for (uint32_t i = 0; i < TINY_INSTANCES - scene->first_turned; i++) {
        const fxl_angle yaw = unit_random(), pitch = unit_random(), roll = unit_random();
        placements[i].scale = unit_between(Q16(0.25), Q16(2));
        TEST_ASSERT_EQUAL(
            FXL_OK, fxl_orientation_from_angles(yaw, pitch, roll, &placements[i].orientation));
    }
}

/* Instance 1 shows a sprite instead of a face. */
static void make_billboard(tiny_scene *tiny)
{
    static const uint16_t map[2] = {0, 1};
    tiny->models[1].face_count = 1;
    tiny->models[1].kind = FXL_MODEL_CONVEX;
    tiny->scene.face_count = 7;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    sprite = (fxl_sprite){texels, NULL, 6, 5, 8, 33};
    board = (fxl_billboard){.sprite = &sprite,
                            .width = unit_between(Q16(0.5), Q16(1.8)),
                            .height = Q16(2),
                            .anchor_x = unit_between(Q16(0.4), Q16(0.5)),
                            .anchor_y = Q16(1)};
    set = (fxl_billboard_set){&board, 1, map};
}

/* Through a window above the cubes, from a lamp and from the sun. */
static void make_beams(void)
{
    const fxl_q16_16 x = unit_between(Q16(-1), Q16(1)), y = Q16(4);
    const fxl_point window[] = {{x - Q16(0.9), y, Q16(8.5)},
                                {x + Q16(0.8), y, Q16(8.4)},
                                {x + Q16(1.1), y, Q16(10.3)},
                                {x - Q16(0.7), y, Q16(10.6)}};
    const fxl_point lamp = {Q16(0.3), Q16(30), unit_between(Q16(5), Q16(13))};
    const fxl_direction slanted = {0, Q30(-0.8), Q30(0.6)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_point(&lamp, window, 4, &beams[0]));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_beam_from_direction(&slanted, window, 4, &beams[1]));
}

static fxl_pose make_scene(uint32_t with)
{
    static bsp_scene clustered;
    if (with & CLUSTERED) {
        clustered.tiny = cluster_make()->tiny;
        made = &clustered;
    } else {
        made = bsp_make();
    }
    fxl_scene *scene = &made->tiny->scene;
    if (!(with & TREE)) {
        scene->bsp_nodes = NULL;
        scene->bsp_node_count = 0;
        scene->bsp_instance = 0;
    }
    const fxl_pose pose = bsp_shuffle(made);
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) { /* mostly that of the tree */
        const int32_t layer = unit_between(-2, 2);
        made->tiny->instances[i].layer = i == 1 || layer < 0 ? 1 : (uint8_t)layer;
    }
    if (with & PLACEMENT) {
        make_placements(scene);
    }
    if (with & BILLBOARD) {
        make_billboard(made->tiny);
    }
    fxl_scene_fault fault = {"", 0};
    TEST_ASSERT_EQUAL_MESSAGE(FXL_OK, fxl_scene_check_all(scene, &fault), fault.what);
    return pose;
}

/* place light: hashes of frames */
static void add_light(void)
{
    const fxl_light_settings settings = {.ambient = FXL_Q2_30_ONE / 8,
                                         .strength = FXL_Q2_30_ONE / 2,
                                         .direction = unit_direction(),
                                         .points = {{{Q16(2), Q16(3), Q16(8)}, Q16(9), Q30(0.6)}},
                                         .point_count = 1,
                                         .fog_near = Q16(5),
                                         .fog_far = unit_between(Q16(9), Q16(15)),
                                         .ramp = ramp,
                                         .levels = LEVELS};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &settings));
}

static void set_method(const choice *method)
{
    const bool has_depth = method->target->depth_bits != 0;
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, method, has_depth ? cells : room,
                                          has_depth ? sizeof cells : sizeof room));
}

static void add_extras(const choice *method, uint32_t with)
{
    if (with & TREE) {
        fxl_bsp_workspace *tree = renderer.order_memory;
        tree->pieces = pieces;
        tree->pieces_size = (uint32_t)unit_between(0, sizeof pieces / 4) * 4;
    }
    if (with & BILLBOARD) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &billboards, &set,
                                                        method->target == &fxl_palette_depth_32
                                                            ? FXL_SPRITES_OF(fxl_palette_depth_32)
                                                            : FXL_SPRITES_OF(fxl_palette)));
    }
    if (with & BEAMS) {
        make_beams();
        static const fxl_beam_set beam_set = {beams, 2, lit};
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_beams(&renderer, &beam_set, beam_room, sizeof beam_room));
    }
    if (with & LIGHT) {
        add_light();
    }
    if (with & OUTLINES) {
        const fxl_outline_style style = {.line = 1, .fill = 2, .keeps_colours = true};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    }
}

static fxl_lens make_lens(uint32_t with)
{
    fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    if (with & OFF_CENTRE) {
        const fxl_q16_16 x = unit_between(Q16(-WIDTH), Q16(2 * WIDTH)),
                         y = unit_between(0, Q16(HEIGHT));
        lens.inset = 0;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_set_centre(&lens, x, y));
    }
    return lens;
}

static void start(const fxl_clipper *clipper, const choice *method, uint32_t with)
{
    const fxl_lens lens = make_lens(with);
    const uint32_t words = unit_between(0, 3) ? (uint32_t)unit_between(0, LIST_WORDS) : 0;
    const fxl_memory memory = {order, ORDER, list, words, cache, (uint32_t)unit_between(0, 8)};
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderer, &made->tiny->scene, &lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, clipper, &clipper_room,
                                                       clipper->workspace_size));
    set_method(method);
    add_extras(method, with);
}

static uint32_t draw(const fxl_pose *pose)
{
    const uint32_t rows = (uint32_t)unit_between(1, HEIGHT);
    frame_draw_pose(&renderer, pose, frame, rows, BACKGROUND);
    return unit_crc32(frame, sizeof frame) +
           31u * unit_crc32((const uint8_t *)&renderer.workspace.counters,
                            sizeof renderer.workspace.counters);
}

static uint32_t hash_of(const fxl_clipper *clipper, const choice *method, uint32_t with)
{
    uint32_t hash = 0;
    for (uint32_t i = 0; i < FRAMES; i++) {
        const fxl_pose pose = make_scene(with);
        start(clipper, method, with);
        hash = 31u * hash + draw(&pose);
        if (with & TREE) {
            const fxl_bsp_workspace *tree = renderer.order_memory;
            hash = 31u * hash + tree->used + 7u * tree->unsplit;
        }
    }
    return hash;
}

void test_frames_are_those_on_record(void)
{
    static const choice *const sorted = &choice_sorted;
    static const struct {
        const fxl_clipper *clipper;
        const choice *method;
        uint32_t with, hash;
    } record[] = {
        {&fxl_clipper_view, sorted, 0, 0xB76C657A},
        {&fxl_clipper_world, sorted, PLACEMENT, 0x3FC1E976},
        {&fxl_clipper_normalised, sorted, PLACEMENT, 0xD5F6C9BE},
        {&fxl_clipper_once, sorted, PLACEMENT | LIGHT, 0xC10A8AB1},
        {&fxl_clipper_half_spaces, sorted, PLACEMENT | CLUSTERED, 0xDBEA88CC},
        {&fxl_clipper_triangles, sorted, PLACEMENT, 0x71E2F047},
        {&fxl_clipper_near, sorted, PLACEMENT | CLUSTERED, 0x5E534FBA},
        {&fxl_clipper_left, sorted, PLACEMENT, 0x3CD5E92C},
        {&fxl_clipper_view, sorted, PLACEMENT | CLUSTERED, 0x03A182D1},
        {&fxl_clipper_view, sorted, BEAMS, 0xACCAF69F},
        {&fxl_clipper_world, sorted, BEAMS | PLACEMENT, 0xD1A6F5E0},
        {&fxl_clipper_triangles, sorted, BEAMS | PLACEMENT, 0x4FCDDE04},
        {&fxl_clipper_view, sorted, PLACEMENT | LIGHT, 0xDC7A16E7},
        {&fxl_clipper_view, sorted, BILLBOARD, 0x285422D4},
        {&fxl_clipper_world, sorted, BILLBOARD | PLACEMENT | LIGHT, 0x65BDB371},
        {&fxl_clipper_view, &choice_tree, TREE, 0x11DDEE9C},
        {&fxl_clipper_view, &choice_tree, TREE | PLACEMENT, 0x99C60DD4},
        {&fxl_clipper_view, &choice_tree, TREE | PLACEMENT | LIGHT, 0x0ED8B4B4},
        {&fxl_clipper_view, &choice_tree, TREE | PLACEMENT | BEAMS, 0x16D339C8},
        {&fxl_clipper_triangles, &choice_tree, TREE | PLACEMENT, 0xD53F3897},
        {&fxl_clipper_view, &choice_tree_spans, TREE | PLACEMENT, 0x170A8249},
        {&fxl_clipper_near, &choice_tree_spans, TREE | PLACEMENT | BEAMS, 0x41B52A8B},
        {&fxl_clipper_view, &choice_spans, PLACEMENT | CLUSTERED, 0x29394181},
        {&fxl_clipper_once, &choice_spans, PLACEMENT | BEAMS, 0xE6514092},
        {&fxl_clipper_view, &choice_spans_box, PLACEMENT | LIGHT, 0x8B77AE31},
        {&fxl_clipper_view, &choice_box, PLACEMENT, 0x868D87BB},
        {&fxl_clipper_view, sorted, PLACEMENT | OUTLINES, 0x2840FE04},
        {&fxl_clipper_left, sorted, CLUSTERED | LIGHT | OUTLINES, 0xCAB25BE7},
        {&fxl_clipper_view, &choice_depth_16, PLACEMENT | BEAMS, 0x7DF9AE88},
        {&fxl_clipper_once, &choice_depth_16, PLACEMENT | CLUSTERED | OFF_CENTRE, 0xD0877E37},
        {&fxl_clipper_triangles, &choice_depth_32, PLACEMENT | BEAMS, 0x96D778AA},
        {&fxl_clipper_view, &choice_depth_32, PLACEMENT | BILLBOARD | LIGHT, 0x3F88B336},
        {&fxl_clipper_view, sorted, PLACEMENT | CLUSTERED | OFF_CENTRE, 0x4BE9AB07},
        {&fxl_clipper_triangles, sorted, PLACEMENT | BEAMS | OFF_CENTRE, 0xD9982D40},
        {&fxl_clipper_left, sorted, PLACEMENT | BILLBOARD | OFF_CENTRE, 0xCF692EDA},
        {&fxl_clipper_normalised, &choice_spans, PLACEMENT | OFF_CENTRE, 0xA0462869},
        {&fxl_clipper_world, &choice_tree, TREE | PLACEMENT | OFF_CENTRE, 0x87A7A0B7},
    };
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < sizeof record / sizeof record[0]; i++) {
        const uint32_t hash = hash_of(record[i].clipper, record[i].method, record[i].with);
        wrong += unit_tell_hash(i, hash, record[i].hash);
    }
    TEST_ASSERT_EQUAL_UINT32(0, wrong);
}
