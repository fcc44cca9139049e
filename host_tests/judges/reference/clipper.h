/* SPDX-License-Identifier: MIT */
/* The planes that each clipper of the library cuts by, and those that it leaves to the scan
 * (docs/extras/clippers.md). */
#ifndef REF_CLIPPER_H
#define REF_CLIPPER_H

#include <stdbool.h>

#include "reference/frustum.h"

/* The bits of all planes. A clipper cuts by the planes whose bit, 1 << REF_PLANE_..., it has. On
 * the other sides it cuts only what is beyond the guard band. */
#define REF_CUT_ALL ((1u << REF_PLANE_COUNT) - 1)

/* How far the guard band reaches from the centre of the screen, in pixels. */
#define REF_GUARD_PIXELS 3500

/* Looks a clipper up by its name. Returns false where no clipper has that name. */
bool ref_clipper_cuts(const char *name, unsigned *planes, bool *by_points);

/* How a visibility method of this name draws: by_bsp: a scene that has a BSP tree by the tree;
 * flat: faces in their own colours, whatever surfaces they have; depth_bits: of a depth buffer, or
 * 0. Returns false where no method has that name. A span buffer gives the same picture as drawing
 * over. */
bool ref_visibility_draws(const char *name, bool *by_bsp, bool *flat, int *depth_bits);

#endif
