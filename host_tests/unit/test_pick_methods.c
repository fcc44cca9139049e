/* SPDX-License-Identifier: MIT */
/* What a pick answers with each visibility method (docs/extras/pick.md, section 2.4). */
#include "choices.h"
#include "tiny.h"
#include "tiny_frames.h"
#include "study/methods.h"
#include "study/span_buffer.h"

enum {
    WIDTH = 24,
    HEIGHT = 16,
    BACKGROUND = 200,
    LINE = 99,
    TEXEL = 60,
    KEY = 61,
    LIST_WORDS = 60 /* a part of the frame's polygons */
};

static uint8_t frame[HEIGHT][WIDTH];
static uint16_t row_565[WIDTH], palette[256];
static fxl_picked by_order[HEIGHT][WIDTH];
static uint32_t list[LIST_WORDS];
static fxl_order_entry order[TINY_INSTANCES + 6];
static fxl_renderer renderer;
static uint64_t room[FXL_SPAN_BUFFER_BYTES_LEAST(WIDTH, HEIGHT) / 8 + 1];
static FXL_ALIGN_8 uint8_t cells[FXL_DEPTH_BYTES(WIDTH, 4, 32)];
static fxl_surfaces surfaces;
static fxl_billboards billboards;
static tiny_scene *tiny;

/* The texture of the first model's face -z: a texel in two is a hole. */
static const uint8_t texels[4] = {TEXEL, KEY, KEY, TEXEL};
static const fxl_texture texture = {.texels = texels,
                                    .log_width = 1,
                                    .log_height = 1,
                                    .flags = FXL_TEXTURE_KEYED,
                                    .key = KEY,
                                    .levels = 1};
static const fxl_surface surface = {.texture = 1, .division = FXL_DIVIDE_1, .opacity = 16};
static const fxl_mapped_face mapped = {.corners = {0, 1, 2},
                                       .texels = {{0, 0}, {0, Q16(8)}, {Q16(8), Q16(8)}}};
static const uint16_t face_map[12] = {0, 0, 0, 0, 1};
static const fxl_surface_set surface_set = {.textures = &texture,
                                            .surfaces = &surface,
                                            .faces = &mapped,
                                            .face_map = face_map,
                                            .texture_count = 1,
                                            .surface_count = 1,
                                            .face_count = 1};

void setUp(void)
{
    tiny = tiny_make();
    tiny->instances[1].centre = (fxl_point){Q16(0.75), Q16(0.5), Q16(0.5)};
    tiny->instances[2].centre = (fxl_point){Q16(-1), Q16(1), Q16(4)};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)i;
    }
}

void tearDown(void)
{
}

static fxl_pose random_pose(void)
{
    fxl_pose pose = {unit_point(Q16(1)), 0, 0, 0};
    pose.position.z -= Q16(3.5);
    pose.yaw = DEGREES(1) * (fxl_angle)unit_between(-10, 10);
    return pose;
}

static void start(void)
{
    const fxl_memory memory = {order, TINY_INSTANCES + 6, list, LIST_WORDS, NULL, 0};
    tiny_start(&renderer, tiny, WIDTH, HEIGHT, &memory);
}

static void choose(const choice *method)
{
    start();
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, method, room, sizeof room));
}

static void attach_surfaces(const fxl_painter *painter)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_surfaces(&renderer, &surfaces, &surface_set, painter));
}

static void choose_depth(uint32_t bits, bool with_surfaces)
{
    start();
    const choice *const pair = bits == 32 ? &choice_depth_32 : &choice_depth_16;
    TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, pair, cells, sizeof cells));
    if (with_surfaces) {
        attach_surfaces(bits == 32 ? FXL_SURFACES_OF(fxl_palette_depth_32)
                                   : FXL_SURFACES_OF(fxl_palette_depth_16));
    }
}

static void draw(const fxl_pose *pose)
{
    const fxl_band band = {.pixels = frame[0], .width = WIDTH, .stride = WIDTH, .first_row = 0,
                           .rows = HEIGHT};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    fxl_fill_band(&band, BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
}

static void pick(uint16_t x, uint16_t y, fxl_picked *picked)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderer, x, y, picked));
}

/* What every method has to answer: the picks of the default one. They are what it has drawn. */
static void pick_by_order(const fxl_pose *pose)
{
    choose(&choice_sorted);
    draw(pose);
    for (uint16_t y = 0; y < HEIGHT; y++) {
        for (uint16_t x = 0; x < WIDTH; x++) {
            fxl_picked *picked = &by_order[y][x];
            pick(x, y, picked);
            TEST_ASSERT_EQUAL_UINT8(picked->instance == FXL_PICK_NONE ? BACKGROUND : picked->colour,
                                    frame[y][x]);
        }
    }
}

/* A frame was begun. Answers how many pixels show another colour than their pick says. */
static uint32_t expect_picks(void)
{
    uint32_t others = 0;
    for (uint16_t y = 0; y < HEIGHT; y++) {
        for (uint16_t x = 0; x < WIDTH; x++) {
            const fxl_picked *wanted = &by_order[y][x];
            fxl_picked picked = {1, 2, 3};
            pick(x, y, &picked);
            TEST_ASSERT_TRUE(picked.instance == wanted->instance && picked.face == wanted->face &&
                             picked.colour == wanted->colour);
            others +=
                frame[y][x] != (picked.instance == FXL_PICK_NONE ? BACKGROUND : picked.colour);
        }
    }
    return others;
}

void test_methods_of_the_order_alone_show_what_is_picked(void)
{
    static const choice *const methods[] = {&choice_box, &choice_spans,
                                                    &choice_spans_box};
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_pose pose = random_pose();
        pick_by_order(&pose);
        choose(methods[i]);
        draw(&pose);
        TEST_ASSERT_EQUAL_UINT32(0, expect_picks());
    }
}

