/* SPDX-License-Identifier: MIT */
/* The orthographic lens, its view and its projection, and what a renderer takes for it: a clipper and
 * an order in which no eye stands (docs/extras/orthographic.md). Only what makes such a lens names
 * this file's record. */
#include "orthographic.h"
#include "../math/arith.h"
#include "../view/project.h"
#include "../view/view.h"
#include "fixel/camera.h"
#include "renderer.h"

/* --- the lens -------------------------------------------------------------------------------- */

/* The view's planes are those of any view (fxl_view_frustum) with an inset below 0: a point is inside
 * left and right if +-x_side x >= inset. The smaller extent of the screen says the inset, and the
 * larger one has a normal that is as much shorter. So sphere test, outcode and clip are those of any
 * view. */

/* Where the centre is from the middle of the screen, to the right and downward. */
static int64_t offset_x(const fxl_lens *lens)
{
    return lens->centre_x - lens->width * (int64_t)32768;
}

static int64_t offset_y(const fxl_lens *lens)
{
    return lens->centre_y - lens->height * (int64_t)32768;
}

/* orthographic 1.1, 1.2 */
static bool is_valid(const fxl_lens *lens)
{
    return lens->inset == 0 && lens->focal >= FXL_ORTHOGRAPHIC_SCALE_MIN &&
           lens->focal <= FXL_ORTHOGRAPHIC_SCALE_MAX &&
           fxl_within(offset_x(lens), FXL_ORTHOGRAPHIC_CENTRE_MAX) &&
           fxl_within(offset_y(lens), FXL_ORTHOGRAPHIC_CENTRE_MAX);
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

/* It is drawn as a centred one whose eye is moved along right and up, to where the middle of the screen
 * is. Places of the world are in units of 1/65536, so the eye is up to 1.6 of them beside that, and the
 * view's planes are as far beside the borders of the screen: less than an eighth of a pixel. Each of
 * the coordinates along right, up and forward from the pose's eye is that from the moved one and a
 * sum that is exact: points are projected by the former. The frustum in the world is one of clippers
 * that no orthographic lens has, so the distances of its first planes are those sums. */

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
    frustum->x_slope = frustum->y_slope = 0;
    frustum->inset = -(int64_t)fxl_fraction(smaller, 8 * (uint64_t)(uint32_t)lens->focal);
    view->frustum.planes[FXL_ALONG_RIGHT].distance = view->frustum.planes[FXL_ALONG_UP].distance =
        0;
    fxl_lens flat = *lens;
    flat.focal = lens->focal << flat_shift(lens);
    fxl_projection_from_lens(&flat, &view->projection);
}

/* --- an off-centre lens ---------------------------------------------------------------------- */

/* offset / scale in units of 1/65536: a product below 2^43, a quotient below 2^31. */
static int64_t units_of(int64_t offset, const fxl_lens *lens)
{
    return fxl_divide_round(offset * 65536, (uint32_t)lens->focal);
}

/* A component of the eye, moved by so much along right and up: products below 2^61. */
static int64_t moved_by(fxl_q16_16 from, int64_t right, fxl_q2_30 by_right, int64_t up,
                        fxl_q2_30 by_up)
{
    return from + fxl_round_shift(right * by_right, 30) + fxl_round_shift(up * by_up, 30);
}

/* Where X = Y = 0 of the moved eye is, beside the middle of the screen: offset + scale moved, less than
 * an eighth of a pixel. The lower 64 bits of both, in units of 2^-62 pixel, say what their sum is. */
static fxl_q16_16 beside_middle(const fxl_lens *lens, int64_t offset, fxl_q18_46 moved)
{
    const uint64_t pixels =
        fxl_bits_64(offset) * ((uint64_t)1 << 46) + fxl_bits_64(lens->focal) * fxl_bits_64(moved);
    return (fxl_q16_16)fxl_round_shift(fxl_signed_64(pixels), 46);
}

/* Keeps where the eye is from the pose's: sums below 2^61, of differences below 2^30. */
static void keep_moved(fxl_view *view, const fxl_point *by)
{
    const fxl_lens *lens = &view->lens;
    const fxl_axes *axes = &view->camera.axes;
    const fxl_q18_46 right = fxl_dot(&axes->right, by->x, by->y, by->z);
    const fxl_q18_46 up = fxl_dot(&axes->up, by->x, by->y, by->z);
    const fxl_q18_46 ahead = fxl_dot(&axes->forward, by->x, by->y, by->z);
    view->frustum.planes[FXL_ALONG_RIGHT].distance = right;
    view->frustum.planes[FXL_ALONG_UP].distance = up;
    view->view_frustum.near_z = (int64_t)lens->near_z * FXL_Q2_30_ONE - ahead;
    view->view_frustum.far_z = (int64_t)lens->far_z * FXL_Q2_30_ONE - ahead;
    view->projection.centre_x = lens->width * 32768 + beside_middle(lens, offset_x(lens), right);
    view->projection.centre_y = lens->height * 32768 + beside_middle(lens, offset_y(lens), -up);
}

/* The axes are those of the pose. */
/* orthographic 1.2 */
static fxl_status set_pose(fxl_view *view, const fxl_pose *pose)
{
    const fxl_lens *lens = &view->lens;
    const int64_t right = -units_of(offset_x(lens), lens), up = units_of(offset_y(lens), lens);
    if (offset_x(lens) == 0 && offset_y(lens) == 0) {
        return fxl_view_set_own_pose(view, pose);
    }
    fxl_camera camera;
    const fxl_status status = fxl_camera_from_pose(pose, &camera);
    if (status != FXL_OK) {
        return status;
    }
    const fxl_direction *x = &camera.axes.right, *y = &camera.axes.up;
    const int64_t to[3] = {moved_by(camera.position.x, right, x->x, up, y->x),
                           moved_by(camera.position.y, right, x->y, up, y->y),
                           moved_by(camera.position.z, right, x->z, up, y->z)};
    for (uint32_t i = 0; i < 3; i++) {
        if (!fxl_within(to[i], FXL_COORDINATE_MAX)) {
            return FXL_E_RANGE;
        }
    }
    const fxl_point eye = {(fxl_q16_16)to[0], (fxl_q16_16)to[1], (fxl_q16_16)to[2]};
    fxl_point by;
    fxl_subtract(&eye, &camera.position, &by);
    camera.position = eye;
    view->camera = camera;
    fxl_view_next_frame(view);
    keep_moved(view, &by);
    return FXL_OK;
}

/* --- projection ------------------------------------------------------------------------------ */

fxl_status fxl_project_orthographic(const fxl_view *view, const fxl_view_point *point,
                                    fxl_screen_point *screen)
{
    const int64_t x = fxl_orthographic_x(view, point), y = fxl_orthographic_y(view, point);
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
                                           fxl_orthographic_face_is_front,
                                           fxl_submit_orthographic,
                                           fxl_find_orthographic_depth,
                                           fxl_distance_of_orthographic};

const fxl_off_centre_code fxl_orthographic = {is_valid, set_lens, set_pose, &code};
