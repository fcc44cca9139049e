/* SPDX-License-Identifier: MIT */
/* The lens: screen, focal length, near and far. */
#ifndef FXL_LENS_H
#define FXL_LENS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes a lens from a horizontal field of view:
 *   focal = (width / 2) / tan(fov / 2), for both axes (square pixels).
 * width and height are in pixels; near_z, far_z and inset are in world units.
 * Requires width, height in 1..FXL_SCREEN_MAX; fov in FXL_FOV_MIN..FXL_FOV_MAX;
 * near_z >= FXL_NEAR_MIN; far_z <= FXL_FAR_MAX; 0 <= inset <= FXL_INSET_MAX;
 * near_z + 2 * inset < far_z.
 * FXL_E_ARGUMENT, FXL_E_RANGE: lens untouched.
 * Error of focal: at most 1 unit of 1/65536 pixel plus focal * 2^-27. Source: A4. */
fxl_status fxl_lens_from_fov(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near_z,
                             fxl_q16_16 far_z, fxl_q16_16 inset, fxl_lens *lens);

/* Whether a lens may have been made by fxl_lens_from_fov: all members within their ranges, and a
 * focal length of a field of view within FXL_FOV_MIN..FXL_FOV_MAX, or beyond it by less than
 * 2/1000. */
bool fxl_lens_is_valid(const fxl_lens *lens);

#ifdef __cplusplus
}
#endif

#endif
