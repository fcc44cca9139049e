/* SPDX-License-Identifier: MIT */
/* The depth of one pixel that is found without a plane, against that of the plane. */
#include <math.h>

#include "draw/depth_pixel.h"
#include "draw/depth_plane.h"
#include "math/pixel_centre.h"
#include "unit.h"
#include "view/project.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 4 /* of a band */
};

static struct {
    FXL_ALIGN_8 fxl_depth_head head;
    uint16_t cells[WIDTH * ROWS];
} memory;

static uint16_t pixels[WIDTH * ROWS];
static fxl_view view;
static fxl_workspace workspace;
static fxl_cached_vertex vertex;
static fxl_orientation axes;

/* A vertex at most so many 2^-16 pixels from the centre of a pixel, at any distance. */
static void make_vertex(int32_t column, int32_t row, int32_t most)
{
    const double x = fxl_centre_of(column) + unit_between(-most, most) - view.projection.centre_x,
                 y = view.projection.centre_y - fxl_centre_of(row) + unit_between(-most, most);
    const int64_t z = (int64_t)(view.lens.near_z + unit_between(1, view.lens.far_z - 1)) << 30 |
                      unit_random() >> 2;
    vertex.position.x = (int64_t)(x / fxl_view_drawn_focal(&view) * (double)z);
    vertex.position.y = (int64_t)(y / fxl_view_drawn_focal(&view) * (double)z);
    vertex.position.z = z;
}

/* Most faces' codes are known, and those are the codes of their planes. */
/* SPEC 10.2, 10.3 */
void test_the_code_of_one_pixel_is_that_of_the_plane(void)
{
    const fxl_model_view model_view = {
        .view = &view, .entries = &vertex, .mask = 0, .tag = 1, .axes = (const fxl_axes *)&axes};
    fxl_band band = {.rows = ROWS, .width = WIDTH, .stride = WIDTH};
    band.pixels = (uint8_t *)pixels;
    const fxl_traversal traversal = {.workspace = &workspace, .band = &band};
    fxl_face face = {.count = 3, .indices = {0, 1, 2}};
    uint32_t faces = 0, known = 0, visible = 0;
    workspace.target_memory = &memory;
    for (int i = 0; i < 40 * UNIT_REPEAT; i++) {
        fxl_tiny box = {.columns = unit_between(1, 8), .rows = unit_between(1, ROWS)};
        const int32_t x = unit_between(0, box.columns - 1), y = unit_between(0, box.rows - 1);
        fxl_lens lens = unit_lens(WIDTH, HEIGHT);
        lens.near_z = unit_between(64, 1 << unit_between(7, 24));
        lens.far_z = lens.near_z << unit_between(1, 6);
        fxl_view_set_lens(&view, &lens);
        view.projection.factor = (uint32_t)(unit_between(1 << 22, 1 << 27) >> unit_between(0, 2)) << 2;
        memory.head.scale = fxl_depth_scale_of(&lens);
        axes = unit_orientation();
        face.normal = unit_direction();
        box.column = unit_between(0, WIDTH - 8);
        box.row = unit_between(0, HEIGHT - ROWS);
        band.first_row = (uint16_t)box.row;
        box.pixels = 1u << 31 >> (y * box.columns + x);
        const int32_t column = box.column + x, row = box.row + y;
        make_vertex(column, row, unit_between(0, 1) ? 1 << 16 : 9 << 16);
        vertex.tag = model_view.tag;
        if (vertex.position.z < FXL_PROJECT_DEPTH_MIN ||
            fxl_project_any(&view.projection, &vertex.position, &workspace.screen.points[0]) != FXL_OK) {
            continue;
        }
        fxl_depth_plane plane;
        fxl_find_depth_plane(&face.normal, model_view.axes, &vertex.position, &view, &plane);
        const fxl_gradient *of = &plane.gradient;
        const uint32_t code =
            fxl_depth_code_at(memory.head.scale, &plane, of->at + row * of->down, column) >> 16;
        const uint32_t bytes = (uint32_t)unit_between(1, 2), place = (uint32_t)(y * WIDTH + column);
        const uint16_t before = (uint16_t)(unit_between(0, 2) ? 0 : code);
        memory.cells[place] = before;
        pixels[place] = 0;
        ((uint8_t *)pixels)[place] = 0;
        const bool is_known =
            fxl_depth_draw_pixel(&model_view, &face, &traversal, &box, 0x5A5A, bytes);
        TEST_ASSERT_EQUAL_INT32(column, box.column);
        TEST_ASSERT_EQUAL_INT32(row, box.row);
        TEST_ASSERT_TRUE(box.columns == 1 && box.rows == 1 && box.pixels == 1u << 31);
        TEST_ASSERT_EQUAL_UINT16(is_known ? code : before, memory.cells[place]);
        const bool is_drawn = is_known && code > before;
        TEST_ASSERT_EQUAL(is_drawn, bytes == 2 ? pixels[place] == 0x5A5A
                                               : ((uint8_t *)pixels)[place] == 0x5A);
        faces += of->at > 0;
        known += is_known;
        visible += is_drawn;
    }
    TEST_ASSERT_TRUE(known > faces / 4 && visible > faces / 8);
}
