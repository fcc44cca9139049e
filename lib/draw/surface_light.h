/* SPDX-License-Identifier: MIT */
/* Light at the corners of faces with surfaces. Internal. */
#ifndef FXL_SURFACE_LIGHT_H
#define FXL_SURFACE_LIGHT_H

#include "fixel/surfaces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a renderer with lit surfaces links. */
typedef struct fxl_surface_light_code {
    /* The light at the three vertices of a mapped face: levels of the ramp in 16.16, and a half, so
     * that rounding them down gives the nearest. From 32768 to levels - 1/2. */
    void (*light_corners)(const fxl_surfaces *surfaces, const fxl_renderer *renderer,
                          const fxl_instance *instance, const fxl_mapped_face *mapped,
                          int32_t values[3]);
} fxl_surface_light_code;

static inline bool fxl_surface_is_lit(const fxl_surfaces *surfaces, const fxl_surface *surface)
{
    return (surface->flags & FXL_SURFACE_LIT) && surfaces->light != NULL;
}

#ifdef __cplusplus
}
#endif

#endif
