/* SPDX-License-Identifier: MIT */
/* The places of textured segments: the kernel against its definition in double. */
#include "segment_unit.h"
#include "paint/plain_rows.h"

void setUp(void)
{
    segment_begin();
}

/* The worst distance of what the kernel painted: i is 0 for columns of texels, 1 for rows. */
static void check_coordinate(uint32_t i, uint32_t log_width, uint32_t log_height, int columns)
{
    const uint32_t log = log_width > log_height ? log_width : log_height;
    for (uint32_t n = 0; n < 1u << (log_width + log_height); n++) {
        segment.texels[n] = (uint8_t)(i == 0 ? n & ((1u << log_width) - 1u) : n >> log_width);
    }
    segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
    for (int x = 0; x < SEGMENT_COLUMNS; x++) {
        /* 1 of the position and 1/2 of 15 steps; 2 that v carries over; 1 for both ends. */
        const double most = ldexp(4 + (columns - 1) / 2.0, -16 + (int)(i == 0 ? log_width : log));
        const double off = segment_distance(segment_on_line(i, x, columns), segment.pixels[x],
                                            i == 0 ? log_width : log_height);
        TEST_ASSERT_TRUE(off <= most);
    }
}

/* SPEC 9.2c */
void test_texels_are_on_the_line_between_both_ends(void)
{
    for (uint32_t log_width = 4; log_width <= 8; log_width++) {
        for (uint32_t log_height = 0; log_width + log_height <= 10 && log_height <= 8;
             log_height++) {
            for (uint32_t n = 0; n < 4; n++) {
                segment_choose_face();
                segment_choose_size(log_width, log_height);
                TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
                for (uint32_t log = 0; log <= 4; log += log == 0 ? 2 : 1) {
                    segment_choose_log(log);
                    check_coordinate(0, log_width, log_height, 1 << log);
                    check_coordinate(1, log_width, log_height, 1 << log);
                }
            }
        }
    }
}

/* Its leading zeros are at most the drop and 32: below that the kernel would shift to the left. A row of
 * one weight keeps FXL_ROW_BITS bits more, and its least weight is also that of each length of segments, by
 * which clamped texels are painted. */
void test_the_least_weight_that_a_face_takes(void)
{
    segment_choose_size(5, 5);
    for (int i = 0; i < 2 * 80; i++) {
        const int shift = i / 2, is_line = i % 2;
        const int drop = 46 - (shift > 24 ? shift : 24) - (20 - 5) - (is_line ? FXL_ROW_BITS : 0);
        int32_t least = 2;
        int zeros = 30;
        segment.gradients.weight.along = !is_line;
        segment.gradients.shifts[0] = (int8_t)shift;
        segment.gradients.shifts[1] = 24;
        for (; zeros > 0 && zeros > drop + 32; zeros--) {
            least = zeros > 1 ? 2 * least : INT32_MAX;
        }
        memset(segment.face.least, 0xFF, sizeof segment.face.least);
        TEST_ASSERT_EQUAL(least != INT32_MAX, fxl_segments_find(&segment.paint, &segment.face));
        for (uint32_t k = 0; k < 4; k++) {
            TEST_ASSERT_EQUAL_UINT32(least, segment.face.least[k]);
        }
    }
}

