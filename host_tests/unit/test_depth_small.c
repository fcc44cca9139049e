/* SPDX-License-Identifier: MIT */
/* The codes of small faces: by the pixels of a box, where a code has one octave, and each of its own octave. */
#include <math.h>

#include "depth_scene.h"
#include "paint/depth_code.h"
#include "paint/depth_outline.h"
#include "view/view.h"

/* A triangle of few pixels: each is tested and kept by the code of its column and row, and none beside
 * them is touched; where codes have several octaves, nothing is. */
/* SPEC 10.3, 10.4b */
void test_a_tiny_triangle_keeps_the_codes_of_its_pixels(void)
{
    enum {
        WIDTH = 12,
        ROWS = 10,
        FIRST_ROW = 3
    };
    static struct {
        fxl_depth_head head;
        uint16_t cells[WIDTH * ROWS];
    } memory;
    static uint16_t wanted[WIDTH * ROWS], pixels[WIDTH * ROWS], painted[WIDTH * ROWS];
    uint32_t drawn = 0, hidden = 0, others = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int32_t columns = unit_between(1, 8), most = 32 / columns;
        const int32_t rows = unit_between(1, most < 8 ? most : 8), centres = columns * rows;
        const fxl_tiny tiny = {unit_between(0, WIDTH - columns),
                               FIRST_ROW + unit_between(0, ROWS - rows), columns, rows,
                               (unit_random() | 1u << 31) & UINT32_MAX << (32 - centres)};
        const uint32_t bits = unit_random() % 2 ? 16 : 8;
        const fxl_band band = {.pixels = (uint8_t *)pixels,
                               .width = WIDTH,
                               .stride = WIDTH,
                               .first_row = FIRST_ROW,
                               .rows = ROWS};
        const fxl_depth_scale scale = {(uint8_t)unit_between(1, 24), (uint8_t)unit_between(11, 15)};
        /* steps of 1/8 to 1/1024 of the value in the corner */
        const int32_t top = unit_between(42, 59);
        const int64_t unit = (int64_t)1 << (top - 31 - unit_between(3, 10));
        const fxl_depth_plane plane = {{(int64_t)1 << top | (int64_t)unit_random() << (top - 32),
                                        (int32_t)unit_random() * unit,
                                        (int32_t)unit_random() * unit},
                                       top + unit_between(0, 12)};
        bool is_one_octave = true;
        int32_t length = 0;
        memory.head.scale = scale;
        for (uint32_t k = 0; k < WIDTH * ROWS; k++) {
            memory.cells[k] = wanted[k] = (uint16_t)unit_random();
            pixels[k] = painted[k] = 0;
        }
        for (int32_t k = 0; k < centres; k++) {
            const int32_t x = tiny.column + k % columns, y = tiny.row + k / columns;
            const int64_t row = plane.gradient.at + plane.gradient.down * y;
            const int64_t value = row + plane.gradient.along * x;
            const int32_t here = value >> 32 > 0 ? (int32_t)fxl_bit_length((uint64_t)value) : -1;
            const size_t place = (size_t)(y - FIRST_ROW) * WIDTH + (size_t)x;
            const uint32_t code = fxl_depth_code_at(scale, &plane, row, x);
            is_one_octave = is_one_octave && here > 0 && (length == 0 || here == length);
            length = here;
            if ((tiny.pixels << k >> 31) == 0) {
                continue;
            }
            if (code >> 16 > wanted[place]) {
                wanted[place] = (uint16_t)(code >> 16);
                if (bits == 16) {
                    painted[place] = 0xA5C3u;
                } else {
                    ((uint8_t *)painted)[place] = 0xC3u;
                }
            } else {
                hidden++;
            }
        }
        if (!fxl_depth_tiny_draw(&plane, &tiny, &memory.head, &band, 0xA5C3u, bits)) {
            for (uint32_t k = 0; k < WIDTH * ROWS; k++) {
                TEST_ASSERT_EQUAL_HEX16(0, pixels[k]);
            }
            others++;
            continue;
        }
        TEST_ASSERT_TRUE(is_one_octave);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(wanted, memory.cells, WIDTH * ROWS);
        TEST_ASSERT_EQUAL_HEX16_ARRAY(painted, pixels, WIDTH * ROWS);
        drawn++;
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 8, drawn);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 8, hidden);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 8, others);
}