/* An outline is in front of its neighbours, and a fill of one colour is no face's. */
void test_an_outlined_face_is_picked_whatever_is_drawn_on_it(void)
{
    static fxl_outlines outlines;
    for (uint32_t keeps = 0; keeps < 2; keeps++) {
        const fxl_pose pose = random_pose();
        uint32_t lines = 0;
        pick_by_order(&pose);
        start();
        const fxl_outline_style style = {
            .line = LINE, .fill = BACKGROUND, .keeps_colours = keeps == 1};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
        draw(&pose);
        const uint32_t others = expect_picks();
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            lines += frame[i / WIDTH][i % WIDTH] == LINE;
        }
        TEST_ASSERT_GREATER_THAN(10, lines);
        if (keeps == 1) {
            TEST_ASSERT_EQUAL_UINT32(lines, others);
        } else {
            TEST_ASSERT_GREATER_THAN(lines, others);
        }
    }
}

/* The pixels of the face that has the texture: texels, and holes with what is behind. */
static void expect_face_and_holes(uint32_t others)
{
    uint32_t covered = 0, painted = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const fxl_picked *picked = &by_order[i / WIDTH][i % WIDTH];
        if (picked->instance != FXL_PICK_NONE && picked->instance != 1 && picked->face == 4) {
            covered++;
            painted += frame[i / WIDTH][i % WIDTH] == TEXEL;
        }
    }
    TEST_ASSERT_TRUE(painted > 10 && painted + 10 < covered);
    TEST_ASSERT_EQUAL_UINT32(covered, others); /* neither has the face's own colour */
}

void test_a_face_with_a_texture_is_picked_in_its_holes_too(void)
{
    fxl_pose pose = random_pose();
    pick_by_order(&pose);
    start();
    attach_surfaces(FXL_SURFACES_OF(fxl_palette));
    draw(&pose);
    expect_face_and_holes(expect_picks());
}

void test_a_face_of_16_bits_is_picked_by_its_entry_of_the_palette(void)
{
    const fxl_pose pose = random_pose();
    pick_by_order(&pose);
    start();
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, &fxl_rgb565);
    config.palette = palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&renderer, &config));
    attach_surfaces(FXL_SURFACES_OF(fxl_rgb565));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    for (uint16_t y = 0; y < HEIGHT; y++) {
        const fxl_band band = {.pixels = (uint8_t *)(void *)row_565, .width = WIDTH,
                               .stride = WIDTH, .first_row = y, .rows = 1, .palette = palette};
        fxl_rgb565.fill(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        for (uint32_t x = 0; x < WIDTH; x++) {
            frame[y][x] = (uint8_t)row_565[x];
        }
    }
    expect_face_and_holes(expect_picks());
}

/* Where instances intersect, a pixel may show what the order has behind. Instance 1 has the centre
 * that is farther, and a front that is nearer. Where nothing intersects, the pick is what is shown.
 */
void test_a_depth_buffer_is_picked_by_the_order(void)
{
    const fxl_pose eye = {{0, 0, Q16(-3.5)}, 0, 0, 0};
    tiny->instances[1].centre = (fxl_point){Q16(1.2), Q16(1.2), Q16(-0.4)};
    pick_by_order(&eye);
    for (uint32_t i = 0; i < 4; i++) {
        choose_depth(i % 2 ? 32 : 16, i >= 2);
        draw(&eye);
        TEST_ASSERT_GREATER_THAN(5, expect_picks());
    }
    tiny->instances[1].centre = (fxl_point){Q16(3), Q16(0.5), Q16(0.5)};
    for (uint32_t i = 0; i < 2; i++) {
        const fxl_pose pose = random_pose();
        pick_by_order(&pose);
        choose_depth(i ? 32 : 16, false);
        draw(&pose);
        TEST_ASSERT_EQUAL_UINT32(0, expect_picks());
    }
}

static void expect_refused(const fxl_pose *pose)
{
    fxl_picked picked = {1, 2, 3};
    draw(pose);
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(FXL_E_BSP, fxl_pick_face(&renderer, WIDTH / 2, HEIGHT / 2, &picked));
    TEST_ASSERT_TRUE(picked.instance == 1 && picked.face == 2 && picked.colour == 3);
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
}

void test_trees_and_billboards_are_refused(void)
{
    static const uint8_t sprite_texels[1] = {7};
    static const fxl_sprite sprite = {sprite_texels, NULL, 1, 1, 8, FXL_SPRITE_OPAQUE};
    static const fxl_billboard board = {&sprite, Q16(1), Q16(1), Q16(0.5), Q16(0.5)};
    static const uint16_t model_map[2] = {0, 1};
    static const fxl_billboard_set set = {&board, 1, model_map};
    const fxl_pose pose = random_pose();
    choose(&choice_tree);
    expect_refused(&pose);
    choose(&choice_tree_spans);
    expect_refused(&pose);
    /* A billboard stands for a model of one face. */
    tiny->models[1].face_count = 1;
    tiny->models[1].kind = FXL_MODEL_CONVEX;
    tiny->scene.face_count = 7;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    start();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &billboards, &set,
                                                    FXL_SPRITES_OF(fxl_palette)));
    expect_refused(&pose);
    start();
    attach_surfaces(FXL_SURFACES_OF(fxl_palette));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &billboards, &set,
                                                    FXL_SPRITES_OF(fxl_palette)));
    expect_refused(&pose);
    choose_depth(16, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &billboards, &set,
                                                    FXL_SPRITES_OF(fxl_palette_depth_16)));
    expect_refused(&pose);
}
