/* SPDX-License-Identifier: MIT */
/* Cameras: the lens, which is what a screen shows of the view, and the directions of a pose. */
#ifndef FXL_CAMERA_H
#define FXL_CAMERA_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- the lens --------------------------------------------------------------------------- */

/* Makes a lens from a horizontal field of view:
 *   focal = (width / 2) / tan(fov / 2), for both axes (square pixels).
 * Its centre is the middle of the screen.
 * width and height are in pixels; near_z, far_z and inset are in world units.
 * Requires width, height in 1..FXL_SCREEN_MAX; fov in FXL_FOV_MIN..FXL_FOV_MAX;
 * near_z >= FXL_NEAR_MIN; far_z <= FXL_FAR_MAX; 0 <= inset <= FXL_INSET_MAX;
 * near_z + 2 * inset < far_z.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: lens untouched.
 * Error of focal: at most 1 unit of 1/65536 pixel plus focal * 2^-27.
 * Source: A4. */
fxl_status fxl_lens_from_fov(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near_z,
                             fxl_q16_16 far_z, fxl_q16_16 inset, fxl_lens *lens);

/* --- off-centre ------------------------------------------------------------------------- */

/* A window that is wider to one side than to the other: one display of several that show one
 * picture, or a display that is a window in front of a viewer who moves. The focal length stays,
 * and so does the perspective: the picture of the moved lens is a part of one larger picture.
 *
 * Every function that takes an fxl_lens to draw with takes such a lens. */

/* Moves the centre of a lens to the point (x, y) of the screen, in pixels, y down. The middle of
 * the screen makes it a lens as fxl_lens_from_fov does.
 * Requires a lens made by the functions of this header.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: its inset is not 0, or the centre is farther from the middle of the screen than one
 * and a half times the width in x, or the height in y, or than four focal lengths in x or y. Of an
 * orthographic lens: than FXL_ORTHOGRAPHIC_CENTRE_MAX in x or y. Its eye is then moved, for each pose, by
 * as many world units as the centre is away from the middle (pixels / scale): a pose for which that
 * is beyond FXL_COORDINATE_MAX is refused.
 * With each of these statuses: lens untouched.
 * Exact.
 * Source: D1. */
fxl_status fxl_lens_set_centre(fxl_lens *lens, fxl_q16_16 x, fxl_q16_16 y);

/* Makes the lens of a part of a screen: the pixels x <= column < x + width, y <= row < y + height,
 * which may lie beyond the screen. With the same pose it draws what the whole shows there; a pixel
 * may differ if its centre lies within 1/8192 pixel of an edge.
 * Requires a lens made by the functions of this header; part may be whole.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the part is not 1..FXL_SCREEN_MAX pixels wide and high, its centre is out of the
 * range of fxl_lens_set_centre, or it is so narrow that its field of view is below FXL_FOV_MIN, but
 * that of an orthographic lens, which has none.
 * With each of these statuses: part untouched.
 * Exact. */
fxl_status fxl_lens_of_part(const fxl_lens *whole, int16_t x, int16_t y, uint16_t width,
                            uint16_t height, fxl_lens *part);

/* Makes the lens of a window: the eye looks through a rectangle in the plane z = near_z, whose
 * sides lie at left < right and bottom < top, in world units. The screen shows the rectangle;
 * its pixels are square, so its height follows from its width and is rounded to whole pixels, and
 * the last row may show up to half a pixel more or less than the window. The lens has no inset.
 * Requires |left|, |right|, |bottom|, |top| <= FXL_COORDINATE_MAX; a width in 1..FXL_SCREEN_MAX;
 * near_z and far_z as fxl_lens_from_fov.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: one of these, a height, a focal length or a centre is out of its range.
 * With each of these statuses: lens untouched.
 * Error: half a unit of 1/65536 pixel in focal and centre.
 * Source: D1. */
fxl_status fxl_lens_from_window(uint16_t width, fxl_q16_16 left, fxl_q16_16 right,
                                fxl_q16_16 bottom, fxl_q16_16 top, fxl_q16_16 near_z,
                                fxl_q16_16 far_z, fxl_lens *lens);

/* --- orthographic ------------------------------------------------------------------------ */

/* Makes a lens with which a thing has the same size at every depth: `scale` pixels a world unit, in
 * 16.16. Its centre is the middle of the screen, and it has no inset.
 * Requires width, height in 1..FXL_SCREEN_MAX; scale in
 * FXL_ORTHOGRAPHIC_SCALE_MIN..FXL_ORTHOGRAPHIC_SCALE_MAX; near_z >= FXL_NEAR_MIN;
 * near_z < far_z <= FXL_FAR_MAX.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: lens untouched.
 * Exact. */
fxl_status fxl_lens_orthographic(uint16_t width, uint16_t height, fxl_q16_16 scale,
                                 fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_lens *lens);

/* Pitches of the usual poses of maps of tiles, with a yaw of 45 degrees (FXL_ANGLE_QUARTER / 2).
 * Isometric: the three edges of a cube are equally long, -asin(1 / sqrt(3)). Dimetric: an edge of the
 * ground goes one pixel down in two, -30 degrees. */
#define FXL_PITCH_ISOMETRIC FXL_CAST(fxl_angle, 3874246739u)
#define FXL_PITCH_DIMETRIC  FXL_DEGREES(-30)

/* --- the directions of a pose ------------------------------------------------------------ */

/* A rotation: its rows are the axes that it turns x, y and z of the view to. */
typedef struct {
    fxl_direction right, up, forward;
} fxl_axes;

/* The view matrix: the position of the eye, and the world-to-view rotation. */
typedef struct fxl_camera {
    fxl_point position;
    fxl_axes axes;
} fxl_camera;

/* Sets up a camera from a pose:
 *   forward = ( cos p sin y,  sin p, cos p cos y)
 *   right   = ( cos r cos y - sin r sin p sin y,  sin r cos p, -cos r sin y - sin r sin p cos y)
 *   up      = (-sin r cos y - cos r sin p sin y,  cos r cos p,  sin r sin y - cos r sin p cos y)
 * Requires |position| <= FXL_COORDINATE_MAX in each coordinate. Takes any angles.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: camera untouched.
 * Error: at most 2 units of 2^-30 an entry.
 * Source: Listing 65.3, UpdateViewPos. SPEC.md, section 1.4, says where sign and order of the
 * angles follow the Black Book's text and not its listing. */
fxl_status fxl_camera_from_pose(const fxl_pose *pose, fxl_camera *camera);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_camera_reasons[];

#ifdef __cplusplus
}
#endif

#endif
