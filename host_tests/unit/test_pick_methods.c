/* SPDX-License-Identifier: MIT */
/* What a pick answers with each visibility method (docs/extras/pick.md, section 2.4). */
#include "frame_bands.h"
#include "bsp_scene.h"
#include "choices.h"
#include "tiny.h"
#include "study/targets.h"
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
static fxl_draw_entry order[TINY_INSTANCES + 6];
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
static const fxl_mapped_face mapped = {.corners = {0, 1, 2}};
static const fxl_corner corners[3] = {
    {{0, 0}, 0, 0}, {{0, Q16(8)}, 2, 0}, {{Q16(8), Q16(8)}, 6, 0}};
static const uint16_t face_map[12] = {0, 0, 0, 0, 1};
static const fxl_surface_set surface_set = {.textures = &texture,
                                            .surfaces = &surface,
                                            .faces = &mapped,
                                            .face_map = face_map,
                                            .corners = corners,
                                            .texture_count = 1,
                                            .surface_count = 1,
                                            .face_count = 1,
                                            .corner_count = 3};

void setUp(void)
{
    tiny = tiny_make();
    tiny->instances[1].centre = (fxl_point){Q16(0.75), Q16(0.5), Q16(0.5)};
    tiny->instances[2].centre = (fxl_point){Q16(-1), Q16(1), Q16(4)};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)i;
    }
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
    const fxl_lens lens = unit_lens(WIDTH, HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&renderer, &tiny->scene, &lens, &memory));
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
    frame_draw_pose(&renderer, pose, frame[0], HEIGHT, BACKGROUND);
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

/* pick 2.2, 2.4b */
void test_methods_of_the_order_alone_show_what_is_picked(void)
{
    static const choice *const methods[] = {&choice_box, &choice_spans, &choice_spans_box};
    for (uint32_t i = 0; i < 3; i++) {
        const fxl_pose pose = random_pose();
        pick_by_order(&pose);
        choose(methods[i]);
        draw(&pose);
        TEST_ASSERT_EQUAL_UINT32(0, expect_picks());
    }
}

/* An outline is in front of its neighbours, and a fill of one colour is no face's. */
/* pick 2.4g, wire 3.4c */
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

/* A frame was begun and drawn. Each pixel shows what is picked there: the face or the sprite in its
 * colour, or the texture of the first model's face -z. Answers how many picks are not those of the
 * order alone. */
static uint32_t expect_shown(void)
{
    uint32_t others = 0;
    for (uint16_t y = 0; y < HEIGHT; y++) {
        for (uint16_t x = 0; x < WIDTH; x++) {
            const fxl_picked *ordered = &by_order[y][x];
            fxl_picked picked = {1, 2, 3};
            pick(x, y, &picked);
            if (frame[y][x] == TEXEL) {
                TEST_ASSERT_TRUE(picked.face == 4 &&
                                 (picked.instance == 0 || picked.instance == 2));
            } else if (picked.instance == FXL_PICK_NONE) {
                TEST_ASSERT_EQUAL_UINT8(BACKGROUND, frame[y][x]);
            } else {
                TEST_ASSERT_EQUAL_UINT8(frame[y][x], picked.colour);
                TEST_ASSERT_EQUAL(frame[y][x] > 10 && frame[y][x] <= 16, picked.instance == 1);
                if (picked.colour <= 16) { /* of a model's faces, which count from 0: 1.. or 11.. */
                    TEST_ASSERT_EQUAL((picked.colour - 1) % 10, picked.face);
                }
            }
            others += picked.instance != ordered->instance || picked.face != ordered->face;
        }
    }
    return others;
}

static uint32_t count_of(uint8_t colour)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        count += frame[i / WIDTH][i % WIDTH] == colour;
    }
    return count;
}

/* pick 2.4e, surfaces 6.2b */
void test_holes_are_looked_through(void)
{
    fxl_pose pose = random_pose();
    pick_by_order(&pose);
    start();
    attach_surfaces(FXL_SURFACES_OF(fxl_palette));
    draw(&pose);
    TEST_ASSERT_GREATER_THAN(10, expect_shown());
    TEST_ASSERT_GREATER_THAN(10, count_of(TEXEL));
}

