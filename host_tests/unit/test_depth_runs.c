/* SPDX-License-Identifier: MIT */
/* The depth test of a run of pixels, against its definition: random runs, most of whose codes are
 * near their cells. And the codes of small faces, each pixel of which has its own octave. */
#include <math.h>

#include "depth_scene.h"
#include "draw/depth_plane.h"
#include "draw/surface_polygon.h"
#include "paint/depth_cells.h"
#include "paint/depth_code.h"
#include "paint/depth_outline.h"
#include "paint/smooth_outline.h"
#include "raster/scan.h"
#include "view/view.h"

enum {
    MOST = 23
};

static uint16_t cells[MOST + 1], kept[MOST + 1];

static bool is_visible(uint32_t code, uint32_t i, uint32_t step)
{
    return (code + i * step) >> 16 > cells[i];
}

/* Cells at most 1 from the codes; at_equals: as many as that, and one that is decided otherwise at
 * the end. */
static void make_cells(uint32_t code, uint32_t step, bool visible, uint32_t ends)
{
    for (uint32_t i = 0; i <= MOST; i++) {
        const uint32_t of_pixel = (code + i * step) >> 16;
        const bool wanted = (i < ends) == visible;
        const uint32_t near = (uint32_t)unit_between(0, 2);
        cells[i] =
            (uint16_t)(wanted ? (of_pixel > near ? of_pixel - 1 - near : 0)
                              : (of_pixel + near > UINT16_MAX ? UINT16_MAX : of_pixel + near));
    }
}

/* SPEC 10.4b */
void test_runs_end_where_the_definition_says(void)
{
    uint32_t equals = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const bool visible = unit_random() % 2;
        const uint32_t count = (uint32_t)unit_between(0, MOST), code = unit_random() | 1u << 20,
                       step = (uint32_t)unit_between(-(1 << 18), 1 << 18);
        make_cells(code, step, visible, (uint32_t)unit_between(0, MOST));
        memcpy(kept, cells, sizeof kept);
        uint32_t wanted = 0;
        while (wanted < count && is_visible(code, wanted, step) == visible) {
            equals += cells[wanted] == (code + wanted * step) >> 16;
            if (visible) {
                kept[wanted] = (uint16_t)((code + wanted * step) >> 16);
            }
            wanted++;
        }
        TEST_ASSERT_EQUAL_UINT32(wanted, visible ? fxl_depth_keep_visible(cells, count, code, step)
                                                 : fxl_depth_skip_hidden(cells, count, code, step));
        TEST_ASSERT_EQUAL_HEX16_ARRAY(kept, cells, MOST + 1);
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, equals);
}

/* Which of two at the same nearness is visible: the first, or with or_equal the second. */
/* SPEC 10.4b, 10.5a */
void test_ties(void)
{
    static const uint16_t narrow[] = {7, 8, 9};
    static const uint32_t wide[] = {0x80000, 0x80001, 0x80002};
    for (int32_t x = 0; x < 3; x++) {
        const fxl_depth_rule rules[] = {{.wide = false},
                                        {.wide = true},
                                        {.wide = false, .or_equal = true},
                                        {.wide = true, .or_equal = true}};
        TEST_ASSERT_EQUAL(x < 1, fxl_depth_passes(narrow, x, 0x8FFFF, rules[0]));
        TEST_ASSERT_EQUAL(x < 1, fxl_depth_passes(wide, x, 0x80001, rules[1]));
        TEST_ASSERT_EQUAL(x <= 1, fxl_depth_passes(narrow, x, 0x8FFFF, rules[2]));
        TEST_ASSERT_EQUAL(x <= 1, fxl_depth_passes(wide, x, 0x80001, rules[3]));
    }
}

/* The loops of wide cells, which no kernel has: they end at the end, whatever comes after it. */
void test_runs_of_wide_cells(void)
{
    static const fxl_depth_rule rule = {.wide = true};
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        uint32_t wide[MOST + 1];
        const bool visible = unit_random() % 2;
        const uint32_t code = unit_random() >> 1 | 1u << 20, ends = (uint32_t)unit_between(0, MOST);
        const uint32_t step = (uint32_t)unit_between(-999, 999),
                       end = (uint32_t)unit_between(0, MOST);
        for (uint32_t x = 0; x <= MOST; x++) {
            const bool below = (x < ends) == visible;
            wide[x] = code + x * step - (below ? 1u : 0u) + (unit_random() % 2 && !below ? 9u : 0u);
        }
        fxl_depth_line line = {code, step};
        const int32_t found = visible
                                  ? fxl_depth_visible_end(wide, 0, (int32_t)end, &line, false, rule)
                                  : fxl_depth_hidden_end(wide, 0, (int32_t)end, &line, rule);
        TEST_ASSERT_EQUAL_INT32(ends < end ? ends : end, found);
        TEST_ASSERT_EQUAL_UINT32(code + (uint32_t)found * step, line.code);
    }
}

