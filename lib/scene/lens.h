/* SPDX-License-Identifier: MIT */
/* What the library asks of a lens, and what an off-centre one needs: a lens points to it, so that
 * a program whose lenses all have their centre in the middle of the screen does not link it.
 * Internal. */
#ifndef FXL_LENS_H
#define FXL_LENS_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether a lens may have been made by the functions of fixel/camera.h: all members within their
 * ranges, and a focal length of a field of view within FXL_FOV_MIN..FXL_FOV_MAX, or beyond it by
 * less than 2/1000. False if lens is null. */
bool fxl_lens_is_valid(const fxl_lens *lens);

struct fxl_off_centre_code {
    /* Whether the centre is in its range, for a lens whose other members are. */
    bool (*is_valid)(const fxl_lens *lens);
    /* Turns frustum and projection, made for a centred lens, into those of the sheared view. */
    void (*set_lens)(fxl_view *view);
    /* Shears the axes of a camera that was set from a pose. */
    void (*set_pose)(fxl_view *view);
};

/* lib/view/off_centre.c */
extern const fxl_off_centre_code fxl_off_centre;

/* Whether the centre is no farther from the middle of the screen than fxl_lens_set_centre says, and
 * the inset 0. */
bool fxl_off_centre_is_valid(const fxl_lens *lens);

#ifdef __cplusplus
}
#endif

#endif
