/* SPDX-License-Identifier: MIT */
/* The pixels and depths of lines and points of models and of the world. */
#include <math.h>
#include <stdlib.h>

#include "line_scene.h"

static uint8_t without[PIXELS];

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
    TEST_ASSERT_EQUAL(FXL_OK, fxl_project_visible(&renderer.frame.view.projection, view, screen));
}

/* A point in front of an eye at the origin that looks along +z, on the screen. */
static fxl_point visible_point(void)
{
    const fxl_q16_16 z = unit_between(Q16(1), Q16(40));
    const fxl_point point = {(fxl_q16_16)((int64_t)z * unit_between(-90, 90) / 100),
                             (fxl_q16_16)((int64_t)z * unit_between(-60, 60) / 100), z};
    return point;
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

/* --- lines that leave the view ------------------------------------------------------------- */

/* A vertex of the first instance in the view, and on the screen in pixels. */
typedef struct {
    double x, y, z, right, down;
} seen_end;

static void project_end(seen_end *end)
{
    end->right = WIDTH / 2.0 * (1 + end->x / end->z);
    end->down = HEIGHT / 2.0 - WIDTH / 2.0 * end->y / end->z;
}

static seen_end see_end(uint16_t number)
{
    const fxl_point *vertex = &tiny->vertices[number], *centre = &tiny->instances[0].centre;
    const fxl_point point = {centre->x + vertex->x, centre->y + vertex->y, centre->z + vertex->z};
    fxl_view_point view;
    fxl_transform_point(&renderer.frame.view.camera, &point, &view);
    seen_end end = {ldexp((double)view.x, -46), ldexp((double)view.y, -46),
                    ldexp((double)view.z, -46), 0, 0};
    project_end(&end);
    return end;
}

/* Moves an end to the near plane, if it is nearer. */
static void cut_near(seen_end *end, const seen_end *other)
{
    const double near_z = NEAR / 65536.0, t = (near_z - end->z) / (other->z - end->z);
    if (end->z < near_z) {
        end->x += t * (other->x - end->x);
        end->y += t * (other->y - end->y);
        end->z = near_z;
        project_end(end);
    }
}

/* How far a pixel of a line of one pixel's width is within it: of the ends, and of the sides. Below 0: it is none. */
static double within_line(const seen_end *a, const seen_end *b, bool is_steep, int32_t x, int32_t y)
{
    const double along = (is_steep ? y : x) + 0.5, across = is_steep ? x : y;
    const double from = is_steep ? a->down : a->right, to = is_steep ? b->down : b->right;
    const double side = is_steep ? a->right : a->down, other = is_steep ? b->right : b->down;
    const double at = side + (other - side) * (along - from) / (to - from) - across;
    const double ends = fmin(along - fmin(from, to), fmax(from, to) - along);
    return fmin(ends, fmin(at, 1 - at));
}

/* Whether a point is drawn: how far it is within the sides, in pixels. */
static double within_view(const seen_end *end)
{
    return end->z < NEAR / 65536.0
               ? -1
               : fmin(fmin(end->right, WIDTH - end->right), fmin(end->down, HEIGHT - end->down));
}

/* What rounding may move. */
#define UNSURE 0.02

static void expect_line(const seen_end *a, const seen_end *b)
{
    const double width = fabs(b->right - a->right), height = fabs(b->down - a->down);
    if (fabs(width - height) < UNSURE * (1 + width)) {
        return;
    }
    for (int32_t i = 0; i < PIXELS; i++) {
        const double within = within_line(a, b, height > width, i % WIDTH, i / WIDTH);
        if (fabs(within) > UNSURE) {
            TEST_ASSERT_EQUAL(within > 0, frame[i] == LINE);
        }
    }
}

static void expect_point(const seen_end *end, uint32_t *shown, uint32_t *left)
{
    const double within = within_view(end);
    const bool is_shown = memchr(frame, LINE, sizeof frame) != NULL;
    if (fabs(within) > UNSURE) {
        TEST_ASSERT_EQUAL(within > 0, is_shown);
        *shown += is_shown;
        *left += !is_shown && within > -4; /* its pixels would be seen */
    }
}

/* The first cube's corners, most of which are beside the screen or behind the eye. */
/* lines 2.1a, 2.1b, 2.1c */
void test_lines_are_cut_by_the_view_and_points_are_not(void)
{
    uint32_t cut = 0, nearer = 0, shown = 0, left = 0;
    for (int round = 0; round < 300 + UNIT_REPEAT / 100; round++) {
        const fxl_pose pose = {{unit_between(Q16(-2), Q16(2)), unit_between(Q16(-2), Q16(2)),
                                unit_between(Q16(-4), Q16(1))},
                               unit_random(),
                               (uint32_t)unit_between(-1000, 1000) << 20,
                               unit_random()};
        make_edges(1);
        tiny->scene.instance_count = 1;
        lines[0] = (fxl_line){
            (uint16_t)unit_between(0, 7), (uint16_t)unit_between(0, 7), {0, 0}, LINE, 1, 0};
        line_map[1] = line_map[2] = set.count = 1;
        if (lines[0].from == lines[0].to) {
            lines[0].width = 9;
        }
        start(&fxl_palette, true);
        draw(&pose, frame);
        seen_end a = see_end(lines[0].from), b = see_end(lines[0].to);
        if (lines[0].from == lines[0].to) {
            expect_point(&a, &shown, &left);
        } else if (a.z < NEAR / 65536.0 && b.z < NEAR / 65536.0) {
            TEST_ASSERT_NULL(memchr(frame, LINE, sizeof frame));
        } else {
            nearer += a.z < NEAR / 65536.0 || b.z < NEAR / 65536.0;
            cut += attached.counters.clipped;
            cut_near(&a, &b);
            cut_near(&b, &a);
            expect_line(&a, &b);
        }
    }
    TEST_ASSERT_TRUE(cut > 20 && nearer > 20 && shown > 2 && left > 2);
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
            make_free_edges(2);
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

/* Draws a line or a point of the world, of which each pixel has the depth of its definition: off by less than 2^-25
 * of itself, so a code of 32 bits by less than 2^4; and at most 512 less by rounding. */
static void check_depths(const fxl_world_line *line, uint32_t bits)
{
    const bool is_point = memcmp(&line->from, &line->to, sizeof line->from) == 0;
    const fxl_band band = whole_band(frame);
    const double near_z = (double)renderer.frame.view.lens.near_z * FXL_Q2_30_ONE;
    fxl_screen_point a, b;
    fxl_view_point at, behind;
    begin_band(&ahead);
    place(&line->from, &a, &at);
    place(&line->to, &b, &behind);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw_line(&renderer, NULL, line, &band));
    const double d0 = near_z / (double)at.z, d1 = near_z / (double)behind.z;
    const bool is_steep = llabs(b.y - a.y) > llabs(b.x - a.x);
    for (int32_t i = 0; i < PIXELS; i++) {
        if (frame[i] != LINE) {
            continue;
        }
        const double centre = (is_steep ? i / WIDTH : i % WIDTH) * 65536.0 + 32768;
        const double from_a = is_steep ? a.y : a.x, to_b = is_steep ? b.y : b.x;
        const double t = is_point ? 0 : (centre - from_a) / (to_b - from_a);
        const double depth = d0 + t * (d1 - d0);
        const uint32_t code = cell_at(bits, i);
        if (depth < 1) {
            const double exact = exact_code(depth) * 65536;
            const double error = exact - code * (bits == 16 ? 65536.0 : 1.0);
            TEST_ASSERT_TRUE(error > -18 && error < 19 + (bits == 16 ? 65536 : 512));
        } else { /* of a line whose depth is near everywhere, or of its end: nearly so */
            TEST_ASSERT_TRUE(code == (bits == 16 ? UINT16_MAX : UINT32_MAX) || d0 < d1 || d1 < d0);
        }
    }
}

/* lines 3.3a, 3.3b, 3.3c, 3.3d */
void test_a_line_has_the_depth_of_its_points(void)
{
    make_edges(1);
    tiny->scene.instance_count = 1;
    tiny->instances[0].centre.z = Q16(-9);
    start(&fxl_palette_depth_32, false);
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        const fxl_point from = visible_point();
        const fxl_world_line line = {from, round % 8 == 0 ? from : visible_point(), LINE,
                                     (uint8_t)unit_between(1, 3)};
        check_depths(&line, 32);
    }
}

