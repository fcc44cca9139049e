/* SPDX-License-Identifier: MIT */
/* The kernel that paints colours between those of corners. Any words are right: sums wrap. */

#include "equality.h"
#include "paint/depth_rows.h"
#include "paint/light_level.h"
#include "paint/paint_polygon.h"
#include "sides.h"

#define PIXELS 80u

static uint16_t by_core[PIXELS], by_portable[PIXELS];

void test_colour_runs(uint32_t rounds)
{
    for (uint32_t i = 0; i < rounds; i++) {
        const fxl_colour_words words = {any_32(), any_32(), any_32() >> (any_32() >> 27), any_32()};
        const uint32_t first = any_32() >> 29, count = 1u + (any_32() >> 8) % 70u;
        bool same = true;
        fxl_paint_colour_run(&words, by_core + first, count);
        portable_paint_colour_run(&words, by_portable + first, count);
        for (uint32_t k = 0; k < PIXELS; k++) {
            same &= by_core[k] == by_portable[k];
            by_core[k] = by_portable[k] = 0xA5A5;
        }
        equality_case(same);
    }
}

/* --- light at corners ------------------------------------------------------------------------- */

/* A component of a direction: those of a vector are at most 1 together. */
static int32_t any_component(uint32_t index)
{
    const uint32_t number = any_32();
    const int32_t component = (int32_t)(number >> 2 >> (number & 15u));
    const int32_t held = index == 0 ? component : component / 2;
    return number & 16u ? held : -held;
}

static fxl_direction any_direction(void)
{
    const uint32_t longest = any_32() % 3u;
    const fxl_direction direction = {any_component(longest), any_component((longest + 1u) % 3u),
                                     any_component((longest + 2u) % 3u)};
    return direction;
}

static fxl_q2_30 any_part(void)
{
    const uint32_t number = any_32();
    return (fxl_q2_30)(number % 5u == 0 ? 1u << 30 : number >> 2 >> (number & 7u));
}

void test_light_corners(uint32_t rounds)
{
    fxl_direction normals[4];
    fxl_corner corners[3] = {{{0, 0}, 0, 0}};
    const fxl_corner *const of[3] = {&corners[0], &corners[1], &corners[2]};
    for (uint32_t i = 0; i < rounds; i++) {
        int32_t core[3], portable[3];
        const fxl_light_settings settings = {.ambient = any_part(),
                                             .strength = any_part(),
                                             .direction = any_direction(),
                                             .levels = 2u + any_32() % 63u};
        for (uint32_t k = 0; k < 4; k++) {
            normals[k] = any_direction();
        }
        for (uint32_t k = 0; k < 3; k++) {
            corners[k].normal = (uint16_t)(any_32() >> 30);
        }
        fxl_light_corners_of(&settings, normals, of, core);
        portable_light_corners_of(&settings, normals, of, portable);
        equality_case(equality_same_words(core, portable, sizeof core));
    }
}

/* --- texels that are lit, blended or added --------------------------------------------------- */

#define COLUMNS 128u /* from one row to the next */
#define LEVELS  32u  /* at most */

static FXL_ALIGN_8 uint8_t texels[2u * 65536u];
static uint16_t palette[256];
static FXL_ALIGN_8 uint16_t lit_by_core[2u * COLUMNS], lit_by_portable[2u * COLUMNS];

/* A number below 2^bits and above -2^bits. */
static int64_t any_value(uint32_t bits)
{
    const int64_t value = (int64_t)(any_64() >> (64u - bits));
    return any_32() >> 9 & 1u ? value : -value;
}

/* A gradient whose upper word is about that of the weight: so the attribute is about 2^shift. */
static void any_gradient(uint32_t bits, int64_t *at, fxl_gradient *gradient)
{
    *at = any_value(bits);
    gradient->along = any_value(bits - (any_32() >> 9) % 8u) / 96;
    gradient->down = any_value(bits - (any_32() >> 9) % 8u) / 96;
}

/* A run in each of two rows, by the core: where it has lists of them in one call. */
static void paint_by_core(const fxl_paint *paint, const fxl_paint_row rows[2],
                          const uint32_t list[2])
{
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
    const fxl_gradients *gradients = paint->gradients;
    fxl_plain_runs runs = {.row = rows[0], .next = list, .end = list + 2, .stride = 2u * COLUMNS};
    fxl_find_downs(gradients, runs.downs);
    runs.downs[3] = gradients->attributes[FXL_SEGMENT_LIGHT].down;
    fxl_paint_texel_runs(paint, &runs);
#else
    for (uint32_t i = 0; i < 2; i++) {
        fxl_paint_pixels_565(paint, &rows[i], (int32_t)(list[i] & 0xFFFFu),
                             (int32_t)((list[i] & ~FXL_RUN_BELOW) >> 16));
    }
#endif
}

