/* SPDX-License-Identifier: MIT */
/* What the stages of a frame share: from where it is seen, and what of it. */
#ifndef FXL_VIEW_H
#define FXL_VIEW_H

#include "fixel/stage/frustum.h"
#include "fixel/stage/project.h"

/* The caller owns it. Set up by the functions below, first the lens. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens;
    fxl_projection projection;
    fxl_view_frustum view_frustum;
    fxl_frustum frustum;     /* the same in the world: fxl_view_set_world_frustum */
    uint32_t frame;          /* counts poses; 0: none yet */
    void *clipper_workspace; /* the clipper's, of the caller's memory; or null */
} fxl_view;

/* Sets frame and room to 0 and null. Requires a lens made by its function. */
void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens);

/* FXL_E_ARGUMENT, FXL_E_RANGE (pose): view untouched. */
fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose);

/* Works out the planes in the world, once a pose: fxl_clipper.begin of clippers
 * that clip there. */
void fxl_view_set_world_frustum(fxl_view *view);

#endif
