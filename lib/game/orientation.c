/* SPDX-License-Identifier: MIT */
/* Orientations from angles and from products. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "fixel/camera.h"
#include "fixel/orientation.h"

/* --- the nearest rotation -------------------------------------------------------------------- */

/* Three rows in units of 2^-60. */
typedef struct {
    int64_t rows[3][3];
} wide_matrix;

/* One step of Newton's method for the polar factor: with E = I - C C', the rotation nearest to C is
 * C + E C / 2 up to 3/8 |E|^2, which is below 2^-45 for |E| <= 2^-22. */

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

/* Writes the rotation that is nearest to a matrix. Requires a matrix C for which no eigenvalue of
 * C C' - I is above 2^-22 in magnitude.
 * Error: at most 0.501 unit of 2^-30 an entry. So a row is at most
 * sqrt(3) * 0.501 = 0.87 unit off unit length, and two rows are 1.74 units off a right angle. */
/* accuracy 1.2, orientation 1.4 */
FXL_COLD static void orthonormalise(const wide_matrix *matrix, fxl_orientation *orientation)
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
static uint32_t in_31_bits(uint64_t magnitude, int shift)
{
    return (uint32_t)(shift > 0 ? (fxl_shifted_down((int64_t)magnitude, (unsigned)shift - 1) + 1) / 2
                                : (int64_t)(magnitude << -shift));
}

/* unit = vector / |vector| in units of 2^-31. Takes components below 2^62. Returns false for a
 * vector of length 0, and leaves unit untouched.
 * Error: at most 1 unit of 2^-31 an entry if every component is below 2^31, else 2.5. */
FXL_COLD static bool unit_length(const int64_t vector[3], int64_t unit[3])
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
        parts[i] = in_31_bits(magnitudes[i], (int)bits - 31);
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

/* --- orientations ---------------------------------------------------------------------------- */

static int64_t widened(fxl_q2_30 entry)
{
    return (int64_t)entry * FXL_Q2_30_ONE;
}

/* The camera's rows are the columns. The camera's entries are at most 1.7 units off; each row and
 * column of them is then off by at most 1.7 sqrt(3). With C = R + e, the nearest rotation is
 * R + (e - R e' R) / 2, of which an entry is at most (1.7 + 3 * 1.7) / 2 = 3.4 units. */
