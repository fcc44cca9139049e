/* SPDX-License-Identifier: MIT */
/* Lines and points in frames, however drawn; what does not go with them, and what is refused. */
#include "study/study.h"

#include "line_scene.h" /* last: its names are those of parameters */

static uint64_t room[4096];
static uint8_t without[PIXELS], again[PIXELS];

/* --- however a frame is drawn --------------------------------------------------------------- */

static void check_ways(const fxl_target *target, const fxl_pose *pose)
{
    static const uint16_t steps[] = {1, 5, 9, 36};
    static uint32_t list[900];
    fxl_workspace other;
    fxl_config config = config_of(target);
    start(target, true);
    draw(pose, frame);
    for (uint32_t i = 0; i < 8; i++) {
        config.depth_size = (uint32_t)FXL_DEPTH_BYTES(
            WIDTH, i % 3 == 0 ? HEIGHT : unit_between(1, HEIGHT), target->depth_bits);
        start_with(&config, sizeof memory);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
        renderer.frame.display_list.words = list;
        renderer.frame.display_list.capacity = i == 0 ? 0 : unit_random() % 900;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
        frame_draw_bands(&renderer, again, steps[i % 4], BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof again);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_workspace_init(&other, &renderer, room, sizeof room));
        memset(again, 77, sizeof again);
        frame_draw_band(&renderer, &renderer.workspace, again, 0, 13, BACKGROUND);
        frame_draw_band(&renderer, &other, again, 13, HEIGHT - 13, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof again);
    }
}

/* lines 2.1a, 2.5a, 2.6b, 2.7a */
void test_bands_lists_and_cores_have_the_same_pixels(void)
{
    uint32_t count = 0;
    fxl_placement placements[TINY_INSTANCES];
    for (int round = 0; round < UNIT_REPEAT / 2000 + 8; round++) {
        const fxl_pose pose = round % 2 ? tiny_pose_between() : tiny_pose_about();
        make_edges((uint8_t)unit_between(1, 4));
        lines[3].to = lines[3].from; /* a point */
        lines[5].faces[0] = lines[5].faces[1] = lines[7].faces[1] = 0;
        if (round % 3 == 0) {
            tiny_place_from(tiny, placements, 1);
            placements[0].orientation = unit_orientation();
        }
        check_ways(&fxl_palette, &pose);
        check_ways(depths[round % 2], &pose);
        for (uint32_t i = 0; i < PIXELS; i++) {
            count += frame[i] >= LINE;
        }
    }
    TEST_ASSERT_TRUE(count > 100);
}

/* Without a depth buffer a cube's lines cover its faces, and the cube that is drawn later the lines of the others. */
/* lines 2.5a */
void test_lines_come_in_the_turn_of_their_instance(void)
{
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    uint32_t farther = 0, over = 0;
    make_free_edges(1);
    tiny->instances[1].centre.x = Q16(5); /* partly behind the first */
    tiny->scene.instance_count = 1;
    start(&fxl_palette, false);
    draw(&pose, again);
    start(&fxl_palette, true);
    draw(&pose, without);
    tiny->scene.instance_count = 2;
    start(&fxl_palette, true);
    draw(&pose, frame);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const fxl_line *line = without[i] >= LINE ? &lines[without[i] - LINE] : NULL;
        over += line != NULL && (line->from & line->to & 1) != 0 && again[i] != BACKGROUND;
        farther += frame[i] >= LINE + EDGES;
        TEST_ASSERT_TRUE(without[i] == BACKGROUND || frame[i] == without[i]);
    }
    TEST_ASSERT_TRUE(farther > 3 && over > 3); /* over: of edges behind the front face */
}

