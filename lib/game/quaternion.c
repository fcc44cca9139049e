/* SPDX-License-Identifier: MIT */
/* Orientations from quaternions, and back. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "fixel/orientation.h"

/* --- from a quaternion ----------------------------------------------------------------------- */

/* part / norm in units of 2^-30, to the nearest; halves go away from 0. Each round of the long
 * division doubles a rest that is at most the norm, so at most 2^62: it stays within 2^63. */
/* orientation 1.5 */
FXL_COLD static fxl_q2_30 over_norm(int64_t part, int64_t norm)
    FXL_REQUIRES(norm > 0 && norm <= (int64_t)1 << 62 && fxl_within(part, norm)) FXL_ASSIGNS()
        FXL_ENSURES(FXL_BELOW(FXL_RESULT, FXL_Q2_30_ONE))
{
    const uint64_t whole = (uint64_t)norm;
    uint64_t rest = fxl_magnitude(part);
    int32_t quotient = 0;
    for (uint32_t i = 0; i < 30; i++) {
        rest *= 2;
        quotient *= 2;
        if (rest >= whole) {
            rest -= whole;
            quotient += 1;
        }
    }
    if (2 * rest >= whole) {
        quotient += 1;
    }
    return part < 0 ? -quotient : quotient;
}

#define PRODUCT_MAX ((int64_t)1 << 60)

/* The products of two numbers of at most 2^30 are at most 2^60, and the norm, the sum of four
 * squares, at most 2^62. 2 |a b| is at most a a + b b: so no part is above the norm. */
/* orientation 1.5, 1.7 */
FXL_COLD fxl_status fxl_orientation_from_quaternion(const fxl_quaternion *quaternion,
                                                    fxl_orientation *orientation)
{
    if (quaternion == NULL || orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    const int32_t w = quaternion->w, x = quaternion->x, y = quaternion->y, z = quaternion->z;
    if (!fxl_within(w, FXL_Q2_30_ONE) || !fxl_within(x, FXL_Q2_30_ONE) ||
        !fxl_within(y, FXL_Q2_30_ONE) || !fxl_within(z, FXL_Q2_30_ONE)) {
        return FXL_E_RANGE;
    }
    const int64_t ww = fxl_multiply_s32(w, w), xx = fxl_multiply_s32(x, x);
    const int64_t yy = fxl_multiply_s32(y, y), zz = fxl_multiply_s32(z, z);
    const int64_t xy = fxl_multiply_s32(x, y), wz = fxl_multiply_s32(w, z);
    const int64_t xz = fxl_multiply_s32(x, z), wy = fxl_multiply_s32(w, y);
    const int64_t yz = fxl_multiply_s32(y, z), wx = fxl_multiply_s32(w, x);
    FXL_LEMMA(FXL_BELOW(xy, PRODUCT_MAX) && FXL_BELOW(xz, PRODUCT_MAX) && FXL_BELOW(yz, PRODUCT_MAX));
    FXL_LEMMA(FXL_BELOW(wx, PRODUCT_MAX) && FXL_BELOW(wy, PRODUCT_MAX) && FXL_BELOW(wz, PRODUCT_MAX));
    FXL_LEMMA(FXL_BELOW(ww, PRODUCT_MAX) && FXL_BELOW(xx, PRODUCT_MAX) && ww >= 0 && xx >= 0);
    FXL_LEMMA(FXL_BELOW(yy, PRODUCT_MAX) && FXL_BELOW(zz, PRODUCT_MAX) && yy >= 0 && zz >= 0);
    const int64_t norm = ww + xx + yy + zz;
    const int64_t parts[3][3] = {{ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy)},
                                 {2 * (xy + wz), ww - xx + yy - zz, 2 * (yz - wx)},
                                 {2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz}};
    fxl_direction *const out[3] = {&orientation->x, &orientation->y, &orientation->z};
    if (norm == 0) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < 3; i++) {
        FXL_LEMMA(fxl_within(parts[i][0], norm) && fxl_within(parts[i][1], norm) &&
                  fxl_within(parts[i][2], norm));
        out[i]->x = over_norm(parts[i][0], norm);
        out[i]->y = over_norm(parts[i][1], norm);
        out[i]->z = over_norm(parts[i][2], norm);
    }
    return FXL_OK;
}

