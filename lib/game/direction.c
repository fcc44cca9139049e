/* SPDX-License-Identifier: MIT */
/* Orientations from an axis, and from a direction to look in. */
#include "fixel/orientation.h"

#include "../math/arith.h"
#include "../math/sine.h"
#include "orthonormal.h"
#include "unit_length.h"

/* The two components after i, in the order x, y, z, x, y. */
static const uint8_t after[3][2] = {{1, 2}, {2, 0}, {0, 1}};

/* Whether each coordinate is below 2^30 in magnitude; widens them. */
static bool widen(const fxl_point *point, int64_t wide[3])
{
    const int64_t limit = ((int64_t)1 << 30) - 1;
    wide[0] = point->x;
    wide[1] = point->y;
    wide[2] = point->z;
    return fxl_within(wide[0], limit) && fxl_within(wide[1], limit) && fxl_within(wide[2], limit);
}

/* a cross b. Requires components of at most 2^31: each product is at most 2^62. */
static void cross(const int64_t a[3], const int64_t b[3], int64_t out[3])
{
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t j = after[i][0], k = after[i][1];
        out[i] = fxl_multiply_s64(a[j], b[k]) - fxl_multiply_s64(a[k], b[j]);
    }
}

/* cos I + (1 - cos) a a' + sin [a]. With t = a (1 - cos) / 2, rounded once to 2^-31, a product t a
 * is at most 2^62, and so is sin times a. Bound of an entry before it is made orthonormal: the
 * cosine and the sine are 0.52 unit of 2^-31 off, the axis 1 unit, t 1.5 units: below 3.3 units of
 * 2^-31, which is 1.65 units of 2^-30. */
fxl_status fxl_orientation_from_axis(const fxl_point *axis, fxl_angle angle,
                                     fxl_orientation *orientation)
{
    if (axis == NULL || orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    int64_t vector[3], a[3], t[3];
    if (!widen(axis, vector) || !fxl_unit_length(vector, a)) {
        return FXL_E_RANGE;
    }
    const int64_t cosine = fxl_cos_q31(angle), sine = fxl_sin_q31(angle);
    /* (1 - cos) / 2 in units of 2^-31; the half unit that is cut off is within the bound. */
    const int64_t half = (((int64_t)1 << 31) - cosine) >> 1;
    fxl_wide_matrix matrix;
    for (uint32_t i = 0; i < 3; i++) {
        t[i] = fxl_round_shift(fxl_multiply_s64(half, a[i]), 31);
    }
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t j = after[i][0], k = after[i][1];
        const int64_t turn = fxl_multiply_s64(sine, a[k]) >> 2;
        const int64_t both =
            fxl_multiply_s64(t[i], a[j]) >> 1; /* t a' is symmetric but for 2^-32 */
        matrix.rows[i][i] = cosine * ((int64_t)1 << 29) + (fxl_multiply_s64(t[i], a[i]) >> 1);
        matrix.rows[i][j] = both - turn;
        matrix.rows[j][i] = both + turn;
    }
    fxl_orthonormalise(&matrix, orientation);
    return FXL_OK;
}

/* The columns are right, up and forward. right is up cross forward: the cross product of integers
 * is exact, so that its direction is as good where the two are nearly parallel. */
fxl_status fxl_orientation_look_at(const fxl_point *direction, const fxl_point *up,
                                   fxl_orientation *orientation)
{
    if (direction == NULL || up == NULL || orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    int64_t ahead[3], above[3], across[3], forward[3], right[3], upward[3];
    if (!widen(direction, ahead) || !widen(up, above) || !fxl_unit_length(ahead, forward)) {
        return FXL_E_RANGE;
    }
    cross(above, ahead, across);
    if (!fxl_unit_length(across, right)) {
        return FXL_E_RANGE;
    }
    cross(forward, right, upward); /* in units of 2^-62 */
    fxl_wide_matrix matrix;
    for (uint32_t i = 0; i < 3; i++) {
        matrix.rows[i][0] = right[i] * ((int64_t)1 << 29);
        matrix.rows[i][1] = upward[i] >> 2;
        matrix.rows[i][2] = forward[i] * ((int64_t)1 << 29);
    }
    fxl_orthonormalise(&matrix, orientation);
    return FXL_OK;
}