/* lines 4.4a */
void test_a_pick_looks_through_lines(void)
{
    const fxl_pose pose = {{Q16(0.3), Q16(0.4), Q16(-5)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 3; bits++) {
        make_edges(5);
        start(bits == 0 ? &fxl_palette : depths[bits - 1], false);
        draw(&pose, without);
        start(bits == 0 ? &fxl_palette : depths[bits - 1], true);
        draw(&pose, frame);
        TEST_ASSERT_TRUE(memcmp(frame, without, sizeof frame) != 0);
        const fxl_line_counters before = attached.counters;
        for (uint32_t i = 0; i < PIXELS; i += 5) {
            fxl_picked picked;
            TEST_ASSERT_EQUAL(FXL_OK, fxl_pick_face(&renderer, (uint16_t)(i % WIDTH),
                                                    (uint16_t)(i / WIDTH), &picked));
            TEST_ASSERT_EQUAL(without[i] == BACKGROUND ? FXL_PICK_NONE : picked.instance,
                              picked.instance);
            TEST_ASSERT_TRUE(without[i] == BACKGROUND || picked.colour == without[i]);
        }
        TEST_ASSERT_EQUAL_MEMORY(&before, &attached.counters, sizeof before);
    }
}

/* Of the first model the lines alone are left: these are drawn as before where no face hides them. */
/* lines 1.1e */
void test_a_model_without_faces(void)
{
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 3; bits++) {
        uint32_t seen = 0, lost = 0;
        make_free_edges(1);
        tiny->scene.instance_count = 1;
        start(bits == 0 ? &fxl_palette : depths[bits - 1], true);
        draw(&pose, without);
        tiny->models[0].face_count = tiny->models[1].face_count = 0;
        tiny->models[1].first_face = tiny->models[1].kind = 0;
        tiny->models[1].first_cluster = 0;
        tiny->scene.face_count = tiny->scene.face_bounds_count = 0;
        tiny->scene.faces = NULL;
        tiny->scene.face_bounds = NULL;
        start(bits == 0 ? &fxl_palette : depths[bits - 1], true);
        draw(&pose, frame);
        for (uint32_t i = 0; i < PIXELS; i++) {
            seen += frame[i] >= LINE;
            lost += without[i] >= LINE && frame[i] != without[i] && bits == 0;
            TEST_ASSERT_TRUE(frame[i] >= LINE || frame[i] == BACKGROUND);
        }
        TEST_ASSERT_EQUAL_UINT32(0, lost);
        TEST_ASSERT_TRUE(seen > 30);
    }
    tiny->models[1].kind = FXL_MODEL_SORTED;
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_check(&tiny->scene, NULL));
}

/* Light and fog change the faces alone. */
/* lines 1.1c */
void test_light_leaves_lines_as_they_are(void)
{
    static uint8_t ramp[2 * 256]; /* no colour of a line */
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 4, .ramp = ramp, .levels = 2};
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 3; bits++) {
        fxl_light light;
        uint32_t seen = 0;
        make_edges(2);
        start(bits == 0 ? &fxl_palette : depths[bits - 1], true);
        draw(&pose, without);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_light(&renderer, &light, &lamp));
        draw(&pose, frame);
        for (uint32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL(without[i] >= LINE ? without[i] : 0, frame[i]);
            seen += frame[i] >= LINE;
        }
        TEST_ASSERT_TRUE(seen > 30);
    }
}

/* Two cubes at one place: with a depth buffer faces of the upper layer come first, near to far, so the lines
 * of the lower one come last, and are seen. */
/* lines 2.6b */
void test_lines_come_in_the_sequence_of_faces(void)
{
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t round = 0; round < 4; round++) {
        const uint32_t upper = round % 2;
        uint32_t counts[2] = {0, 0};
        make_free_edges(1);
        tiny->scene.instance_count = 2;
        tiny->instances[1] = tiny->instances[0];
        tiny->instances[1].model = 1;
        tiny->instances[upper].layer = 1;
        start(depths[round / 2], true);
        draw(&pose, frame);
        for (uint32_t i = 0; i < PIXELS; i++) {
            if (frame[i] >= LINE) {
                counts[frame[i] >= LINE + EDGES]++;
            }
        }
        TEST_ASSERT_EQUAL_UINT32(0, counts[upper]);
        TEST_ASSERT_TRUE(counts[1 - upper] > 30);
    }
}

