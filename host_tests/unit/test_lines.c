/* SPDX-License-Identifier: MIT */
/* Lines and points of models and of the world, with a depth buffer and without. */
#include <math.h>
#include <stdlib.h>

#include "frame_bands.h"
#include "study/study.h"
#include "tiny_frames.h"

enum {
    WIDTH = 48,
    HEIGHT = 36,
    BACKGROUND = 0,
    LINE = 200, /* colours from here on are of lines */
    EDGES = 12,
    PIXELS = WIDTH * HEIGHT
};

static tiny_scene *tiny;
static fxl_renderer renderer;
static fxl_lines attached;
static fxl_line lines[2 * EDGES + 16];
static uint32_t line_map[3];
static fxl_line_set set;
static uint64_t memory[4096], room[4096];
static uint64_t cells[FXL_DEPTH_BYTES(WIDTH, HEIGHT, 32) / 8];
static uint16_t palette[256];
static uint8_t frame[PIXELS], without[PIXELS], again[PIXELS];

/* --- set-up --------------------------------------------------------------------------------- */

/* The other face of a cube, counted from 1, that has an edge of a face in the other direction. */
static uint16_t other_face(const fxl_model *model, uint32_t face, uint16_t a, uint16_t b)
{
    for (uint16_t i = 0; i < model->face_count; i++) {
        const fxl_face *other = &tiny->faces[model->first_face + i];
        const uint16_t *corners = fxl_face_indices(tiny->corners, other);
        for (uint32_t k = 0; k < 4 && i != face; k++) {
            if (corners[k] == b && corners[(k + 1) % 4] == a) {
                return (uint16_t)(i + 1);
            }
        }
    }
    return 0;
}

/* The twelve edges of both cubes, each with its two faces, and a colour of its own. */
static void make_edges(uint8_t width)
{
    uint32_t count = 0;
    tiny = tiny_make();
    for (uint32_t m = 0; m < 2; m++) {
        line_map[m] = count;
        const fxl_model *model = &tiny->models[m];
        for (uint16_t i = 0; i < model->face_count; i++) {
            const uint16_t *corners =
                fxl_face_indices(tiny->corners, &tiny->faces[model->first_face + i]);
            for (uint32_t k = 0; k < 4; k++) {
                const uint16_t a = corners[k], b = corners[(k + 1) % 4];
                if (a < b) {
                    lines[count] = (fxl_line){a, b, {(uint16_t)(i + 1), other_face(model, i, a, b)},
                                              (uint8_t)(LINE + count), width, 0};
                    count++;
                }
            }
        }
    }
    line_map[2] = count;
    set = (fxl_line_set){lines, count, line_map};
    TEST_ASSERT_EQUAL_UINT32(2 * EDGES, count);
}

static fxl_config config_of(const fxl_target *target)
{
    fxl_config config = fxl_config_for(WIDTH, HEIGHT, target);
    config.near_z = Q16(0.25);
    config.far_z = Q16(100);
    config.fov = DEGREES(90);
    config.background = BACKGROUND;
    config.palette = palette;
    config.depth = cells;
    config.depth_size = sizeof cells;
    return config;
}

static void start_with(const fxl_config *config, uint32_t memory_size)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check_all(&tiny->scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init(&renderer, &tiny->scene, config, memory, memory_size));
}

static void start(const fxl_target *target, bool has_lines)
{
    const fxl_config config = config_of(target);
    start_with(&config, sizeof memory);
    if (has_lines) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_attach_lines(&renderer, &attached, &set));
    }
}

static void draw(const fxl_pose *pose, uint8_t *to)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, pose, to, WIDTH));
}

static const fxl_target *const depths[] = {&fxl_palette_depth_16, &fxl_palette_depth_32};

/* --- the rule of the pixels ----------------------------------------------------------------- */

static int64_t floor_of(int64_t part, int64_t whole)
{
    return part >= 0 ? part / whole : -((-part + whole - 1) / whole);
}

/* place fill-rule: definition: the pixels of a line with a width */
/* Whether the definition gives a line of a width a pixel. Coordinates are on the screen, so their
 * products are below 2^60. */
