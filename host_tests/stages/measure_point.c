/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "reference/project.h"
#include "reference/transform.h"
#include "stages/bridge.h"
#include "stages/measure.h"

stages_tally stages_transform_tally(const char *input) {
    return (stages_tally){
        .stage = "transform",
        .input = input,
        .unit = "1/65536 world unit",
        .measure = "largest coordinate difference of a view point from the twin's, both given the "
                   "same camera matrix and point; max_relative is the same divided by the largest "
                   "coordinate, in units of 2^-31",
        .bound = "2^-31 of the largest coordinate",
        .extra_names = {"max_relative"},
    };
}

void stages_measure_transform(stages_tally *tally, const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view) {
    fxl_transform_point(camera, point, view);
    ref_camera exact_camera = bridge_camera(camera);
    ref_point exact_point = bridge_point(point);
    ref_point exact = ref_transform_point(&exact_camera, &exact_point);
    ref_point fixed = bridge_view_point(view);
    double difference =
        fmax(fabs(fixed.x - exact.x), fmax(fabs(fixed.y - exact.y), fabs(fixed.z - exact.z)));
    double largest = fmax(fabs(exact.x), fmax(fabs(exact.y), fabs(exact.z)));
    /* 1e-5: the twin's own roundings, 2^-51 or so of the largest coordinate. */
    int within = difference <= largest * 0x1p-31 * (1 + 1e-5);
    stages_count(tally, REF_ONE * difference, within);
    if (largest > 0) {
        stages_extra(tally, 0, difference / largest * 0x1p31);
    }
}

stages_tally stages_project_tally(const char *input) {
    return (stages_tally){
        .stage = "project",
        .input = input,
        .unit = "1/65536 pixel",
        .measure = "larger coordinate difference of a screen point from the twin's, both given the "
                   "same view point and focal length",
        .bound = "0.5 + 2^-30 (|x - width/2| + focal max(1, |X/Z|, |Y/Z|)), in 1/65536 pixel",
    };
}

int stages_measure_project(stages_tally *tally, const fxl_lens *lens, const fxl_view_point *view,
                           fxl_screen_point *screen) {
    fxl_status status = fxl_project_point(lens, view, screen);
    ref_lens exact_lens = bridge_lens(lens);
    ref_point exact_view = bridge_view_point(view);
    if (exact_view.z <= 0) {
        tally->mismatched += status != FXL_E_RANGE;
        return 0;
    }
    ref_screen_point exact = ref_project_point(&exact_lens, &exact_view);
    double reach = fmax(fabs(exact.x), fabs(exact.y)) - FXL_SCREEN_COORDINATE_MAX / REF_ONE;
    if (status != FXL_OK) { /* right only at the range's end, to within the rounding */
        tally->mismatched += status != FXL_E_RANGE || reach * REF_ONE < -1;
        return 0;
    }
    tally->mismatched += reach * REF_ONE > 1;
    double dx = fabs(screen->x - exact.x * REF_ONE), dy = fabs(screen->y - exact.y * REF_ONE);
    double slope = fmax(1, fmax(fabs(exact_view.x), fabs(exact_view.y)) / exact_view.z);
    double off_centre =
        fmax(fabs(exact.x - exact_lens.width / 2.0), fabs(exact.y - exact_lens.height / 2.0));
    double bound = 0.5 + 0x1p-30 * REF_ONE * (off_centre + exact_lens.focal * slope);
    stages_count(tally, fmax(dx, dy), fmax(dx, dy) <= bound + 1e-6);
    return 1;
}
