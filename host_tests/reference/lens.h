/* SPDX-License-Identifier: MIT */
/* The lens (SPEC.md, section 4.2), in double. */
#ifndef REF_LENS_H
#define REF_LENS_H

#include "reference/record.h"

typedef struct {
    int width, height;           /* pixels */
    double focal;                /* pixels */
    double near_z, far_z, inset; /* world units */
} ref_lens;

/* focal = (width / 2) / tan(fov / 2), as the nearest 1/65536: the law's
 * definition includes that rounding. near, far and inset in world units. */
ref_lens ref_lens_from_fov(int width, int height, ref_angle fov, double near_z, double far_z,
                           double inset);

#endif
