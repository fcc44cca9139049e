/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "game/exact.h"
#include "reference/camera.h"
#include "reference/cull.h"
#include "stages/bridge.h"
#include "stages/measure.h"

const stages_tally stages_transform_tally = {
    .stage = "transform",
    .unit = "1/65536 world unit",
    .measure =
        "largest coordinate difference of a view point from the reference's, both given the "
        "same camera matrix and point; the reference sums in 64 bits, which hold every "
        "such sum",
    .bound = "0",
};

void stages_measure_transform(stages_tally *tally, const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view)
{
    fxl_transform_point(camera, point, view);
    ref_camera exact_camera = bridge_camera(camera);
    ref_point exact_point = bridge_point(point);
    ref_view_point exact = ref_transform_point(&exact_camera, &exact_point);
    ref_view_point fixed = bridge_view_point(view);
    double difference = (double)fmaxl(fabsl(fixed.x - exact.x),
                                      fmaxl(fabsl(fixed.y - exact.y), fabsl(fixed.z - exact.z)));
    stages_count(tally, REF_ONE * difference, difference == 0);
}

const stages_tally stages_project_tally = {
    .stage = "project",
    .unit = "1/65536 pixel",
    .measure =
        "larger coordinate difference of a screen point from the reference's, both given the "
        "same view point and focal length",
    .bound = "0.5 + 2^-31 |x - width/2| + 2^-30, likewise y, in 1/65536 pixel",
};

int stages_measure_project(stages_tally *tally, const fxl_lens *lens, const fxl_view_point *view,
                           fxl_screen_point *screen)
{
    fxl_status status = fxl_project_point(lens, view, screen);
    ref_lens exact_lens = bridge_lens(lens);
    ref_view_point exact_view = bridge_view_point(view);
    if (view->z < FXL_PROJECT_DEPTH_MIN) {
        tally->mismatched += status != FXL_E_RANGE;
        return 0;
    }
    ref_screen_point exact = ref_project_point(&exact_lens, &exact_view);
    double reach = fmax(fabs(exact.x), fabs(exact.y)) - FXL_SCREEN_COORDINATE_MAX / REF_ONE;
    if (status != FXL_OK) { /* correct only at the end of the range, to within the rounding */
        tally->mismatched += status != FXL_E_RANGE || reach * REF_ONE < -1;
        return 0;
    }
    tally->mismatched += reach * REF_ONE > 1;
    double dx = fabs(screen->x - exact.x * REF_ONE), dy = fabs(screen->y - exact.y * REF_ONE);
    double off_x = fabs(exact.x - exact_lens.width / 2.0) * REF_ONE;
    double off_y = fabs(exact.y - exact_lens.height / 2.0) * REF_ONE;
    /* 1e-6 covers the reference renderer's own rounding to double, 2^-42 pixel. */
    int within = dx <= 0.5 + 0x1p-31 * off_x + 0x1p-30 + 1e-6 &&
                 dy <= 0.5 + 0x1p-31 * off_y + 0x1p-30 + 1e-6;
    stages_count(tally, fmax(dx, dy), within);
    return 1;
}

/* --- spheres and boxes --------------------------------------------------------------------------- */

_Static_assert(FXL_SPHERE_OUTSIDE == REF_SPHERE_OUTSIDE, "the same answers");

const stages_tally stages_sphere_tally = {
    .stage = "sphere",
    .unit = "1/65536 world unit",
    .measure =
        "how far from the reference's reach, radius + 2^-9, a plane lies about which the two "
        "disagree, both given the same camera matrix, planes, centre and radius",
    .bound = "64",
};

/* Returns how far the reach that explains the library's result for a plane must be from that of
 * the reference renderer. */
static double off_by(const ref_sphere_distances *distances, double reach, uint32_t fixed,
                     uint32_t exact)
{
    double outermost = -INFINITY, off = 0;
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        double inside = (double)distances->inside[plane];
        outermost = fmax(outermost, -inside);
        if ((fixed ^ exact) >> plane & 1u) {
            off = fmax(off, fabs(inside - reach));
        }
    }
    bool outside = fixed == FXL_SPHERE_OUTSIDE, reference_outside = exact == REF_SPHERE_OUTSIDE;
    return outside != reference_outside ? fabs(outermost - reach) : off;
}

uint32_t stages_measure_sphere(stages_tally *tally, const fxl_camera *camera,
                               const fxl_view_frustum *frustum, const fxl_point *centre,
                               fxl_q16_16 radius)
{
    uint32_t fixed = fxl_sphere_planes(camera, frustum, centre, radius);
    ref_camera exact_camera = bridge_camera(camera);
    ref_view_frustum exact_frustum = bridge_view_frustum(frustum);
    ref_point exact_centre = bridge_point(centre);
    ref_sphere_distances distances =
        ref_sphere_measure(&exact_camera, &exact_frustum, &exact_centre);
    double exact_radius = radius / REF_ONE;
    uint32_t exact = ref_sphere_planes(&distances, exact_radius);
    double off = off_by(&distances, exact_radius + REF_SPHERE_SLACK, fixed, exact) * REF_ONE;
    tally->mismatched += fixed > FXL_SPHERE_OUTSIDE;
    stages_count(tally, off, off <= 64);
    return fixed;
}

uint32_t stages_measure_box(stages_tally *tally, const fxl_frustum *frustum, const fxl_scene *scene,
                            const fxl_instance *instance)
{
    ref_frustum exact;
    fxl_box box;
    fxl_box_of_instance(scene, instance, &box);
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        exact.planes[plane] = bridge_plane(&frustum->planes[plane]);
    }
    ref_point least = bridge_point(&box.least), most = bridge_point(&box.most);
    uint32_t fixed = fxl_box_planes(frustum, &box);
    tally->mismatched += fixed != ref_box_planes(&exact, &least, &most);
    return fixed;
}

void stages_check_left_out(stages_tally *tally, const fxl_camera *camera,
                           const fxl_view_frustum *frustum, uint32_t planes,
                           const fxl_polygon *polygon)
{
    ref_camera exact_camera = bridge_camera(camera);
    ref_view_frustum exact_frustum = bridge_view_frustum(frustum);
    ref_polygon exact = bridge_polygon(polygon);
    bool someone_inside_all = true;
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        int inside = 0;
        for (int i = 0; i < exact.count; i++) {
            ref_view_point seen = ref_transform_point(&exact_camera, &exact.vertices[i].position);
            inside += ref_view_distance(&exact_frustum.planes[plane], &seen) >= 0;
        }
        someone_inside_all = someone_inside_all && inside > 0;
        if (planes != FXL_SPHERE_OUTSIDE && (planes >> plane & 1u) == 0) {
            tally->mismatched += inside != exact.count;
        }
    }
    tally->mismatched += planes == FXL_SPHERE_OUTSIDE && someone_inside_all;
}
