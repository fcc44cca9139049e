/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/plane.h"
#include "../scene/scene_check.h"
#include "fixel/camera.h"
#include "fixel/player.h"

/* +1 for the plus key, -1 for the minus key, 0 for neither or both. */
/* formats 1.3 */
static int32_t key_sign(uint32_t keys, uint32_t plus, uint32_t minus)
{
    return ((keys & plus) != 0) - ((keys & minus) != 0);
}

static fxl_angle turned(fxl_angle angle, int32_t sign, fxl_angle turn)
{
    return sign > 0 ? angle + turn : sign < 0 ? angle - turn : angle;
}

static fxl_q16_16 held_within(int64_t value, fxl_q16_16 limit, bool *held)
{
    if (fxl_within(value, limit)) {
        return (fxl_q16_16)value;
    }
    *held = true;
    return value < 0 ? -limit : limit;
}

/* Reduces a speed by friction, to no less than 0. */
static fxl_q16_16 slow_down(fxl_q16_16 speed, fxl_q16_16 friction)
{
    if (speed > friction) {
        return speed - friction;
    }
    return speed < -friction ? speed + friction : 0;
}

/* A step of a player who walks, or who flies. */
/* formats 1.3 */
static fxl_status step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                       bool *clamped, bool flies)
{
    if (viewer == NULL || limits == NULL) {
        return FXL_E_ARGUMENT;
    }
    if ((keys & ~(uint32_t)FXL_KEY_ALL) != 0 || !fxl_motion_limits_in_range(limits) ||
        !fxl_within(viewer->speed, FXL_MOTION_MAX) || !fxl_point_in_range(&viewer->pose.position)) {
        return FXL_E_RANGE;
    }
    fxl_pose *pose = &viewer->pose;
    pose->yaw = turned(pose->yaw, key_sign(keys, FXL_KEY_RIGHT, FXL_KEY_LEFT), limits->turn);
    pose->pitch =
        turned(pose->pitch, key_sign(keys, FXL_KEY_PITCH_UP, FXL_KEY_PITCH_DOWN), limits->turn);
    pose->roll =
        turned(pose->roll, key_sign(keys, FXL_KEY_ROLL_LEFT, FXL_KEY_ROLL_RIGHT), limits->turn);

    bool speed_held = false; /* the top speed is a setting, not an edge of the world, so clamping it
                                is not reported */
    int32_t speed = viewer->speed + /* both within FXL_MOTION_MAX */
                    key_sign(keys, FXL_KEY_FORWARD, FXL_KEY_BACK) * limits->acceleration;
    viewer->speed = held_within(speed, limits->speed_max, &speed_held);

    fxl_camera camera;
    fxl_status status = fxl_camera_from_pose(pose, &camera);
    FXL_ASSERT(status == FXL_OK);
    (void)status;

    /* A unit vector times at most 2^24 is below 2^55. */
    int64_t move_x = fxl_round_shift(fxl_multiply_s32(camera.axes.forward.x, viewer->speed), 30);
    int64_t move_z = fxl_round_shift(fxl_multiply_s32(camera.axes.forward.z, viewer->speed), 30);
    bool held = false;
    pose->position.x = held_within(pose->position.x + move_x, FXL_COORDINATE_MAX, &held);
    pose->position.z = held_within(pose->position.z + move_z, FXL_COORDINATE_MAX, &held);
    if (flies) {
        int64_t move_y =
            fxl_round_shift(fxl_multiply_s32(camera.axes.forward.y, viewer->speed), 30);
        pose->position.y = held_within(pose->position.y + move_y, FXL_COORDINATE_MAX, &held);
    }
    if (held) {
        viewer->clamped += 1;
    }
    if (clamped != NULL) {
        *clamped = held;
    }
    viewer->speed = slow_down(viewer->speed, limits->friction);
    return FXL_OK;
}

FXL_COLD fxl_status fxl_player_step(fxl_player *viewer, uint32_t keys,
                                    const fxl_motion_limits *limits, bool *clamped)
{
    return step(viewer, keys, limits, clamped, false);
}

FXL_COLD fxl_status fxl_player_fly(fxl_player *viewer, uint32_t keys,
                                   const fxl_motion_limits *limits, bool *clamped)
{
    return step(viewer, keys, limits, clamped, true);
}

/* Both are at most 2^24: the product is at most 2^48. */
static fxl_q16_16 product(fxl_q16_16 limit, fxl_q16_16 factor)
{
    const int64_t exact = fxl_round_shift(fxl_multiply_s32(limit, factor), 16);
    return exact > FXL_MOTION_MAX ? -1 : (fxl_q16_16)exact; /* -1: out of range */
}

FXL_COLD fxl_status fxl_scale_motion_limits(const fxl_motion_limits *limits, fxl_q16_16 factor,
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

FXL_COLD fxl_status fxl_pose_look_at(fxl_pose *pose, const fxl_point *target)
{
    if (pose == NULL || target == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!fxl_point_in_range(&pose->position) || !fxl_point_in_range(target)) {
        return FXL_E_RANGE;
    }
    fxl_point direction; /* each coordinate is below 2^30 */
    fxl_subtract(target, &pose->position, &direction);
    const uint32_t level =
        (uint32_t)fxl_magnitude(direction.x) | (uint32_t)fxl_magnitude(direction.z);
    if (level == 0 && direction.y == 0) {
        return FXL_E_DEGENERATE;
    }
    if (level == 0) {
        pose->pitch = direction.y > 0 ? FXL_ANGLE_QUARTER : 0u - FXL_ANGLE_QUARTER;
        return FXL_OK;
    }
    pose->yaw = direction_of(direction.x, direction.z);
    /* The level distance, with as many bits as fit: its squares are below 2^62, and one is at least
     * 2^60, so the root is at least 2^30. Its rounding costs 2^-31 of it, 0.16 of 2^-32 turn. */
    const unsigned shift = 31u - fxl_bit_length(level);
    const int64_t x = (int64_t)direction.x * ((int64_t)1 << shift),
                  z = (int64_t)direction.z * ((int64_t)1 << shift);
    pose->pitch = direction_of((int64_t)direction.y * ((int64_t)1 << shift),
                               fxl_square_root((uint64_t)(x * x + z * z)));
    return FXL_OK;
}
