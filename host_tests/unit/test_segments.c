/* SPDX-License-Identifier: MIT */
/* The kernel of textured segments against its definition in double, and the faces that it takes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "paint/plain_rows.h"
#include "paint/texel_place.h"
#include "unity.h"

enum {
    COLUMNS = 128,
    TEXELS = 1024,
    LEVELS = 3,
    UNTOUCHED = 255
};

static uint8_t texels[TEXELS], ramp[256 * LEVELS];
static uint8_t row_pixels[COLUMNS], part[COLUMNS];
static fxl_gradients gradients;
static fxl_paint paint;
static fxl_paint_row row;
static fxl_segment_face face;
static uint32_t state;

void setUp(void)
{
    state = 2463534242u;
    memset(&gradients, 0, sizeof gradients);
    memset(&paint, 0, sizeof paint);
    memset(&row, 0, sizeof row);
    gradients.count = 2;
    gradients.weight_min[0] = gradients.weight_min[1] = 1;
    paint.gradients = &gradients;
    paint.level.texels = texels;
    paint.opacity = 16;
}

void tearDown(void)
{
}

static uint32_t any(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static void choose_size(uint32_t log_width, uint32_t log_height)
{
    paint.level.log_width = (uint8_t)log_width;
    paint.level.columns_less_1 = (1u << log_width) - 1u;
    paint.level.rows_less_1 = (1u << log_height) - 1u;
}

/* A gradient from one value to another over the columns; the row's value is the first. */
static void choose_gradient(fxl_gradient *gradient, int64_t *at, double from, double to)
{
    gradient->at = *at = (int64_t)ldexp(from, 32);
    gradient->along = (int64_t)(ldexp(to - from, 32) / COLUMNS);
}

static double exact(const fxl_gradient *gradient, int column)
{
    return ldexp((double)(gradient->at + gradient->along * column), -32);
}

/* An attribute at the end of a segment: texels, or levels. */
static double divided(uint32_t attribute, int column)
{
    return ldexp(exact(&gradients.attributes[attribute], column) / exact(&gradients.weight, column),
                 gradients.shifts[attribute] - 16);
}

/* On the line between both ends of a pixel's segment of so many columns. */
static double on_line(uint32_t attribute, int x, int columns)
{
    const int first = x & -columns;
    const double from = divided(attribute, first), to = divided(attribute, first + columns);
    return from + (to - from) * (x - first) / columns;
}

/* Has the kernel take segments of 2^log columns; 0: divide each pixel. */
static void choose_log(uint32_t log)
{
    for (uint32_t i = 0; i < 3; i++) {
        face.least[i] = log != 0 && i >= 4 - log ? 2 : INT32_MAX;
    }
    face.least[3] = 2;
}

/* How far a coordinate is from texel number n of 2^log, which repeats. */
static double distance(double coordinate, uint32_t n, uint32_t log)
{
    const double size = ldexp(1, (int)log), from_middle = coordinate - n - 0.5;
    return fabs(from_middle - size * floor(from_middle / size + 0.5)) - 0.5;
}

/* A face whose weights are from 2^26 to 2^30, and whose coordinates are within 200 texels. */
static void choose_face(void)
{
    const double weights[2] = {67108864.0 + any() % 900000000u, 67108864.0 + any() % 900000000u};
    choose_gradient(&gradients.weight, &row.weight, weights[0], weights[1]);
    for (uint32_t i = 0; i < 2; i++) {
        const double from = (int)(any() % 400u) - 200 + (any() & 255u) / 256.0;
        const double to = from + (int)(any() % 161u) - 80;
        gradients.shifts[i] = 24;
        choose_gradient(&gradients.attributes[i], &row.attributes[i], from * weights[0] / 256,
                        to * weights[1] / 256);
    }
}

static void paint_row(uint8_t *pixels, int32_t x0, int32_t x1)
{
    memset(pixels, UNTOUCHED, COLUMNS);
    row.pixels = pixels;
    fxl_paint_segments(&face, &row, x0, x1);
}