/* Detached, the frame is that without lines. */
/* lines 4.3a */
void test_lines_are_detached(void)
{
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 3; bits++) {
        make_edges(2);
        start(bits == 0 ? &fxl_palette : depths[bits - 1], false);
        draw(&pose, without);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
        draw(&pose, frame);
        TEST_ASSERT_TRUE(memcmp(frame, without, sizeof frame) != 0);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set)); /* once more */
        draw(&pose, again);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof again);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, NULL));
        draw(&pose, again);
        TEST_ASSERT_EQUAL_MEMORY(without, again, sizeof again);
    }
}

/* lines 4.1a, 4.1b */
void test_a_frame_with_lines_is_released_from_its_list_alone(void)
{
    static uint32_t list[2000];
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 2; bits++) {
        make_edges(2);
        start(bits == 0 ? &fxl_palette : &fxl_palette_depth_16, true);
        renderer.frame.display_list.words = list;
        renderer.frame.display_list.capacity = 2000;
        begin_band(&pose);
        TEST_ASSERT_EQUAL(bits == 0 ? FXL_OK : FXL_E_CAPACITY, fxl_frame_release_scene(&renderer));
        memset(again, BACKGROUND, sizeof again);
        frame_draw_bands(&renderer, again, 7, BACKGROUND);
        TEST_ASSERT_EQUAL_MEMORY(frame, again, sizeof again);
    }
}

/* Aside by 2.25 a cube's sphere reaches into the view, and none of its edges does; aside by 2.6 neither does. */
/* lines 4.2b */
void test_lines_of_rejected_instances_are_not_counted(void)
{
    static const fxl_q16_16 places[] = {0, Q16(7.25), Q16(7.6)};
    for (uint32_t round = 0; round < 9; round++) {
        make_free_edges(1);
        for (uint32_t i = 0; i < 3; i++) {
            tiny->instances[i].centre = (fxl_point){places[(i + round) % 3], 0, Q16(5)};
        }
        start(round / 3 == 0 ? &fxl_palette : depths[round / 3 - 1], true);
        begin_band(&ahead);
        TEST_ASSERT_EQUAL_UINT32(2 * EDGES, attached.counters.in);
        TEST_ASSERT_EQUAL_UINT32(EDGES, attached.counters.drawn);
        TEST_ASSERT_EQUAL_UINT32(EDGES, attached.counters.outside);
    }
}

