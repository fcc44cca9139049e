/* SPDX-License-Identifier: MIT */
/* Outlines with a depth buffer, against the edges of each face as lines on it. */
#include "study/study.h"

#include "line_scene.h" /* last: its names are those of parameters */

enum {
    FILL = 150,
    SIDES = 4 /* of a face of the cubes */
};

static fxl_outlines outlines;
static uint64_t room[4096];
static uint8_t expected[PIXELS], again[PIXELS];

static fxl_outline_style style_of(bool keeps_colours)
{
    const fxl_outline_style style = {.line = LINE,
                                     .fill = FILL,
                                     .keeps_colours = keeps_colours,
                                     .code = &fxl_outlines_by_depth};
    return style;
}

/* With a lens of 8 pixels a unit, or that of start. */
static void take_lens(bool is_orthographic)
{
    if (is_orthographic) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(8)));
    }
}

static void attach_outlines(bool keeps_colours)
{
    const fxl_outline_style style = style_of(keeps_colours);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
}

/* The edges of each face as lines on that face alone. */
static void make_edges_of_faces(fxl_line edges[2 * EDGES * 2], fxl_line_set *of_faces)
{
    uint32_t count = 0;
    make_edges(1);
    for (uint32_t m = 0; m < 2; m++) {
        const fxl_model *model = &tiny->models[m];
        line_map[m] = count;
        for (uint32_t i = 0; i < model->face_count; i++) {
            const uint16_t *corners =
                fxl_face_indices(tiny->corners, &tiny->faces[model->first_face + i]);
            for (uint32_t k = 0; k < SIDES; k++) {
                edges[count++] = (fxl_line){
                    corners[k], corners[(k + 1) % SIDES], {(uint16_t)(i + 1), 0}, LINE, 1, 0};
            }
        }
    }
    line_map[2] = count;
    *of_faces = (fxl_line_set){edges, count, line_map};
}

/* However the frame is drawn, by both depth buffers and by both kinds of lenses, of turned instances and still ones. */
/* wire 3.5a, 3.5b, 3.5g, lines 2.7a, orthographic 2.12b-c */
void test_outlines_are_lines_on_their_faces(void)
{
    static fxl_line edges[2 * EDGES * 2];
    static uint32_t list[900];
    fxl_placement placements[TINY_INSTANCES];
    fxl_line_set of_faces;
    uint32_t seen = 0, hidden = 0;
    for (int round = 0; round < UNIT_REPEAT / 400 + 12; round++) {
        const fxl_target *target = depths[round % 2];
        const bool is_orthographic = round % 5 > 2;
        const fxl_pose pose = round % 3 ? tiny_pose_about() : tiny_pose_between();
        fxl_workspace other;
        fxl_config config = config_of(target);
        make_edges_of_faces(edges, &of_faces);
        if (round % 4 == 0) {
            tiny_place_from(tiny, placements, 1);
            placements[0].orientation = unit_orientation();
        }
        start(target, false);
        take_lens(is_orthographic);
        draw(&pose, again);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &of_faces));
        draw(&pose, expected);
        config.depth_size =
            (uint32_t)FXL_DEPTH_BYTES(WIDTH, unit_between(1, HEIGHT), target->depth_bits);
        start_with(&config, sizeof memory);
        take_lens(is_orthographic);
        attach_outlines(true);
        draw(&pose, frame);
        TEST_ASSERT_EQUAL_MEMORY(expected, frame, sizeof frame);
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_TRUE(frame[i] == LINE || frame[i] == again[i]);
            seen += frame[i] == LINE;
            hidden += frame[i] != LINE && frame[i] != BACKGROUND;
        }
        renderer.frame.display_list.words = list;
        renderer.frame.display_list.capacity = unit_random() % 900;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
        TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_release_scene(&renderer));
        frame_draw_bands(&renderer, frame, (uint32_t)unit_between(1, HEIGHT), BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(expected, frame, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &renderer, room, sizeof room));
        frame_draw_band(&renderer, &renderer.workspace, frame, 0, 13, BACKGROUND);
        frame_draw_band(&renderer, &other, frame, 13, HEIGHT - 13, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(expected, frame, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, NULL, NULL));
        draw(&pose, frame);
        TEST_ASSERT_EQUAL_MEMORY(again, frame, sizeof frame);
    }
    TEST_ASSERT_TRUE(seen > 100 && hidden > 100);
}

/* Lines are drawn over outlines, whichever was attached first. */
/* wire 3.5c */
void test_lines_come_over_outlines(void)
{
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t first = 0; first < 2; first++) {
        uint32_t marks = 0;
        make_edges(1);
        for (uint32_t i = 0; i < set.count; i++) {
            lines[i].colour = LINE + 1;
        }
        start(&fxl_palette_depth_16, first == 0);
        attach_outlines(true);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
        draw(&pose, frame);
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_NOT_EQUAL(LINE, frame[i]); /* each edge of a face is a line as well */
            marks += frame[i] == LINE + 1;
        }
        TEST_ASSERT_TRUE(marks > 20);
    }
}