/* surfaces 2.2a */
void test_a_pixel_does_not_depend_on_where_a_row_begins(void)
{
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 300; n++) {
        const int32_t x0 = (int32_t)(segment_any() % SEGMENT_COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(segment_any() % (uint32_t)(SEGMENT_COLUMNS - x0));
        segment_choose_face();
        segment.paint.ramp = NULL;
        if (n & 1u) {
            segment.paint.ramp = segment.ramp;
            segment.paint.levels_less_1 = SEGMENT_LEVELS - 1;
            segment.gradients.count = 3;
            segment.gradients.shifts[2] = 24;
            segment_choose_gradient(&segment.gradients.attributes[2], &segment.row.attributes[2],
                                    segment_any() % 10000000u, segment_any() % 10000000u);
        }
        for (uint32_t i = 0; i < sizeof segment.ramp; i++) {
            segment.ramp[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
        }
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
        segment_paint_row(segment.part, x0, x1);
        for (int32_t x = 0; x < SEGMENT_COLUMNS; x++) {
            TEST_ASSERT_EQUAL(x >= x0 && x < x1 ? segment.pixels[x] : SEGMENT_UNTOUCHED,
                              segment.part[x]);
        }
    }
}

/* Weights, from the least to the largest, constant ones too, with drops that fit them. A texture of
 * one row has as many texels as the sanitizers let the kernel read. */
void test_every_weight_reads_texels_of_the_texture_alone(void)
{
    uint32_t taken = 0;
    segment_choose_size(8, 2);
    for (uint32_t bits = 1; bits < 30; bits++) {
        for (uint32_t n = 0; n < 20; n++) {
            const double from = ldexp(1, (int)bits) + n % 2,
                         to = n % 4 == 3 ? from : ldexp(1, 1 + (int)(segment_any() % 29u));
            segment_choose_gradient(&segment.gradients.weight, &segment.row.weight, from, to);
            for (uint32_t i = 0; i < 2; i++) {
                segment.gradients.shifts[i] = (int8_t)((int32_t)(segment_any() % 130u) - 40);
                segment_choose_gradient(&segment.gradients.attributes[i],
                                        &segment.row.attributes[i],
                                        (int32_t)segment_any() / 4 >> segment_any() % 28u,
                                        (int32_t)segment_any() / 4 >> segment_any() % 28u);
            }
            const bool found = fxl_segments_find(&segment.paint, &segment.face);
            if (found && fxl_segments_suffice(&segment.face, &segment.row, 0, SEGMENT_COLUMNS)) {
                segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
                taken++;
            }
            fxl_paint_row any_row = segment.row;
            any_row.pixels = segment.part;
            any_row.segments = found ? &segment.face : NULL;
            fxl_paint_pixels(&segment.paint, &any_row, 0, SEGMENT_COLUMNS);
        }
    }
    TEST_ASSERT_GREATER_THAN(50, taken);
}

/* A row has the segments that the weights at the ends of each 16 columns allow: the pixels of 16
 * columns are those that a face with such segments alone has there. */
/* surfaces 2.1, SPEC 9.2a-b, 9.2f-g */
void test_each_16_columns_have_segments_of_their_own(void)
{
    uint32_t times[5] = {0};
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 200; n++) {
        segment_choose_face();
        segment_choose_gradient(&segment.gradients.weight, &segment.row.weight,
                                n & 1u ? 1 << 26 : 1 << 29, n & 1u ? 1 << 29 : 1 << 26);
        segment.gradients.weight_min[0] = (100u + segment_any() % 300u) << 20;
        segment.gradients.weight_min[1] = segment.gradients.weight_min[0] * 2u / 5u;
        segment.paint.division = n % 3 == 0 ? FXL_DIVIDE_8 : FXL_DIVIDE_16;
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        TEST_ASSERT_TRUE(fxl_segments_suffice(&segment.face, &segment.row, 0, SEGMENT_COLUMNS));
        uint32_t least[3];
        fxl_find_least_weights(&segment.gradients, segment.paint.division, least);
        segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
        for (int32_t x = 0; x < SEGMENT_COLUMNS; x += 16) {
            const uint32_t log =
                fxl_segment_log(least, (uint32_t)segment_exact(&segment.gradients.weight, x),
                                (uint32_t)segment_exact(&segment.gradients.weight, x + 16));
            segment_choose_log(log);
            segment_paint_row(segment.part, x, x + 16);
            TEST_ASSERT_EQUAL_MEMORY(segment.pixels + x, segment.part + x, 16);
            times[log]++;
        }
    }
    TEST_ASSERT_TRUE(times[0] > 50 && times[2] > 50 && times[3] > 50 && times[4] > 50);
}

/* Where no segment suffices, pixels are divided: those of fxl_paint_pixels without a kernel. */
void test_divided_pixels_are_as_without_a_kernel(void)
{
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(segment_any() % SEGMENT_UNTOUCHED);
    }
    for (uint32_t n = 0; n < 100; n++) {
        segment_choose_face();
        segment.gradients.weight_min[0] = segment.gradients.weight_min[1] = UINT32_MAX;
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        segment_paint_row(segment.pixels, (int32_t)(n % 7), SEGMENT_COLUMNS);
        segment.row.segments = NULL;
        segment.row.pixels = segment.part;
        memset(segment.part, SEGMENT_UNTOUCHED, sizeof segment.part);
        fxl_paint_pixels(&segment.paint, &segment.row, (int32_t)(n % 7), SEGMENT_COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(segment.pixels, segment.part, SEGMENT_COLUMNS);
    }
}