/* Of a lens with nearly as many octaves as there can be; depths from far on, where the upper word of one has fewer
 * bits than a code, to near, where a depth is 1. */
/* lines 3.3a, 3.3b, 3.3c, 3.3d */
void test_a_line_from_near_to_far_has_the_depth_of_its_points(void)
{
    for (int round = 0; round < UNIT_REPEAT / 200; round++) {
        const uint32_t bits = round % 2 ? 16 : 32;
        fxl_config config = config_of(depths[bits / 32]);
        fxl_point ends[2];
        config.near_z = FXL_NEAR_MIN;
        config.far_z = FXL_NEAR_MIN << 20;
        make_edges(1);
        tiny->scene.instance_count = 1;
        tiny->instances[0].centre.z = Q16(-9);
        start_with(&config, sizeof memory);
        for (uint32_t i = 0; i < 2; i++) {
            const bool is_near = round % 3 == 0 || (round % 3 == 1 && i == 0);
            const fxl_q16_16 z =
                is_near ? FXL_NEAR_MIN : 3 * (FXL_NEAR_MIN / 2) << unit_random() % 20;
            const int32_t x = unit_between(-20, 19), y = unit_between(-15, 14);
            ends[i].x = (fxl_q16_16)((2 * x + 1) * (int64_t)z / WIDTH); /* of a pixel's centre */
            ends[i].y = (fxl_q16_16)((2 * y + 1) * (int64_t)z / WIDTH);
            ends[i].z = z;
        }
        const fxl_world_line line = {ends[0], ends[1], LINE, (uint8_t)unit_between(1, 3)};
        check_depths(&line, bits);
    }
}

