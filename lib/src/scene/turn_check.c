/* SPDX-License-Identifier: MIT */
#include "fixel/stage/turn.h"

#include "../math/arith.h"

/* 1, and 2^-28, in units of 2^-60. */
#define ONE       ((uint64_t)1 << 60)
#define TOLERANCE ((uint64_t)1 << 32)

static uint64_t product(int32_t a, int32_t b)
{
    return (uint64_t)fxl_multiply_s32(a, b);
}

/* The upper word of sum - expected + tolerance; tolerance is 2^32 << bits. It is below 2 << bits if
 * and only if -tolerance <= sum - expected < tolerance. */
static uint32_t beyond(uint64_t sum, uint64_t expected, unsigned bits)
{
    return (uint32_t)((sum - expected + (TOLERANCE << bits)) >> 32);
}

/* Whether the rows are those of a rotation: x and y are of unit length and at right angles, to
 * within 2^-28, and z is x cross y, to within 2^-26 a component. Rows of which all six products are
 * within 2^-28 pass: z is then a combination of x, y and their product with coefficients within
 * 2^-28 and 1.5 2^-28 of those of the product, so a component is off by less than 2.1 2^-28.
 *
 * A sum of three squares is below 3 2^62, so it does not wrap. If both squared lengths pass, all
 * components of x and y are below 2^30 + 2^2 and no other sum wraps. */
static bool is_rotation(const fxl_orientation *rows)
{
    const fxl_direction x = rows->x, y = rows->y, z = rows->z;
    const uint32_t narrow =
        beyond(product(x.x, x.x) + product(x.y, x.y) + product(x.z, x.z), ONE, 0) |
        beyond(product(y.x, y.x) + product(y.y, y.y) + product(y.z, y.z), ONE, 0) |
        beyond(product(x.x, y.x) + product(x.y, y.y) + product(x.z, y.z), 0, 0);
    /* bug: turn-mirror */
    const uint32_t wide =
        beyond(product(x.y, y.z) - product(x.z, y.y) - product(z.x, FXL_Q2_30_ONE), 0, 2) |
        beyond(product(x.z, y.x) - product(x.x, y.z) - product(z.y, FXL_Q2_30_ONE), 0, 2) |
        beyond(product(x.x, y.y) - product(x.y, y.x) - product(z.z, FXL_Q2_30_ONE), 0, 2);
    return (narrow >> 1 | wide >> 3) == 0;
}

/* scale * radius is below 2^24 2^31. */
fxl_q16_16 fxl_turn_radius(const fxl_turn *turn, fxl_q16_16 radius)
{
    const uint64_t scaled = fxl_multiply_u32((uint32_t)turn->scale, (uint32_t)radius);
    return (fxl_q16_16)((scaled + 0xFFFF) >> 16) + FXL_TURN_SLACK; /* bug: turn-radius */
}

fxl_status fxl_turn_check(const fxl_turn *turn, const fxl_point *centre, fxl_q16_16 radius)
{
    if (turn == NULL || centre == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (turn->scale < FXL_SCALE_MIN || turn->scale > FXL_SCALE_MAX || radius < 0 ||
        radius > FXL_RADIUS_MAX ||
        /* Below 2^14 units, so that fxl_turn_radius is in range. */
        fxl_multiply_u32((uint32_t)turn->scale, (uint32_t)radius) >> 46 != 0) {
        return FXL_E_RANGE;
    }
    const int32_t limit = FXL_COORDINATE_MAX - fxl_turn_radius(turn, radius);
    if (!fxl_within(centre->x, limit) || !fxl_within(centre->y, limit) ||
        !fxl_within(centre->z, limit)) { /* bug: turn-reach */
        return FXL_E_RANGE;
    }
    return is_rotation(&turn->orientation) ? FXL_OK : FXL_E_TURN;
}
