/* SPDX-License-Identifier: MIT */
/* The slow path of project: for points that the kernels cannot project. Internal. */
#ifndef FXL_PROJECT_ANY_H
#define FXL_PROJECT_ANY_H

#include "fixel/stage/project.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The same as fxl_project_visible, for any point, by a long division. */
fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen);

#ifdef __cplusplus
}
#endif

#endif