/* The table's numbers, rounded up: the change of the distance z in which near / z changes by a code. */
/* SPEC 10.6d-g */
void test_the_resolutions_of_two_scenes(void)
{
    static const struct {
        double near_z, far_z;
        uint32_t octaves;
        double largest[2][3], digit[2][3]; /* at near, between, at far: the number, its last digit */
    } scenes[] = {{0.75, 228.2, 9, {{0.0001, 0.0018, 0.034}, {0.000003, 0.00006, 0.0011}},
                   {{0.0001, 0.0001, 0.001}, {0.000001, 0.00001, 0.0001}}},
                  {0.0625, 64, 11, {{0.000008, 0.0005, 0.016}, {0.0000003, 0.00002, 0.0005}},
                   {{0.000001, 0.0001, 0.001}, {0.0000001, 0.00001, 0.0001}}}};
    for (int i = 0; i < 6; i++) {
        const double near_z = scenes[i / 3].near_z, far_z = scenes[i / 3].far_z;
        const fxl_lens lens = {.near_z = (int32_t)(near_z * 65536),
                               .far_z = (int32_t)(far_z * 65536)};
        const fxl_depth_scale scale = fxl_depth_scale_of(&lens);
        TEST_ASSERT_EQUAL_UINT8(scenes[i / 3].octaves, scale.octaves);
        TEST_ASSERT_EQUAL_UINT8(12, scale.mantissa);
        const double z = i % 3 == 0 ? near_z : i % 3 == 1 ? sqrt(near_z * far_z) : far_z;
        double step = ldexp(z * z / near_z, -1 - scale.mantissa);
        for (double depth = near_z / z; depth < 0.5; depth *= 2) { /* of octave 0 from 1/2 on */
            step /= 2;
        }
        for (int k = 0; k < 2; k++) {
            const double here = k == 0 ? step : step / 32, stated = scenes[i / 3].largest[k][i % 3];
            TEST_ASSERT_TRUE(here <= stated && here > stated - scenes[i / 3].digit[k][i % 3]);
        }
    }
}

/* Given its normal, which is not rounded in a view that is not turned. */
/* SPEC 10.2c-d */
void test_a_plane_gives_the_depth_of_its_points(void)
{
    static fxl_view view;
    const fxl_lens lens = unit_lens(64, 48);
    const double focal = lens.focal / 65536.0, near_z = lens.near_z / 65536.0;
    double worst = 0;
    fxl_view_set_lens(&view, &lens);
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_direction normal = unit_direction();
        const fxl_view_point point = {unit_wide(50), unit_wide(50),
                                      ((int64_t)1 << unit_between(44, 56)) + unit_wide(42)};
        const int x = unit_between(0, 63), y = unit_between(0, 47);
        const double way[3] = {(x + 0.5 - 32) / focal, (24 - y - 0.5) / focal, 1};
        fxl_depth_plane plane;
        double of_point = 0, at_pixel = 0;
        for (int k = 0; k < 3; k++) {
            of_point += (double)(&normal.x)[k] * ldexp((double)(&point.x)[k], -46);
            at_pixel += (&normal.x)[k] * way[k];
        }
        fxl_find_depth_plane(&normal, NULL, &point, &view, &plane);
        const fxl_gradient *of = &plane.gradient;
        const double depth = near_z * at_pixel / of_point;
        if (depth >= 1.0 / 65536 && depth <= 1 && of_point > 0) {
            const double found = ldexp((double)(of->at + x * of->along + y * of->down), -plane.one);
            const double off = fabs(found - depth) / depth;
            worst = fmax(worst, off);
        }
    }
    TEST_ASSERT_TRUE(worst > ldexp(1, -34) && worst < ldexp(1, -27));
}

