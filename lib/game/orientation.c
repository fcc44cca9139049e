/* SPDX-License-Identifier: MIT */
/* Orientations from angles and from products. */
#include "../math/arith.h"
#include "../math/sine.h"
#include "fixel/camera.h"
#include "fixel/orientation.h"
#include "orthonormal.h"

static int64_t widened(fxl_q2_30 entry)
{
    return (int64_t)entry * FXL_Q2_30_ONE;
}

/* The camera's rows are the columns. The camera's entries are at most 1.7 units off; each row and
 * column of them is then off by at most 1.7 sqrt(3). With C = R + e, the nearest rotation is
 * R + (e - R e' R) / 2, of which an entry is at most (1.7 + 3 * 1.7) / 2 = 3.4 units. */
fxl_status fxl_orientation_from_angles(fxl_angle yaw, fxl_angle pitch, fxl_angle roll,
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
    const fxl_wide_matrix matrix = {
        {{widened(axes->right.x), widened(axes->up.x), widened(axes->forward.x)},
         {widened(axes->right.y), widened(axes->up.y), widened(axes->forward.y)},
         {widened(axes->right.z), widened(axes->up.z), widened(axes->forward.z)}}};
    fxl_orthonormalise(&matrix, orientation);
    return FXL_OK;
}

/* A row of a times b. By Cauchy-Schwarz an entry is at most 2^60 (1 + 2^-24)^2, and so is every
 * partial sum. Exact. */
static void multiply_row(const fxl_direction *row, const fxl_orientation *b, int64_t out[3])
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
fxl_status fxl_orientation_multiply(const fxl_orientation *a, const fxl_orientation *b,
                                    fxl_orientation *product)
{
    if (a == NULL || b == NULL || product == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!is_rotation(a) || !is_rotation(b)) {
        return FXL_E_PLACEMENT;
    }
    fxl_wide_matrix matrix;
    multiply_row(&a->x, b, matrix.rows[0]);
    multiply_row(&a->y, b, matrix.rows[1]);
    multiply_row(&a->z, b, matrix.rows[2]);
    fxl_orthonormalise(&matrix, product);
    return FXL_OK;
}

/* An instance that is attached to another. */

/* scale * length in 16.16, for a length of at most 2^61 in units of 2^-46 and a scale of at most
 * 2^24. The length is split at 2^30, so that each product is below 2^56. Rounded once: error half
 * a unit. */
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

fxl_status fxl_placement_attach(const fxl_point *parent_centre, const fxl_placement *parent,
                                const fxl_point *child_centre, const fxl_placement *child,
                                fxl_point *centre, fxl_placement *placement)
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
        const int64_t across = fxl_multiply_s64(sine, a[k]) >> 2;
        const int64_t both =
            fxl_multiply_s64(t[i], a[j]) >> 1; /* t a' is symmetric but for 2^-32 */
        matrix.rows[i][i] = cosine * ((int64_t)1 << 29) + (fxl_multiply_s64(t[i], a[i]) >> 1);
        matrix.rows[i][j] = both - across;
        matrix.rows[j][i] = both + across;
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
