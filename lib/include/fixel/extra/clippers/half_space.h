/* SPDX-License-Identifier: MIT */
/* Convex volumes of six half-spaces, as homogeneous vectors, and what lies within
 * them: points, polygons. line.h cuts lines. Source: notes on homogeneous view
 * volumes (D1, D2, D5, D6); planes of the world and of the view by one clipper: C7. */
#ifndef FXL_HALF_SPACE_H
#define FXL_HALF_SPACE_H

#include "fixel/extra/clippers/clip_record.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point (x, y, z, 1) of the view is inside where
 *   normal . (x, y, z) + offset >= 0.
 * The normal need not have unit length: |x| + |y| + |z| < 2^31. |offset| < 2^62,
 * in units of 2^-46. These integers are the plane. */
typedef struct {
    fxl_direction normal;
    fxl_q18_46 offset;
} fxl_half_space;

/* In the order of FXL_PLANE_...; any six will do. */
typedef struct {
    fxl_half_space planes[FXL_PLANE_COUNT];
} fxl_volume;

/* How far from the screen's centre the guard band reaches, in pixels: a polygon
 * within it stays within FXL_SCREEN_COORDINATE_MAX on any screen, with room for the
 * clipper's rounding, however near. */
#define FXL_GUARD_PIXELS 3500

/* The planes of a lens, exactly those of fxl_view_frustum_from_lens, for those with
 * a bit in screen (1 << FXL_PLANE_...); the others of the four sides lie at the
 * guard band, exactly: focal |X| <= FXL_GUARD_PIXELS Z. Near and far must have
 * their bits. */
void fxl_volume_from_lens(const fxl_lens *lens, uint32_t screen, fxl_volume *volume);

/* The same, for who has the lens's frustum already. */
void fxl_volume_from_sides(const fxl_view_frustum *sides, fxl_q16_16 focal, uint32_t screen,
                           fxl_volume *volume);

/* A frustum that need not be upright before the eye: its window, on the plane
 * z = near, reaches from left to right and from bottom to top, where they may lie
 * both on one side. Exact. FXL_E_RANGE, volume untouched: near below FXL_NEAR_MIN or
 * not below far, far above FXL_FAR_MAX, near or a side beyond FXL_COORDINATE_MAX,
 * or left not below right or bottom not below top. */
fxl_status fxl_volume_from_window(fxl_q16_16 left, fxl_q16_16 right, fxl_q16_16 bottom,
                                  fxl_q16_16 top, fxl_q16_16 near_z, fxl_q16_16 far_z,
                                  fxl_volume *volume);

/* A plane of the world for polygons whose vertices lie in the world: the same clipper
 * serves there, on the same integers. Requires a plane made by its function. */
void fxl_half_space_from_plane(const fxl_plane *plane, fxl_half_space *half_space);

/* A point of the world in units of 2^-46; below 2^59. Exact. Requires a point in range. */
void fxl_clip_place(const fxl_point *point, fxl_view_point *place);

/* The left side of the above, rounded downward to a unit of 2^-46: below 2^63, and
 * the sign cannot err. Requires |x|, |y|, |z| < 2^61. */
fxl_q18_46 fxl_half_space_distance(const fxl_half_space *plane, const fxl_view_point *point);

/* A bit, 1 << its place, for each plane that the point lies outside of. */
uint32_t fxl_volume_code(const fxl_volume *volume, const fxl_view_point *point);

/* Whether a point is inside of all six. Exact. */
bool fxl_volume_holds(const fxl_volume *volume, const fxl_view_point *point);

/* Clips a polygon to one half-space; the rules are those of fxl_clip_world_to_plane. */
fxl_clip_result fxl_clip_to_half_space(const fxl_varying_polygon *in, const fxl_half_space *plane,
                                       fxl_clip_stats *stats, fxl_varying_polygon *out,
                                       fxl_q18_46 *distances);

/* Clips a polygon to a volume. One with all vertices outside of one plane, or
 * inside of all, is known by codes; otherwise it is cut by those planes alone that
 * a vertex lies outside of, in their order. Else as fxl_clip_normalised. */
fxl_clip_result fxl_clip_to_volume(const fxl_varying_polygon *in, const fxl_volume *volume,
                                   fxl_clip_workspace *workspace,
                                   const fxl_varying_polygon **result);

#ifdef __cplusplus
}
#endif

#endif