/* The worst distance of what the kernel painted: i is 0 for columns of texels, 1 for rows. */
static void check_coordinate(uint32_t i, uint32_t log_width, uint32_t log_height, int columns)
{
    const uint32_t log = log_width > log_height ? log_width : log_height;
    for (uint32_t n = 0; n < 1u << (log_width + log_height); n++) {
        texels[n] = (uint8_t)(i == 0 ? n & ((1u << log_width) - 1u) : n >> log_width);
    }
    paint_row(row_pixels, 0, COLUMNS);
    for (int x = 0; x < COLUMNS; x++) {
        /* 1 of the position and 1/2 of 15 steps; 2 that v carries over; 1 for both ends. */
        const double most = ldexp(4 + (columns - 1) / 2.0, -16 + (int)(i == 0 ? log_width : log));
        const double off =
            distance(on_line(i, x, columns), row_pixels[x], i == 0 ? log_width : log_height);
        TEST_ASSERT_TRUE(off <= most);
    }
}

/* SPEC 9.2 */
void test_texels_are_on_the_line_between_both_ends(void)
{
    for (uint32_t log_width = 4; log_width <= 8; log_width++) {
        for (uint32_t log_height = 0; log_width + log_height <= 10 && log_height <= 8;
             log_height++) {
            for (uint32_t n = 0; n < 4; n++) {
                choose_face();
                choose_size(log_width, log_height);
                TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
                for (uint32_t log = 0; log <= 4; log += log == 0 ? 2 : 1) {
                    choose_log(log);
                    check_coordinate(0, log_width, log_height, 1 << log);
                    check_coordinate(1, log_width, log_height, 1 << log);
                }
            }
        }
    }
}

/* Its leading zeros are at most the drop and 32: below that the kernel would shift to the left. */
void test_the_least_weight_that_a_face_takes(void)
{
    choose_size(5, 5);
    gradients.weight.along = 1;
    for (int shift = 0; shift < 80; shift++) {
        const int drop = 46 - (shift > 24 ? shift : 24) - (20 - 5);
        int32_t least = 2;
        int zeros = 30;
        gradients.shifts[0] = (int8_t)shift;
        gradients.shifts[1] = 24;
        for (; zeros > 0 && zeros > drop + 32; zeros--) {
            least = zeros > 1 ? 2 * least : INT32_MAX;
        }
        TEST_ASSERT_EQUAL(least != INT32_MAX, fxl_segments_find(&paint, &face));
        TEST_ASSERT_EQUAL_UINT32(least, face.least[0]);
        TEST_ASSERT_EQUAL_UINT32(least, face.least[3]);
    }
}

/* surfaces 2.2 */
void test_a_pixel_does_not_depend_on_where_a_row_begins(void)
{
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 300; n++) {
        const int32_t x0 = (int32_t)(any() % COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(any() % (uint32_t)(COLUMNS - x0));
        choose_face();
        paint.ramp = NULL;
        if (n & 1u) {
            paint.ramp = ramp;
            paint.levels_less_1 = LEVELS - 1;
            gradients.count = 3;
            gradients.shifts[2] = 24;
            choose_gradient(&gradients.attributes[2], &row.attributes[2], any() % 10000000u,
                            any() % 10000000u);
        }
        for (uint32_t i = 0; i < sizeof ramp; i++) {
            ramp[i] = (uint8_t)(any() % UNTOUCHED);
        }
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        paint_row(row_pixels, 0, COLUMNS);
        paint_row(part, x0, x1);
        for (int32_t x = 0; x < COLUMNS; x++) {
            TEST_ASSERT_EQUAL(x >= x0 && x < x1 ? row_pixels[x] : UNTOUCHED, part[x]);
        }
    }
}

/* A step of light is off by less than a unit of 1/256 level. Beyond the levels it is limited. */
static void check_light(int columns)
{
    for (int x = 0; x < COLUMNS; x++) {
        const double light = on_line(2, x, columns);
        TEST_ASSERT_TRUE(row_pixels[x] < LEVELS);
        TEST_ASSERT_TRUE(light - row_pixels[x] > -1.0 / 15 || row_pixels[x] == 0);
        TEST_ASSERT_TRUE(light - row_pixels[x] < 1 + 1.0 / 15 || row_pixels[x] == LEVELS - 1);
    }
}