/* Of a plane whose depths are known: how much smaller the codes of a wide row are. */
/* SPEC 10.3e */
void test_a_code_is_too_small_by_less_than_a_64th(void)
{
    static fxl_view view;
    const fxl_lens lens = unit_lens(FXL_SCREEN_MAX, 48);
    const fxl_depth_scale scale = fxl_depth_scale_of(&lens);
    double worst = 0;
    fxl_view_set_lens(&view, &lens);
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const fxl_direction normal = unit_direction();
        const fxl_view_point point = {unit_wide(50), unit_wide(50),
                                      ((int64_t)1 << unit_between(44, 56)) + unit_wide(42)};
        const int x = unit_between(0, FXL_SCREEN_MAX - 1);
        fxl_depth_plane plane;
        fxl_find_depth_plane(&normal, NULL, &point, &view, &plane);
        const int64_t row = plane.gradient.at + unit_between(0, 47) * plane.gradient.down;
        const double depth = ldexp((double)(row + x * plane.gradient.along), -plane.one);
        if (depth < 1 && depth >= ldexp(1, -scale.octaves)) {
            const int octave = -1 - ilogb(depth);
            const double code = ldexp(ldexp(depth, octave + 1) - 2 + scale.octaves - octave,
                                      scale.mantissa + 16) + 65536;
            const double less = code - fxl_depth_code_at(scale, &plane, row, x);
            TEST_ASSERT_TRUE(less > -1e-3 && less < 1024);
            worst = fmax(worst, less);
        }
    }
    TEST_ASSERT_TRUE(worst > 256);
}

/* A plane through the eye, or on the wrong side of it: its code is the least, at each pixel. */
/* SPEC 10.1c */
void test_a_face_that_is_seen_edge_on_is_at_infinity(void)
{
    static fxl_view view;
    const fxl_lens lens = unit_lens(64, 48);
    const fxl_direction away = {0, 0, FXL_Q2_30_ONE}, upward = {0, FXL_Q2_30_ONE, 0};
    const struct {
        const fxl_direction *normal;
        fxl_view_point point;
        bool is_near;
    } cases[] = {{&away, {0, 0, (fxl_q18_46)1 << 46}, true},
                 {&away, {0, 0, -((fxl_q18_46)1 << 46)}, false},
                 {&upward, {0, 0, (fxl_q18_46)1 << 46}, false},
                 {&upward, {0, 1 << 30, (fxl_q18_46)1 << 46}, true},
                 {&upward, {0, -(1 << 30), (fxl_q18_46)1 << 46}, false}};
    fxl_view_set_lens(&view, &lens);
    const fxl_depth_scale scale = fxl_depth_scale_of(&lens);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fxl_depth_plane plane;
        fxl_depth_octave octave;
        fxl_find_depth_plane(cases[i].normal, NULL, &cases[i].point, &view, &plane);
        const fxl_gradient *of = &plane.gradient;
        TEST_ASSERT_EQUAL(cases[i].is_near, (of->at | of->along | of->down) != 0);
        if (!cases[i].is_near) {
            fxl_depth_octave_of(scale, &plane, of->at, &octave);
            TEST_ASSERT_TRUE(octave.is_constant && octave.bias == 65536);
        }
    }
}

/* SPEC 10.3g */
void test_a_cell_of_no_face_is_0_and_hides_nothing(void)
{
    enum {
        CELLS = 6
    };
    static union {
        fxl_depth_head head;
        uint16_t words[sizeof(fxl_depth_head) / 2 + CELLS];
    } memory;
    static fxl_workspace workspace;
    const fxl_band band = {.width = CELLS / 2, .stride = CELLS / 2, .rows = 2};
    memset(&memory, 0xA5, sizeof memory);
    memory.head.clear_from = memory.head.clear_to = 0;
    workspace.target_memory = &memory;
    fxl_depth_clear_all(&workspace, &band, &fxl_rgb565_depth_16);
    const uint16_t *left = (const uint16_t *)(const void *)(&memory.head + 1);
    for (int32_t x = 0; x < CELLS; x++) {
        const fxl_depth_rule rule = {.wide = false};
        TEST_ASSERT_EQUAL_UINT16(0, left[x]);
        TEST_ASSERT_TRUE(fxl_depth_passes(left, x, 1u << 16, rule)); /* the least code */
    }
}

/* The fewest octaves that reach from 257/256 of the far plane to the near one, and as many bits of
 * mantissa, 15 at most, as let every code be below 2^16. */
