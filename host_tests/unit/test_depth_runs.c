/* SPDX-License-Identifier: MIT */
/* The depth test of a run of pixels, against its definition: random runs, most of whose codes are
 * near their cells. And what a code is: planes, octaves, scales. */
#include <math.h>

#include "unit.h"
#include "draw/depth_plane.h"
#include "draw/surface_polygon.h"
#include "paint/depth_cells.h"
#include "paint/depth_code.h"
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
    fxl_depth_clear_all(&workspace, &band, &fxl_palette_depth_16);
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
