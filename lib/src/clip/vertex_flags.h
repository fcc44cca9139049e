/* SPDX-License-Identifier: MIT */
/* What fxl_clip_by_view, a kernel, shares with the rest of its clipper. Internal. */
#ifndef FXL_VERTEX_FLAGS_H
#define FXL_VERTEX_FLAGS_H

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "fixel/stage/clipper.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A face with a vertex that is outside, or with FXL_SMALL any: assembled, cut by the planes
 * that a vertex is outside of, and projected. */
fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The state of a vertex that is inside of all planes, at its place on the screen: the first
 * column whose centre is not left of it, and the first row whose centre is not above it. A
 * polygon whose vertices have the same row, or the same column, covers no centre. Inside of
 * all planes both are 0..FXL_SCREEN_MAX: 12 bits each. */
#define FXL_VERTEX_COLUMN 0x000FFF00u
#define FXL_VERTEX_ROW    0xFFF00000u

static inline uint32_t fxl_vertex_place_flags(const fxl_screen_point *screen)
{
    uint32_t column = (uint32_t)fxl_first_centre_from(screen->x);
    uint32_t row = (uint32_t)fxl_first_centre_from(screen->y);
    FXL_ASSERT(column <= FXL_SCREEN_MAX && row <= FXL_SCREEN_MAX);
    return row << 20 | column << 8;
}

#ifdef __cplusplus
}
#endif

#endif
