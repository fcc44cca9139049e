/* SPDX-License-Identifier: MIT */
/* The orthographic lens, its view and its projection, and what a renderer takes for it: a clipper and
 * an order in which no eye stands (docs/extras/orthographic.md). Only what makes such a lens names
 * this file's record. */
#include "orthographic.h"
#include "../math/arith.h"
#include "../view/project.h"
#include "fixel/camera.h"
#include "renderer.h"

/* --- the lens -------------------------------------------------------------------------------- */

/* The view's planes are those of any view (fxl_view_frustum) with an inset below 0: a point is inside
 * left and right if +-x_side x >= inset. The smaller extent of the screen says the inset, and the
 * larger one has a normal that is as much shorter. So sphere test, outcode and clip are those of any
 * view. */

/* orthographic 1.1 */
static bool is_valid(const fxl_lens *lens)
{
    return lens->inset == 0 && lens->focal >= FXL_ORTHOGRAPHIC_SCALE_MIN &&
           lens->focal <= FXL_ORTHOGRAPHIC_SCALE_MAX &&
           lens->centre_x == (int32_t)lens->width * 32768 &&
           lens->centre_y == (int32_t)lens->height * 32768;
}

fxl_status fxl_lens_orthographic(uint16_t width, uint16_t height, fxl_q16_16 scale,
                                 fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_lens *lens)
{
    if (lens == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_lens made = {width, height,        scale,          near_z,           far_z,
                           0,     width * 32768, height * 32768, &fxl_orthographic};
    if (!fxl_lens_is_valid(&made)) {
        return FXL_E_RANGE;
    }
    *lens = made;
    return FXL_OK;
}

/* The part that the smaller extent is of this one, at most 1. Below 2^41 / 1. */
static fxl_q2_30 side_of(uint32_t smaller, uint32_t extent)
{
    return fxl_divide_round((int64_t)smaller * FXL_Q2_30_ONE, extent);
}

/* Of C, as a power of two (fxl_flat_depth). */
static unsigned flat_shift(const fxl_lens *lens)
{
    const uint32_t larger = lens->width > lens->height ? lens->width : lens->height;
    unsigned shift = 0;
    while ((uint64_t)(uint32_t)lens->focal << (shift + 1) < (uint64_t)larger << 16) {
        shift++;
    }
    return shift;
}

fxl_q18_46 fxl_flat_depth(const fxl_lens *lens)
{
    return (fxl_q18_46)1 << (46 + flat_shift(lens));
}

/* m / (2 scale) world units, rounded downward: m 2^61 / scale in units of 2^-46, at most 2^59. The
 * scale is at least 2^12, so 8 times it is above m, and below 2^32. */
/* orthographic 2.1 */
static void set_lens(fxl_view *view)
{
    const fxl_lens *lens = &view->lens;
    fxl_view_frustum *frustum = &view->view_frustum;
    const uint32_t smaller = lens->width < lens->height ? lens->width : lens->height;
    frustum->x_side = side_of(smaller, lens->width);
    frustum->y_side = side_of(smaller, lens->height);
    frustum->x_depth = frustum->y_depth = 0;
    frustum->inset = -(int64_t)fxl_fraction(smaller, 8 * (uint64_t)(uint32_t)lens->focal);
    fxl_lens flat = *lens;
    flat.focal = lens->focal << flat_shift(lens);
    fxl_projection_from_lens(&flat, &view->projection);
}

/* The axes are those of the pose. */
static void set_pose(fxl_view *view)
{
    (void)view;
}

/* scale * across, rounded. The scale is at most 2^28, so what is summed is below 2^58, in units of
 * 2^-30 pixel. The 32 bits that the sum leaves out are below the half that rounding adds: a floor of
 * a floor. */
static int64_t pixels_of(uint32_t scale, fxl_q18_46 across)
{
    const uint64_t low = fxl_multiply_u32(scale, fxl_low_32(fxl_bits_64(across)));
    const int64_t high =
        fxl_multiply_s32((int32_t)scale, (int32_t)(across >> 32)) + (int64_t)(low >> 32);
    return fxl_round_shift(high, 14);
}

/* A centre is below 2^26. */
/* orthographic 2.6 */
fxl_status fxl_project_orthographic(const fxl_view *view, const fxl_view_point *point,
                                    fxl_screen_point *screen)
{
    const uint32_t scale = (uint32_t)view->lens.focal;
    const int64_t x = view->lens.centre_x + pixels_of(scale, point->x);
    const int64_t y = view->lens.centre_y - pixels_of(scale, point->y);
    if (!fxl_within(x, FXL_SCREEN_COORDINATE_MAX) || !fxl_within(y, FXL_SCREEN_COORDINATE_MAX)) {
        return FXL_E_RANGE;
    }
    screen->x = (fxl_q16_16)x;
    /* SPEC 1.1 */
    screen->y = (fxl_q16_16)y;
    return FXL_OK;
}
/* --- the renderer ---------------------------------------------------------------------------- */

static bool has_clipper(const fxl_renderer *renderer)
{
    return renderer->clipper == &fxl_orthographic_clipper ||
           renderer->clipper == &fxl_orthographic_deep_clipper;
}

/* orthographic 1.3 */
static void take(fxl_renderer *renderer)
{
    const bool is_deep = renderer->target != NULL && renderer->target->depth_bits != 0 &&
                         fxl_renderer_shader(renderer, FXL_SHADER_SURFACES) != NULL;
    if (renderer->clipper == &fxl_clipper_view || has_clipper(renderer)) {
        renderer->clipper = is_deep ? &fxl_orthographic_deep_clipper : &fxl_orthographic_clipper;
    }
    if (renderer->order == &fxl_by_distance) {
        renderer->order = &fxl_by_depth;
    }
    renderer->check = fxl_check_combination;
}

static const fxl_orthographic_code code = {fxl_project_orthographic,
                                           has_clipper,
                                           &fxl_by_depth,
                                           take,
                                           fxl_orthographic_begin,
                                           fxl_submit_orthographic,
                                           fxl_find_orthographic_depth,
                                           fxl_distance_of_orthographic};

const fxl_off_centre_code fxl_orthographic = {is_valid, set_lens, set_pose, &code};
