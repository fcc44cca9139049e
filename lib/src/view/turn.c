/* SPDX-License-Identifier: MIT */
/* The numbers of a turned instance. Rows and columns of a checked orientation are at most
 * 1 + 11 2^-28 long (turn_check.c), so a product of one with differences below 2^30 is below 2^61,
 * as with a unit vector (fxl_dot). Their entries exceed 2^30 by less than 2^6, which
 * fxl_multiply_s31 allows for both factors: where the upper half of a factor is 2^14 or more, its
 * lower half is below 2^6, and where it is -2^14 - 1, the middle products add up to more than
 * -2^31. */
#include "fixel/stage/turn.h"

#include "../math/arith.h"

/* floor(value * scale / 2^32). |value| < 2^61 and scale <= 2^24: the result is below 2^53. */
static int64_t scaled(int64_t value, fxl_q16_16 scale)
{
    const uint64_t low = fxl_multiply_u32((uint32_t)value, (uint32_t)scale);
    return fxl_multiply_s32((int32_t)(value >> 32), scale) + (int64_t)(low >> 32);
}

/* One row of the matrix, in units of 2^-60: a row of the view times the orientation's columns. */
static void row_times(const fxl_direction *row, const fxl_orientation *of, int64_t entries[3])
{
    entries[0] = fxl_multiply_s31(row->x, of->x.x) + fxl_multiply_s31(row->y, of->y.x) +
                 fxl_multiply_s31(row->z, of->z.x);
    entries[1] = fxl_multiply_s31(row->x, of->x.y) + fxl_multiply_s31(row->y, of->y.y) +
                 fxl_multiply_s31(row->z, of->z.y);
    entries[2] = fxl_multiply_s31(row->x, of->x.z) + fxl_multiply_s31(row->y, of->y.z) +
                 fxl_multiply_s31(row->z, of->z.z);
}

unsigned fxl_turn_matrix(const fxl_turn *turn, const fxl_axes *view, fxl_axes *matrix)
{
    const fxl_direction *const from[3] = {&view->right, &view->up, &view->forward};
    fxl_direction *const to[3] = {&matrix->right, &matrix->up, &matrix->forward};
    const fxl_q16_16 scale = turn->scale;
    unsigned shift = 0;
    int64_t entries[3];
    if (scale == FXL_Q16_16_ONE) {
        for (uint32_t i = 0; i < 3; i++) {
            row_times(from[i], &turn->orientation, entries);
            to[i]->x = (fxl_q2_30)fxl_round_shift(entries[0], 30);
            to[i]->y = (fxl_q2_30)fxl_round_shift(entries[1], 30);
            to[i]->z = (fxl_q2_30)fxl_round_shift(entries[2], 30);
        }
        return 0;
    }
    while (FXL_Q16_16_ONE << shift < scale) { /* bug: turn-shift */
        shift++;
    }
    for (uint32_t i = 0; i < 3; i++) {
        /* The 32 bits that scaled leaves out are below the half unit that the rounding adds. */
        row_times(from[i], &turn->orientation, entries);
        to[i]->x = (fxl_q2_30)fxl_round_shift(scaled(entries[0], scale), 14 + shift);
        to[i]->y = (fxl_q2_30)fxl_round_shift(scaled(entries[1], scale), 14 + shift);
        to[i]->z = (fxl_q2_30)fxl_round_shift(scaled(entries[2], scale), 14 + shift);
    }
    return shift;
}

static int32_t along(const fxl_direction *row, const fxl_point *vertex, fxl_q16_16 scale)
{
    const int64_t sum = fxl_multiply_s31(row->x, vertex->x) + fxl_multiply_s31(row->y, vertex->y) +
                        fxl_multiply_s31(row->z, vertex->z);
    return (int32_t)fxl_round_shift(scaled(sum, scale), 14);
}

void fxl_turn_point(const fxl_turn *turn, const fxl_point *centre, const fxl_point *vertex,
                    fxl_point *point)
{
    point->x = centre->x + along(&turn->orientation.x, vertex, turn->scale);
    point->y = centre->y + along(&turn->orientation.y, vertex, turn->scale);
    point->z = centre->z + along(&turn->orientation.z, vertex, turn->scale);
    FXL_ASSERT(fxl_point_in_range(point));
}

