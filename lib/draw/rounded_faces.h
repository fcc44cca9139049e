/* SPDX-License-Identifier: MIT */
/* The faces of a turned instance as polygons of the world, whose points are rounded: what a
 * clipper, a shader or an order needs that cuts faces there. These name fxl_rounded_faces, so a
 * program with none of them does not link it. Internal. */
#ifndef FXL_ROUNDED_FACES_H
#define FXL_ROUNDED_FACES_H

#include "submit.h"

/* The instance whose faces are rounded. It is the model view's shader, of the code
 * fxl_rounded_faces, so that fxl_submit_face leaves the faces to it. */
typedef struct fxl_rounded_instance {
    fxl_shader shader;
    uint32_t number;
    fxl_planes planes; /* that its points may lie outside of */
} fxl_rounded_instance;

#endif
