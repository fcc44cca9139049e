/* SPDX-License-Identifier: MIT */
/* What an off-centre lens needs of the library. A lens points to it, so that a program whose lenses
 * all have their centre in the middle of the screen does not link it. Internal. */
#ifndef FXL_OFF_CENTRE_CODE_H
#define FXL_OFF_CENTRE_CODE_H

#include "fixel/stage/view.h"

#ifdef __cplusplus
extern "C" {
#endif

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