static bool covers(const fxl_screen_point *a, const fxl_screen_point *b, int32_t width, int32_t x,
                   int32_t y)
{
    const int64_t across = b->x - a->x, down = b->y - a->y;
    const bool is_steep = llabs(down) > llabs(across);
    const int64_t centre = (is_steep ? y : x) * 65536 + 32768;
    const int64_t from = is_steep ? a->y : a->x, to = is_steep ? b->y : b->x;
    if (centre < (from < to ? from : to) || centre >= (from < to ? to : from)) {
        return false;
    }
    /* twice the place across, less width - 1 pixels, over the length */
    const int64_t length = to - from;
    const int64_t base = (is_steep ? a->x : a->y) - (width - 1) * 32768;
    const int64_t sum = base * length + (centre - from) * (is_steep ? across : down);
    const int64_t first =
        length > 0 ? floor_of(sum, length * 65536) : floor_of(-sum, -length * 65536);
    const int64_t at = is_steep ? x : y;
    return at >= first && at < first + width;
}

static void place(const fxl_point *point, fxl_screen_point *screen, fxl_view_point *view)
{
    fxl_transform_point(&renderer.frame.view.camera, point, view);
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_project_visible(&renderer.frame.view.projection, view, screen));
}

/* A point in front of an eye at the origin that looks along +z, on the screen. */
static fxl_point visible_point(void)
{
    const fxl_q16_16 z = unit_between(Q16(1), Q16(40));
    const fxl_point point = {(fxl_q16_16)((int64_t)z * unit_between(-90, 90) / 100),
                             (fxl_q16_16)((int64_t)z * unit_between(-60, 60) / 100), z};
    return point;
}

static const fxl_pose ahead = {{0, 0, 0}, 0, 0, 0};

static void begin_band(const fxl_pose *pose)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    frame_draw_bands(&renderer, frame, HEIGHT, BACKGROUND);
}

static fxl_band whole_band(uint8_t *pixels)
{
    const fxl_band band = UNIT_BAND(pixels, WIDTH, 0, HEIGHT);
    return band;
}

