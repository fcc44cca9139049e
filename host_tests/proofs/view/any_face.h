/* SPDX-License-Identifier: MIT */
/* Any face of a model, for rows of what goes through its corners. */
#ifndef ANY_FACE_H
#define ANY_FACE_H

#include "proof.h"
#include "fixel/records.h"

#define CORNERS  FXL_FACE_VERTICES_MAX
#define VERTICES 8 /* of the model */

static uint16_t indices[CORNERS];
static fxl_face face;

/* Of 3 to 24 corners, at any vertices of the model. */
static inline void any_face(void)
{
    ANY_CONTENT(indices);
    ANY_CONTENT(&face);
    ASSUME(face.count >= 3 && face.count <= CORNERS && (face.count == 3 || (face.indices[1] == 0 && face.indices[2] == 0)));
    for (uint32_t i = 0; i < CORNERS; i++) {
        ASSUME(indices[i] < VERTICES && (face.count != 3 || i >= 3 || face.indices[i] < VERTICES));
    }
}

#endif
