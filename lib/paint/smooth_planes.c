/* SPDX-License-Identifier: MIT */
/* The portable text of fxl_find_smooth_planes. */
#include "corner_planes.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M || FXL_IS_COMPACT

bool fxl_find_smooth_planes(const fxl_screen_corners *corners, const fxl_lens *lens,
                            const int32_t light[3], fxl_gradients *gradients,
                            fxl_depth_plane *depth)
{
    fxl_corner_planes planes;
    return fxl_corner_planes_begin(corners, lens, FXL_WORDS_SIDE_MAX, &planes) &&
           fxl_corner_planes_linear(&planes, light, gradients, depth);
}

#endif
