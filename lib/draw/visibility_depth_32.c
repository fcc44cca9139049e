/* SPDX-License-Identifier: MIT */
/* The depth buffer of 32 bits a pixel. */
#define FXL_DEPTH_BITS        32
#define FXL_DEPTH_METHOD      fxl_visibility_depth_32
#define FXL_DEPTH_FAR_TO_NEAR fxl_depth_far_to_near_32
#include "depth_methods.h"