/* An image's lines are those of its two sections, which come together. */
/* formats 1.2bd, 1.2be, 1.14b, 1.14c */
void test_the_lines_of_an_image(void)
{
    fxl_scene_image opened;
    fxl_scene_fault fault;
    tiny_image *image = tiny_image_make(false);
    make_edges(2);
    tiny_set_section(image, SECTION_LINES, lines, 2 * EDGES, sizeof lines[0]);
    tiny_set_section(image, SECTION_LINE_MAP, line_map, 3, sizeof line_map[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_UINT32(2 * EDGES, opened.lines.count);
    TEST_ASSERT_EQUAL_MEMORY(lines, opened.lines.lines, sizeof lines[0] * 2 * EDGES);
    TEST_ASSERT_EQUAL_MEMORY(line_map, opened.lines.line_map, sizeof line_map);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lines_check(&opened.lines, &opened.scene, &fault));
    tiny_set_section(image, SECTION_LINE_MAP, line_map, 2, sizeof line_map[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("line map", fault.what);
    tiny_set_section(image, SECTION_LINE_MAP, line_map, 0, sizeof line_map[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_EQUAL_STRING("line map", fault.what);
    tiny_set_section(image, SECTION_LINES, lines, 0, sizeof lines[0]);
    tiny_seal(image);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(image->words, image->size, &opened, &fault));
    TEST_ASSERT_NULL(opened.lines.line_map);
}

/* What does not go with lines: the sentence names both, and detaching ends it. */
/* lines 4.5a */
void test_conflicts(void)
{
    static uint64_t tree[64];
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    static const char *const others[] = {"the order by tree", "a clipper of the study"};
    const char *names[2] = {NULL, NULL};
    for (uint32_t way = 0; way < 2; way++) {
        fxl_config config = config_of(&fxl_palette);
        make_edges(1);
        config.order = way == 0 ? &fxl_by_tree : NULL;
        config.tree = tree;
        config.tree_size = sizeof tree;
        start_with(&config, sizeof memory);
        if (way == 1) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_clipper(&renderer, &fxl_clipper_world, room,
                                                               fxl_clipper_world.workspace_size));
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
        TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_render(&renderer, &pose, frame, WIDTH));
        TEST_ASSERT_TRUE(fxl_renderer_conflict(&renderer, names));
        TEST_ASSERT_EQUAL_STRING("lines", names[way != 1]);
        TEST_ASSERT_EQUAL_STRING(others[way], names[way == 1]);
        const char *sentence = fxl_render_explain(&renderer, &pose, frame, WIDTH, NULL);
        TEST_ASSERT_NOT_NULL(sentence);
        TEST_ASSERT_NOT_NULL(strstr(sentence, names[0]));
        TEST_ASSERT_NOT_NULL(strstr(sentence, names[1]));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, frame, WIDTH));
    }
}

/* --- what is refused ------------------------------------------------------------------------ */

static void expect_fault(fxl_status status, const char *what, uint32_t index)
{
    fxl_scene_fault fault = {NULL, 0};
    TEST_ASSERT_EQUAL(status, fxl_lines_check(&set, &tiny->scene, &fault));
    TEST_ASSERT_EQUAL_STRING(what, fault.what);
    TEST_ASSERT_EQUAL_UINT32(index, fault.index);
    const uint32_t refused = renderer.workspace.counters.refused_calls;
    TEST_ASSERT_EQUAL(status, fxl_attach_lines(&renderer, &attached, &set));
    TEST_ASSERT_EQUAL_UINT32(refused + 1, renderer.workspace.counters.refused_calls);
    make_edges(1);
}

