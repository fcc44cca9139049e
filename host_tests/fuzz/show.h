/* SPDX-License-Identifier: MIT */
/* A frame on its way to a display: formats, the pump, the drivers. */
#ifndef SHOW_H
#define SHOW_H

#include "input.h"

/* Shows frames of a renderer whose screen is 24 x 16, and feeds formats, pump and drivers with what
 * they must refuse. */
void fuzz_show(fuzz_input *in, fxl_renderer *renderer, const fxl_pose *eye);

#endif
