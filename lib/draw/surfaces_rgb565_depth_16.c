/* SPDX-License-Identifier: MIT */
#define FXL_TARGET            fxl_rgb565_depth_16
#define FXL_TARGET_SURFACES   fxl_rgb565_depth_16_surfaces
#define FXL_TARGET_TEXTURES   fxl_rgb565_depth_16_textures
#define FXL_TARGET_FORMAT     FXL_RGB565_PIXELS
#define FXL_TARGET_DEPTH_BITS 16
#include "surfaces_text.h"
