/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "../view/view.h"
#include "normalised.h"

#include "../math/arith.h"
#include "clip_polygon.h"

/* part / whole as a quotient of 2^30 to 2^32, times 2^-down; 0 < part, whole < 2^62. part is
 * shifted until its highest bit is at 2^62. whole is shifted until its highest bit is at 2^31.
 * From its highest 1 to its lowest it has at most 32 bits, so it loses none: it is a component of a
 * direction, of 30 bits, or width height, below 2^32, times a power of 2. Error: 2^-31 of the
 * quotient. */
static uint64_t scaled_quotient(uint64_t part, uint64_t whole, int *down)
{
    unsigned part_up = 62u - fxl_bit_length(part), whole_up = 62u - fxl_bit_length(whole);
    uint32_t divisor = (uint32_t)(whole << whole_up >> 30);
    uint32_t rest;
    uint64_t quotient = fxl_divide_u64(part << (part_up + 1), divisor, &rest);
    *down = 31 + (int)part_up - (int)whole_up;
    return quotient + (rest >= divisor - rest);
}

/* part / whole as mantissa 2^-(31 + shift), mantissa from 2^30 to 2^31; 0 < part <= whole <
 * 2^55. Exactly 1 where the two are equal, else within 2^-30 of itself. */
typedef struct {
    uint32_t mantissa;
    uint8_t shift;
} factor;

/* clippers 2.2 */
static factor factor_of(uint64_t part, uint64_t whole)
{
    factor of = {(uint32_t)1 << 31, 0};
    int down;
    uint64_t quotient = scaled_quotient(part, whole, &down);
    if (part != whole) { /* where part is more than half of whole, down is 31 */
        bool large = quotient > of.mantissa;
        of.mantissa = (uint32_t)(large ? (quotient + 1) >> 1 : quotient);
        of.shift = (uint8_t)(down - 31 - large);
    }
    return of;
}

/* An entry is below 2^31 and a mantissa at most 2^31: the product is at most 2^62. */
static fxl_q2_30 scale(fxl_q2_30 entry, const factor *by)
{
    return (fxl_q2_30)fxl_round_shift((int64_t)entry * (int64_t)by->mantissa, 31);
}

/* clippers 2.2 */
static fxl_normalised_row row_of(const fxl_direction *axis, const factor *by)
{
    fxl_normalised_row row = {{scale(axis->x, by), scale(axis->y, by), scale(axis->z, by)},
                              by->shift};
    return row;
}

/* A depth in 16.16, below 2^31, times the factor, in 18.46. The product is below 2^62. */
static fxl_q18_46 scale_depth(int64_t depth, const factor *by)
{
    return fxl_round_shift(depth * (int64_t)by->mantissa, 1u + by->shift);
}

/* inset * factor / along. along is the component of depth in the side plane's unit normal. The
 * result is the inset in the scale of the sum z + x. The product has at most 48 bits. */
/* clippers 2.2 */
static fxl_q18_46 scale_inset(fxl_q16_16 inset, const factor *by, fxl_q2_30 along)
{
    uint64_t product = (uint64_t)inset * by->mantissa;
    int down;
    if (product == 0) {
        return 0;
    }
    int64_t quotient = (int64_t)scaled_quotient(product, (uint64_t)along, &down);
    /* inset mantissa / along in units of 2^-46 is 2^(29 - shift) times the fraction. */
    down += by->shift - 29;
    FXL_ASSERT(down > -31 && down < 62);
    return down > 0 ? fxl_round_shift(quotient, (unsigned)down) : quotient * ((int64_t)1 << -down);
}

/* clippers 2.2 */
void fxl_normalised_from_camera(const fxl_camera *camera, const fxl_lens *lens,
                                fxl_normalised *frustum)
{
    fxl_view_frustum sides;
    fxl_view_frustum_from_lens(lens, &sides);
    frustum->half_width = (fxl_q16_16)(lens->width * 32768u);
    frustum->half_height = (fxl_q16_16)(lens->height * 32768u);
    /* The factors focal / half width, focal / half height and 1, each times both halves. Focal
     * is below 2^29 and a half at most 2^25, so each is below 2^54. */
    uint64_t x = (uint64_t)lens->focal * (uint64_t)frustum->half_height;
    uint64_t y = (uint64_t)lens->focal * (uint64_t)frustum->half_width;
    uint64_t z = (uint64_t)frustum->half_width * (uint64_t)frustum->half_height;
    uint64_t largest = x > y ? x : y, one = z;
    factor along_z = {(uint32_t)1 << 31, 0};
    for (; one < largest; one <<= 1) { /* below 2^55 in the end */
        along_z.shift += 1;
    }
    factor along_x = factor_of(x, one);
    factor along_y = factor_of(y, one);
    frustum->eye = camera->position;
    frustum->x = row_of(&camera->axes.right, &along_x);
    frustum->y = row_of(&camera->axes.up, &along_y);
    frustum->z = row_of(&camera->axes.forward, &along_z);
    frustum->x_inset = scale_inset(lens->inset, &along_z, sides.x_depth);
    frustum->y_inset = scale_inset(lens->inset, &along_z, sides.y_depth);
    frustum->near_z = scale_depth((int64_t)lens->near_z + lens->inset, &along_z);
    frustum->far_z = scale_depth((int64_t)lens->far_z - lens->inset, &along_z);
}

