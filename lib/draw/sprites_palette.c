/* SPDX-License-Identifier: MIT */
#define FXL_TARGET            fxl_palette
#define FXL_TARGET_SPRITES    fxl_palette_sprites
#define FXL_TARGET_FORMAT     FXL_PALETTE_PIXELS
#define FXL_TARGET_DEPTH_BITS 0
#include "sprites_text.h"
