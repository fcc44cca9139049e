/* SPDX-License-Identifier: MIT */
#include "placements.h"

#include <math.h>

static fxl_q2_30 rounded(double value)
{
    return (fxl_q2_30)floor(value * FXL_Q2_30_ONE + 0.5);
}

/* From a unit quaternion a + bi + cj + dk. */
fxl_orientation placements_orientation(void)
{
    double q[4], length;
    do {
        length = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = unit_between(-1000000, 1000000);
            length += q[i] * q[i];
        }
    } while (length < 1e6);
    const double a = q[0] / sqrt(length), b = q[1] / sqrt(length), c = q[2] / sqrt(length),
                 d = q[3] / sqrt(length);
    return (fxl_orientation){{rounded(1 - 2 * (c * c + d * d)), rounded(2 * (b * c - a * d)),
                              rounded(2 * (b * d + a * c))},
                             {rounded(2 * (b * c + a * d)), rounded(1 - 2 * (b * b + d * d)),
                              rounded(2 * (c * d - a * b))},
                             {rounded(2 * (b * d - a * c)), rounded(2 * (c * d + a * b)),
                              rounded(1 - 2 * (b * b + c * c))}};
}

fxl_placement placements_any(void)
{
    fxl_placement placement = {placements_orientation(), FXL_Q16_16_ONE};
    const uint32_t kind = unit_random() % 8;
    if (kind == 0) {
        placement.scale = unit_between(0, 1) ? FXL_SCALE_MIN : FXL_SCALE_MAX;
    } else if (kind >= 3) {
        placement.scale = unit_between(FXL_SCALE_MIN, FXL_SCALE_MAX) >> unit_between(0, 16);
        placement.scale = placement.scale < FXL_SCALE_MIN ? FXL_SCALE_MIN : placement.scale;
    }
    return placement;
}
