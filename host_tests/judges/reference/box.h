/* SPDX-License-Identifier: MIT */
/* Boxes against the frustum (docs/extras/clippers.md, section 8). */
#ifndef REF_BOX_H
#define REF_BOX_H

#include "reference/frustum.h"

/* Returns a bit for each plane that a box may cross: one for which the eight corners are neither
 * all outside by more than 2^-9 nor all inside by at least 2^-9. Returns 1 << REF_PLANE_COUNT
 * alone where all corners are outside one plane by more than 2^-9. */
uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most);

#endif