/* --- and back -------------------------------------------------------------------------------- */

/* difference / (4 root), a number of the quaternion in units of 2^-30, to the nearest: the
 * difference of two entries in units of 2^-30 is at most 2^31, times 2^29 at most 2^60, and the root
 * in units of 2^-31 is 2^30 at least. */
FXL_COLD static int32_t beside_root(int64_t difference, uint32_t root)
    FXL_REQUIRES(fxl_within(difference, (int64_t)1 << 31) && root >= (uint32_t)1 << 30)
        FXL_ASSIGNS() FXL_ENSURES(FXL_RESULT > INT32_MIN)
{
    uint32_t rest;
    const uint64_t dividend = (fxl_magnitude(difference) << 29) + (root >> 1);
    const int32_t number = (int32_t)fxl_divide_u64(dividend, root, &rest);
    return difference < 0 ? -number : number;
}

/* With the largest number r of the quaternion, which is half at least, 4 r r is 1 plus three
 * entries of the diagonal, and 4 r times another number is a sum or a difference of two entries.
 * Each entry of the nearest rotation is off by 0.501. So 4 r r is off by 1.51, r by 1.51 / (8 r) <=
 * 0.38 and by the rounding of the root by 0.25 more: 0.63, and 0.5 when it is rounded. Another
 * number is off by 1.01 / (4 r) <= 0.51, by 0.63 of the divisor, for it is not larger than r,
 * and by its rounding: 1.64. The four squares make 4: so the largest is 1 at least, of any rows.
 * Requires entries within 2^30. */
FXL_COLD static void quaternion_of(const fxl_orientation *nearest, fxl_quaternion *quaternion)
{
    const int64_t a = nearest->x.x, b = nearest->y.y, c = nearest->z.z;
    const int64_t squares[4] = {FXL_Q2_30_ONE + a + b + c, FXL_Q2_30_ONE + a - b - c,
                                FXL_Q2_30_ONE - a + b - c, FXL_Q2_30_ONE - a - b + c};
    const int64_t across[3] = {(int64_t)nearest->z.y - nearest->y.z,
                               (int64_t)nearest->x.z - nearest->z.x,
                               (int64_t)nearest->y.x - nearest->x.y};
    const int64_t both[3] = {(int64_t)nearest->z.y + nearest->y.z,
                             (int64_t)nearest->x.z + nearest->z.x,
                             (int64_t)nearest->y.x + nearest->x.y};
    uint32_t largest = 0;
    for (uint32_t i = 1; i < 4; i++) {
        largest = squares[i] > squares[largest] ? i : largest;
    }
    /* Its square is 2^30 at least, and at most 2^32: the root is in units of 2^-31. */
    const uint32_t root = fxl_square_root((uint64_t)squares[largest] << 30);
    int32_t numbers[4];
    for (uint32_t i = 0; i < 4; i++) {
        if (i == largest) {
            numbers[i] = (int32_t)((root + 1) >> 1);
        } else if (i == 0 || largest == 0) {
            numbers[i] = beside_root(across[i + largest - 1], root);
        } else {
            numbers[i] = beside_root(both[5 - i - largest], root);
        }
    }
    const bool is_turned = numbers[0] < 0;
    quaternion->w = is_turned ? -numbers[0] : numbers[0];
    quaternion->x = is_turned ? -numbers[1] : numbers[1];
    quaternion->y = is_turned ? -numbers[2] : numbers[2];
    quaternion->z = is_turned ? -numbers[3] : numbers[3];
}

/* orientation 1.6 */
FXL_COLD fxl_status fxl_orientation_to_quaternion(const fxl_orientation *orientation,
                                                  fxl_quaternion *quaternion)
{
    static const fxl_orientation none = FXL_ORIENTATION_NONE;
    fxl_orientation nearest;
    if (quaternion == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = fxl_orientation_multiply(&none, orientation, &nearest);
    if (status == FXL_OK) {
        quaternion_of(&nearest, quaternion);
    }
    return status;
}
