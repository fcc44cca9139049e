/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "reference/camera.h"
#include "stages/bridge.h"
#include "stages/measure.h"

stages_tally stages_transform_tally(const char *input)
{
    return (stages_tally){
        .stage = "transform",
        .input = input,
        .unit = "1/65536 world unit",
        .measure =
            "largest coordinate difference of a view point from the reference's, both given the "
            "same camera matrix and point; the reference sums in 64 bits, which hold every "
            "such sum",
        .bound = "0",
    };
}

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

stages_tally stages_project_tally(const char *input)
{
    return (stages_tally){
        .stage = "project",
        .input = input,
        .unit = "1/65536 pixel",
        .measure =
            "larger coordinate difference of a screen point from the reference's, both given the "
            "same view point and focal length",
        .bound = "0.5 + 2^-31 |x - width/2| + 2^-30, likewise y, in 1/65536 pixel",
    };
}

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
