/* SPDX-License-Identifier: MIT */
/* Clipping triangles: by planes before projection, then by the four borders of the
 * screen in two dimensions, through a queue. Source: notes on clipping triangles
 * before and after projection (B3, B4). */
#ifndef FXL_TRIANGLE_H
#define FXL_TRIANGLE_H

#include "fixel/extra/clippers/half_space.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    fxl_varying_vertex corners[3];
} fxl_clip_triangle;

/* A corner on the screen; the depth is the view point's z, so that what rides along
 * can be cut as in space. */
typedef struct {
    fxl_screen_point at;
    fxl_q18_46 depth;
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_screen_corner;

typedef struct {
    fxl_screen_corner corners[3];
} fxl_screen_triangle;

/* Cuts a triangle by one half-space: none is left where all corners are outside,
 * itself where all are inside, one where one corner is inside, two where two are.
 * Answers how many, 0..2, and puts them into out, in which the triangle itself must
 * not lie. A corner on the plane is inside; what has no area for it is left out.
 * The rest is as fxl_clip_world_to_plane has it; the sliver rule holds. */
uint32_t fxl_triangle_cut(const fxl_clip_triangle *in, const fxl_half_space *plane,
                          uint32_t carried, fxl_clip_stats *stats, fxl_clip_triangle out[2]);

/* Which border of the screen. */
enum {
    FXL_BORDER_LEFT,
    FXL_BORDER_RIGHT,
    FXL_BORDER_TOP,
    FXL_BORDER_BOTTOM,
    FXL_BORDER_COUNT
};

/* The same on the screen, by the border x = 0, x = width, y = 0 or y = height. Such as
 * are turned into a line or a point by rounding are left out, too. Requires coordinates
 * within FXL_SCREEN_COORDINATE_MAX, depths of 2^37 at least and below 2^61.
 * Error of a new corner: on the border exactly, half a unit of 1/65536 pixel along it
 * from the edge; what rides along 0.51 unit of 2^-16, given the fraction of the edge
 * in space that the border's crossing means, good to 2^-59. The sliver rule's unit
 * is 1/65536 pixel here. */
uint32_t fxl_triangle_cut_screen(const fxl_screen_triangle *in, int border, uint16_t extent,
                                 uint32_t carried, fxl_clip_stats *stats,
                                 fxl_screen_triangle out[2]);

/* How many triangles may wait. Planes go into depth: each leaves at most one more to
 * come back to. Borders go through a queue, each at most doubling it. Neither can be
 * overrun. */
#define FXL_TRIANGLE_STACK (FXL_PLANE_COUNT + 1)
#define FXL_TRIANGLE_QUEUE (1u << FXL_BORDER_COUNT)

/* What clipping a triangle needs. The caller owns it; of its contents only the account
 * and screen_sliver mean anything to him. */
typedef struct {
    fxl_clip_stats stats;
    fxl_q16_16 screen_sliver; /* the sliver rule of the borders, in 1/65536 pixel; 0: none */
    uint8_t carried;
    uint32_t planes; /* those that a corner lies outside of */
    uint32_t solid_count, flat_first, flat_count;
    uint8_t next_plane[FXL_TRIANGLE_STACK];
    fxl_clip_triangle solids[FXL_TRIANGLE_STACK];
    fxl_screen_triangle flats[FXL_TRIANGLE_QUEUE];
} fxl_triangle_workspace;

/* Begins to clip a triangle of the view to a volume that keeps it in range of the
 * screen, as fxl_volume_from_lens does with near and far alone: by the planes that a
 * corner lies outside of. FXL_CLIP_OUTSIDE: nothing is seen, by the corners' codes.
 * FXL_CLIP_INSIDE, FXL_CLIP_CUT: the volume holds it, or not all of it;
 * fxl_triangle_next gives what is seen, if anything. */
fxl_clip_result fxl_triangle_begin(const fxl_clip_triangle *in, uint32_t carried,
                                   const fxl_volume *volume, fxl_triangle_workspace *workspace);

/* The next triangle, within the screen; null when there are no more. It stays until the
 * next call. FXL_E_RANGE in *status, and null, where a corner leaves the range after
 * all, which the guard band rules out. */
const fxl_screen_triangle *fxl_triangle_next(const fxl_volume *volume, const fxl_lens *lens,
                                             fxl_triangle_workspace *workspace, fxl_status *status);

#ifdef __cplusplus
}
#endif

#endif
