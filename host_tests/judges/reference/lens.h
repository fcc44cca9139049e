/* SPDX-License-Identifier: MIT */
/* The lens (SPEC.md, section 4.2), in double. */
#ifndef REF_LENS_H
#define REF_LENS_H

#include "reference/record.h"

typedef struct {
    int width, height;           /* pixels */
    double focal;                /* pixels */
    double near_z, far_z, inset; /* world units */
    double centre_x, centre_y;   /* pixels: where the screen is straight ahead */
} ref_lens;

/* Makes a lens. focal = (width / 2) / tan(fov / 2), rounded to the nearest 1/65536; the
 * specification defines that rounding. near_z, far_z and inset are in world units. The centre is
 * the middle of the screen. */
ref_lens ref_lens_from_fov(int width, int height, ref_angle fov, double near_z, double far_z,
                           double inset);

#endif
