/* SPDX-License-Identifier: MIT */
/* The default clipper, and the parts that its kernel and the rest of it share. Internal. */
#ifndef FXL_CLIP_BY_VIEW_H
#define FXL_CLIP_BY_VIEW_H

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The function clip of fxl_clipper_view. It transforms the face's vertices, then clips in the view
 * on exact sums, then projects.
 * Error: the outline on the screen is within 1.25/65536 pixel of the exact one, with the exceptions
 * of docs/accuracy.md, section 3. Source: A12. */
fxl_clip_result fxl_clip_by_view(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen);

/* Assembles a face, cuts it by the planes that a vertex is outside of, and projects it. It serves
 * the faces with a vertex that is outside a plane, but not all with the same one. */
fxl_clip_result fxl_clip_assembled(const fxl_model_view *model_view, const fxl_face *face,
                                   fxl_clipper_work *work, fxl_screen_polygon *screen);

/* The first pixel centre of a vertex, in clip_flags, for a vertex that is inside all planes and
 * projected: the first column whose centre is not left of the vertex, and the first row whose
 * centre is not above it. If all vertices of a polygon have the same row, or the same column, the
 * polygon covers no centre. Inside all planes both are 0..FXL_SCREEN_MAX: 12 bits each. */
#define FXL_VERTEX_COLUMN 0x000FFF00u
#define FXL_VERTEX_ROW    0xFFF00000u

/* place fill-rule: the first centres of a vertex */
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