/* orientation 1.1 */
FXL_COLD fxl_status fxl_orientation_from_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll,
                                                fxl_orientation *orientation)
{
    const fxl_pose pose = {{0, 0, 0}, yaw, pitch, roll};
    fxl_camera camera;
    if (orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_status status = fxl_camera_from_pose(&pose, &camera);
    FXL_ASSERT(status == FXL_OK);
    (void)status;
    const fxl_axes *axes = &camera.axes;
    const wide_matrix matrix = {
        {{widened(axes->right.x), widened(axes->up.x), widened(axes->forward.x)},
         {widened(axes->right.y), widened(axes->up.y), widened(axes->forward.y)},
         {widened(axes->right.z), widened(axes->up.z), widened(axes->forward.z)}}};
    orthonormalise(&matrix, orientation);
    return FXL_OK;
}

/* A row of a times b. By Cauchy-Schwarz an entry is at most 2^60 (1 + 2^-24)^2, and so is every
 * partial sum. Exact. */
FXL_COLD static void multiply_row(const fxl_direction *row, const fxl_orientation *b,
                                  int64_t out[3])
{
    out[0] = fxl_multiply_s32(row->x, b->x.x) + fxl_multiply_s32(row->y, b->y.x) +
             fxl_multiply_s32(row->z, b->z.x);
    out[1] = fxl_multiply_s32(row->x, b->x.y) + fxl_multiply_s32(row->y, b->y.y) +
             fxl_multiply_s32(row->z, b->z.y);
    out[2] = fxl_multiply_s32(row->x, b->x.z) + fxl_multiply_s32(row->y, b->y.z) +
             fxl_multiply_s32(row->z, b->z.z);
}

static bool is_rotation(const fxl_orientation *orientation)
{
    const fxl_point origin = {0, 0, 0};
    const fxl_placement placement = {*orientation, FXL_Q16_16_ONE};
    return fxl_placement_check(&placement, &origin, 0) == FXL_OK;
}

/* Two rows of a checked orientation are within 2^-28, and the third is within 2^-26 a component of
 * their cross product. So no eigenvalue of A A' - I is above 2^-24, nor of B B' - I; of the product
 * none is above 2^-23 (1 + 2^-24). */
/* orientation 1.4 */
FXL_COLD fxl_status fxl_orientation_multiply(const fxl_orientation *a, const fxl_orientation *b,
                                             fxl_orientation *product)
{
    if (a == NULL || b == NULL || product == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_rotation(a) || !is_rotation(b)) {
        return FXL_E_PLACEMENT;
    }
    wide_matrix matrix;
    multiply_row(&a->x, b, matrix.rows[0]);
    multiply_row(&a->y, b, matrix.rows[1]);
    multiply_row(&a->z, b, matrix.rows[2]);
    orthonormalise(&matrix, product);
    return FXL_OK;
}

/* An instance that is attached to another. */

/* scale * length in 16.16, for a length of at most 2^61 in units of 2^-46 and a scale of at most
 * 2^24. The length is split at 2^30, so that each product is below 2^56. Rounded once: error half
 * a unit. */
/* orientation 3.1 */
static int64_t scaled(fxl_q18_46 length, fxl_q16_16 scale)
{
    const int64_t high = length >> 30;
    const int64_t low = length & (((int64_t)1 << 30) - 1);
    const int64_t low_part = fxl_multiply_s64(low, scale) + ((int64_t)1 << 45);
    return (fxl_multiply_s64(high, scale) + (low_part >> 30)) >> 16;
}

static bool below_2_to_30(const fxl_point *point)
{
    const int64_t limit = ((int64_t)1 << 30) - 1;
    return fxl_within(point->x, limit) && fxl_within(point->y, limit) &&
           fxl_within(point->z, limit);
}

/* orientation 3.1, 3.2 */
FXL_COLD fxl_status fxl_placement_attach(const fxl_point *parent_centre,
                                         const fxl_placement *parent, const fxl_point *child_centre,
                                         const fxl_placement *child, fxl_point *centre,
                                         fxl_placement *placement)
{
    if (parent_centre == NULL || parent == NULL || child_centre == NULL || child == NULL ||
        centre == NULL || placement == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_point origin = {0, 0, 0};
    fxl_status status = fxl_placement_check(parent, parent_centre, 0);
    if (status == FXL_OK) {
        status = fxl_placement_check(child, &origin, 0);
    }
    if (status != FXL_OK) {
        return status;
    }
    if (!below_2_to_30(child_centre)) {
        return FXL_E_RANGE;
    }
    const fxl_direction *rows[3] = {&parent->orientation.x, &parent->orientation.y,
                                    &parent->orientation.z};
    int64_t at[3] = {parent_centre->x, parent_centre->y, parent_centre->z};
    for (uint32_t i = 0; i < 3; i++) {
        at[i] += scaled(fxl_dot(rows[i], child_centre->x, child_centre->y, child_centre->z),
                        parent->scale);
        if (!fxl_within(at[i], FXL_COORDINATE_MAX)) {
            return FXL_E_RANGE;
        }
    }
    /* Both are at most 2^24, so the product is below 2^49 before it is rounded. */
    const int64_t scale = fxl_round_shift(fxl_multiply_s32(parent->scale, child->scale), 16);
    if (scale > FXL_SCALE_MAX) {
        return FXL_E_RANGE;
    }
    const fxl_point place = {(fxl_q16_16)at[0], (fxl_q16_16)at[1], (fxl_q16_16)at[2]};
    fxl_placement made;
    made.scale = (fxl_q16_16)scale;
    status = fxl_orientation_multiply(&parent->orientation, &child->orientation, &made.orientation);
    FXL_ASSERT(status == FXL_OK);
    status = fxl_placement_check(&made, &place, 0);
    if (status == FXL_OK) {
        *centre = place;
        *placement = made;
    }
    return status;
}

/* Orientations from an axis, and from a direction to look in. */

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
FXL_COLD static void cross(const int64_t a[3], const int64_t b[3], int64_t out[3])
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
/* orientation 1.2 */
FXL_COLD fxl_status fxl_orientation_from_axis(const fxl_point *axis, fxl_angle angle,
                                              fxl_orientation *orientation)
{
    if (axis == NULL || orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    int64_t vector[3], a[3], t[3];
    if (!widen(axis, vector) || !unit_length(vector, a)) {
        return FXL_E_RANGE;
    }
    const int64_t cosine = fxl_cos_q31(angle), sine = fxl_sin_q31(angle);
    /* (1 - cos) / 2 in units of 2^-31; the half unit that is cut off is within the bound. */
    const int64_t half = (((int64_t)1 << 31) - cosine) >> 1;
    wide_matrix matrix;
    for (uint32_t i = 0; i < 3; i++) {
        t[i] = fxl_round_shift(fxl_multiply_s64(half, a[i]), 31);
    }
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t j = after[i][0], k = after[i][1];
        const int64_t across = fxl_multiply_s64(sine, a[k]) >> 2;
        const int64_t both =
            fxl_multiply_s64(t[i], a[j]) >> 1; /* t a' is symmetric but for 2^-32 */
        matrix.rows[i][i] = cosine * ((int64_t)1 << 29) + (fxl_multiply_s64(t[i], a[i]) >> 1);
        matrix.rows[i][j] = both - across;
        matrix.rows[j][i] = both + across;
    }
    orthonormalise(&matrix, orientation);
    return FXL_OK;
}

/* The columns are right, up and forward. right is up cross forward: the cross product of integers
 * is exact, so that its direction is as good where the two are nearly parallel. */
/* orientation 1.3 */
FXL_COLD fxl_status fxl_orientation_look_at(const fxl_point *direction, const fxl_point *up,
                                            fxl_orientation *orientation)
{
    if (direction == NULL || up == NULL || orientation == NULL) {
        return FXL_E_ARGUMENT;
    }
    int64_t ahead[3], above[3], across[3], forward[3], right[3], upward[3];
    if (!widen(direction, ahead) || !widen(up, above) || !unit_length(ahead, forward)) {
        return FXL_E_RANGE;
    }
    cross(above, ahead, across);
    if (!unit_length(across, right)) {
        return FXL_E_RANGE;
    }
    cross(forward, right, upward); /* in units of 2^-62 */
    wide_matrix matrix;
    for (uint32_t i = 0; i < 3; i++) {
        matrix.rows[i][0] = right[i] * ((int64_t)1 << 29);
        matrix.rows[i][1] = upward[i] >> 2;
        matrix.rows[i][2] = forward[i] * ((int64_t)1 << 29);
    }
    orthonormalise(&matrix, orientation);
    return FXL_OK;
}