void test_light_is_on_the_line_between_both_ends(void)
{
    choose_size(4, 4);
    memset(texels, 7, sizeof texels);
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)((i & 255u) == 7 ? i >> 8 : UNTOUCHED);
    }
    paint.ramp = ramp;
    paint.levels_less_1 = LEVELS - 1;
    gradients.count = 3;
    for (uint32_t n = 0; n < 100; n++) {
        choose_face();
        gradients.shifts[2] = 20;
        choose_gradient(&gradients.attributes[2], &row.attributes[2],
                        exact(&gradients.weight, 0) * ((int)(any() % 1200u) - 100) / 5000,
                        exact(&gradients.weight, COLUMNS) * ((int)(any() % 1200u) - 100) / 5000);
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        for (uint32_t log = 2; log <= 4; log++) {
            choose_log(log);
            paint_row(row_pixels, 0, COLUMNS);
            check_light(1 << log);
        }
    }
}

/* What fxl_paint_pixels paints of a lit row are the kernel's pixels, wherever light is. */
void test_lit_rows_are_those_of_the_kernel(void)
{
    choose_size(4, 4);
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(any() % UNTOUCHED);
    }
    paint.ramp = ramp;
    paint.levels_less_1 = LEVELS - 1;
    gradients.count = 3;
    for (uint32_t n = 0; n < 400; n++) {
        choose_face();
        gradients.shifts[2] = 20;
        choose_gradient(&gradients.attributes[2], &row.attributes[2],
                        exact(&gradients.weight, 0) * ((int)(any() % 1200u) - 100) / 5000,
                        exact(&gradients.weight, COLUMNS) * ((int)(any() % 1200u) - 100) / 5000);
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        choose_log(2 + n % 3);
        paint_row(row_pixels, 0, COLUMNS);
        row.segments = &face;
        row.pixels = part;
        fxl_paint_pixels(&paint, &row, 0, COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(row_pixels, part, COLUMNS);
    }
}

/* Light far beyond the levels, whatever its numbers: no entry beyond the ramp is read, as the
 * sanitizers see, and every pixel is painted. */
void test_light_beyond_the_levels_is_limited(void)
{
    choose_size(4, 0);
    memset(texels, 0, sizeof texels);
    memset(ramp, 1, sizeof ramp);
    paint.ramp = ramp;
    gradients.count = 3;
    for (uint32_t n = 0; n < 500; n++) {
        choose_face();
        paint.levels_less_1 = (uint8_t)(n % LEVELS);
        gradients.shifts[2] = (int8_t)(n % 64);
        choose_gradient(&gradients.attributes[2], &row.attributes[2], (int32_t)any() / 4 >> n % 28,
                        (int32_t)any() / 4 >> n % 29);
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        if (fxl_segments_suffice(&face, &row, 0, COLUMNS)) {
            paint_row(row_pixels, 0, COLUMNS);
            for (int x = 0; x < COLUMNS; x++) {
                TEST_ASSERT_EQUAL(1, row_pixels[x]);
            }
        }
    }
}

/* Weights, from the least to the largest, with drops that fit them. A texture of one row has as
 * many texels as the sanitizers let the kernel read. */
void test_every_weight_reads_texels_of_the_texture_alone(void)
{
    uint32_t taken = 0;
    choose_size(8, 2);
    for (uint32_t bits = 1; bits < 30; bits++) {
        for (uint32_t n = 0; n < 20; n++) {
            const double from = ldexp(1, (int)bits) + n % 2, to = ldexp(1, 1 + (int)(any() % 29u));
            choose_gradient(&gradients.weight, &row.weight, from, to);
            for (uint32_t i = 0; i < 2; i++) {
                gradients.shifts[i] = (int8_t)(any() % 90u);
                choose_gradient(&gradients.attributes[i], &row.attributes[i],
                                (int32_t)any() / 4 >> any() % 28u,
                                (int32_t)any() / 4 >> any() % 28u);
            }
            const bool found = fxl_segments_find(&paint, &face);
            if (found && fxl_segments_suffice(&face, &row, 0, COLUMNS)) {
                paint_row(row_pixels, 0, COLUMNS);
                taken++;
            }
            fxl_paint_row any_row = row;
            any_row.pixels = part;
            any_row.segments = found ? &face : NULL;
            fxl_paint_pixels(&paint, &any_row, 0, COLUMNS);
        }
    }
    TEST_ASSERT_GREATER_THAN(50, taken);
}

