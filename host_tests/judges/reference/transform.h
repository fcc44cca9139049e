/* SPDX-License-Identifier: MIT */
/* The transform from the world into the view (SPEC.md, section 4.6). */
#ifndef REF_TRANSFORM_H
#define REF_TRANSFORM_H

#include "reference/camera.h"

/* Summed in 64 bits: exact where matrix and point are the library's integers. */
ref_view_point ref_transform_point(const ref_camera *camera, const ref_point *point);
void ref_transform_polygon(const ref_camera *camera, const ref_polygon *polygon,
                           ref_view_polygon *view);

#endif
