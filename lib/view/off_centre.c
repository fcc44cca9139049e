/* SPDX-License-Identifier: MIT */
/* The view of an off-centre lens: that of a centred lens with sheared axes (SPEC.md, section 4.2).
 *
 * Let f be the focal length and (a, b) the offset of the centre from the middle of the screen, to
 * the right and upward. The point (X, Y, Z) of the unsheared view lies on the screen at
 *   (a + f X / Z, b + f Y / Z) = ((f X + a Z) / Z, (f Y + b Z) / Z)
 * from the middle. With a focal length F and
 *   right' = (f right + a forward) / F,  up' = (f up + b forward) / F
 * that is (F X' / Z, F Y' / Z): the projection of a centred lens. F is at least the length of (f,
 * a) and of (f, b), so neither row is longer than 1, and everything that holds of a centred view
 * holds of this one: no coordinate, product or sum is larger. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "../scene/lens.h"
#include "project.h"
#include "view.h"

/* To the right and upward. */
static int32_t offset_x(const fxl_lens *lens)
{
    return lens->centre_x - lens->width * 32768;
}

static int32_t offset_y(const fxl_lens *lens)
{
    return lens->height * 32768 - lens->centre_y;
}

/* F. The focal length is below 5853 pixels and the offsets are at most 1536, so the squares are
 * below 2^58, and F is below 6052 pixels, which is below 2^29. F exceeds the length by 2^-25 of it
 * at least: 32 units of 2^-30. The rows of a camera are off by 2 units an entry, so what they make
 * is longer by less than 6, and no longer than 1 after all. */
/* SPEC 4.2 */
static fxl_q16_16 drawn_focal(const fxl_lens *lens)
{
    const uint64_t x = fxl_magnitude(offset_x(lens)), y = fxl_magnitude(offset_y(lens));
    const uint64_t offset = x > y ? x : y;
    const uint32_t length =
        fxl_square_root((uint64_t)lens->focal * (uint64_t)lens->focal + offset * offset);
    return (fxl_q16_16)(length + (length >> 25) + 2);
}

/* 2^30 / sqrt(2), less 1: enough for the rounding. */
#define ROOT_HALF 759250123

/* SPEC 4.3 */
static fxl_q2_30 shortened(fxl_q2_30 component)
{
    return (fxl_q2_30)fxl_round_shift(fxl_multiply_s32(component, ROOT_HALF), 30);
}

/* With n = (F^2 + (w/2)^2)^1/2 the normal of the left plane in the unsheared view is
 * (f, 0, w/2 + a) / n. Its square is at most (F^2 + (w/2)^2 + w |a|) / n^2 <= 2, since w |a| is at
 * most (w/2)^2 + a^2. The sphere test wants normals that are no longer than 1; so all are divided
 * by the root of 2. */
static void set_lens(fxl_view *view)
{
    fxl_view_frustum *frustum = &view->view_frustum;
    fxl_lens drawn = view->lens;
    drawn.focal = drawn_focal(&drawn);
    fxl_view_frustum_from_lens(&drawn, frustum);
    fxl_projection_from_lens(&drawn, &view->projection);
    frustum->x_side = shortened(frustum->x_side);
    frustum->x_depth = shortened(frustum->x_depth);
    frustum->y_side = shortened(frustum->y_side);
    frustum->y_depth = shortened(frustum->y_depth);
    frustum->x_slope = frustum->y_slope = 0;
}

/* The focal length and the offset are below 2^29 and an entry at most 2^30, so each product is
 * below 2^59. Rounding: half a unit. The rows that go in are off by 2 units, which the sum takes by
 * at most root 2: 3.4 units of 2^-30 in all. */
/* SPEC 4.2 */
static void shear(fxl_direction *row, const fxl_direction *forward, const fxl_lens *lens,
                  int32_t offset, fxl_q16_16 focal)
{
    int32_t *to[3] = {&row->x, &row->y, &row->z};
    const int32_t ahead[3] = {forward->x, forward->y, forward->z};
    for (uint32_t i = 0; i < 3; i++) {
        *to[i] = fxl_divide_round(fxl_multiply_s32(lens->focal, *to[i]) +
                                      fxl_multiply_s32(offset, ahead[i]),
                                  (uint32_t)focal);
    }
}

static fxl_status set_pose(fxl_view *view, const fxl_pose *pose)
{
    const fxl_status status = fxl_view_set_own_pose(view, pose);
    if (status != FXL_OK) {
        return status;
    }
    fxl_axes *axes = &view->camera.axes;
    const fxl_lens *lens = &view->lens;
    const fxl_q16_16 focal = fxl_view_drawn_focal(view);
    shear(&axes->right, &axes->forward, lens, offset_x(lens), focal);
    shear(&axes->up, &axes->forward, lens, offset_y(lens), focal);
    return FXL_OK;
}

const fxl_off_centre_code fxl_off_centre = {fxl_off_centre_is_valid, set_lens, set_pose, NULL};