/* A row has the segments that the weights at the ends of each 16 columns allow: the pixels of 16
 * columns are those that a face with such segments alone has there. */
/* SPEC 9.2, surfaces 2.1 */
void test_each_16_columns_have_segments_of_their_own(void)
{
    uint32_t times[5] = {0};
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 200; n++) {
        choose_face();
        choose_gradient(&gradients.weight, &row.weight, n & 1u ? 1 << 26 : 1 << 29,
                        n & 1u ? 1 << 29 : 1 << 26);
        gradients.weight_min[0] = (100u + any() % 300u) << 20;
        gradients.weight_min[1] = gradients.weight_min[0] * 2u / 5u;
        paint.division = n % 3 == 0 ? FXL_DIVIDE_8 : FXL_DIVIDE_16;
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        TEST_ASSERT_TRUE(fxl_segments_suffice(&face, &row, 0, COLUMNS));
        uint32_t least[3];
        fxl_find_least_weights(&gradients, paint.division, least);
        paint_row(row_pixels, 0, COLUMNS);
        for (int32_t x = 0; x < COLUMNS; x += 16) {
            const uint32_t log = fxl_segment_log(least, (uint32_t)exact(&gradients.weight, x),
                                                 (uint32_t)exact(&gradients.weight, x + 16));
            choose_log(log);
            paint_row(part, x, x + 16);
            TEST_ASSERT_EQUAL_MEMORY(row_pixels + x, part + x, 16);
            times[log]++;
        }
    }
    TEST_ASSERT_TRUE(times[0] > 50 && times[2] > 50 && times[3] > 50 && times[4] > 50);
}

/* The pixels of a kind of texels, where `plain` has those of the same texels of 8 bits, in light that
 * is the same everywhere or in none. */
static void check_kind_in_light(const uint8_t *plain, int32_t x0, const uint8_t *colours)
{
    TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
    TEST_ASSERT_NOT_EQUAL(FXL_TEXELS_PLAIN, face.kind);
    paint_row(row_pixels, x0, COLUMNS);
    for (int32_t x = 0; x < COLUMNS; x++) {
        const bool is_drawn =
            x >= x0 && (face.kind != FXL_TEXELS_KEYED || plain[x] != paint.level.key) &&
            (face.kind != FXL_TEXELS_STIPPLED || !fxl_is_stippled_away(paint.opacity, x, row.y));
        const uint8_t colour = colours != NULL && is_drawn ? colours[plain[x]] : plain[x];
        TEST_ASSERT_EQUAL(!is_drawn             ? UNTOUCHED
                          : paint.table != NULL ? paint.table[colour]
                                                : colour,
                          row_pixels[x]);
    }
}

static void check_kind(const uint8_t *plain, int32_t x0, const uint8_t *colours)
{
    static uint8_t table[256];
    for (uint32_t i = 0; i < sizeof table; i++) {
        table[i] = (uint8_t)(any() % UNTOUCHED);
    }
    check_kind_in_light(plain, x0, colours);
    paint.table = table;
    check_kind_in_light(plain, x0, colours);
    paint.table = NULL;
}

