/* SPDX-License-Identifier: MIT */
/* Where the records of surfaces have their fields in a scene image (docs/formats.md).
 * Written by `fixel formats` of tools/fixel/image/fields.py: change that. Internal. */
#ifndef FXL_SURFACE_SECTIONS_H
#define FXL_SURFACE_SECTIONS_H

#include "../scene/scene_header.h"
#include "fixel/surfaces.h"

FXL_STATIC_ASSERT(sizeof(fxl_surface) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, texture) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, division) == 2, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, flags) == 3, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, opacity) == 4, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, sixteenths) == 5, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_surface, reserved) == 6, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(sizeof(fxl_mapped_face) == 40, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, surface) == 0, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, vertices) == 2, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, normals) == 8, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, reserved) == 14, FXL_AS_DOCUMENTED);
FXL_STATIC_ASSERT(offsetof(fxl_mapped_face, texels) == 16, FXL_AS_DOCUMENTED);

#endif
