/* SPDX-License-Identifier: MIT */
/* Where the records of surfaces have their fields in a scene image (docs/formats.md).
 * Written by `fixel formats` of tools/fixel/image/fields.py: change that. Internal. */
#ifndef FXL_SURFACE_SECTIONS_H
#define FXL_SURFACE_SECTIONS_H

#include "../scene/scene_header.h"
#include "fixel/surfaces.h"

FXL_STATIC_ASSERT(sizeof(fxl_surface) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, texture) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, division) == 2, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, flags) == 3, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, opacity) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, sixteenths) == 5, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, reserved) == 6, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, first_corner) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_mapped_face) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, surface) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, corners) == 2, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_corner) == 12, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_corner, texel) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_corner, vertex) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_corner, normal) == 10, FXL_AS_DOCUMENTED);

#endif