/* Texels that are keyed, stippled or of 4 bits are those that are plain, at every pixel. */
/* SPEC 9.5, surfaces 1.1, 1.3 */
void test_other_kinds_of_texels_are_at_the_places_of_plain_ones(void)
{
    static uint8_t packed[TEXELS / 2];
    uint8_t plain[COLUMNS], colours[16];
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % 16u);
        packed[i / 2] = (uint8_t)(packed[i / 2] >> 4 | texels[i] << 4);
    }
    for (uint32_t i = 0; i < 16; i++) {
        colours[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 100; n++) {
        const int32_t x0 = (int32_t)(any() % 20u);
        choose_face();
        choose_size(4 + n % 2, 5);
        row.y = (int32_t)(n % 7);
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        TEST_ASSERT_EQUAL(FXL_TEXELS_PLAIN, face.kind);
        paint_row(plain, x0, COLUMNS);
        paint.level.flags = FXL_TEXTURE_KEYED;
        paint.level.key = (uint8_t)(any() % 16u);
        check_kind(plain, x0, NULL);
        paint.level.flags = 0;
        paint.opacity = (uint8_t)(1u + n % 15u);
        check_kind(plain, x0, NULL);
        paint.opacity = 16;
        paint.level.texels = packed;
        paint.level.colours = colours;
        check_kind(plain, x0, colours);
        paint.level.texels = texels;
        paint.level.colours = NULL;
    }
}

/* Texels that do not repeat are those that fxl_paint_pixels shows without a kernel, to within what
 * both round: a texel beside it at most, and few of them. */
/* SPEC 9.5, surfaces 1.1 */
void test_clamped_texels_are_held_within_the_texture(void)
{
    uint32_t unlike = 0, beyond = 0;
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(i % 32u / 4u * 16u + i / 32u / 4u);
    }
    for (uint32_t n = 0; n < 300; n++) {
        const int32_t x0 = (int32_t)(any() % 20u);
        choose_face();
        paint.level.flags = FXL_TEXTURE_CLAMP;
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        TEST_ASSERT_EQUAL(FXL_TEXELS_CLAMPED, face.kind);
        paint_row(row_pixels, x0, COLUMNS);
        row.segments = NULL;
        row.pixels = part;
        memset(part, UNTOUCHED, sizeof part);
        fxl_paint_pixels(&paint, &row, x0, COLUMNS);
        TEST_ASSERT_EQUAL(0, memcmp(row_pixels, part, (size_t)x0));
        for (int32_t x = x0; x < COLUMNS; x++) {
            const int columns = abs((row_pixels[x] >> 4) - (part[x] >> 4));
            const int rows = abs((row_pixels[x] & 15) - (part[x] & 15));
            TEST_ASSERT_TRUE(columns <= 1 && rows <= 1);
            unlike += columns + rows > 0;
            beyond += part[x] == 0 || part[x] == 0x77;
        }
    }
    TEST_ASSERT_LESS_THAN(400, unlike);
    TEST_ASSERT_GREATER_THAN(5000, beyond);
}

/* Where no segment suffices, pixels are divided: those of fxl_paint_pixels without a kernel. */
void test_divided_pixels_are_as_without_a_kernel(void)
{
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 100; n++) {
        choose_face();
        gradients.weight_min[0] = gradients.weight_min[1] = UINT32_MAX;
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        paint_row(row_pixels, (int32_t)(n % 7), COLUMNS);
        row.segments = NULL;
        row.pixels = part;
        memset(part, UNTOUCHED, sizeof part);
        fxl_paint_pixels(&paint, &row, (int32_t)(n % 7), COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(row_pixels, part, COLUMNS);
    }
}

/* A chord is off by at most 0.3 of a unit from the exact value, and by 0.075 with
 * FXL_DIVIDE_8, whatever the face. */
