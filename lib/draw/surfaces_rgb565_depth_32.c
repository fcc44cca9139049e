/* SPDX-License-Identifier: MIT */
#define FXL_TARGET            fxl_rgb565_depth_32
#define FXL_TARGET_SURFACES   fxl_rgb565_depth_32_surfaces
#define FXL_TARGET_TEXTURES   fxl_rgb565_depth_32_textures
#define FXL_TARGET_FORMAT     FXL_RGB565_PIXELS
#define FXL_TARGET_DEPTH_BITS 32
#include "surfaces_text.h"
