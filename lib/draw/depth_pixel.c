/* SPDX-License-Identifier: MIT */
/* With the normal n, the direction D of the pixel, that of a vertex V, and the vertex's z, the depth is
 * near_z / z (n . D) / (n . V) = near_z / z (1 + q), q = n . (D - V) / (n . V). In pixels, n . V is at
 * least 64 here and |q| at most 2^-8. Relatively, the depth is off by less than 2^-19.4:
 *   where the vertex is seen is rounded by 0.51 2^-16 pixel a coordinate: 2^-22.5;
 *   n is off by 2^-24.6, |D - V| is below 13 and |V| below 2^11.1 pixels: 2^-25;
 *   the reciprocal of n . V is off by 2^-13.3: 2^-21.3; two roundings to 2^-22, and one to 2^-24;
 *   the reciprocal of z is off by 2^-24.5, and 1 + q takes 2^-8 of all this more;
 *   the plane of fxl_find_depth_plane is off by 2^-28. */
#include "depth_pixel.h"

#include "../view/view.h"

/* 2^32 times what a depth below 1 is off by. */
#define DEPTH_ERROR 6144u

/* a b / 2^32, rounded down; on an Armv6-M less by 1 more at most. Requires |a| and |b| of at most 2^30 +
 * 2^16: then the sum of two products of halves is below 2^31. */
static inline int32_t upper(int32_t a, int32_t b)
{
#if FXL_CORE_ARMV6M
    int32_t a_low, b_low;
    __asm__(".syntax unified\n\tuxth %[l], %[p]\n\tasrs %[p], %[p], #16\n\t"
            "uxth %[o], %[q]\n\tasrs %[q], %[q], #16\n\t"
            "muls %[l], %[q]\n\tmuls %[o], %[p]\n\tmuls %[q], %[p]\n\t"
            "adds %[l], %[l], %[o]\n\tasrs %[l], %[l], #16\n\tadds %[q], %[q], %[l]"
            : [p] "+l"(a), [q] "+l"(b), [l] "=&l"(a_low), [o] "=&l"(b_low)
            :
            : "cc");
    return b;
#else
    return (int32_t)(fxl_multiply_s32(a, b) >> 32);
#endif
}

/* row . normal in 2.30, less 0 to 24 units. Requires length 1 at most of each. */
FXL_APART int32_t row_times(const fxl_direction *row, const fxl_direction *normal)
{
    int32_t sum = upper(normal->x, row->x);
    sum += upper(normal->y, row->y);
    return 4 * (sum + upper(normal->z, row->z));
}

/* 2^31 / value for 2^15 <= value <= 2^16, within 3 units. */
static inline uint32_t reciprocal_of(uint32_t value)
{
#if FXL_HAS_DIVIDER
    return 0x7FFFFFFFu / value;
#else
    return fxl_reciprocal_half(value);
#endif
}

/* 2^22 q, at the centre of a pixel, off by less than 2 units and 2^-13.3 of it; INT32_MIN: it is above
 * 2^-8, or a focal length or n . V has no bound. n is negative: it is that of the axes. A focal length is
 * below 2^27, and a vertex 9 pixels from the centre at most, so factors are below 2^30. n . V is below
 * 2^28.2, in units of 2^-17 pixel; the part of it is in units of 2^-24, and half of it at most. */
static inline int32_t find_ratio(const fxl_model_view *model_view, const fxl_direction *normal,
                                 const fxl_screen_point *seen, const fxl_tiny *pixel)
{
    const fxl_axes *axes = model_view->axes;
    const fxl_projection *projection = &model_view->view->projection;
    const fxl_q16_16 focal = fxl_view_drawn_focal(model_view->view);
    if (focal >> 27 != 0) {
        return INT32_MIN;
    }
    const int32_t x = row_times(&axes->right, normal);
    FXL_IN_ORDER();
    const int32_t y = row_times(&axes->up, normal);
    FXL_IN_ORDER();
    const int32_t z = row_times(&axes->forward, normal);
    FXL_IN_ORDER();
    int32_t sum = upper(x, 8 * (seen->x - projection->centre_x));
    sum += upper(y, 8 * (projection->centre_y - seen->y));
    sum += upper(z, 8 * focal);
    int32_t part = upper(x, 1024 * (seen->x - fxl_centre_of(pixel->column)));
    part += upper(y, 1024 * (fxl_centre_of(pixel->row) - seen->y));
    const uint32_t whole = fxl_bits_32(-sum);
    if (sum > -(1 << 23) || fxl_bits_32(2 * part) + whole > 2u * whole) {
        return INT32_MIN;
    }
    const unsigned zeros = fxl_leading_zeros(whole); /* 3..8 */
    const uint32_t reciprocal = reciprocal_of(((whole << zeros >> 15) + 1u) >> 1);
    return (fxl_signed_32(fxl_bits_32(part) << (zeros - 1u)) >> 15) * (int32_t)reciprocal >> 16;
}

