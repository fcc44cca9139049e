/* SPDX-License-Identifier: MIT */
/* The depth buffer of 16 bits a pixel. */
#define FXL_DEPTH_BITS        16
#define FXL_DEPTH_METHOD      fxl_visibility_depth
#define FXL_DEPTH_FAR_TO_NEAR fxl_depth_far_to_near
#include "depth_methods.h"