/* lines 2.2a, 2.2b, 5.1a */
void test_a_line_has_the_pixels_of_its_definition(void)
{
    make_edges(1);
    tiny->scene.instance_count = 1;
    tiny->instances[0].centre.z = Q16(-9); /* behind the eye */
    start(&fxl_palette, false);
    begin_band(&ahead);
    for (int round = 0; round < UNIT_REPEAT / 50; round++) {
        const fxl_world_line line = {visible_point(), visible_point(), LINE,
                                     (uint8_t)unit_between(1, FXL_LINE_WIDTH_MAX)};
        const fxl_band band = whole_band(frame);
        fxl_screen_point a, b;
        fxl_view_point view;
        place(&line.from, &a, &view);
        place(&line.to, &b, &view);
        memset(frame, BACKGROUND, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
        for (int32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_EQUAL(covers(&a, &b, line.width, i % WIDTH, i / WIDTH) ? LINE : BACKGROUND,
                              frame[i]);
        }
    }
}

/* lines 2.3a */
void test_a_point_is_a_square(void)
{
    make_edges(1);
    tiny->scene.instance_count = 1;
    tiny->instances[0].centre.z = Q16(-9);
    start(&fxl_palette, false);
    begin_band(&ahead);
    for (int round = 0; round < UNIT_REPEAT / 100; round++) {
        const fxl_point at = visible_point();
        const fxl_world_line line = {at, at, LINE, (uint8_t)unit_between(1, FXL_LINE_WIDTH_MAX)};
        const fxl_band band = whole_band(frame);
        fxl_screen_point a;
        fxl_view_point view;
        place(&at, &a, &view);
        const int64_t left = floor_of(a.x - (line.width - 1) * 32768, 65536);
        const int64_t top = floor_of(a.y - (line.width - 1) * 32768, 65536);
        memset(frame, BACKGROUND, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
        for (int32_t i = 0; i < PIXELS; i++) {
            const bool is_in = i % WIDTH >= left && i % WIDTH < left + line.width &&
                               i / WIDTH >= top && i / WIDTH < top + line.width;
            TEST_ASSERT_EQUAL(is_in ? LINE : BACKGROUND, frame[i]);
        }
    }
    for (uint32_t i = 0; i < 2; i++) { /* ends of which one coordinate differs */
        const fxl_point from = {Q16(0.5), 0, Q16(3)};
        const fxl_point to = {Q16(0.5), i == 0 ? Q16(1) : 0, i == 0 ? Q16(3) : Q16(6)};
        const fxl_world_line line = {from, to, LINE, 1};
        const fxl_band band = whole_band(frame);
        uint32_t count = 0;
        memset(frame, BACKGROUND, sizeof frame);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
        for (int32_t k = 0; k < PIXELS; k++) {
            count += frame[k] == LINE;
        }
        TEST_ASSERT_GREATER_THAN_UINT32(1, count);
    }
}

/* --- lines on faces ------------------------------------------------------------------------- */

/* The line of an instance has a pixel, by the definition, with its ends where the faces' vertices
 * are. False: an end lies beside the screen, so that the pixel is not known. */
static bool line_covers(const fxl_instance *instance, const fxl_line *line, int32_t pixel)
{
    const fxl_model *model = &tiny->models[instance->model];
    fxl_screen_point ends[2];
    for (uint32_t i = 0; i < 2; i++) {
        const fxl_point *vertex =
            &tiny->vertices[model->first_vertex + (i == 0 ? line->from : line->to)];
        const fxl_point point = {instance->centre.x + vertex->x, instance->centre.y + vertex->y,
                                 instance->centre.z + vertex->z};
        fxl_view_point view;
        fxl_transform_point(&renderer.frame.view.camera, &point, &view);
        if (view.z < renderer.frame.view.view_frustum.near_z ||
            fxl_project_visible(&renderer.frame.view.projection, &view, &ends[i]) != FXL_OK ||
            ends[i].x < 0 || ends[i].y < 0 || ends[i].x >= WIDTH * 65536 ||
            ends[i].y >= HEIGHT * 65536) {
            return false;
        }
    }
    return covers(&ends[0], &ends[1], line->width, pixel % WIDTH, pixel / WIDTH);
}

/* Each pixel in which the frame without lines shows a face of an edge shows a line in the frame with
 * them, wherever the edge has the pixel: no bias, and none is lost. */
/* lines 3.2a, 3.2c */
void test_an_edge_is_seen_wherever_its_face_is(void)
{
    uint32_t seen = 0, hidden = 0;
    for (int round = 0; round < UNIT_REPEAT / 300 + 20; round++) {
        const fxl_target *target = depths[round % 2];
        const fxl_pose pose = tiny_pose_before();
        make_edges((uint8_t)unit_between(1, 5));
        tiny->scene.instance_count = 1u + (uint32_t)round % 3;
        start(target, false);
        draw(&pose, without);
        start(target, true);
        draw(&pose, frame);
        for (int32_t i = 0; i < PIXELS; i++) {
            TEST_ASSERT_TRUE(frame[i] == without[i] || frame[i] >= LINE);
            for (uint32_t n = 0; n < tiny->scene.instance_count; n++) {
                const fxl_instance *instance = &tiny->instances[n];
                const fxl_model *model = &tiny->models[instance->model];
                for (uint32_t k = line_map[instance->model]; k < line_map[instance->model + 1];
                     k++) {
                    const fxl_line *line = &lines[k];
                    if (!line_covers(instance, line, i)) {
                        continue;
                    }
                    bool shows = false;
                    for (uint32_t f = 0; f < 2; f++) {
                        const fxl_face *face =
                            &tiny->faces[model->first_face + line->faces[f] - 1u];
                        shows = shows || without[i] == face->material;
                    }
                    /* Both instances of the convex cube have its colours. */
                    if (shows && tiny->scene.instance_count < 3) {
                        TEST_ASSERT_TRUE(frame[i] >= LINE);
                        seen++;
                    } else {
                        hidden += frame[i] == without[i];
                    }
                }
            }
        }
    }
    TEST_ASSERT_TRUE(seen > 100 && hidden > 100);
}

/* Lines on faces that are turned away are not drawn, whether or not there is a depth buffer. */
/* lines 2.4a, 4.2a */
void test_a_line_on_faces_that_are_turned_away(void)
{
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    for (uint32_t bits = 0; bits < 2; bits++) {
        make_edges(1);
        tiny->scene.instance_count = 1;
        start(bits == 0 ? &fxl_palette : &fxl_palette_depth_16, true);
        begin_band(&pose);
        TEST_ASSERT_EQUAL_UINT32(EDGES, attached.counters.in);
        TEST_ASSERT_EQUAL_UINT32(8, attached.counters.backfacing); /* but those of the front face */
        TEST_ASSERT_EQUAL_UINT32(4, attached.counters.drawn);
        TEST_ASSERT_EQUAL_UINT32(0, attached.counters.outside + attached.counters.refused +
                                        attached.counters.clipped);
    }
}

/* lines 2.1b, 4.2a */
void test_lines_are_counted_once(void)
{
    static uint32_t list[600];
    uint32_t clipped = 0, outside = 0;
    for (int round = 0; round < UNIT_REPEAT / 300; round++) {
        const fxl_pose pose = tiny_pose_between();
        fxl_line_counters first;
        for (uint32_t way = 0; way < 3; way++) {
            make_edges(2);
            for (uint32_t i = 0; i < set.count; i++) {
                lines[i].faces[0] = lines[i].faces[1] = 0;
            }
            start(way == 2 ? &fxl_palette_depth_16 : &fxl_palette, true);
            renderer.frame.display_list.words = list;
            renderer.frame.display_list.capacity = way == 0 ? 0 : unit_random() % 600;
            begin_band(&pose);
            frame_draw_bands(&renderer, frame, 7, BACKGROUND);
            const fxl_line_counters *counted = &attached.counters;
            TEST_ASSERT_EQUAL_UINT32(counted->in, counted->backfacing + counted->outside +
                                                      counted->refused + counted->drawn);
            if (way == 0) {
                first = *counted;
            }
            TEST_ASSERT_EQUAL_MEMORY(&first, counted, sizeof first);
        }
        clipped += first.clipped;
        outside += first.outside;
    }
    TEST_ASSERT_TRUE(clipped > 10 && outside > 10);
}

/* --- the depth of a line -------------------------------------------------------------------- */

/* The code of a depth, with 16 bits after the point, as SPEC.md, section 10.3, defines it. */
static double code_of(double depth, double far_by_near)
{
    const int e = (int)ceil(log2(far_by_near * 257 / 256));
    int m = 16, o = 0;
    while (e * pow(2, m) >= 65536) {
        m--;
    }
    while (depth < pow(2, -(o + 1))) {
        o++;
    }
    return ((depth * pow(2, o + 1) - 1 + e - 1 - o) * pow(2, m) + 1) * 65536;
}

static uint32_t cell_at(int32_t pixel)
{
    const uint32_t *first = (const uint32_t *)(const void *)&cells[1];
    return first[pixel];
}

/* lines 3.3a, 3.3b, 3.3c, 3.3d */
void test_a_line_has_the_depth_of_its_points(void)
{
    make_edges(1);
    tiny->scene.instance_count = 1;
    tiny->instances[0].centre.z = Q16(-9);
    start(&fxl_palette_depth_32, false);
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        const bool is_point = round % 8 == 0;
        const fxl_point from = visible_point(), to = is_point ? from : visible_point();
        const fxl_world_line line = {from, to, LINE, (uint8_t)unit_between(1, 3)};
        const fxl_band band = whole_band(frame);
        fxl_screen_point a, b;
        fxl_view_point at, behind;
        begin_band(&ahead);
        place(&from, &a, &at);
        place(&to, &b, &behind);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
        const double near_z = 0.25 * 70368744177664.0;
        const double d0 = near_z / (double)at.z, d1 = near_z / (double)behind.z;
        const bool is_steep = llabs(b.y - a.y) > llabs(b.x - a.x);
        for (int32_t i = 0; i < PIXELS; i++) {
            if (frame[i] != LINE) {
                continue;
            }
            const double centre = (is_steep ? i / WIDTH : i % WIDTH) * 65536.0 + 32768;
            const double from_a = is_steep ? a.y : a.x, to_b = is_steep ? b.y : b.x;
            const double t = is_point ? 0 : (centre - from_a) / (to_b - from_a);
            const double exact = code_of(d0 + t * (d1 - d0), 400);
            const double error = exact - (double)cell_at(i);
            TEST_ASSERT_TRUE(error > -2 - exact * 0x1p-25 && error < 3 + exact * 0x1p-25 + 512);
        }
    }
}

/* A line before a face covers it, one behind it is hidden. */
/* lines 3.1a */
void test_faces_hide_lines(void)
{
    for (uint32_t i = 0; i < 2; i++) {
        for (uint32_t behind = 0; behind < 2; behind++) {
            const fxl_q16_16 z = behind ? Q16(2) : Q16(-2);
            const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
            const fxl_world_line line = {{Q16(-0.5), Q16(0.1), z}, {Q16(0.5), Q16(-0.1), z}, LINE, 2};
            const fxl_band band = whole_band(frame);
            uint32_t count = 0;
            make_edges(1);
            tiny->scene.instance_count = 1;
            start(depths[i], false);
            begin_band(&pose);
            TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
            for (uint32_t k = 0; k < PIXELS; k++) {
                count += frame[k] == LINE;
            }
            TEST_ASSERT_EQUAL(behind != 0, count == 0);
        }
    }
}

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

/* lines 2.1a, 2.6b, 2.7a */
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

/* Without a depth buffer the cube that is drawn later covers the lines of the others. */
/* lines 2.5a */
void test_lines_come_in_the_turn_of_their_instance(void)
{
    const fxl_pose pose = {{0, 0, Q16(-4)}, 0, 0, 0};
    make_edges(1);
    for (uint32_t i = 0; i < set.count; i++) {
        lines[i].faces[0] = lines[i].faces[1] = 0;
    }
    tiny->instances[1].centre.x = Q16(5); /* partly behind the first */
    tiny->scene.instance_count = 1;
    start(&fxl_palette, true);
    draw(&pose, without);
    tiny->scene.instance_count = 2;
    start(&fxl_palette, true);
    draw(&pose, frame);
    uint32_t farther = 0;
    for (uint32_t i = 0; i < PIXELS; i++) {
        farther += frame[i] >= LINE + EDGES;
        TEST_ASSERT_TRUE(without[i] == BACKGROUND || frame[i] == without[i]);
    }
    TEST_ASSERT_TRUE(farther > 3);
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

/* place pixel-format: what an extra does in frames of the format */
/* A pixel of 16 bits has the colour that the palette gives the pixel of 8. */
/* lines 1.1d */
void test_lines_in_rgb565(void)
{
    static const fxl_target *const pairs[][2] = {{&fxl_palette, &fxl_rgb565},
                                                 {&fxl_palette_depth_16, &fxl_rgb565_depth_16},
                                                 {&fxl_palette_depth_32, &fxl_rgb565_depth_32}};
    static uint16_t pixels[PIXELS];
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(i * 257);
    }
    for (uint32_t i = 0; i < 3; i++) {
        make_edges(3);
        start(pairs[i][0], true);
        draw(&pose, frame);
        start(pairs[i][1], true);
        TEST_ASSERT_EQUAL(FXL_OK, fxl_render(&renderer, &pose, pixels, WIDTH));
        for (uint32_t k = 0; k < PIXELS; k++) {
            TEST_ASSERT_EQUAL_HEX16(palette[frame[k]], pixels[k]);
        }
    }
    const fxl_world_line line = {{0, 0, Q16(3)}, {Q16(1), 0, Q16(3)}, LINE, 2};
    fxl_band band = whole_band((uint8_t *)pixels + 1);
    band.palette = palette;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, &pose));
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT, fxl_frame_draw_line(&renderer, NULL, &line, &band));
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
/* lines 4.5a, orthographic 1.3b */
void test_conflicts(void)
{
    static uint64_t tree[64];
    const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
    static const char *const others[] = {"the order by tree", "a clipper of the study",
                                         "an orthographic lens"};
    const char *names[2] = {NULL, NULL};
    for (uint32_t way = 0; way < 3; way++) {
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
        if (way == 2) {
            TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(8)));
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
    TEST_ASSERT_EQUAL(FXL_E_ALIGNMENT,
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
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, &line, &band));
    start(&fxl_palette, false);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_set_orthographic(&renderer, Q16(3)));
    begin_band(&ahead);
    TEST_ASSERT_EQUAL(FXL_E_COMBINATION, fxl_frame_draw_line(&renderer, NULL, &line, &band));
}