static void draw_565(const fxl_pose *pose)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    for (uint16_t y = 0; y < HEIGHT; y++) {
        const fxl_band band = {.pixels = (uint8_t *)(void *)row_565,
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = y,
                               .rows = 1,
                               .palette = palette};
        fxl_rgb565.fill(NULL, &band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        for (uint32_t x = 0; x < WIDTH; x++) {
            frame[y][x] = (uint8_t)row_565[x];
        }
    }
}

static void choose_565(const fxl_target *target)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    start();
    config.palette = palette;
    config.depth = cells;
    config.depth_size = sizeof cells;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_choose(&renderer, &config));
}

/* pick 2.3b, rgb565 3.1e */
void test_a_face_of_16_bits_is_picked_by_its_entry_of_the_palette(void)
{
    const fxl_pose pose = random_pose();
    pick_by_order(&pose);
    choose_565(&fxl_rgb565);
    attach_surfaces(FXL_SURFACES_OF(fxl_rgb565));
    draw_565(&pose);
    TEST_ASSERT_GREATER_THAN(10, expect_shown());
    choose_565(&fxl_rgb565_depth_32);
    attach_surfaces(FXL_SURFACES_OF(fxl_rgb565_depth_32));
    draw_565(&pose);
    TEST_ASSERT_GREATER_THAN(10, expect_shown());
}

/* Where instances intersect, a pixel may show what the order has behind. Instance 1 has the centre
 * that is farther, and a front that is nearer. */
