/* SPDX-License-Identifier: MIT */
#define FXL_TARGET            fxl_rgb565
#define FXL_TARGET_SPRITES    fxl_rgb565_sprites
#define FXL_TARGET_FORMAT     FXL_RGB565_PIXELS
#define FXL_TARGET_DEPTH_BITS 0
#include "sprites_text.h"