/* Pixels of two rows, whose light is mostly a level, against fxl_paint_pixels_565 in C. */
void test_lit_texels(uint32_t rounds)
{
    static const uint8_t lengths[] = {16, 16, 8, 4};
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(any_32() >> 11);
    }
    for (uint32_t i = 0; i < 256; i++) {
        palette[i] = (uint16_t)(any_32() >> 9);
    }
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_gradients gradients = {.count = 3};
        fxl_paint_row rows[2] = {{.y = 0}}, row = {.y = 0};
        uint32_t list[2];
        const uint32_t bits = 34u + (any_32() >> 5) % 29u, kind = any_32() >> 8;
        const uint32_t log_width = 1u + (any_32() >> 5) % 8u, log_height = (any_32() >> 5) % 9u;
        const uint32_t mixed = any_32() >> 9 & 7u; /* 0: added, 1: blended, others: lit */
        const uint32_t levels_less_1 = 1u + (any_32() >> 6) % (LEVELS - 1u);
        row.weight = (int64_t)(any_64() >> (64u - bits)) | (int64_t)1 << (bits - 1u);
        gradients.weight.along = any_value(bits - (any_32() >> 9) % 8u) / 96;
        gradients.weight.down = any_value(bits - (any_32() >> 9) % 8u) / 96;
        for (uint32_t k = 0; k < FXL_ATTRIBUTES; k++) {
            any_gradient(bits, &row.attributes[k], &gradients.attributes[k]);
            gradients.shifts[k] = (int8_t)(16u + (any_32() >> 9) % 10u);
        }
        if ((kind & 7u) != 0) { /* between two levels */
            gradients.shifts[FXL_SEGMENT_LIGHT] = 20;
            row.attributes[FXL_SEGMENT_LIGHT] =
                row.weight / 16 * (int64_t)(1u + (any_32() >> 9) % levels_less_1);
            gradients.attributes[FXL_SEGMENT_LIGHT].along /= 16;
        }
        gradients.weight_min[0] =
            (uint32_t)(row.weight >> 32) / lengths[any_32() >> 9 & 3u] * (any_32() >> 9 & 31u) + 1u;
        gradients.weight_min[1] = gradients.weight_min[0] / (1u + (any_32() >> 9 & 15u)) + 1u;
        const fxl_paint paint = {
            .gradients = &gradients,
            .level = {.texels = texels,
                      .columns_less_1 = (1u << log_width) - 1u,
                      .rows_less_1 = (1u << log_height) - 1u,
                      .log_width = (uint8_t)log_width,
                      .flags = kind & 8u ? 0x80u : 0}, /* FXL_LEVEL_565 */
            .levels_less_1 = (uint8_t)levels_less_1,
            .division = kind & 16u ? FXL_DIVIDE_16 : FXL_DIVIDE_8,
            .opacity = 16,
            .of_565 = {.palette = palette,
                       .part_of_level =
                           mixed <= 1u ? 0 : (65536u + levels_less_1 / 2u) / levels_less_1,
                       .dark = (uint16_t)(kind & 32u ? any_32() >> 9 : 0),
                       .sixteenths = mixed == 1u ? (uint8_t)(1u + kind % 15u) : (uint8_t)0,
                       .adds = mixed == 0},
        };
        gradients.count = mixed <= 1u ? 2 : 3;
        for (uint32_t k = 0; k < 2; k++) {
            const uint32_t x0 = any_32() >> 8 & 31u, x1 = x0 + 1u + (any_32() >> 7) % 63u;
            list[k] = x0 | x1 << 16 | (k != 0 ? FXL_RUN_BELOW : 0);
            rows[k] = row;
            row.weight += gradients.weight.down;
            for (uint32_t of = 0; of < FXL_ATTRIBUTES; of++) {
                row.attributes[of] += gradients.attributes[of].down;
            }
            rows[k].pixels = (uint8_t *)(lit_by_portable + 16u + k * COLUMNS);
            portable_paint_pixels_565(&paint, &rows[k], (int32_t)x0, (int32_t)x1);
            rows[k].pixels = (uint8_t *)(lit_by_core + 16u + k * COLUMNS);
        }
        paint_by_core(&paint, rows, list);
        equality_case(equality_same_words(lit_by_core, lit_by_portable, sizeof lit_by_core));
    }
}
