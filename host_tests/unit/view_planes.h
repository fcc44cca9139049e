/* SPDX-License-Identifier: MIT */
#ifndef VIEW_PLANES_H
#define VIEW_PLANES_H

#include "unit.h"

/* The camera of a pose, and the planes of its view: in the view and in the world. */
static inline void view_planes_look(const fxl_pose *pose, const fxl_lens *lens, fxl_camera *camera,
                                    fxl_view_frustum *frustum, fxl_frustum *world)
{
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, camera));
    fxl_view_frustum_from_lens(lens, frustum);
    fxl_frustum_from_camera(camera, lens, world);
}

#endif
