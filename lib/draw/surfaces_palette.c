/* SPDX-License-Identifier: MIT */
#define FXL_TARGET            fxl_palette
#define FXL_TARGET_SURFACES   fxl_palette_surfaces
#define FXL_TARGET_TEXTURES   fxl_palette_textures
#define FXL_TARGET_FORMAT     FXL_PALETTE_PIXELS
#define FXL_TARGET_DEPTH_BITS 0
#include "surfaces_text.h"
