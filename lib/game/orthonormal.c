/* SPDX-License-Identifier: MIT */
/* One step of Newton's method for the polar factor: with E = I - C C', the rotation nearest to C is
 * C + E C / 2 up to 3/8 |E|^2, which is below 2^-45 for |E| <= 2^-22. */
#include "../math/arith.h"
#include "../math/unit_vector.h"
#include "orthonormal.h"

/* A row as 2.30 and the rest, |rest| <= 2^29 units of 2^-60. */
typedef struct {
    int32_t head[3], tail[3];
} split_row;

static void split(const int64_t row[3], split_row *parts)
{
    for (uint32_t i = 0; i < 3; i++) {
        parts->head[i] = (int32_t)fxl_round_shift(row[i], 30);
        parts->tail[i] = (int32_t)(row[i] - (int64_t)parts->head[i] * FXL_Q2_30_ONE);
    }
}

/* a . b in units of 2^-60, without the product of the rests, which is below one unit. The product
 * of the heads is at most 2^60 (1 + 2^-22). A head times a rest is below 2^60, and a sum of six
 * below 2^63. Error: 2 units. */
static int64_t product(const split_row *a, const split_row *b)
{
    int64_t heads = 0, rests = 0;
    for (uint32_t i = 0; i < 3; i++) {
        heads += fxl_multiply_s32(a->head[i], b->head[i]);
        rests +=
            fxl_multiply_s32(a->head[i], b->tail[i]) + fxl_multiply_s32(a->tail[i], b->head[i]);
    }
    return heads + fxl_round_shift(rests, 30);
}

void fxl_orthonormalise(const fxl_wide_matrix *matrix, fxl_orientation *orientation)
{
    split_row rows[3];
    int32_t lack[3][3]; /* E in units of 2^-46: at most 2^24. Rounding costs 2^-47 */
    fxl_direction *const out[3] = {&orientation->x, &orientation->y, &orientation->z};
    for (uint32_t i = 0; i < 3; i++) {
        split(matrix->rows[i], &rows[i]);
        for (uint32_t j = 0; j <= i; j++) {
            const int64_t one = i == j ? (int64_t)1 << 60 : 0;
            const int64_t error = one - product(&rows[i], &rows[j]);
            FXL_ASSERT(fxl_within(error, (int64_t)1 << 38));
            lack[i][j] = lack[j][i] = (int32_t)fxl_round_shift(error, 14);
        }
    }
    for (uint32_t i = 0; i < 3; i++) {
        int32_t entries[3];
        for (uint32_t k = 0; k < 3; k++) {
            int64_t sum = 0; /* E C in units of 2^-76: three products below 2^55 */
            for (uint32_t j = 0; j < 3; j++) {
                sum += fxl_multiply_s32(lack[i][j], rows[j].head[k]);
            }
            const int64_t half = fxl_round_shift(sum, 17);
            /* In units of 2^-60. The only rounding that counts is this one. */
            entries[k] = (int32_t)fxl_round_shift(matrix->rows[i][k] + half, 30);
        }
        out[i]->x = entries[0];
        out[i]->y = entries[1];
        out[i]->z = entries[2];
    }
}

/* Shifted so that the largest component has 31 bits. Rounding a longer one may make it 2^31. */
static uint32_t scaled(uint64_t magnitude, int shift)
{
    return (uint32_t)(shift > 0 ? (uint64_t)fxl_round_shift((int64_t)magnitude, (unsigned)shift)
                                : magnitude << -shift);
}

bool fxl_unit_length(const int64_t vector[3], int64_t unit[3])
{
    const uint64_t magnitudes[3] = {fxl_magnitude(vector[0]), fxl_magnitude(vector[1]),
                                    fxl_magnitude(vector[2])};
    const unsigned bits = fxl_bit_length(magnitudes[0] | magnitudes[1] | magnitudes[2]);
    uint32_t parts[3];
    uint64_t square = 0; /* at most 3 * 2^62, which the square root takes */
    if (bits == 0) {
        return false;
    }
    for (uint32_t i = 0; i < 3; i++) {
        parts[i] = scaled(magnitudes[i], (int)bits - 31);
        square += fxl_multiply_u32(parts[i], parts[i]);
    }
    const uint32_t length = fxl_square_root(square); /* 2^30 at least, and no part is longer */
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t tail;
        const uint64_t dividend = ((uint64_t)parts[i] << 31) + (length >> 1);
        const int64_t part = fxl_divide_u64(dividend, length, &tail);
        unit[i] = vector[i] < 0 ? -part : part;
    }
    return true;
}
