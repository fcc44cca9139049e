/* SPDX-License-Identifier: MIT */
/* An instance that is attached to another. */
#include "fixel/orientation.h"

#include "../math/arith.h"

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

fxl_status fxl_turn_attach(const fxl_point *parent_centre, const fxl_turn *parent,
                           const fxl_point *child_centre, const fxl_turn *child, fxl_point *centre,
                           fxl_turn *turn)
{
    if (parent_centre == NULL || parent == NULL || child_centre == NULL || child == NULL ||
        centre == NULL || turn == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_point origin = {0, 0, 0};
    fxl_status status = fxl_turn_check(parent, parent_centre, 0);
    if (status == FXL_OK) {
        status = fxl_turn_check(child, &origin, 0);
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
    fxl_turn made;
    made.scale = (fxl_q16_16)scale;
    status = fxl_orientation_multiply(&parent->orientation, &child->orientation, &made.orientation);
    FXL_ASSERT(status == FXL_OK);
    status = fxl_turn_check(&made, &place, 0);
    if (status == FXL_OK) {
        *centre = place;
        *turn = made;
    }
    return status;
}
