/* SPDX-License-Identifier: MIT */
/* The kernels that paint rows of a textured face. Each side writes into memory of its own, all of
 * which must be equal. */
#include "texture_rows.h"

#include "equality.h"
#include "paint/segments.h"
#include "sides.h"

#define COLUMNS 96u
#define LEVELS  32u

static uint8_t texels[65536], ramp[256u * LEVELS];
static uint8_t by_core[COLUMNS + 32u], by_portable[COLUMNS + 32u];

/* A number below 2^30 and above -2^30, of any length. */
static int64_t any_value(void)
{
    const int64_t value = (int64_t)(any_64() >> 2 >> (any_32() >> 7) % 62u);
    return any_32() >> 9 & 1u ? value : -value;
}

static void compare(fxl_segment_face *face, fxl_paint_row *row, int32_t x0, int32_t x1)
{
    row->pixels = by_core + 16;
    fxl_paint_segments(face, row, x0, x1);
    row->pixels = by_portable + 16;
    portable_paint_segments(face, row, x0, x1);
    bool same = true;
    for (uint32_t i = 0; i < sizeof by_core; i++) {
        same &= by_core[i] == by_portable[i];
        by_core[i] = by_portable[i] = 0xA5;
    }
    equality_case(same);
}

/* A texture of any size that the kernel takes. */
static void choose_texture(fxl_segment_face *face, uint32_t log_width, uint32_t log_height)
{
    const uint32_t log = log_width > log_height ? log_width : log_height;
    face->texels = texels;
    face->rows_mask = ((1u << log_height) - 1u) << log_width;
    face->log_width = (uint8_t)log_width;
    face->row_drop = (uint8_t)(16u - log - log_width);
    face->form = (uint8_t)(log_width == log ? log_width - FXL_SEGMENT_LOG_MIN : 0u);
}

/* The weight rises or falls between two weights that the face allows, from column 0 to the last. */
static void choose_weights(fxl_segment_face *face, fxl_paint_row *row, int64_t at, int64_t end)
{
    face->weight_step = (end - at) / (int64_t)(COLUMNS / 16u);
    face->is_constant = face->weight_step == 0;
    row->weight = at;
}

static void choose_light(fxl_segment_face *face, fxl_paint_row *row, uint32_t levels)
{
    face->ramp = levels == 0 ? NULL : ramp;
    face->light_max = (int32_t)(256u * levels) - 1;
    face->light_step = (int32_t)(any_value() >> 32);
    row->attributes[FXL_SEGMENT_LIGHT] = any_value();
}

static void choose_coordinates(fxl_segment_face *face, fxl_paint_row *row)
{
    face->u_step = any_value();
    face->v_step = any_value();
    row->attributes[FXL_ATTRIBUTE_U] = any_value();
    row->attributes[FXL_ATTRIBUTE_V] = any_value();
}

/* The drops are at least what the least weight needs: 32 less than its leading zeros. */
static void choose_drops(fxl_segment_face *face, int32_t least, uint32_t range)
{
    face->u_drop = least + (int32_t)((any_32() >> 8) % range);
    face->v_drop = least + (int32_t)((any_32() >> 8) % range);
    face->light_drop = least + (int32_t)((any_32() >> 8) % range);
    face->drop_min = face->u_drop < face->v_drop ? face->u_drop : face->v_drop;
    face->drop_min = face->drop_min < face->light_drop ? face->drop_min : face->light_drop;
}

/* Every size, at every beginning and end of a row. */
static void sizes(void)
{
    fxl_segment_face face;
    fxl_paint_row row;
    for (uint32_t log_width = FXL_SEGMENT_LOG_MIN; log_width <= 8; log_width++) {
        for (uint32_t log_height = 0; log_height <= 8; log_height++) {
            for (uint32_t i = 0; i < 34u * 3u; i++) {
                const int32_t x0 = (int32_t)(i % 34u);
                const int32_t x1 = x0 + 1 + (int32_t)((any_32() >> 9) % (COLUMNS - 34u));
                choose_texture(&face, log_width, log_height);
                choose_weights(&face, &row, (int64_t)(any_32() >> 2 | 1u << 20) << 32,
                               (int64_t)(any_32() >> 2 | 1u << 20) << 32);
                choose_coordinates(&face, &row);
                choose_drops(&face, -21, 40);
                choose_light(&face, &row, i % 3u == 0 ? 0 : LEVELS - i % LEVELS);
                compare(&face, &row, x0, x1);
            }
        }
    }
}

/* Weights about powers of two, constant and not, with the least drops. */
static void weights(void)
{
    fxl_segment_face face;
    fxl_paint_row row;
    for (uint32_t bits = 1; bits <= 30; bits++) {
        for (uint32_t i = 0; i < 24; i++) {
            const int64_t at = ((int64_t)1 << (bits + 32)) - (i & 1u ? 1 : 0) * ((int64_t)1 << 32);
            const int64_t end = i & 2u ? at : (int64_t)1 << (33 + i);
            const int64_t less = at < end ? at : end;
            int32_t zeros = 0;
            while (less >> (62 - zeros) == 0) {
                zeros++;
            }
            if (less < (int64_t)2 << 32) {
                continue;
            }
            choose_texture(&face, 4u + i % 5u, 4u + i % 5u);
            choose_weights(&face, &row, at, end);
            choose_coordinates(&face, &row);
            choose_drops(&face, zeros + 1 - 32, i & 4u ? 1 : 60);
            choose_light(&face, &row, i & 8u ? LEVELS : 0);
            compare(&face, &row, (int32_t)(i & 15u), (int32_t)COLUMNS - (int32_t)(i >> 1));
        }
    }
}

void test_texture_rows(uint32_t rounds)
{
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(any_32() >> 11);
    }
    for (uint32_t i = 0; i < sizeof ramp; i++) {
        ramp[i] = (uint8_t)(any_32() >> 11);
    }
    sizes();
    weights();
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_segment_face face;
        fxl_paint_row row;
        const uint32_t least = 1u + (any_32() >> 5) % 28u;
        const int32_t x0 = (int32_t)(any_32() >> 8 & 31u);
        choose_texture(&face, 4u + (any_32() >> 5) % 5u, (any_32() >> 5) % 9u);
        choose_weights(&face, &row, (int64_t)(any_64() >> 2 | (uint64_t)1 << (32u + least)),
                       (int64_t)(any_64() >> 2 | (uint64_t)1 << (32u + least)));
        choose_coordinates(&face, &row);
        choose_drops(&face, -1 - (int32_t)least, 50);
        choose_light(&face, &row, (any_32() >> 5) % (LEVELS + 1u));
        compare(&face, &row, x0, x0 + 1 + (int32_t)((any_32() >> 7) % 63u));
    }
}
