/* SPDX-License-Identifier: MIT */
#include "reference/depth.h"

#include <math.h>

#include "reference/transform.h"

/* accuracy 4.3 */
double ref_depth_bound(const ref_polygon *polygon, const ref_point *eye, const ref_lens *lens)
{
    double largest = 0;
    for (int i = 0; i < polygon->count; i++) {
        const ref_point *point = &polygon->vertices[i].position;
        largest = fmax(largest,
                       fabs(point->x - eye->x) + fabs(point->y - eye->y) + fabs(point->z - eye->z));
    }
    double shorter = fmin(lens->width, lens->height);
    return 0x2p-30 * largest + 0x4p-46 * fmax(1, 2 * lens->focal / shorter);
}

bool ref_depth_is_in_doubt(const ref_view_frustum *frustum, const ref_camera *camera,
                           const ref_polygon *polygon, double bound)
{
    for (int plane = REF_PLANE_NEAR; plane <= REF_PLANE_FAR; plane++) {
        ref_wide least = INFINITY, most = -INFINITY;
        for (int i = 0; i < polygon->count; i++) {
            ref_view_point view_point = ref_transform_point(camera, &polygon->vertices[i].position);
            ref_wide distance = ref_view_distance(&frustum->planes[plane], &view_point);
            least = distance < least ? distance : least;
            most = distance > most ? distance : most;
        }
        if (least <= bound && most >= -bound) {
            return true;
        }
    }
    return false;
}

void ref_depth_move_frustum(ref_frustum *frustum, double distance)
{
    frustum->planes[REF_PLANE_NEAR].distance -= distance;
    frustum->planes[REF_PLANE_FAR].distance -= distance;
}

void ref_depth_move_view_frustum(ref_view_frustum *frustum, double distance)
{
    frustum->planes[REF_PLANE_NEAR].distance -= distance;
    frustum->planes[REF_PLANE_FAR].distance -= distance;
}
