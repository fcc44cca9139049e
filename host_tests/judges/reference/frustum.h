/* SPDX-License-Identifier: MIT */
/* The view frustum (SPEC.md, section 4.3), in double. */
#ifndef REF_FRUSTUM_H
#define REF_FRUSTUM_H

#include "reference/camera.h"
#include "reference/lens.h"

enum {
    REF_PLANE_NEAR,
    REF_PLANE_FAR,
    REF_PLANE_LEFT,
    REF_PLANE_RIGHT,
    REF_PLANE_BOTTOM,
    REF_PLANE_TOP,
    REF_PLANE_COUNT
};

typedef struct {
    ref_plane planes[REF_PLANE_COUNT];
} ref_frustum;

ref_frustum ref_frustum_from_camera(const ref_camera *camera, const ref_lens *lens);

/* Makes the same frustum, except for the sides without a bit in cuts: they lie at this many
 * pixels from the middle of the screen, without an inset (docs/extras/clippers.md, section 2.3). */
ref_frustum ref_frustum_with_guard(const ref_camera *camera, const ref_lens *lens, unsigned cuts,
                                   double pixels);

#endif