/* SPEC 10.6, 10.3a */
void test_the_scale_of_a_lens(void)
{
    uint32_t equals = 0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_lens lens = {.near_z = unit_between(16, 65536)};
        const int64_t far_z =
            ((int64_t)lens.near_z << unit_between(0, 24)) * unit_between(200, 300) / 256;
        lens.far_z = (int32_t)(far_z > INT32_MAX     ? INT32_MAX
                               : far_z > lens.near_z ? far_z
                                                     : lens.near_z + 1);
        const int64_t power = (int64_t)lens.near_z << unit_between(1, 14);
        if (i % 2 != 0 && power > 2 * lens.near_z) { /* at a power of two, or just beside it */
            lens.far_z = (int32_t)((power - 1) * 256 / 257 + unit_between(-1, 2));
        }
        const fxl_depth_scale scale = fxl_depth_scale_of(&lens);
        const double ratio = lens.far_z * (257.0 / 256) / lens.near_z;
        const double reached = (double)((int64_t)1 << scale.octaves);
        TEST_ASSERT_TRUE(ratio <= reached);
        const int64_t least = (int64_t)lens.far_z + lens.far_z / 256 + 1;
        TEST_ASSERT_TRUE(least <= (int64_t)lens.near_z << scale.octaves);
        TEST_ASSERT_TRUE(scale.octaves == 1 || least > (int64_t)lens.near_z << (scale.octaves - 1));
        equals += least == (int64_t)lens.near_z << scale.octaves;
        const int64_t codes = (int64_t)scale.octaves << scale.mantissa;
        TEST_ASSERT_TRUE(codes + 1 <= 65536 && scale.mantissa <= 15);
        TEST_ASSERT_TRUE(scale.mantissa == 15 || 2 * codes + 1 > 65536);
    }
    TEST_ASSERT_TRUE(equals > UNIT_REPEAT / 20);
}

void test_a_number_shifted_either_way(void)
{
    TEST_ASSERT_EQUAL_HEX32(40, fxl_depth_shifted(5, -3));
    TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFDu, fxl_depth_shifted(-5, 1));
    TEST_ASSERT_EQUAL_HEX32(0x89ABCDEFu, fxl_depth_shifted(0x123456789ABCDEF, 0));
    TEST_ASSERT_EQUAL_HEX32(0x56789ABCu, fxl_depth_shifted(0x123456789ABCDEF, 12));
}

/* An octave holds the values whose codes it gives: from a power of two to the next. */
/* SPEC 10.3c-d */
void test_octaves(void)
{
    static const fxl_depth_scale scale = {.octaves = 11, .mantissa = 12};
    fxl_depth_plane plane;
    memset(&plane, 0, sizeof plane);
    plane.gradient.along = (int64_t)5 << 40;
    plane.one = 60;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        const int64_t value = unit_wide(62) >> unit_random() % 62u; /* of every length */
        fxl_depth_octave octave;
        fxl_depth_octave_of(scale, &plane, value, &octave);
        TEST_ASSERT_TRUE(fxl_depth_octave_holds(&octave, value));
        TEST_ASSERT_EQUAL(value >= (int64_t)1 << 60 || value < (int64_t)1 << 49,
                          octave.is_constant);
        if (!octave.is_constant) {
            TEST_ASSERT_TRUE(octave.high == 2 * octave.low && octave.low <= value);
            TEST_ASSERT_TRUE(fxl_depth_octave_holds(&octave, octave.low));
            TEST_ASSERT_FALSE(fxl_depth_octave_holds(&octave, octave.low - 1));
            TEST_ASSERT_TRUE(fxl_depth_octave_holds(&octave, octave.high - 1));
            TEST_ASSERT_FALSE(fxl_depth_octave_holds(&octave, octave.high));
        }
    }
}

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

#if !FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT

enum {
    SIDE = 14
};

static fxl_depth_head *smooth_head; /* cells follow */
static uint16_t smooth_cells[SIDE * SIDE];

/* The definition of a pixel: a bent code, and light that is held within the ramp. */
static void define_smooth(const fxl_paint *paint, const fxl_depth_plane *depth, uint32_t x,
                          uint32_t y, bool is_wide, uint16_t *pixel)
{
    const fxl_gradient *light = paint->gradients->attributes, *of = &depth->gradient;
    const uint32_t border = fxl_depth_border(smooth_head->scale, depth);
    const int64_t word = of->at + x * of->along + y * of->down;
    const int64_t code = word < border ? 2 * word - border : word;
    const int64_t half = is_wide ? ((int64_t)paint->levels_less_1 << 15) - (1 << 23) : 0;
    const int64_t most = ((int64_t)paint->levels_less_1 << 24) + (is_wide ? half + (1 << 23) : 0);
    int64_t level = light->at + x * light->along + y * light->down + half;
    level = level < 0 ? 0 : level > most ? most : level;
    if (code >> 16 > smooth_cells[y * SIDE + x]) {
        smooth_cells[y * SIDE + x] = (uint16_t)(code >> 16);
        *pixel = is_wide ? fxl_mix_565(paint->of_565.palette[paint->colour], paint->of_565.dark,
                                       (uint32_t)(level * paint->of_565.part_of_level >> 32))
                         : paint->ramp[(level >> 24) * 256 + paint->colour];
    }
}