void fxl_turn_direction(const fxl_turn *turn, const fxl_direction *direction, fxl_direction *turned)
{
    const fxl_point as_point = {direction->x, direction->y, direction->z};
    turned->x = along(&turn->orientation.x, &as_point, FXL_Q16_16_ONE);
    turned->y = along(&turn->orientation.y, &as_point, FXL_Q16_16_ONE);
    turned->z = along(&turn->orientation.z, &as_point, FXL_Q16_16_ONE);
}

/* orientation^T . (eye - centre), exact, in units of 2^-46. */
static void eye_along(const fxl_orientation *of, const fxl_point *from_eye, fxl_q18_46 eye[3])
{
    const int32_t x = -from_eye->x, y = -from_eye->y, z = -from_eye->z;
    eye[0] =
        fxl_multiply_s31(of->x.x, x) + fxl_multiply_s31(of->y.x, y) + fxl_multiply_s31(of->z.x, z);
    eye[1] =
        fxl_multiply_s31(of->x.y, x) + fxl_multiply_s31(of->y.y, y) + fxl_multiply_s31(of->z.y, z);
    eye[2] =
        fxl_multiply_s31(of->x.z, x) + fxl_multiply_s31(of->y.z, y) + fxl_multiply_s31(of->z.z, z);
}

/* value / (scale 2^(14 + shift)), rounded: floor((value + half) / divisor), in two exact floors.
 * half is below 2^24 2^23. Returns false if the quotient exceeds 2^30. */
static inline bool divide(int64_t value, fxl_q16_16 scale, unsigned shift, int32_t *quotient)
{
    const int64_t half = (int64_t)scale << (13 + shift);
    const int64_t numerator = (value + half) >> (14 + shift);
    if (!fxl_within(numerator, (int64_t)scale << 30)) {
        return false;
    }
    *quotient = scale == FXL_Q16_16_ONE ? (int32_t)(numerator >> 16)
                                        : fxl_divide_down(numerator, (uint32_t)scale);
    return true;
}

unsigned fxl_turn_eye(const fxl_turn *turn, const fxl_point *from_eye, fxl_q16_16 radius,
                      fxl_point *eye)
{
    const fxl_q16_16 scale = turn->scale;
    fxl_q18_46 exact[3];
    unsigned shift = 0;
    int32_t limit = (1 << 30) - 1 - radius; /* bug: turn-eye-near */
    eye_along(&turn->orientation, from_eye, exact);
    while (!(divide(exact[0], scale, shift, &eye->x) && divide(exact[1], scale, shift, &eye->y) &&
             divide(exact[2], scale, shift, &eye->z) && fxl_within(eye->x, limit) &&
             fxl_within(eye->y, limit) && fxl_within(eye->z, limit))) {
        shift++;
        limit = (1 << 30) - 1 - (radius >> shift);
    }
    return shift;
}

/* Both sides in units of 2^-76, as upper * 2^32 + lower, 0 <= lower < 2^32. Left: with
 * e = upper * 2^32 + lower along each axis, |upper| < 2^29 and |normal| sums up to less than
 * 1.74 2^30, so both sums are below 2^63. Right: scale * height * 2^14, with |scale * height| below
 * 2^14 units, 2^76 of 2^-62. */
bool fxl_turn_is_front(const fxl_turn *turn, const fxl_point *from_eye, const fxl_direction *normal,
                       fxl_q18_46 height)
{
    const int32_t of[3] = {normal->x, normal->y, normal->z};
    fxl_q18_46 eye[3];
    int64_t upper = 0, lower = 0;
    eye_along(&turn->orientation, from_eye, eye);
    for (uint32_t i = 0; i < 3; i++) {
        upper += fxl_multiply_s32(of[i], (int32_t)(eye[i] >> 32));
        lower += fxl_multiply_su32(of[i], (uint32_t)eye[i]);
    }
    const uint64_t low = fxl_multiply_u32((uint32_t)height, (uint32_t)turn->scale);
    const int64_t high =
        fxl_multiply_s32((int32_t)(height >> 32), turn->scale) + (int64_t)(low >> 32);
    const int64_t right_upper = (int64_t)((uint64_t)high << 14) + (int64_t)((uint32_t)low >> 18);
    const uint32_t right_lower = (uint32_t)low << 14;
    upper += (lower >> 32) - right_upper;
    return upper > 0 || (upper == 0 && (uint32_t)lower > right_lower); /* bug: turn-facing-low */
}