/* The largest of two codes is kept, whichever of the faces is named first. */
/* lines 3.2a */
void test_the_sequence_of_a_lines_faces_does_not_matter(void)
{
    static uint64_t first[sizeof cells / sizeof cells[0]];
    uint32_t drawn = 0;
    for (int round = 0; round < 20; round++) {
        const fxl_pose pose = tiny_pose_before();
        for (uint32_t way = 0; way < 2; way++) {
            make_edges(5);
            for (uint32_t i = 0; i < set.count && way == 1; i++) {
                const uint16_t face = lines[i].faces[0];
                lines[i].faces[0] = lines[i].faces[1];
                lines[i].faces[1] = face;
            }
            start(depths[round % 2], true);
            draw(&pose, way == 0 ? without : frame);
            if (way == 0) {
                memcpy(first, cells, sizeof first);
            }
        }
        TEST_ASSERT_EQUAL_MEMORY(first, cells, sizeof first);
        TEST_ASSERT_EQUAL_MEMORY(without, frame, sizeof frame);
        drawn += attached.counters.drawn;
    }
    TEST_ASSERT_TRUE(drawn > 100);
}

/* A line before a face covers it, one behind it is hidden. */
/* lines 3.1a */
void test_faces_hide_lines(void)
{
    for (uint32_t i = 0; i < 2; i++) {
        for (uint32_t behind = 0; behind < 2; behind++) {
            const fxl_q16_16 z = behind ? Q16(2) : Q16(-2);
            const fxl_pose pose = {{0, 0, Q16(-5)}, 0, 0, 0};
            const fxl_world_line line = {
                {Q16(-0.5), Q16(0.1), z}, {Q16(0.5), Q16(-0.1), z}, LINE, 2};
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
