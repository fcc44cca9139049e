/* SPDX-License-Identifier: MIT */
/* Clips triangles: to planes before the projection, then to the four borders of the screen in
 * two dimensions, through a queue. Source: notes on clipping triangles before and after
 * projection (B3, B4). */
#ifndef FXL_TRIANGLE_H
#define FXL_TRIANGLE_H

#include "fixel/line.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    fxl_varying_vertex corners[3];
} fxl_clip_triangle;

/* A vertex on the screen. depth is the z of the view point: the varyings are cut in proportion
 * to distances in space, not on the screen. */
typedef struct {
    fxl_screen_point at;
    fxl_q18_46 depth;
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_screen_corner;

typedef struct {
    fxl_screen_corner corners[3];
} fxl_screen_triangle;

/* Clips a triangle to one half-space: leaves none where all three vertices are outside, the
 * triangle itself where all are inside, one where one vertex is inside, two where two are.
 * Returns how many are left, 0..2, and writes them to out. The input must not lie in out. A
 * vertex on the plane is inside. A triangle that has no area because its vertices lie on the
 * plane is left out. carried is the number of varyings used. The sliver rule of stats applies.
 * New vertices are computed as fxl_clip_to_half_space computes them. */
uint32_t fxl_triangle_cut(const fxl_clip_triangle *in, const fxl_half_space *plane,
                          uint32_t carried, fxl_clip_stats *stats, fxl_clip_triangle out[2]);

/* The borders of the screen. */
enum {
    FXL_BORDER_LEFT,
    FXL_BORDER_RIGHT,
    FXL_BORDER_TOP,
    FXL_BORDER_BOTTOM,
    FXL_BORDER_COUNT
};

/* Clips a triangle to one border of the screen: x = 0, x = width, y = 0 or y = height. extent is
 * that width or height, in pixels. A triangle that rounding turns into a line or a point is left
 * out, too. The unit of the sliver rule is 1/65536 pixel here. Requires coordinates within
 * FXL_SCREEN_COORDINATE_MAX, and depths of at least 2^37 and below 2^61.
 * Error of a new vertex: none across the border, half a unit of 1/65536 pixel along it from the
 * edge.
 * Error of a varying: 0.51 unit of 2^-16, given the fraction of the edge in space at which it
 * crosses the border; that fraction is good to 2^-59. */
uint32_t fxl_triangle_cut_screen(const fxl_screen_triangle *in, int border, uint16_t extent,
                                 uint32_t carried, fxl_clip_stats *stats,
                                 fxl_screen_triangle out[2]);

/* How many triangles may wait. The planes use a stack: each plane leaves at most one triangle to
 * come back to. The borders use a queue: each border at most doubles it. Neither can overflow. */
#define FXL_TRIANGLE_STACK (FXL_PLANE_COUNT + 1)
#define FXL_TRIANGLE_QUEUE (1u << FXL_BORDER_COUNT)

/* The memory that the triangle clipper needs. The caller owns it. Of its contents only stats and
 * screen_sliver have a meaning for the caller. */
typedef struct {
    fxl_clip_stats stats;
    fxl_q16_16 screen_sliver; /* the sliver rule of the borders, in 1/65536 pixel; 0: off */
    uint8_t carried;
    uint32_t planes; /* the planes that a vertex lies outside of */
    uint32_t solid_count, flat_first, flat_count;
    uint8_t next_plane[FXL_TRIANGLE_STACK];
    fxl_clip_triangle solids[FXL_TRIANGLE_STACK];
    fxl_screen_triangle flats[FXL_TRIANGLE_QUEUE];
} fxl_triangle_workspace;

/* Begins to clip a triangle of the view to the planes that one of its vertices lies outside of.
 * Requires a volume that keeps coordinates within the range of the screen, such as
 * fxl_volume_from_sides makes for near and far alone.
 * FXL_CLIP_OUTSIDE: the vertices' outcodes show that nothing is visible. FXL_CLIP_INSIDE: the
 * triangle lies in the volume. FXL_CLIP_CUT: a vertex lies outside the volume. After the last
 * two results, fxl_triangle_next returns the visible triangles, if any. */
fxl_clip_result fxl_triangle_begin(const fxl_clip_triangle *in, uint32_t carried,
                                   const fxl_volume *volume, fxl_triangle_workspace *workspace);

/* Returns the next triangle, which lies within the screen; null when there are no more. The
 * record is valid until the next call. *status is FXL_OK or:
 * FXL_E_RANGE: a vertex leaves the range of the screen, which the guard band rules out; the result
 * is null. */
const fxl_screen_triangle *fxl_triangle_next(const fxl_volume *volume, const fxl_lens *lens,
                                             fxl_triangle_workspace *workspace, fxl_status *status);

#ifdef __cplusplus
}
#endif

#endif
