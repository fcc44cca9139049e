/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../math/sine.h"
#include "lens.h"

FXL_STATIC_ASSERT((FXL_SCREEN_MAX & (FXL_SCREEN_MAX - 1)) == 0, "both are tested at once");

/* Both 1..FXL_SCREEN_MAX: less 1, no bit above those of FXL_SCREEN_MAX - 1 is set. */
static bool screen_in_range(uint16_t width, uint16_t height)
{
    return (uint32_t)((width - 1) | (height - 1)) < FXL_SCREEN_MAX;
}

/* Neither near_z nor far_z is below 0, so the difference does not overflow. */
static bool depth_in_range(fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_q16_16 inset)
{
    return near_z >= FXL_NEAR_MIN && (uint32_t)far_z <= FXL_FAR_MAX &&
           (uint32_t)inset <= FXL_INSET_MAX && 2 * inset < far_z - near_z;
}

fxl_status fxl_lens_from_fov(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near_z,
                             fxl_q16_16 far_z, fxl_q16_16 inset, fxl_lens *lens)
{
    if (lens == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!screen_in_range(width, height) || fov < FXL_FOV_MIN || fov > FXL_FOV_MAX ||
        !depth_in_range(near_z, far_z, inset)) {
        return FXL_E_RANGE;
    }
    /* 1 / tan(fov / 2) = (1 + cos fov) / sin fov, which does not halve fov. Width is
     * below 2^11, so the product is below 2^(11 + 15 + 32) = 2^58. The sine of
     * 10..150 degrees is above 2^28. */
    int64_t numerator =
        fxl_multiply_s64((int32_t)width * 32768, ((int64_t)1 << 31) + fxl_cos_q31(fov));
    lens->width = width;
    lens->height = height;
    lens->focal = fxl_divide_round(numerator, (uint32_t)fxl_sin_q31(fov));
    lens->near_z = near_z;
    lens->far_z = far_z;
    lens->inset = inset;
    lens->centre_x = (int32_t)width * 32768;
    lens->centre_y = (int32_t)height * 32768;
    lens->off_centre = NULL;
    return FXL_OK;
}

/* 1 / (2 tan(fov / 2)) of FXL_FOV_MAX and FXL_FOV_MIN is 0.13397 and 5.71503. Here each is moved
 * outward by less than 2/1000, in units of 2^-16, to a number that an instruction can hold. A width
 * is below 2^11, so the products are below 2^30. */
#define FOCAL_LEAST 0x2240
#define FOCAL_MOST  0x5B800

/* One comparison for both ends: a focal length below the least wraps to 2^31 - 2^24 or more, and
 * the span is below 2^29. */
static bool focal_in_range(fxl_q16_16 focal, uint16_t width)
{
    return (uint32_t)focal - (uint32_t)width * FOCAL_LEAST <=
           (uint32_t)width * (FOCAL_MOST - FOCAL_LEAST);
}

static bool centre_in_range(const fxl_lens *lens)
{
    return lens->off_centre != NULL ? lens->off_centre->is_valid(lens)
                                    : lens->centre_x == (int32_t)lens->width * 32768 &&
                                          lens->centre_y == (int32_t)lens->height * 32768;
}

bool fxl_lens_is_valid(const fxl_lens *lens)
{
    return lens != NULL && screen_in_range(lens->width, lens->height) &&
           depth_in_range(lens->near_z, lens->far_z, lens->inset) &&
           focal_in_range(lens->focal, lens->width) && centre_in_range(lens);
}