static fxl_q18_46 coordinate(const fxl_normalised_row *row, int32_t dx, int32_t dy, int32_t dz)
{
    fxl_q18_46 sum = fxl_dot(&row->direction, dx, dy, dz);
    return row->shift > 0 ? fxl_round_shift(sum, row->shift) : sum;
}

void fxl_normalised_from_eye(const fxl_normalised *frustum, const fxl_point *from_eye,
                             fxl_view_point *view_point)
{
    view_point->x = coordinate(&frustum->x, from_eye->x, from_eye->y, from_eye->z);
    view_point->y = coordinate(&frustum->y, from_eye->x, from_eye->y, from_eye->z);
    view_point->z = coordinate(&frustum->z, from_eye->x, from_eye->y, from_eye->z);
}

/* Sums are below 2^62, and an inset below 2^49. */
/* clippers 2.2 */
uint32_t fxl_normalised_code(const fxl_normalised *frustum, const fxl_view_point *point)
{
    fxl_q18_46 x_room = point->z - frustum->x_inset;
    fxl_q18_46 y_room = point->z - frustum->y_inset;
    return (uint32_t)(point->z < frustum->near_z) << FXL_PLANE_NEAR |
           (uint32_t)(point->z > frustum->far_z) << FXL_PLANE_FAR |
           (uint32_t)(point->x < -x_room) << FXL_PLANE_LEFT |
           (uint32_t)(point->x > x_room) << FXL_PLANE_RIGHT |
           (uint32_t)(point->y < -y_room) << FXL_PLANE_BOTTOM |
           (uint32_t)(point->y > y_room) << FXL_PLANE_TOP;
}

fxl_q18_46 fxl_normalised_distance(const fxl_normalised *frustum, int plane,
                                   const fxl_view_point *point)
{
    switch (plane) {
    case FXL_PLANE_LEFT:
        return point->z + point->x - frustum->x_inset;
    case FXL_PLANE_RIGHT:
        return point->z - point->x - frustum->x_inset;
    case FXL_PLANE_BOTTOM:
        return point->z + point->y - frustum->y_inset;
    case FXL_PLANE_TOP:
        return point->z - point->y - frustum->y_inset;
    case FXL_PLANE_NEAR:
        return point->z - frustum->near_z;
    default:
        FXL_ASSERT(plane == FXL_PLANE_FAR);
        return frustum->far_z - point->z;
    }
}

static void measure(const void *planes, int plane, const fxl_varying_polygon *polygon,
                    fxl_clip_stats *stats, fxl_q18_46 *distances)
{
    const fxl_normalised *frustum = (const fxl_normalised *)planes;
    (void)stats; /* the distances are sums, without products */
    for (uint32_t i = 0; i < polygon->count; i++) {
        distances[i] = fxl_normalised_distance(frustum, plane, &polygon->vertices[i].position);
    }
}

fxl_clip_result fxl_clip_polygon_by_normalised(const fxl_varying_polygon *in, uint32_t any,
                                               const fxl_normalised *frustum,
                                               fxl_clip_workspace *workspace,
                                               const fxl_varying_polygon **result)
{
    return fxl_clip_polygon_by_planes(in, any, 0, measure, frustum, workspace, result);
}

/* clippers 7.1 */
fxl_clip_result fxl_clip_normalised(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                                    fxl_clip_workspace *workspace,
                                    const fxl_varying_polygon **result)
{
    uint32_t any = 0, all = UINT32_MAX;
    for (uint32_t i = 0; i < in->count; i++) {
        uint32_t code = fxl_normalised_code(frustum, &in->vertices[i].position);
        any |= code;
        all &= code;
    }
    return fxl_clip_polygon_by_planes(in, any, all, measure, frustum, workspace, result);
}

fxl_status fxl_normalised_project(const fxl_normalised *frustum, const fxl_view_point *point,
                                  fxl_screen_point *screen)
{
    const int32_t limit = FXL_SCREEN_COORDINATE_MAX;
    int32_t x, y;
    if (point->z <= 0 ||
        !fxl_ratio(frustum->half_width, point->x, point->z, limit - frustum->half_width, &x) ||
        !fxl_ratio(frustum->half_height, point->y, point->z, limit - frustum->half_height, &y)) {
        return FXL_E_RANGE;
    }
    screen->x = frustum->half_width + x;
    screen->y = frustum->half_height - y;
    return FXL_OK;
}
