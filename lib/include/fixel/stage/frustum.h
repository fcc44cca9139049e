/* SPDX-License-Identifier: MIT */
/* The view frustum, in the view and as six planes of the world (Listing 65.3,
 * SetUpFrustum). */
#ifndef FXL_FRUSTUM_H
#define FXL_FRUSTUM_H

#include "fixel/stage/camera.h"
#include "fixel/stage/lens.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In the order of clipping. Near and far come first: a polygon that is nearly
 * parallel to them is cut where its exact distances say, before the side planes
 * have rounded any vertex. */
enum {
    FXL_PLANE_NEAR,
    FXL_PLANE_FAR,
    FXL_PLANE_LEFT,
    FXL_PLANE_RIGHT,
    FXL_PLANE_BOTTOM,
    FXL_PLANE_TOP,
    FXL_PLANE_COUNT
};

typedef struct {
    fxl_plane planes[FXL_PLANE_COUNT];
} fxl_frustum;

/* The frustum in the view. A point (x, y, z) is inside
 *   left, right   where  +-x_side x + x_depth z >= inset,
 *   bottom, top   where  +-y_side y + y_depth z >= inset,
 *   near          where  z >= near,
 *   far           where  z <= far.
 * These integers are the planes: whatever clips in the view clips to them
 * exactly. near and far have the inset in them. */
typedef struct {
    fxl_q2_30 x_side, x_depth;
    fxl_q2_30 y_side, y_depth;
    fxl_q18_46 near_z, far_z, inset;
} fxl_view_frustum;

/* The frustum of a lens made by its function.
 * Error: (x_side, x_depth) is (focal, width/2) scaled to unit length, each
 * component within 1 unit of 2^-30; y likewise; near, far, inset exact. */
void fxl_view_frustum_from_lens(const fxl_lens *lens, fxl_view_frustum *frustum);

/* The six planes, rotated into the world, each moved inward by lens->inset.
 * In view space, before the inset: left (focal, 0, width/2), right
 * (-focal, 0, width/2), bottom (0, focal, height/2), top (0, -focal,
 * height/2), each scaled to unit length and through the eye; near (0, 0, 1)
 * at lens->near, far (0, 0, -1) at lens->far.
 * Requires a camera and a lens made by their functions.
 * Error: each component of a normal within 4 units of 2^-30; the side planes
 * pass through the eye, and near and far lie at their distance from it, to
 * within 1 unit of 1/65536 (exactly, but for the length of the normal). */
void fxl_frustum_from_camera(const fxl_camera *camera, const fxl_lens *lens, fxl_frustum *frustum);

#ifdef __cplusplus
}
#endif

#endif
