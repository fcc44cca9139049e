/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/square_root.h"
#include "fixel/player.h"

/* The angles whose tangents are 1, 1/2, 1/4 and so on, in units of 2^-44 turn, rounded. */
static const int64_t halved_tangents[] = {
    2199023255552, 1298159229407, 685911684590, 348179481054, 174765388006, 87467890064,
    43744617923,   21873643805,   10936988781,  5468515251,   2734260233,   1367130443,
    683565262,     341782636,     170891319,    85445659,     42722830,     21361415,
    10680707,      5340354,       2670177,      1335088,      667544,       333772,
    166886,        83443,         41722,        20861,        10430,        5215,
    2608,          1304,          652,          326,          163,          81};
#define TURNS (sizeof halved_tangents / sizeof halved_tangents[0])

/* The angle from the axis `along` towards the axis `across` of a vector that is not 0, each
 * component below 2^60 (CORDIC). The vector is turned onto the axis by the angles of the table, one
 * after the other, each to the side that brings it nearer. Turning makes it longer by a factor
 * of 1.647 in all, so components stay below 2^60 * 1.415 * 1.647 < 2^62. Errors, in units of 2^-32
 * turn: the last angle, 2^-35 radian, 0.02; the table, 36 halves of 2^-44 turn, and the shifts,
 * less than 0.01; the rounding to the result 0.5. */
static fxl_angle direction_of(int64_t across, int64_t along)
{
    const uint64_t bits = fxl_magnitude(across) | fxl_magnitude(along);
    const unsigned shift = 60u - fxl_bit_length(bits);
    const bool turned_round = along < 0;
    int64_t x = along * ((int64_t)1 << shift), y = across * ((int64_t)1 << shift), angle = 0;
    if (turned_round) {
        x = -x;
        y = -y;
    }
    for (unsigned i = 0; i < TURNS; i++) {
        const int64_t before = x;
        if (y > 0) {
            x += y >> i;
            y -= before >> i;
            angle += halved_tangents[i];
        } else {
            x -= y >> i;
            y += before >> i;
            angle -= halved_tangents[i];
        }
    }
    return (fxl_angle)fxl_round_shift(angle, 12) + (turned_round ? 2 * FXL_ANGLE_QUARTER : 0u);
}

fxl_status fxl_pose_look_at(fxl_pose *pose, const fxl_point *target)
{
    if (pose == NULL || target == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(&pose->position) || !fxl_point_in_range(target)) {
        return FXL_E_RANGE;
    }
    fxl_point way; /* each coordinate is below 2^30 */
    fxl_subtract(target, &pose->position, &way);
    const uint32_t level = (uint32_t)fxl_magnitude(way.x) | (uint32_t)fxl_magnitude(way.z);
    if (level == 0 && way.y == 0) {
        return FXL_E_DEGENERATE;
    }
    if (level == 0) {
        pose->pitch = way.y > 0 ? FXL_ANGLE_QUARTER : 0u - FXL_ANGLE_QUARTER;
        return FXL_OK;
    }
    pose->yaw = direction_of(way.x, way.z);
    /* The level distance, with as many bits as fit: its squares are below 2^62, and one is at least
     * 2^60, so the root is at least 2^30. Its rounding costs 2^-31 of it, 0.16 of 2^-32 turn. */
    const unsigned shift = 31u - fxl_bit_length(level);
    const int64_t x = (int64_t)way.x * ((int64_t)1 << shift),
                  z = (int64_t)way.z * ((int64_t)1 << shift);
    pose->pitch = direction_of((int64_t)way.y * ((int64_t)1 << shift),
                               fxl_square_root((uint64_t)(x * x + z * z)));
    return FXL_OK;
}
