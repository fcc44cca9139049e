/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"

const fxl_clipper fxl_clipper_view = {.clip = fxl_clip_by_view};