/* pick 2.4d */
void test_by_a_depth_buffer_the_nearest_is_picked(void)
{
    const fxl_pose eye = {{0, 0, Q16(-3.5)}, 0, 0, 0};
    tiny->instances[1].centre = (fxl_point){Q16(1.2), Q16(1.2), Q16(-0.4)};
    pick_by_order(&eye);
    for (uint32_t i = 0; i < 4; i++) {
        choose_depth(i % 2 ? 32 : 16, i >= 2);
        draw(&eye);
        TEST_ASSERT_GREATER_THAN(5, expect_shown());
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

/* Triangles of a few pixels, many of them in one row, which some cores draw without the clipper. */
/* pick 2.2 */
void test_by_a_depth_buffer_a_triangle_of_few_pixels_is_picked(void)
{
    uint32_t pixels = 0;
    for (uint32_t i = 0; i < 6; i++) { /* of the first model, which all instances have */
        fxl_face *face = &tiny->faces[i];
        const uint16_t *of = fxl_face_indices(tiny->corners, face);
        face->count = 3;
        for (uint32_t k = 0; k < 3; k++) {
            face->indices[k] = of[k];
        }
    }
    tiny->instances[1].model = 0;
    for (uint32_t round = 0; round < 12; round++) {
        const fxl_pose pose = random_pose();
        for (int32_t i = 0; i < TINY_INSTANCES; i++) {
            tiny->instances[i].centre = (fxl_point){unit_between(Q16(-4), Q16(4)),
                                                    unit_between(Q16(-4), Q16(4)), Q16(18 + 4 * i)};
        }
        pick_by_order(&pose);
        choose_depth(round % 2 ? 32 : 16, false);
        draw(&pose);
        TEST_ASSERT_EQUAL_UINT32(0, expect_picks());
        pixels += WIDTH * HEIGHT - count_of(BACKGROUND);
    }
    TEST_ASSERT_GREATER_THAN(10, pixels);
}

/* A surface that is blended is drawn in a pass of its own, and is picked where it is not hidden. */
/* pick 2.4e */
void test_what_is_blended_is_picked_before_what_it_covers(void)
{
    static const fxl_surface glass = {.opacity = 16, .flags = FXL_SURFACE_BLEND};
    static uint8_t blend[FXL_BLEND_TABLE_BYTES(20)];
    const fxl_pose eye = {{0, 0, Q16(-3.5)}, 0, 0, 0};
    fxl_surface_set set = surface_set;
    for (uint32_t i = 0; i < sizeof blend; i++) {
        const uint32_t beneath = i % 256; /* 100 and more, but of the ends, which stay */
        blend[i] = (uint8_t)(beneath == 0 || beneath == 255 ? beneath : 100 + beneath / 4);
    }
    set.surfaces = &glass;
    set.blend = blend;
    set.blend_count = 20;
    tiny->instances[1].centre = (fxl_point){Q16(0.5), Q16(0.25), Q16(3)};
    for (uint32_t i = 0; i < 2; i++) {
        uint32_t blended = 0;
        choose_depth(16, false);
        if (i == 0) {
            start();
        }
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_surfaces(&renderer, &surfaces, &set,
                                              i == 0 ? FXL_SURFACES_OF(fxl_palette)
                                                     : FXL_SURFACES_OF(fxl_palette_depth_16)));
        draw(&eye);
        for (uint16_t y = 0; y < HEIGHT; y++) {
            for (uint16_t x = 0; x < WIDTH; x++) {
                fxl_picked picked;
                pick(x, y, &picked);
                const bool is_glass = picked.face == 4 && picked.instance != 1;
                TEST_ASSERT_EQUAL(frame[y][x] >= 100 && frame[y][x] < BACKGROUND, is_glass);
                blended += is_glass;
            }
        }
        TEST_ASSERT_GREATER_THAN(10, blended);
    }
}

/* Black that is added changes no pixel, and nothing changes a white one: the face is picked wherever
 * it would be if it were opaque. */
/* pick 2.4 */
void test_an_added_face_is_picked_whatever_it_adds(void)
{
    static const fxl_surface kinds[2] = {{.opacity = 16},
                                         {.opacity = 16, .flags = FXL_SURFACE_ADD}};
    const fxl_pose eye = {{0, 0, Q16(-3.5)}, 0, 0, 0};
    fxl_surface_set set = surface_set;
    tiny->instances[1].centre = (fxl_point){Q16(0.5), Q16(0.25), Q16(3)};
    for (uint32_t i = 0; i < 8; i++) {
        const bool is_added = i % 2 == 1, has_depth = i % 4 >= 2;
        uint32_t picks = 0;
        for (uint32_t colour = 0; colour < 256; colour++) {
            palette[colour] = i < 4 ? 0 : UINT16_MAX;
        }
        choose_565(has_depth ? &fxl_rgb565_depth_16 : &fxl_rgb565);
        set.surfaces = &kinds[is_added];
        TEST_ASSERT_EQUAL(FXL_OK,
                          fxl_attach_surfaces(&renderer, &surfaces, &set,
                                              has_depth ? FXL_SURFACES_OF(fxl_rgb565_depth_16)
                                                        : FXL_SURFACES_OF(fxl_rgb565)));
        draw_565(&eye);
        for (uint16_t y = 0; y < HEIGHT; y++) {
            for (uint16_t x = 0; x < WIDTH; x++) {
                fxl_picked picked, *const opaque = &by_order[y][x];
                pick(x, y, &picked);
                *opaque = is_added ? *opaque : picked;
                TEST_ASSERT_TRUE(picked.instance == opaque->instance &&
                                 picked.face == opaque->face);
                picks += picked.face == 4 && picked.instance != 1;
            }
        }
        TEST_ASSERT_GREATER_THAN(10, picks);
    }
}

/* --- trees and billboards -----------------------------------------------------------------------
 */

/* What a tree cuts, and the tree's own faces; whole, and with a list of any size. */
/* pick 2.4c */
void test_by_a_tree_its_order_is_picked(void)
{
    static uint64_t tree[64], pieces[512];
    bsp_scene *scene = bsp_make();
    fxl_bsp_workspace *const workspace = (fxl_bsp_workspace *)(void *)tree;
    uint32_t others = 0, cut = 0;
    tiny = scene->tiny;
    tiny->instances[1].centre = (fxl_point){0, 0, 0};
    for (uint32_t i = 0; i < 6; i++) {
        const fxl_pose pose = random_pose();
        tiny->instances[0].centre = unit_point(Q16(1));
        tiny->instances[2].centre = unit_point(Q16(1));
        pick_by_order(&pose);
        start();
        TEST_ASSERT_EQUAL(FXL_OK, choice_take(&renderer, &choice_tree, tree, sizeof tree));
        workspace->pieces = i % 3 == 0 ? NULL : pieces;
        workspace->pieces_size = i % 3 == 0 ? 0 : sizeof pieces;
        if (i % 2 == 0) {
            attach_surfaces(FXL_SURFACES_OF(fxl_palette));
        }
        draw(&pose);
        others += expect_shown();
        cut += workspace->used;
    }
    TEST_ASSERT_TRUE(others > 20 && cut > 0);
}

/* place sampling: if billboards change too: the walk; the texel that is picked */
/* The sprite has a hole in its middle. Of a billboard the face is 0, and the colour the texel's. */
/* billboards 4.3b, pick 2.3d, 2.4f */
void test_a_texel_of_a_billboard_is_picked(void)
{
    static const uint8_t sprite_texels[9] = {71, 72, 73, 74, KEY, 76, 77, 78, 255};
    static const fxl_sprite sprite = {sprite_texels, NULL, 3, 3, 8, KEY};
    static const fxl_billboard board = {&sprite, Q16(1.5), Q16(1.5), Q16(0.75), Q16(0.75)};
    static const uint16_t model_map[2] = {0, 1};
    static const fxl_billboard_set set = {&board, 1, model_map};
    static const fxl_sprite_painter *const painters[] = {
        FXL_SPRITES_OF(fxl_palette), FXL_SPRITES_OF(fxl_palette_depth_16),
        FXL_SPRITES_OF(fxl_rgb565), FXL_SPRITES_OF(fxl_rgb565_depth_32)};
    const fxl_pose pose = {{0, 0, Q16(-3.5)}, 0, 0, 0};
    tiny->models[1].face_count = 1;
    tiny->models[1].kind = FXL_MODEL_CONVEX;
    tiny->scene.face_count = 7;
    tiny->scene.face_bounds = NULL;
    tiny->scene.face_bounds_count = 0;
    tiny->instances[1].centre = (fxl_point){Q16(0.25), 0, Q16(-1.25)};
    for (uint32_t i = 0; i < 4; i++) {
        uint32_t sprites = 0;
        if (i == 0) {
            start();
        } else if (i == 1) {
            choose_depth(16, false);
        } else {
            choose_565(i == 2 ? &fxl_rgb565 : &fxl_rgb565_depth_32);
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_billboards(&renderer, &billboards, &set, painters[i]));
        if (i < 2) {
            draw(&pose);
        } else {
            draw_565(&pose);
        }
        for (uint16_t y = 0; y < HEIGHT; y++) {
            for (uint16_t x = 0; x < WIDTH; x++) {
                fxl_picked picked;
                pick(x, y, &picked);
                TEST_ASSERT_EQUAL_UINT8(
                    picked.instance == FXL_PICK_NONE ? BACKGROUND : picked.colour, frame[y][x]);
                TEST_ASSERT_EQUAL((frame[y][x] > 70 && frame[y][x] < 80) || frame[y][x] == 255,
                                  picked.instance == 1);
                TEST_ASSERT_TRUE(picked.instance != 1 || picked.face == 0);
                sprites += picked.instance == 1;
            }
        }
        TEST_ASSERT_GREATER_THAN(30, sprites);
    }
}

/* A pick leaves the frame, its counters, and what is drawn after it, as they are. */
/* pick 2.1b */
void test_a_pick_changes_nothing(void)
{
    static uint8_t again[HEIGHT][WIDTH];
    const fxl_pose pose = random_pose();
    for (uint32_t i = 0; i < 2; i++) {
        const fxl_band band = UNIT_BAND(again[0], WIDTH, 0, HEIGHT);
        fxl_picked picked;
        choose_depth(16, i == 1);
        draw(&pose);
        const fxl_counters counters = renderer.workspace.counters;
        const fxl_frame before = renderer.frame;
        pick(WIDTH / 2, HEIGHT / 2, &picked);
        TEST_ASSERT_EQUAL_MEMORY(&counters, &renderer.workspace.counters, sizeof counters);
        TEST_ASSERT_EQUAL_MEMORY(&before, &renderer.frame, sizeof before);
        fxl_fill_band(&band, BACKGROUND);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&renderer, &band));
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof frame);
    }
}