/* A chord is off by at most 0.3 of a unit from the exact value, and by 0.075 with
 * FXL_DIVIDE_8, whatever the face. */
/* surfaces 2.1, SPEC 9.2f-g, accuracy 5.2a, 5.2c */
void test_the_rule_bounds_the_error_of_a_chord(void)
{
    static const int32_t sizes[] = {16, 8, 4};
    uint32_t taken = 0, close = 0;
    for (uint32_t n = 0; n < 4000; n++) {
        segment_choose_face();
        for (uint32_t i = 0; i < 2; i++) {
            segment.gradients.attributes[i].at = segment.row.attributes[i];
        }
        const double slope = ldexp((double)segment.gradients.weight.along, -32);
        double twist = 0;
        for (uint32_t i = 0; i < 2; i++) {
            const fxl_gradient *u = &segment.gradients.attributes[i];
            twist = fmax(twist, fabs(ldexp((double)u->along, -32) *
                                         segment_exact(&segment.gradients.weight, 0) -
                                     slope * segment_exact(u, 0)) *
                                    ldexp(1, segment.gradients.shifts[i]));
        }
        segment.gradients.weight_min[0] =
            (uint32_t)fmin(ceil(cbrt(twist * fabs(slope) * 27 / 8192)), 2147483648.0);
        segment.gradients.weight_min[1] =
            (uint32_t)fmin(ceil(cbrt(twist * fabs(slope) * 27 / 131072)), 2147483648.0);
        const uint32_t division = n & 1u ? FXL_DIVIDE_8 : FXL_DIVIDE_16;
        const double most = n & 1u ? 0.075 : 0.3;
        uint32_t least[3];
        fxl_find_least_weights(&segment.gradients, division, least);
        for (int x = 0; x < SEGMENT_COLUMNS; x++) {
            const int first = x & ~15;
            const uint32_t log =
                fxl_segment_log(least, (uint32_t)segment_exact(&segment.gradients.weight, first),
                                (uint32_t)segment_exact(&segment.gradients.weight, first + 16));
            for (uint32_t i = 0; log != 0 && i < 2; i++) {
                const double off =
                    fabs(segment_on_line(i, x, sizes[4 - log]) - segment_divided(i, x));
                TEST_ASSERT_TRUE(off <= most + 1e-6);
                taken++;
                close += off > most / 2;
            }
        }
    }
    TEST_ASSERT_TRUE(taken > 10000 && close > 100);
}

/* Weights below the least one, which no face has: pixels are any texels, or stay as they are, as by
 * the kernels of Armv7-M. */
void test_weights_that_are_too_small_are_safe(void)
{
    segment_choose_size(5, 5);
    for (uint32_t i = 0; i < SEGMENT_TEXELS; i++) {
        segment.texels[i] = (uint8_t)(100u + segment_any() % 50u);
    }
    for (uint32_t n = 0; n < 100; n++) {
        segment_choose_face();
        TEST_ASSERT_TRUE(fxl_segments_find(&segment.paint, &segment.face));
        segment.face.u_drop = segment.face.v_drop = -20;
        segment_choose_gradient(&segment.gradients.weight, &segment.row.weight,
                                1 + segment_any() % 64u, 1 + segment_any() % 64u);
        segment.face.weight_step = segment.gradients.weight.along * 16;
        segment_paint_row(segment.pixels, 0, SEGMENT_COLUMNS);
        for (uint32_t x = 0; x < SEGMENT_COLUMNS; x++) {
            const uint8_t pixel = segment.pixels[x];
            TEST_ASSERT_TRUE((pixel >= 100 && pixel < 150) || pixel == SEGMENT_UNTOUCHED);
        }
    }
}

/* The rows of a trapezoid that a kernel paints, and the faces that it takes. */

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
/* surfaces 2.2b, 2.2d */
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