/* Faces that do not keep their colours have that of the style, in no light. */
/* wire 3.5d */
void test_faces_are_filled(void)
{
    static uint8_t ramp[2 * 256];
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 4, .ramp = ramp, .levels = 2};
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    fxl_light light;
    uint32_t filled = 0;
    make_edges(1);
    start(&fxl_palette_depth_16, false);
    draw(&pose, expected);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
    attach_outlines(false);
    draw(&pose, frame);
    for (uint32_t i = 0; i < PIXELS; i++) {
        TEST_ASSERT_TRUE(frame[i] == LINE ||
                         frame[i] == (expected[i] == BACKGROUND ? BACKGROUND : FILL));
        filled += frame[i] == FILL;
    }
    TEST_ASSERT_TRUE(filled > 100);
}

/* place pixel-format: what an extra does in frames of the format */
/* wire 3.4b */
void test_outlines_by_depth_in_rgb565(void)
{
    static const fxl_target *const same[] = {&fxl_rgb565_depth_16, &fxl_rgb565_depth_32};
    static uint16_t pixels[PIXELS];
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 257);
    }
    for (uint32_t i = 0; i < 4; i++) {
        make_edges(1);
        start(depths[i % 2], false);
        attach_outlines(i < 2);
        draw(&pose, frame);
        start(same[i % 2], false);
        attach_outlines(i < 2);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, pixels, WIDTH));
        for (uint32_t k = 0; k < PIXELS; k++) {
            TEST_ASSERT_EQUAL_HEX16(palette[frame[k]], pixels[k]);
        }
    }
}

/* An instance that shows a billboard has no outlines, and a pick looks through those of the others. */
/* wire 3.4c, 3.5e */
void test_billboards_have_no_outlines_and_picks_look_through(void)
{
    static board_scene boards;
    const fxl_pose pose = {{Q16(0.3), Q16(0.4), Q16(-5)}, 0, 0, 0};
    uint32_t edges = 0;
    board_scene_make(&boards);
    tiny = boards.tiny;
    start(&fxl_palette_depth_16, false);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_attach_billboards(&renderer, &boards.billboards, &boards.set,
                                            FXL_SPRITES_OF(fxl_palette_depth_16)));
    draw(&pose, expected);
    attach_outlines(true);
    draw(&pose, frame);
    for (uint32_t i = 0; i < PIXELS; i++) {
        fxl_picked picked;
        edges += frame[i] == LINE;
        TEST_ASSERT_TRUE(frame[i] == LINE || frame[i] == expected[i]);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderer, (uint16_t)(i % WIDTH),
                                                (uint16_t)(i / WIDTH), &picked));
        TEST_ASSERT_EQUAL(expected[i] == BACKGROUND, picked.instance == FXL_PICK_NONE);
    }
    TEST_ASSERT_TRUE(edges > 20);
    for (uint32_t i = 0; i < tiny->scene.instance_count; i++) {
        tiny->instances[i].model = 1; /* that of the billboard */
    }
    draw(&pose, frame);
    for (uint32_t i = 0; i < PIXELS; i++) {
        TEST_ASSERT_NOT_EQUAL(LINE, frame[i]);
    }
}

/* The code of a style counts where the target has a depth. */
/* wire 3.5f */
void test_the_code_of_a_style(void)
{
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    fxl_outline_style style = style_of(true);
    make_edges(1);
    start(&fxl_palette, false);
    attach_outlines(true);
    draw(&pose, expected);
    style.code = NULL;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    draw(&pose, frame);
    TEST_ASSERT_EQUAL_MEMORY(expected, frame, sizeof frame);
    start(&fxl_palette_depth_16, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, &outlines, &style));
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &pose, frame, WIDTH));
    attach_outlines(true);
    draw(&pose, frame);
    static fxl_renderer none;
    style = style_of(true);
    none.scene = &tiny->scene; /* and no target yet */
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&none, &outlines, &style));
}

static void expect_conflict(const char *first, const char *second)
{
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    const char *names[2] = {NULL, NULL};
    attach_outlines(true);
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &pose, frame, WIDTH));
    TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
    TEST_ASSERT_EQUAL_STRING(first, names[0]);
    TEST_ASSERT_EQUAL_STRING(second, names[1]);
    const char *sentence = fxl_render_explain(&renderer, &pose, frame, WIDTH, NULL);
    TEST_ASSERT_NOT_NULL(sentence);
    TEST_ASSERT_NOT_NULL(strstr(sentence, first));
    TEST_ASSERT_NOT_NULL(strstr(sentence, second));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_outlines(&renderer, NULL, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
}

/* combinations 1.2c */
void test_conflicts_of_outlines_by_depth(void)
{
    make_edges(1);
    start(&fxl_palette_depth_16, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_world, room,
                                                       fxl_clipper_world.workspace_size));
    expect_conflict("outlines", "a clipper of the study");
}
