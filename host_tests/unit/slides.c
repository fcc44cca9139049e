/* SPDX-License-Identifier: MIT */
#include "slides.h"

void slides_stay_free(const fxl_scene *scene, fxl_sphere *sphere,
                      double (*distance)(const fxl_point *point), fxl_q16_16 slack,
                      slide_counts *counts)
{
    for (int i = 0; i < 8; i++) {
        const fxl_point move = unit_point(unit_random() % 4 ? sphere->radius : 16 * sphere->radius);
        const fxl_point before = sphere->centre;
        fxl_slide slide;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_slide_sphere(scene, sphere, &move, &slide));
        TEST_ASSERT_TRUE(distance(&sphere->centre) >= sphere->radius - slack);
        counts->contacts += slide.contacts;
        counts->slid += slide.contacts > 0 && slide.blocked == 0;
        if (slide.contacts == 0) {
            const fxl_point middle = {before.x + move.x / 2, before.y + move.y / 2,
                                      before.z + move.z / 2};
            TEST_ASSERT_TRUE(distance(&middle) >= sphere->radius / 2 - slack);
            TEST_ASSERT_EQUAL_INT32(before.x + move.x, sphere->centre.x);
        }
    }
}
