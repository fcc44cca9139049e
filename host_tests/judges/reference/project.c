/* SPDX-License-Identifier: MIT */
#include "reference/project.h"

ref_screen_point ref_project_point(const ref_lens *lens, const ref_view_point *view)
{
    return (ref_screen_point){(double)(lens->centre_x + lens->focal * view->x / view->z),
                              (double)(lens->centre_y - lens->focal * view->y / view->z)};
}

ref_view_point ref_ray_through(const ref_lens *lens, const ref_screen_point *screen)
{
    return (ref_view_point){(long double)screen->x - lens->centre_x,
                            (long double)lens->centre_y - screen->y, lens->focal};
}

void ref_project_polygon(const ref_lens *lens, const ref_view_polygon *view,
                         ref_screen_polygon *screen)
{
    screen->colour = view->colour;
    screen->count = view->count;
    for (int i = 0; i < view->count; i++) {
        screen->points[i] = ref_project_point(lens, &view->vertices[i].position);
    }
}
