/* SPDX-License-Identifier: MIT */
/* place pixel-format: new files beside it: targets, and painters of surfaces and billboards, for each depth */
#define FXL_TARGET            fxl_rgb565
#define FXL_TARGET_FORMAT     FXL_RGB565_PIXELS
#define FXL_TARGET_DEPTH_BITS 0
#include "target_text.h"