/* A small triangle alone, whose pixels are those that it shows; its codes. */
static depth_scene *draw_triangle(const fxl_point *corners, fxl_q16_16 eye_z, fxl_q16_16 near_z,
                                  uint16_t width)
{
    static const fxl_model model = {
        .vertex_count = 3, .face_count = 1, .kind = FXL_MODEL_CONVEX, .radius = FXL_RADIUS_MAX};
    static const fxl_instance instance = {{0, 0, 0}, 0, 0, 0};
    static fxl_face face;
    fxl_plane plane;
    depth_scene *made = depth_scene_make();
    const fxl_pose ahead = {{0, 0, eye_z}, 0, 0, 0};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_plane_from_points(&corners[0], &corners[1], &corners[2], &plane));
    face = (fxl_face){plane.normal, 3, 10, {0, 1, 2}};
    made->scene.vertices = corners;
    made->scene.faces = &face;
    made->scene.models = &model;
    made->scene.instances = &instance;
    made->scene.vertex_count = made->scene.index_count = 3;
    made->scene.face_count = made->scene.model_count = made->scene.instance_count = 1;
    made->config.width = width;
    made->config.near_z = near_z;
    made->config.far_z = FXL_FAR_MAX;
    depth_scene_start_with(made, &fxl_palette_depth_16);
    made->renderer.frame.display_list.capacity = 0;
    const fxl_band band = UNIT_BAND(made->frame, width, 0, DEPTH_SCENE_HEIGHT);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&made->renderer, &ahead));
    fxl_frame_fill(&made->renderer, &band, DEPTH_SCENE_BACKGROUND);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_draw(&made->renderer, &band));
    return made;
}

static uint16_t code_at(const depth_scene *made, uint32_t pixel)
{
    return ((const uint16_t *)(const void *)(made->cells + FXL_DEPTH_BYTES(1, 0, 16)))[pixel];
}

/* What is as near as the near plane has the largest code. */
/* SPEC 10.3 */
void test_a_small_face_at_the_near_plane(void)
{
    static const fxl_point corners[] = {{-200, -250, 4096}, {0, 260, 4096}, {250, -200, 4096}};
    const depth_scene *made = draw_triangle(corners, 0, 4096, 32); /* of 16 pixels' focal length */
    uint32_t shown = 0;
    for (uint32_t i = 0; i < 32 * DEPTH_SCENE_HEIGHT; i++) {
        if (made->frame[i] == 10) {
            TEST_ASSERT_EQUAL(UINT16_MAX, code_at(made, i));
            shown++;
        }
    }
    TEST_ASSERT_GREATER_THAN(1, shown);
}

/* From 1/4 unit before the eye to 16,000 units: a triangle of few pixels, the first of whose rows of
 * pixels is 1/65536 pixel below its farthest edge. */
/* SPEC 10.2b-c, 10.3b */
void test_a_small_face_that_reaches_far_away(void)
{
    const int32_t z = Q16(16000), y = (int32_t)((0.5 + 1.0 / 65536) / 24 * z), x = z / 26;
    const fxl_q16_16 eye_z = -Q16(8190);
    const fxl_point corners[] = {{200, -920, eye_z + 16384}, {-x, y, eye_z + z}, {x, y, eye_z + z}};
    const depth_scene *made = draw_triangle(corners, eye_z, FXL_NEAR_MIN, DEPTH_SCENE_WIDTH);
    const fxl_lens *lens = &made->renderer.frame.view.lens;
    const fxl_depth_scale scale = fxl_depth_scale_of(lens);
    const double top = 24.0 * y / z, bottom = 24.0 * corners[0].y / 16384;
    uint32_t shown = 0, far_off = 0;
    for (uint32_t i = 0; i < DEPTH_SCENE_WIDTH * DEPTH_SCENE_HEIGHT; i++) {
        if (made->frame[i] != 10) {
            continue;
        }
        const double row = DEPTH_SCENE_HEIGHT / 2.0 - 0.5 - (double)(i / DEPTH_SCENE_WIDTH);
        const double part = (row - bottom) / (top - bottom);
        const double depth = FXL_NEAR_MIN * ((1 - part) / 16384 + part / z);
        const int octave = -1 - ilogb(depth);
        const double code =
            (ldexp(depth, octave + 1) - 1 + scale.octaves - 1 - octave) * (1 << scale.mantissa) + 1;
        TEST_ASSERT_NEAR(code, code_at(made, i), 8);
        shown++;
        far_off += depth * 10000 * 256 < 1; /* beyond 10,000 units */
    }
    TEST_ASSERT_TRUE(shown >= 2 && far_off >= 1);
}
