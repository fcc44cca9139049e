/* SPDX-License-Identifier: MIT */
/* The kernel that paints rows of a textured face whose pixels are each divided. Each side writes
 * into memory of its own, all of which must be equal. */

#include "equality.h"
#include "sides.h"

#define COLUMNS 96u

static uint8_t texels[65536];
static uint8_t by_core[COLUMNS + 32u], by_portable[COLUMNS + 32u];

/* A number below 2^bits and above -2^bits. */
static int64_t any_value(uint32_t bits)
{
    const int64_t value = (int64_t)(any_64() >> (64u - bits));
    return any_32() >> 9 & 1u ? value : -value;
}

/* A slope such that a value moves by at most so much in all columns; the steps of 16 columns follow
 * from it. */
static int64_t any_slope(uint32_t bits, int64_t *step)
{
    const int64_t slope = any_value(bits) / (int64_t)COLUMNS;
    *step = slope * 16;
    return slope;
}

static void compare(const fxl_divided_face *face, fxl_paint_row *row, int32_t x0, int32_t x1)
{
    row->pixels = by_core + 16;
    const int32_t core_end = fxl_paint_divided(face, row, x0, x1);
    row->pixels = by_portable + 16;
    bool same = portable_paint_divided(face, row, x0, x1) == core_end;
    for (uint32_t i = 0; i < sizeof by_core; i++) {
        same &= by_core[i] == by_portable[i];
        by_core[i] = by_portable[i] = 0xA5;
    }
    equality_case(same);
}

void test_divided_rows(uint32_t rounds)
{
    for (uint32_t i = 0; i < sizeof texels; i++) {
        texels[i] = (uint8_t)(any_32() >> 11);
    }
    for (uint32_t i = 0; i < rounds; i++) {
        fxl_divided_face face;
        fxl_paint_row row;
        const uint32_t bits = 34u + (any_32() >> 5) % 29u, size = 34u + (any_32() >> 7) % 29u;
        const uint32_t log_width = 4u + (any_32() >> 5) % 5u, log_height = (any_32() >> 5) % 9u;
        const int32_t x0 = (int32_t)(any_32() >> 8 & 31u);
        row.weight = (int64_t)(any_64() >> (64u - bits)) | (int64_t)1 << (bits - 1u);
        face.weight_slope = any_slope(bits, &face.weight_step);
        row.attributes[FXL_ATTRIBUTE_U] = any_value(size);
        row.attributes[FXL_ATTRIBUTE_V] = any_value(size);
        face.u_slope = any_slope(size, &face.u_step);
        face.v_slope = any_slope(size, &face.v_step);
        /* About what lets the coordinates fill a word, more or less. */
        face.u_shift = (int32_t)bits - (int32_t)size - 2 - (int32_t)((any_32() >> 6) % 6u);
        face.v_shift = i % 16u == 0 ? -40 : face.u_shift + 1 - (int32_t)((any_32() >> 6) % 3u);
        face.texels = texels;
        face.columns_mask = (1u << log_width) - 1u;
        face.rows_mask = ((1u << log_height) - 1u) << log_width;
        face.kind = (uint8_t)((any_32() >> 7) % 6u);
        face.v_drop = face.kind == FXL_TEXELS_PLAIN ? FXL_DIVIDED_V_BITS
                                                    : (uint8_t)((any_32() >> 9) % 12u);
        if (face.kind == FXL_TEXELS_4) {
            face.colours = texels;
        } else {
            face.key = any_32() >> 9 & 1u ? any_32() >> 24 : any_32();
        }
        if (face.kind == FXL_TEXELS_CLAMPED) {
            face.columns_mask = 16u - log_width;
            face.v_drop = (uint8_t)(16u - log_width - log_height);
            face.u_shift += (int32_t)((any_32() >> 6) % 4u);
        }
        row.y = (int32_t)(any_32() >> 25);
        compare(&face, &row, x0, x0 + 1 + (int32_t)((any_32() >> 7) % 63u));
    }
}