/* The code of a pixel; 0: it is not known. `point`: the vertex. */
static inline uint32_t find_code(const fxl_model_view *model_view, const fxl_direction *normal,
                                 const fxl_view_point *point, const fxl_screen_point *seen,
                                 const fxl_tiny *pixel, fxl_depth_scale scale)
{
    const int32_t ratio = find_ratio(model_view, normal, seen, pixel);
    if (ratio == INT32_MIN) {
        return 0;
    }
    /* The upper word is at least 2^5: the vertex was projected. */
    const uint32_t high = fxl_bits_32((int32_t)(point->z >> 32));
    const uint32_t near_z = fxl_bits_32(model_view->view->lens.near_z);
    const unsigned far_zeros = fxl_leading_zeros(high), near_zeros = fxl_leading_zeros(near_z);
    const uint32_t distance =
        (high << far_zeros | fxl_low_32(fxl_bits_64(point->z)) >> 1 >> (31u - far_zeros)) >> 1;
    /* A step of Newton's method from a reciprocal that is too small, by at most 2^-12.4 of it. */
    const uint32_t rough = reciprocal_of((distance >> 15) + 1u) - 3u;
    const uint32_t inverse =
        (rough << 15) - (uint32_t)(fxl_multiply_u32(rough * rough, distance) >> 32);
    uint32_t depth = (uint32_t)(fxl_multiply_u32(near_z << near_zeros, inverse) >> 32);
    const unsigned shift = fxl_leading_zeros(depth);
    depth <<= shift;
    depth += fxl_bits_32((int32_t)(depth >> 16) * ratio >> 6);
    const uint32_t octave = near_zeros + shift - far_zeros - 1u, drop = 31u - scale.mantissa;
    /* A code is too small by less than one of its 2^-16 a column, and one more. */
    const uint32_t least =
        depth - DEPTH_ERROR - (fxl_bits_32(pixel->column + 1) << (drop - 16u));
    if (depth >> 31 == 0 || octave >= scale.octaves ||
        (least ^ (depth + DEPTH_ERROR)) >> drop != 0) {
        return 0;
    }
    return ((scale.octaves - 2u - octave) << scale.mantissa) + 1u + (depth >> drop);
}

bool fxl_depth_draw_pixel(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_tiny *tiny, uint32_t filling,
                          uint32_t pixel_bytes)
{
    const fxl_workspace *workspace = traversal->workspace;
    const fxl_band *band = traversal->band;
    const fxl_depth_head *head = (const fxl_depth_head *)workspace->target_memory;
    const int32_t first = tiny->column, end = first + tiny->columns;
    for (uint32_t pixels = tiny->pixels; pixels >> 31 == 0; pixels <<= 1) {
        tiny->column++;
        if (tiny->column == end) {
            tiny->column = first;
            tiny->row++;
        }
    }
    tiny->columns = tiny->rows = 1;
    tiny->pixels = 1u << 31;
    const uint32_t code = find_code(
        model_view, &face->normal, &fxl_fetch_vertex(model_view, face->indices[0])->position,
        &workspace->screen.points[0], tiny, head->scale);
    const size_t place =
        (size_t)fxl_bits_32(tiny->row - band->first_row) * band->width + (size_t)tiny->column;
    uint16_t *cell = (uint16_t *)(uintptr_t)(head + 1) + place;
    if (code > *cell) {
        *cell = fxl_low_16(code);
        if (pixel_bytes == 2) {
            ((uint16_t *)(uintptr_t)band->pixels)[place] = fxl_low_16(filling);
        } else {
            band->pixels[place] = fxl_low_8(filling);
        }
    }
    return code != 0;
}
