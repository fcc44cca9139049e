/* SPDX-License-Identifier: MIT */
#include "reference/frustum.h"

#include <math.h>

#include "reference/plane.h"

/* Makes the plane whose normal has the view coordinates (x, y, z), before scaling to unit
 * length, and which passes through (0, 0, depth). */
static ref_plane view_plane(const ref_camera *camera, double x, double y, double z, double depth,
                            double inset)
{
    double length = sqrt(x * x + y * y + z * z);
    const ref_point *r = &camera->right, *u = &camera->up, *f = &camera->forward;
    ref_point normal = {(r->x * x + u->x * y + f->x * z) / length,
                        (r->y * x + u->y * y + f->y * z) / length,
                        (r->z * x + u->z * y + f->z * z) / length};
    ref_point through = {camera->position.x + f->x * depth, camera->position.y + f->y * depth,
                         camera->position.z + f->z * depth};
    return ref_plane_from_point(&through, &normal, inset);
}

ref_frustum ref_frustum_with_guard(const ref_camera *camera, const ref_lens *lens, unsigned cuts,
                                   double pixels)
{
    double focal = lens->focal;
    ref_frustum frustum = ref_frustum_from_camera(camera, lens);
    for (int plane = REF_PLANE_LEFT; plane <= REF_PLANE_TOP; plane++) {
        if ((cuts >> plane & 1) == 0) {
            double across = plane == REF_PLANE_LEFT || plane == REF_PLANE_BOTTOM ? focal : -focal;
            bool upright = plane == REF_PLANE_BOTTOM || plane == REF_PLANE_TOP;
            frustum.planes[plane] =
                view_plane(camera, upright ? 0 : across, upright ? across : 0, pixels, 0, 0);
        }
    }
    return frustum;
}

ref_frustum ref_frustum_from_camera(const ref_camera *camera, const ref_lens *lens)
{
    double half_width = lens->width / 2.0, half_height = lens->height / 2.0;
    double focal = lens->focal, inset = lens->inset;
    ref_frustum frustum;
    frustum.planes[REF_PLANE_LEFT] = view_plane(camera, focal, 0, half_width, 0, inset);
    frustum.planes[REF_PLANE_RIGHT] = view_plane(camera, -focal, 0, half_width, 0, inset);
    frustum.planes[REF_PLANE_BOTTOM] = view_plane(camera, 0, focal, half_height, 0, inset);
    frustum.planes[REF_PLANE_TOP] = view_plane(camera, 0, -focal, half_height, 0, inset);
    frustum.planes[REF_PLANE_NEAR] = view_plane(camera, 0, 0, 1, lens->near_z, inset);
    frustum.planes[REF_PLANE_FAR] = view_plane(camera, 0, 0, -1, lens->far_z, inset);
    return frustum;
}
