/* SPDX-License-Identifier: MIT */
/* What the files of draw share beside submit.h. Internal. */
#ifndef FXL_RENDERER_H
#define FXL_RENDERER_H

#include "fixel/render.h"

/* Counts a call that is refused; answers its status. */
fxl_status fxl_renderer_refuse(fxl_renderer *renderer, fxl_status status);

#endif
