/* SPDX-License-Identifier: MIT */
/* The rows of a trapezoid that a kernel paints, and the faces that it takes. */
#include "paint/plain_rows.h"
#include "segment_unit.h"

void setUp(void)
{
    segment_begin();
}

void tearDown(void)
{
}

enum {
    ROWS = 24
};

/* A trapezoid of a face whose weight is at least what the kernel takes, or not in all rows. */
static void choose_rows(fxl_plain_rows *rows)
{
    memset(rows, 0, sizeof *rows);
    rows->row = segment.row;
    rows->row.segments = &segment.face;
    rows->end_row = ROWS;
    rows->stride = SEGMENT_COLUMNS;
    rows->downs[0] = (int64_t)ldexp((int)(segment_any() % 4000000u) - 2000000, 32);
    rows->downs[1] = (int64_t)ldexp((int)(segment_any() % 4000000u) - 2000000, 32);
    rows->downs[2] = (int64_t)ldexp((int)(segment_any() % 4000000u) - 2000000, 32);
    for (uint32_t i = 0; i < 2; i++) {
        rows->edges[i].x = (int32_t)(40u + segment_any() % 48u);
        rows->edges[i].step = (int32_t)(segment_any() % 2u) - 1;
        rows->edges[i].step_fraction = segment_any();
    }
}

/* Paints a trapezoid: rows that are not the kernel's go to fxl_paint_pixels. first, end: of the
 * rows that a band has; from, to: the columns that a clipper leaves. */
static uint32_t paint_trapezoid(const fxl_plain_rows *whole, uint8_t pixels[ROWS][SEGMENT_COLUMNS],
                                int32_t first, int32_t end, int32_t from, int32_t to)
{
    fxl_plain_rows rows = *whole;
    uint32_t left = 0;
    rows.row.pixels = pixels[0];
    while (rows.row.y < first) {
        fxl_plain_rows_next(&rows);
    }
    rows.end_row = end;
    if (from > 0 || to < SEGMENT_COLUMNS) {
        rows.edges[0].x = from;
        rows.edges[1].x = to;
        rows.edges[0].step = rows.edges[1].step = 0;
        rows.edges[0].step_fraction = rows.edges[1].step_fraction = 0;
    }
    while (rows.row.y < end && fxl_paint_rows(&rows)) {
        int32_t x0, x1;
        fxl_plain_rows_columns(&rows, &x0, &x1);
        fxl_paint_pixels(&segment.paint, &rows.row, x0, x1);
        fxl_plain_rows_next(&rows);
        left++;
    }
    return left;
}

/* Neither the band nor what is cut off a face changes a pixel. */
/* surfaces 2.2 */
void test_bands_and_clips_change_no_pixel(void)
{
    static uint8_t all[ROWS][SEGMENT_COLUMNS], parts[ROWS][SEGMENT_COLUMNS];
    uint32_t left = 0, painted = 0;
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 200; n++) {
        fxl_plain_rows rows;
        const int32_t middle = 1 + (int32_t)(segment_any() % (ROWS - 1));
        const int32_t from = (int32_t)(segment_any() % 60u),
                      to = from + 1 + (int32_t)(segment_any() % 60u);
        segment_choose_face();
        segment.gradients.weight_min[0] = (60u + segment_any() % 300u) << 20;
        segment.gradients.weight_min[1] = segment.gradients.weight_min[0] * 2u / 5u;
        segment.gradients.shifts[0] = segment.gradients.shifts[1] = (int8_t)(n % 4 == 0 ? 60 : 24);
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        choose_rows(&rows);
        memset(all, SEGMENT_UNTOUCHED, sizeof all);
        memset(parts, SEGMENT_UNTOUCHED, sizeof parts);
        left += paint_trapezoid(&rows, all, 0, ROWS, 0, SEGMENT_COLUMNS);
        (void)paint_trapezoid(&rows, parts, 0, middle, 0, SEGMENT_COLUMNS);
        (void)paint_trapezoid(&rows, parts, middle, ROWS, 0, SEGMENT_COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(all, parts, sizeof all);
        memset(parts, SEGMENT_UNTOUCHED, sizeof parts);
        (void)paint_trapezoid(&rows, parts, middle / 2, ROWS, from, to);
        for (uint32_t i = 0; i < ROWS * SEGMENT_COLUMNS; i++) {
            const uint8_t one = all[i / SEGMENT_COLUMNS][i % SEGMENT_COLUMNS];
            const uint8_t other = parts[i / SEGMENT_COLUMNS][i % SEGMENT_COLUMNS];
            if (one != SEGMENT_UNTOUCHED && other != SEGMENT_UNTOUCHED) {
                TEST_ASSERT_EQUAL_UINT8(one, other);
                painted++;
            }
        }
    }
    TEST_ASSERT_TRUE(left > 20 && painted > 10000);
}

static void check_refused(bool expected)
{
    TEST_ASSERT_EQUAL(expected, !fxl_segments_find(&segment.paint, &segment.face));
    segment_begin();
    segment_choose_size(4, 4);
}

void test_other_faces_are_not_the_kernels(void)
{
    static const uint8_t colours[16];
    segment_choose_size(4, 4);
    check_refused(false);
    segment_choose_size(3, 4);
    check_refused(true);
    segment.paint.level.texels = NULL;
    check_refused(true);
    segment.paint.level.colours = colours;
    check_refused(false);
    segment.paint.level.flags = FXL_TEXTURE_CLAMP;
    check_refused(true);
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(false);
    segment.paint.opacity = 15;
    check_refused(false);
    segment.paint.opacity = 15;
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(true);
    segment.paint.level.colours = colours;
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(true);
    segment.paint.opacity = 15;
    segment.paint.table = colours;
    check_refused(false);
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    segment.paint.in_beam = colours;
    check_refused(true);
    segment.paint.level.flags = FXL_TEXTURE_KEYED;
    segment.paint.has_beams = true;
    check_refused(true);
    segment.paint.blend = colours;
    check_refused(true);
    segment.paint.division = FXL_DIVIDE_8;
    check_refused(false);
    segment.paint.division = FXL_DIVIDE_1; /* paint_divided.h */
    check_refused(true);
    segment.gradients.weight_min[0] = UINT32_MAX;
    check_refused(false);
}

/* Clamped textures with light at the corners; in RGB565, attributes of too many bits. */
void test_what_segments_do_not_take(void)
{
    segment_choose_size(5, 5);
    segment_choose_face();
    segment.paint.level.flags = FXL_TEXTURE_CLAMP;
    TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
    segment.gradients.count = 3;
    segment.gradients.shifts[2] = 24;
    segment.paint.ramp = segment.ramp;
    TEST_ASSERT_FALSE(fxl_segments_find(&segment.paint, &segment.face));
    segment.gradients.count = 2;
    segment.paint.ramp = NULL;
    segment.paint.level.flags = 0;
    TEST_ASSERT_TRUE(fxl_segments_find_565(&segment.paint, &segment.face));
    segment.gradients.shifts[0] = segment.gradients.shifts[1] = 79;
    TEST_ASSERT_FALSE(fxl_segments_find_565(&segment.paint, &segment.face));
}