/* lines 1.2a */
void test_a_set_that_is_wrong(void)
{
    make_edges(1);
    start(&fxl_palette, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lines_check(&set, &tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lines_check(NULL, &tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_lines_check(&set, NULL, NULL));
    fxl_scene three = tiny->scene; /* of the third model nothing is read */
    const uint32_t falls[] = {0, 4, 2, 4}, zeros[] = {0, 0, 0};
    const fxl_line_set empty = {NULL, 0, zeros}, falling = {lines, 4, falls};
    three.model_count = 3;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lines_check(&empty, &tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_E_COUNT, fxl_lines_check(&falling, &three, NULL));
    set.lines = NULL;
    expect_fault(FXL_E_ARGUMENT, "line table", 0);
    set.line_map = NULL;
    expect_fault(FXL_E_ARGUMENT, "line table", 0);
    set.line_map = (const uint32_t *)(const void *)((const char *)line_map + 2);
    expect_fault(FXL_E_ALIGNMENT, "line table", 0);
    set.lines = (const fxl_line *)(const void *)((const char *)lines + 1);
    expect_fault(FXL_E_ALIGNMENT, "line table", 0);
    set.count = FXL_SCENE_FACES_MAX + 1;
    line_map[2] = set.count;
    expect_fault(FXL_E_COUNT, "line table", 0);
    line_map[0] = 1;
    expect_fault(FXL_E_COUNT, "line table", 0);
    set.count--;
    expect_fault(FXL_E_COUNT, "line table", 0);
    line_map[1] = line_map[2] + 1;
    expect_fault(FXL_E_COUNT, "model", 0);
    lines[2].from = 8;
    expect_fault(FXL_E_INDEX, "line", 2);
    lines[13].to = 8;
    expect_fault(FXL_E_INDEX, "line", 13);
    lines[4].faces[0] = 7;
    expect_fault(FXL_E_INDEX, "line", 4);
    lines[4].faces[1] = 7;
    expect_fault(FXL_E_INDEX, "line", 4);
    lines[1].width = 0;
    expect_fault(FXL_E_RANGE, "line", 1);
    lines[1].width = FXL_LINE_WIDTH_MAX + 1;
    expect_fault(FXL_E_RANGE, "line", 1);
    lines[23].reserved = 1;
    expect_fault(FXL_E_RESERVED, "line", 23);
}

/* combinations 1.1a */
void test_an_attachment_that_is_refused(void)
{
    static fxl_renderer none;
    make_edges(1);
    start(&fxl_palette, false);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_lines(NULL, &attached, &set));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_attach_lines(&renderer, NULL, &set));
    TEST_ASSERT_EQUAL(
        FXL_E_ALIGNMENT,
        fxl_attach_lines(&renderer, (fxl_lines *)(void *)((char *)&attached + 4), &set));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_lines(&none, &attached, &set));
    TEST_ASSERT_EQUAL_UINT32(2, renderer.workspace.counters.refused_calls);
    none.scene = &tiny->scene; /* and no target yet */
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_attach_lines(&none, &attached, &set));
    TEST_ASSERT_EQUAL_UINT32(2, none.workspace.counters.refused_calls);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, NULL, NULL)); /* there are none */
}

/* lines 5.2a */
void test_a_line_of_the_world_that_is_refused(void)
{
    const fxl_world_line good = {{0, 0, Q16(3)}, {Q16(1), 0, Q16(3)}, LINE, 2};
    fxl_world_line line = good;
    fxl_band band = whole_band(frame);
    fxl_config config = config_of(&fxl_palette_depth_16);
    make_edges(1);
    config.depth_size = FXL_DEPTH_BYTES(WIDTH, 9, 16);
    start_with(&config, sizeof memory);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_line(NULL, NULL, &line, &band));
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    begin_band(&ahead);
    memcpy(again, frame, sizeof again);
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    band.rows = 10;
    TEST_ASSERT_EQUAL(FXL_E_CAPACITY, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    band.rows = 9;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_line(&renderer, NULL, NULL, &band));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_line(&renderer, NULL, &line, NULL));
    line.width = 0;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    line.width = FXL_LINE_WIDTH_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    line = good;
    line.from.y = FXL_COORDINATE_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    line = good;
    line.to.z = -FXL_COORDINATE_MAX - 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    line = good;
    band.first_row = HEIGHT - 8;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    band.first_row = 9;
    band.palette = palette;
    TEST_ASSERT_EQUAL(FXL_E_ORDER, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    band.palette = NULL;
    band.pixels = NULL;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    TEST_ASSERT_EQUAL_MEMORY(again, frame, sizeof again);
    band.pixels = frame;
    band.width = WIDTH - 8;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    band.width = WIDTH;
    TEST_ASSERT_EQUAL_UINT32(13, renderer.workspace.counters.refused_calls);
    line.from.z = line.to.z = Q16(-3);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, &renderer.workspace, &line, &band));
    TEST_ASSERT_EQUAL_MEMORY(again, frame, sizeof again); /* it is behind the eye */
    line = good;
    band.first_row = HEIGHT - 9;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    TEST_ASSERT_EQUAL_MEMORY(again, frame, sizeof again); /* its rows are others */
    band.first_row = 9;
    start(&fxl_palette, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(3)));
    begin_band(&ahead);
    memcpy(again, frame, sizeof again);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    TEST_ASSERT_TRUE(memcmp(again, frame, sizeof again) != 0);
}
