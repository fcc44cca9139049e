/* SPDX-License-Identifier: MIT */
/* What the library's clippers leave to the scan (docs/extras/clippers.md), by their names. */
#ifndef REF_CLIPPER_H
#define REF_CLIPPER_H

#include <stdbool.h>

#include "reference/frustum.h"

/* A bit for each of REF_PLANE_...: the planes that cut; of the sides without one
 * only what is beyond the guard band is cut. */
#define REF_CUT_ALL ((1u << REF_PLANE_COUNT) - 1)

/* How far from the screen's centre the guard band reaches, in pixels. */
#define REF_GUARD_PIXELS 3500

/* False where no clipper has that name. */
bool ref_clipper_cuts(const char *name, unsigned *planes);

#endif
