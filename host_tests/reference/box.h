/* SPDX-License-Identifier: MIT */
/* Boxes against the frustum (docs/extras/clippers.md, section 8). */
#ifndef REF_BOX_H
#define REF_BOX_H

#include "reference/frustum.h"

/* A bit for each plane that has neither all eight corners outside by more than 2^-9 nor
 * all inside by no less; 1 << REF_PLANE_COUNT alone where it has all outside of one. */
uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most);

#endif
