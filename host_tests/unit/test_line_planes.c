/* SPDX-License-Identifier: MIT */
/* Lines on planes of faces: their codes, which planes are kept, and lines in RGB565. */
#include <math.h>

#include "paint/line_paint.h"

#include "line_scene.h" /* last: its names are those of parameters */

/* Paints a line along the centres of a row on a plane: its codes are in a depth buffer of 16 or 32 bits, which was
 * cleared. */
static void paint_row(uint32_t bits, int32_t y, fxl_line_plane face)
{
    const fxl_screen_point from = {1, y * 65536 + 32768}, to = {WIDTH * 65536 - 1, from.y};
    const fxl_band band = whole_band(frame);
    const fxl_painted_line line = {
        .ends = {from, to}, .colour = LINE, .width = 1, .plane_count = 1, .planes = {&face}};
    fxl_line_canvas canvas;
    make_edges(1);
    tiny->instances[0].centre.z = Q16(-9);
    tiny->scene.instance_count = 1;
    start(depths[bits == 32], false);
    begin_band(&ahead);
    memset(cells + 1, 0, sizeof cells - sizeof cells[0]);
    fxl_line_plane_begin(&face);
    fxl_line_canvas_begin(&canvas, &band, (const fxl_depth_head *)cells, NEAR, bits == 32);
    fxl_paint_wide_line(&canvas, &line);
}

/* An upper word of such a plane is more than an octave. A line along a row of centres has depths of the first word. */
/* lines 3.2a */
void test_codes_on_a_plane_that_is_nearly_edge_on(void)
{
    for (uint32_t round = 0; round < 200; round++) {
        const uint32_t bits = round % 2 ? 32 : 16;
        const int32_t one = unit_between(35, 40), y = unit_between(0, HEIGHT - 1);
        const int64_t first = unit_between(1 << 24, INT32_MAX), along = unit_between(0, 1 << 29);
        const fxl_gradient gradient = {first - ((int64_t)y << 56), along, (int64_t)1 << 56};
        const fxl_line_plane face = {.plane = {gradient, one}};
        paint_row(bits, y, face);
        for (int32_t x = 0; x < WIDTH; x++) {
            TEST_ASSERT_EQUAL(LINE, frame[y * WIDTH + x]);
            expect_code(exact_code(ldexp((double)(first + x * along), -one)), bits,
                        cell_at(bits, y * WIDTH + x));
        }
    }
}

/* A line may name a face on which it does not lie, and whose plane is before near_z: its code is the largest one,
 * however near it is. */
/* lines 3.2a */
void test_codes_on_a_plane_before_near_are_the_largest(void)
{
    for (int32_t quarters = 4; quarters < 160; quarters++) {
        const uint32_t bits = quarters % 2 ? 32 : 16;
        const int32_t one = unit_between(35, 48);
        const fxl_line_plane face = {.plane = {{(int64_t)quarters << (one - 2), 0, 0}, one}};
        paint_row(bits, 10, face);
        for (int32_t x = 0; x < WIDTH; x++) {
            TEST_ASSERT_EQUAL_HEX32(UINT32_MAX >> (32 - bits), cell_at(bits, 10 * WIDTH + x));
        }
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

/* The second face of each line is one from the 31st on, alike: what is kept of the first 32 is not of these. */
/* lines 2.4a */
void test_lines_on_the_last_of_many_faces(void)
{
    static fxl_face many[42];
    static uint8_t few[PIXELS];
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    make_edges(1);
    start(&fxl_palette_depth_16, true);
    draw(&pose, few);
    for (uint32_t i = 0; i < 42; i++) {
        many[i] = tiny->faces[i < 36 ? i % 6 : i - 30];
    }
    tiny->models[0].face_count = tiny->models[1].first_face = 36;
    tiny->scene.faces = many;
    tiny->scene.face_count = 42;
    for (uint32_t i = 0; i < EDGES; i++) {
        lines[i].faces[1] = (uint16_t)(lines[i].faces[1] + 30);
    }
    start(&fxl_palette_depth_16, true);
    draw(&pose, frame);
    TEST_ASSERT_EQUAL_MEMORY(few, frame, sizeof frame);
    TEST_ASSERT_TRUE(attached.counters.backfacing > 0 && attached.counters.drawn > 0);
}

/* Planes of four faces are kept. Two points on copies of the line's faces, before the line or after it: before it
 * the plane of its second face takes the place of the oldest, which is that of its first. */
/* lines 3.2a */
void test_a_face_does_not_take_the_place_of_the_lines_other(void)
{
    static uint64_t kept[sizeof cells / sizeof cells[0]];
    const fxl_pose pose = {{Q16(1), Q16(2), Q16(-5)}, 0, 0, 0};
    uint32_t drawn = 0;
    for (uint32_t edge = 0; edge < EDGES; edge++) {
        static fxl_face many[24];
        make_edges(3);
        for (uint32_t i = 0; i < 24; i++) {
            many[i] = tiny->faces[i < 18 ? i % 6 : i - 12];
        }
        tiny->models[0].face_count = tiny->models[1].first_face = 18;
        tiny->scene.faces = many;
        tiny->scene.face_count = 24;
        for (uint16_t i = 0; i < 2; i++) {
            fxl_line line = lines[edge], point = {line.from, line.from, {0, 0}, LINE, 1, 0};
            const uint16_t a = line.faces[0], b = line.faces[1];
            line.faces[1] = (uint16_t)(b + 12);
            for (uint16_t k = 0; k < 2; k++) {
                point.faces[0] = (uint16_t)(a + 6 * k);
                point.faces[1] = (uint16_t)(b + 6 * k);
                lines[EDGES + k + i] = point;
            }
            lines[i == 0 ? EDGES + 2 : EDGES] = line;
            set.lines = lines + EDGES;
            set.count = line_map[1] = line_map[2] = 3;
            memset(cells, 0, sizeof cells);
            start(&fxl_palette_depth_16, true);
            draw(&pose, frame);
            if (i == 0) {
                memcpy(kept, cells, sizeof cells);
            }
        }
        TEST_ASSERT_EQUAL_MEMORY(kept, cells, sizeof cells);
        drawn += attached.counters.drawn;
    }
    TEST_ASSERT_TRUE(drawn > 9);
}
