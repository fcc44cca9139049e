/* SPDX-License-Identifier: MIT */
/* The view frustum, in the view and as six planes of the world. */
#ifndef FXL_FRUSTUM_H
#define FXL_FRUSTUM_H

#include "fixel/stage/camera.h"
#include "fixel/stage/lens.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The planes, in the order of clipping. Near and far come first. So a polygon that is
 * nearly parallel to them is cut by its exact distances, before the side planes have
 * rounded any vertex. */
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
 *   left, right   if  +-x_side x + x_depth z >= inset,
 *   bottom, top   if  +-y_side y + y_depth z >= inset,
 *   near          if  z >= near_z,
 *   far           if  z <= far_z.
 * These integers are the planes: every clipper in the view clips to them exactly.
 * near_z and far_z include the inset. (x_side, x_depth) and (y_side, y_depth) have unit length, or
 * half the square of it in the sheared view of an off-centre lens. */
typedef struct fxl_view_frustum {
    fxl_q2_30 x_side, x_depth;
    fxl_q2_30 y_side, y_depth;
    fxl_q18_46 near_z, far_z, inset;
} fxl_view_frustum;

/* Sets up the frustum in the view.
 * Requires a lens made by fxl_lens_from_fov.
 * Error: (x_side, x_depth) is (focal, width/2) scaled to unit length, each
 * component within 1 unit of 2^-30; (y_side, y_depth) likewise, with height/2.
 * near_z, far_z and inset are exact. Source: A4. */
void fxl_view_frustum_from_lens(const fxl_lens *lens, fxl_view_frustum *frustum);

/* Sets up the six planes in the world, each moved inward by lens->inset. In view
 * space, before the inset, their normals are
 *   left (focal, 0, width/2),    right (-focal, 0, width/2),
 *   bottom (0, focal, height/2), top (0, -focal, height/2),
 * each scaled to unit length, and these four planes pass through the eye; near has
 * (0, 0, 1) at lens->near_z, far has (0, 0, -1) at lens->far_z.
 * Requires a camera made by fxl_camera_from_pose and a lens made by fxl_lens_from_fov.
 * Error: each component of a normal within 4 units of 2^-30. The side planes pass
 * through the eye, and near and far lie at their distance from it, to within 1 unit of
 * 1/65536 (exactly, except for the length of the normal).
 * Source: A4 (Listing 65.3, SetUpFrustum). */
void fxl_frustum_from_camera(const fxl_camera *camera, const fxl_lens *lens, fxl_frustum *frustum);

/* Does the same with the sides set up beforehand. It reads near_z, far_z and inset of the lens.
 * Requires the sides of a view, and its camera. In the sheared view of an off-centre lens a side's
 * normal is at most 1 long, and its direction is that of the border that it stands for. */
void fxl_frustum_from_sides(const fxl_camera *camera, const fxl_lens *lens,
                            const fxl_view_frustum *sides, fxl_frustum *frustum);

#ifdef __cplusplus
}
#endif

#endif