/* SPEC 9.2, accuracy 5.2, surfaces 2.1 */
void test_the_rule_bounds_the_error_of_a_chord(void)
{
    static const int32_t sizes[] = {16, 8, 4};
    uint32_t taken = 0, close = 0;
    for (uint32_t n = 0; n < 4000; n++) {
        choose_face();
        for (uint32_t i = 0; i < 2; i++) {
            gradients.attributes[i].at = row.attributes[i];
        }
        const double slope = ldexp((double)gradients.weight.along, -32);
        double twist = 0;
        for (uint32_t i = 0; i < 2; i++) {
            const fxl_gradient *u = &gradients.attributes[i];
            twist = fmax(twist, fabs(ldexp((double)u->along, -32) * exact(&gradients.weight, 0) -
                                     slope * exact(u, 0)) *
                                    ldexp(1, gradients.shifts[i]));
        }
        gradients.weight_min[0] =
            (uint32_t)fmin(ceil(cbrt(twist * fabs(slope) * 27 / 8192)), 2147483648.0);
        gradients.weight_min[1] =
            (uint32_t)fmin(ceil(cbrt(twist * fabs(slope) * 27 / 131072)), 2147483648.0);
        const uint32_t division = n & 1u ? FXL_DIVIDE_8 : FXL_DIVIDE_16;
        const double most = n & 1u ? 0.075 : 0.3;
        uint32_t least[3];
        fxl_find_least_weights(&gradients, division, least);
        for (int x = 0; x < COLUMNS; x++) {
            const int first = x & ~15;
            const uint32_t log = fxl_segment_log(least, (uint32_t)exact(&gradients.weight, first),
                                                 (uint32_t)exact(&gradients.weight, first + 16));
            for (uint32_t i = 0; log != 0 && i < 2; i++) {
                const double off = fabs(on_line(i, x, sizes[4 - log]) - divided(i, x));
                TEST_ASSERT_TRUE(off <= most + 1e-6);
                taken++;
                close += off > most / 2;
            }
        }
    }
    TEST_ASSERT_TRUE(taken > 10000 && close > 100);
}

/* Pixels x0 <= x < x1 that are not the kernel's. A blend table of no colours leaves pixels as they
 * are, and has each painted as any pixel is. */
static void paint_any(uint8_t *pixels, const uint8_t *blend, int32_t x0, int32_t x1)
{
    memset(pixels, UNTOUCHED, COLUMNS);
    paint.blend = blend;
    row.segments = NULL;
    row.pixels = pixels;
    fxl_paint_pixels(&paint, &row, x0, x1);
    paint.blend = NULL;
}

/* Loops for what most faces have paint what the loop for any pixel paints, wherever they begin. */
void test_simple_pixels_are_as_any_pixel(void)
{
    static const uint8_t no_blend[1];
    uint32_t holes = 0, painted = 0;
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % 8u);
    }
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 2000; n++) {
        const int32_t x0 = (int32_t)(any() % COLUMNS);
        const int32_t x1 = x0 + 1 + (int32_t)(any() % (uint32_t)(COLUMNS - x0));
        setUp();
        state += n;
        choose_face();
        choose_size(any() % 6u, any() % 6u);
        paint.level.flags = (uint8_t)(n % 3 == 0 ? FXL_TEXTURE_KEYED : 0);
        paint.level.key = (uint8_t)(any() % 8u);
        paint.division = (uint8_t)(n % 5 == 0 ? FXL_DIVIDE_8 : FXL_DIVIDE_16);
        paint.colour = 3;
        if (n & 4u) {
            paint.level.texels = n & 8u ? texels : NULL;
            paint.ramp = ramp;
            paint.levels_less_1 = LEVELS - 1;
            gradients.count = n & 8u ? 3 : 1;
            gradients.shifts[gradients.count - 1] = 20;
            choose_gradient(&gradients.attributes[gradients.count - 1],
                            &row.attributes[gradients.count - 1],
                            exact(&gradients.weight, 0) * ((int)(any() % 900u) - 100) / 4000,
                            exact(&gradients.weight, COLUMNS) * ((int)(any() % 900u) - 100) / 4000);
        }
        paint_any(row_pixels, NULL, x0, x1);
        paint_any(part, no_blend, x0, x1);
        TEST_ASSERT_EQUAL_MEMORY(part, row_pixels, COLUMNS);
        paint_any(row_pixels, NULL, 0, COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(part + x0, row_pixels + x0, (size_t)(x1 - x0));
        for (int32_t x = x0; x < x1; x++) {
            holes += part[x] == UNTOUCHED;
            painted += part[x] != UNTOUCHED;
        }
    }
    TEST_ASSERT_TRUE(holes > 1000 && painted > 10000);
}

/* --- rows of a trapezoid -------------------------------------------------------------------- */

