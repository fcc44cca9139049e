/* SPDX-License-Identifier: MIT */
/* Light beams: convex parts of the world in which faces are drawn lit. */
#ifndef FXL_EXTRA_BEAMS_H
#define FXL_EXTRA_BEAMS_H

#include "fixel/beam.h"
#include "fixel/beam_light.h"

#endif
