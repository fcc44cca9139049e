/* SPDX-License-Identifier: MIT */
#include "input.h"

#include "answers.h"

/* A lens whose input says this inset is off-centre instead. */
#define OFF_CENTRE 7

uint64_t fuzz_bits(fuzz_input *in, unsigned bytes)
{
    uint64_t value = 0;
    for (unsigned i = 0; i < bytes && in->left > 0; i++) {
        value |= (uint64_t)*in->at << (8 * i);
        in->at += 1;
        in->left -= 1;
    }
    return value;
}

uint32_t fuzz_below(fuzz_input *in, uint32_t count)
{
    unsigned bytes = count <= 0x100 ? 1 : count <= 0x10000 ? 2 : 4;
    return (uint32_t)fuzz_bits(in, bytes) % count;
}

int32_t fuzz_between(fuzz_input *in, int32_t low, int32_t high)
{
    return (int32_t)(low + (int64_t)fuzz_below(in, (uint32_t)(high - low) + 1u));
}

int32_t fuzz_any(fuzz_input *in)
{
    static const int32_t edges[] = {0,
                                    1,
                                    -1,
                                    INT32_MAX,
                                    INT32_MIN,
                                    FXL_COORDINATE_MAX,
                                    -FXL_COORDINATE_MAX,
                                    FXL_COORDINATE_MAX + 1,
                                    2 * FXL_COORDINATE_MAX,
                                    FXL_SCREEN_COORDINATE_MAX,
                                    FXL_FAR_MAX,
                                    FXL_MOTION_MAX,
                                    FXL_Q2_30_ONE};
    uint32_t kind = fuzz_below(in, 32);
    if (kind < sizeof edges / sizeof edges[0]) {
        return edges[kind];
    }
    return kind < 24 ? (int8_t)fuzz_bits(in, 1) : (int32_t)fuzz_bits(in, 4);
}

fxl_q16_16 fuzz_coordinate(fuzz_input *in, fxl_q16_16 limit)
{
    int64_t value;
    switch (fuzz_below(in, 8)) {
    case 0:
        return 0;
    case 1:
        value = (int64_t)(int8_t)fuzz_bits(in, 1) * 65536;
        break;
    case 2:
        value = (int16_t)fuzz_bits(in, 2);
        break;
    case 3:
        value = (int64_t)(int16_t)fuzz_bits(in, 2) * 256;
        break;
    case 4:
        value = (int64_t)(int16_t)fuzz_bits(in, 2) * 65536;
        break;
    case 5:
        value = limit;
        break;
    case 6:
        value = -limit;
        break;
    default:
        value = (int32_t)fuzz_bits(in, 4);
        break;
    }
    return (fxl_q16_16)(value > limit ? limit : value < -limit ? -limit : value);
}

fxl_point fuzz_point(fuzz_input *in, fxl_q16_16 limit)
{
    fxl_point point;
    point.x = fuzz_coordinate(in, limit);
    point.y = fuzz_coordinate(in, limit);
    point.z = fuzz_coordinate(in, limit);
    return point;
}

static fxl_angle any_angle(fuzz_input *in)
{
    uint32_t kind = fuzz_below(in, 4);
    if (kind == 0) {
        return fuzz_below(in, 16) * (FXL_ANGLE_QUARTER / 4);
    }
    return kind == 1 ? (fxl_angle)fuzz_bits(in, 4) : (fxl_angle)fuzz_bits(in, 2) << 16;
}

fxl_pose fuzz_pose(fuzz_input *in)
{
    fxl_pose pose;
    pose.position = fuzz_point(in, FXL_COORDINATE_MAX);
    pose.yaw = any_angle(in);
    pose.pitch = any_angle(in);
    pose.roll = any_angle(in);
    return pose;
}

/* Moves the centre by an offset within its range, made from the lens's own numbers. */
static void move_centre(fxl_lens *lens)
{
    const uint32_t mixed = ((uint32_t)lens->far_z ^ (uint32_t)lens->near_z << 7) * 2654435761u;
    const uint64_t most_x = (uint32_t)lens->width * 98304u,
                   most_y = (uint32_t)lens->height * 98304u;
    const uint64_t focal = 4 * (uint64_t)lens->focal;
    const uint64_t reach_x = most_x < focal ? most_x : focal;
    const uint64_t reach_y = most_y < focal ? most_y : focal;
    const int64_t x = (int64_t)(reach_x * (mixed >> 16) / 32768) - (int64_t)reach_x;
    const int64_t y = (int64_t)(reach_y * (mixed & 65535u) / 32768) - (int64_t)reach_y;
    DEMAND(fxl_lens_set_centre(lens, (fxl_q16_16)(lens->width * 32768 + x),
                               (fxl_q16_16)(lens->height * 32768 + y)) == FXL_OK);
    DEMAND(fxl_lens_is_valid(lens));
}

fxl_lens fuzz_lens(fuzz_input *in, uint32_t pixels)
{
    static const fxl_angle fovs[] = {FXL_ANGLE_QUARTER, FXL_FOV_MIN, FXL_FOV_MAX};
    fxl_lens lens;
    uint32_t width = 1 + fuzz_below(in, FXL_SCREEN_MAX);
    uint32_t height = 1 + fuzz_below(in, FXL_SCREEN_MAX);
    if (width * height > pixels) {
        height = 1 + (height - 1) % (pixels / width);
    }
    uint32_t kind = fuzz_below(in, 4);
    fxl_angle fov = kind < 3 ? fovs[kind] : (fxl_angle)fuzz_between(in, FXL_FOV_MIN + 1, FXL_FOV_MAX - 1);
    /* near by its order of magnitude; far likewise, from near to the greatest. */
    fxl_q16_16 inset =
        fuzz_between(in, 0, 1) ? fuzz_between(in, 0, FXL_INSET_MAX) : fuzz_between(in, 0, 8);
    fxl_q16_16 near = FXL_NEAR_MIN << fuzz_below(in, 16);
    near += fuzz_between(in, 0, near - 1);
    int32_t workspace = FXL_FAR_MAX - near - 2 * inset - 1;
    fxl_q16_16 far = FXL_FAR_MAX - (workspace >> fuzz_below(in, 31));
    fxl_status status =
        fxl_lens_from_fov((uint16_t)width, (uint16_t)height, fov, near, far, inset, &lens);
    DEMAND(status == FXL_OK);
    if (inset == OFF_CENTRE) {
        lens.inset = 0;
        move_centre(&lens);
    }
    return lens;
}