enum {
    ROWS = 24
};

/* A trapezoid of a face whose weight is at least what the kernel takes, or not in all rows. */
static void choose_rows(fxl_plain_rows *rows)
{
    memset(rows, 0, sizeof *rows);
    rows->row = row;
    rows->row.segments = &face;
    rows->end_row = ROWS;
    rows->stride = COLUMNS;
    rows->downs[0] = (int64_t)ldexp((int)(any() % 4000000u) - 2000000, 32);
    rows->downs[1] = (int64_t)ldexp((int)(any() % 4000000u) - 2000000, 32);
    rows->downs[2] = (int64_t)ldexp((int)(any() % 4000000u) - 2000000, 32);
    for (uint32_t i = 0; i < 2; i++) {
        rows->edges[i].x = (int32_t)(40u + any() % 48u);
        rows->edges[i].step = (int32_t)(any() % 2u) - 1;
        rows->edges[i].step_fraction = any();
    }
}

/* Paints a trapezoid: rows that are not the kernel's go to fxl_paint_pixels. first, end: of the
 * rows that a band has; from, to: the columns that a clipper leaves. */
static uint32_t paint_trapezoid(const fxl_plain_rows *whole, uint8_t pixels[ROWS][COLUMNS],
                                int32_t first, int32_t end, int32_t from, int32_t to)
{
    fxl_plain_rows rows = *whole;
    uint32_t left = 0;
    rows.row.pixels = pixels[0];
    while (rows.row.y < first) {
        fxl_plain_rows_next(&rows);
    }
    rows.end_row = end;
    if (from > 0 || to < COLUMNS) {
        rows.edges[0].x = from;
        rows.edges[1].x = to;
        rows.edges[0].step = rows.edges[1].step = 0;
        rows.edges[0].step_fraction = rows.edges[1].step_fraction = 0;
    }
    while (rows.row.y < end && fxl_paint_rows(&rows)) {
        int32_t x0, x1;
        fxl_plain_rows_columns(&rows, &x0, &x1);
        fxl_paint_pixels(&paint, &rows.row, x0, x1);
        fxl_plain_rows_next(&rows);
        left++;
    }
    return left;
}

/* Neither the band nor what is cut off a face changes a pixel. */
/* surfaces 2.2 */
void test_bands_and_clips_change_no_pixel(void)
{
    static uint8_t all[ROWS][COLUMNS], parts[ROWS][COLUMNS];
    uint32_t left = 0, painted = 0;
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(any() % UNTOUCHED);
    }
    for (uint32_t n = 0; n < 200; n++) {
        fxl_plain_rows rows;
        const int32_t middle = 1 + (int32_t)(any() % (ROWS - 1));
        const int32_t from = (int32_t)(any() % 60u), to = from + 1 + (int32_t)(any() % 60u);
        choose_face();
        gradients.weight_min[0] = (60u + any() % 300u) << 20;
        gradients.weight_min[1] = gradients.weight_min[0] * 2u / 5u;
        gradients.shifts[0] = gradients.shifts[1] = (int8_t)(n % 4 == 0 ? 60 : 24);
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        choose_rows(&rows);
        memset(all, UNTOUCHED, sizeof all);
        memset(parts, UNTOUCHED, sizeof parts);
        left += paint_trapezoid(&rows, all, 0, ROWS, 0, COLUMNS);
        (void)paint_trapezoid(&rows, parts, 0, middle, 0, COLUMNS);
        (void)paint_trapezoid(&rows, parts, middle, ROWS, 0, COLUMNS);
        TEST_ASSERT_EQUAL_MEMORY(all, parts, sizeof all);
        memset(parts, UNTOUCHED, sizeof parts);
        (void)paint_trapezoid(&rows, parts, middle / 2, ROWS, from, to);
        for (uint32_t i = 0; i < ROWS * COLUMNS; i++) {
            const uint8_t one = all[i / COLUMNS][i % COLUMNS];
            const uint8_t other = parts[i / COLUMNS][i % COLUMNS];
            if (one != UNTOUCHED && other != UNTOUCHED) {
                TEST_ASSERT_EQUAL_UINT8(one, other);
                painted++;
            }
        }
    }
    TEST_ASSERT_TRUE(left > 20 && painted > 10000);
}

