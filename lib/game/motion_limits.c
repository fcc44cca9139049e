/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../scene/motion_limits.h"
#include "fixel/player.h"

/* Both are at most 2^24: the product is at most 2^48. */
static fxl_q16_16 product(fxl_q16_16 limit, fxl_q16_16 factor)
{
    const int64_t exact = fxl_round_shift(fxl_multiply_s32(limit, factor), 16);
    return exact > FXL_MOTION_MAX ? -1 : (fxl_q16_16)exact; /* -1: out of range */
}

fxl_status fxl_scale_motion_limits(const fxl_motion_limits *limits, fxl_q16_16 factor,
                                   fxl_motion_limits *scaled)
{
    if (limits == NULL || scaled == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (factor < 0 || factor > FXL_MOTION_MAX || !fxl_motion_limits_in_range(limits)) {
        return FXL_E_RANGE;
    }
    const fxl_motion_limits by = {product(limits->acceleration, factor),
                                  product(limits->friction, factor),
                                  product(limits->speed_max, factor), limits->turn};
    if (!fxl_motion_limits_in_range(&by)) {
        return FXL_E_RANGE;
    }
    *scaled = by;
    return FXL_OK;
}
