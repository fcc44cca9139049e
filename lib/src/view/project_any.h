/* SPDX-License-Identifier: MIT */
/* The long way of project, which its kernels leave to it what they cannot do.
 * Internal. */
#ifndef FXL_PROJECT_ANY_H
#define FXL_PROJECT_ANY_H

#include "fixel/stage/project.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What fxl_project_visible answers, for any point, by a long division. */
fxl_status fxl_project_any(const fxl_projection *projection, const fxl_view_point *view,
                           fxl_screen_point *screen);

#ifdef __cplusplus
}
#endif

#endif