static void check_refused(bool expected)
{
    TEST_ASSERT_EQUAL(expected, !fxl_segments_find(&paint, &face));
    setUp();
    choose_size(4, 4);
}

void test_other_faces_are_not_the_kernels(void)
{
    static const uint8_t colours[16];
    choose_size(4, 4);
    check_refused(false);
    choose_size(3, 4);
    check_refused(true);
    paint.level.texels = NULL;
    check_refused(true);
    paint.level.colours = colours;
    check_refused(false);
    paint.level.flags = FXL_TEXTURE_CLAMP;
    check_refused(true);
    paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(false);
    paint.opacity = 15;
    check_refused(false);
    paint.opacity = 15;
    paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(true);
    paint.level.colours = colours;
    paint.level.flags = FXL_TEXTURE_KEYED;
    check_refused(true);
    paint.opacity = 15;
    paint.table = colours;
    check_refused(false);
    paint.level.flags = FXL_TEXTURE_KEYED;
    paint.in_beam = colours;
    check_refused(true);
    paint.level.flags = FXL_TEXTURE_KEYED;
    paint.has_beams = true;
    check_refused(true);
    paint.blend = colours;
    check_refused(true);
    paint.division = FXL_DIVIDE_8;
    check_refused(false);
    paint.division = FXL_DIVIDE_1; /* paint_divided.h */
    check_refused(true);
    gradients.weight_min[0] = UINT32_MAX;
    check_refused(false);
}

/* Clamped textures with light at the corners; in RGB565, attributes of too many bits. */
void test_what_segments_do_not_take(void)
{
    choose_size(5, 5);
    choose_face();
    paint.level.flags = FXL_TEXTURE_CLAMP;
    TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
    gradients.count = 3;
    gradients.shifts[2] = 24;
    paint.ramp = ramp;
    TEST_ASSERT_FALSE(fxl_segments_find(&paint, &face));
    gradients.count = 2;
    paint.ramp = NULL;
    paint.level.flags = 0;
    TEST_ASSERT_TRUE(fxl_segments_find_565(&paint, &face));
    gradients.shifts[0] = gradients.shifts[1] = 79;
    TEST_ASSERT_FALSE(fxl_segments_find_565(&paint, &face));
}

/* Weights below the least one, which no face has: pixels are any texels, or stay as they are, as by
 * the kernels of Armv7-M. */
void test_weights_that_are_too_small_are_safe(void)
{
    choose_size(5, 5);
    for (uint32_t i = 0; i < TEXELS; i++) {
        texels[i] = (uint8_t)(100u + any() % 50u);
    }
    for (uint32_t n = 0; n < 100; n++) {
        choose_face();
        TEST_ASSERT_TRUE(fxl_segments_find(&paint, &face));
        face.u_drop = face.v_drop = -20;
        choose_gradient(&gradients.weight, &row.weight, 1 + any() % 64u, 1 + any() % 64u);
        face.weight_step = gradients.weight.along * 16;
        paint_row(row_pixels, 0, COLUMNS);
        for (uint32_t x = 0; x < COLUMNS; x++) {
            const uint8_t pixel = row_pixels[x];
            TEST_ASSERT_TRUE((pixel >= 100 && pixel < 150) || pixel == UNTOUCHED);
        }
    }
}

/* Of 16 pixels an opacity draws so many, those whose number in the pattern is below it. */
/* SPEC 9.6 */
void test_which_pixels_an_opacity_draws(void)
{
    static const uint32_t numbers[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    for (uint32_t opacity = 0; opacity <= 17; opacity++) {
        for (int32_t at = 0; at < 256; at++) {
            const int32_t x = at % 16, y = at / 16;
            const bool is_drawn = opacity >= 16 || numbers[y % 4][x % 4] < opacity;
            TEST_ASSERT_EQUAL(!is_drawn, fxl_is_stippled_away(opacity, x, y));
        }
    }
}