#endif

/* On cores without a kernel: a lit triangle has the code and the light of each of its pixels, also where a row
 * crosses the end of an octave or of the ramp. */
/* SPEC 9.6, 10.3, 10.4b */
void test_a_smooth_triangle_has_the_light_and_codes_of_its_pixels(void)
{
#if !FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT
    static uint64_t memory[1 + SIDE * SIDE / 4];
    static uint8_t ramp[64 * 256];
    static uint16_t palette[256], pixels[SIDE * SIDE], expected[SIDE * SIDE];
    static fxl_scan scan;
    uint32_t bent = 0, held = 0;
    smooth_head = (fxl_depth_head *)(void *)memory;
    smooth_head->scale = (fxl_depth_scale){9, 12};
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        const bool is_wide = i % 2;
        const int32_t levels = unit_between(2, 64), octave = unit_between(0, 7);
        uint8_t *bytes = (uint8_t *)pixels;
        fxl_gradients gradients = {.count = 1};
        fxl_depth_plane depth = {.one = unit_between(0, 1) ? FXL_DEPTH_IS_BENT + octave
                                                           : FXL_DEPTH_IS_LINEAR};
        const uint32_t border = fxl_depth_border(smooth_head->scale, &depth);
        fxl_paint paint = {.gradients = &gradients,
                           .ramp = ramp,
                           .levels_less_1 = (uint8_t)(levels - 1),
                           .colour = (uint8_t)unit_random(),
                           .of_565 = {.palette = palette,
                                      .part_of_level = (uint32_t)(65536 + (levels - 1) / 2) /
                                                       (uint32_t)(levels - 1),
                                      .dark = (uint16_t)unit_random()}};
        const fxl_band band = {
            .pixels = bytes, .width = SIDE, .stride = SIDE, .first_row = 0, .rows = SIDE};
        fxl_screen_point points[3];
        for (uint32_t k = 0; k < 3; k++) {
            points[k].x = unit_between(0, SIDE << 16);
            points[k].y = unit_between(0, SIDE << 16);
        }
        /* from -1/4 of the ramp on to 5/4 of it */
        gradients.attributes[0].at = unit_between(-levels, 5 * levels) * (1 << 22);
        gradients.attributes[0].along = unit_between(-levels, levels) * (1 << 22) / SIDE;
        gradients.attributes[0].down = unit_between(-levels, levels) * (1 << 22) / SIDE;
        depth.gradient.at = (int64_t)(border != 0 ? border : 1u << 31) + unit_between(-(1 << 24), 1 << 24);
        depth.gradient.along = unit_between(-(1 << 21), 1 << 21);
        depth.gradient.down = unit_between(-(1 << 21), 1 << 21);
        for (uint32_t k = 0; k < 64 * 256; k++) {
            ramp[k] = (uint8_t)(k * 7u + (k >> 8));
        }
        palette[paint.colour] = (uint16_t)unit_random();
        memset(pixels, 0xA5, sizeof pixels);
        memset(expected, 0, sizeof expected);
        uint16_t *found = (uint16_t *)(void *)(memory + 1);
        for (uint32_t k = 0; k < SIDE * SIDE; k++) {
            const int64_t near = depth.gradient.at + unit_between(-(1 << 22), 1 << 22);
            found[k] = smooth_cells[k] = (uint16_t)(unit_between(0, 1) ? 0 : near >> 16);
            expected[k] = is_wide ? pixels[k] : bytes[k];
        }
        fxl_scan_outline(points, 3, &band, &scan);
        for (fxl_span span; fxl_scan_next(&scan, &span);) {
            for (int32_t x = span.x0; x < span.x1; x++) {
                define_smooth(&paint, &depth, (uint32_t)x, (uint32_t)span.y, is_wide,
                              &expected[span.y * SIDE + x]);
                held += gradients.attributes[0].at < 0;
                bent += border != 0;
            }
        }
        fxl_scan_outline(points, 3, &band, &scan);
        fxl_draw_smooth_words(&paint, &depth, memory, is_wide ? 2 : 1, &band, &scan);
        for (uint32_t k = 0; k < SIDE * SIDE; k++) {
            TEST_ASSERT_EQUAL_HEX16(smooth_cells[k], found[k]);
            TEST_ASSERT_EQUAL_HEX16(expected[k], is_wide ? pixels[k] : bytes[k]);
        }
    }
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT, bent);
    TEST_ASSERT_GREATER_THAN(UNIT_REPEAT / 4, held);
#endif
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
