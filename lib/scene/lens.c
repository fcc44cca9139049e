/* SPDX-License-Identifier: MIT */
/* Lenses whose centre is not the middle of the screen. */
#include "../math/arith.h"
#include "lens.h"

FXL_STATIC_ASSERT((FXL_SCREEN_MAX & (FXL_SCREEN_MAX - 1)) == 0, "both are tested at once");

/* Both 1..FXL_SCREEN_MAX: less 1, no bit above those of FXL_SCREEN_MAX - 1 is set. */
/* SPEC 3.1 */
static bool screen_in_range(uint16_t width, uint16_t height)
{
    return fxl_bits_32((width - 1) | (height - 1)) < FXL_SCREEN_MAX;
}

/* Neither near_z nor far_z is below 0, so the difference does not overflow. */
/* SPEC 3.1 */
static bool depth_in_range(fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_q16_16 inset)
{
    return near_z >= FXL_NEAR_MIN && fxl_bits_32(far_z) <= FXL_FAR_MAX &&
           fxl_bits_32(inset) <= FXL_INSET_MAX && 2 * inset < far_z - near_z;
}

/* SPEC 2.1, 3.1, 4.2 */
FXL_COLD fxl_status fxl_lens_from_fov(uint16_t width, uint16_t height, fxl_angle fov,
                                      fxl_q16_16 near_z, fxl_q16_16 far_z, fxl_q16_16 inset,
                                      fxl_lens *lens)
{
    if (lens == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (!screen_in_range(width, height) || fov < FXL_FOV_MIN || fov > FXL_FOV_MAX ||
        !depth_in_range(near_z, far_z, inset)) {
        return FXL_E_RANGE;
    }
    /* 1 / tan(fov / 2) = (1 + cos fov) / sin fov, which does not halve fov. Width is
     * below 2^11, so the product is below 2^(11 + 15 + 32) = 2^58. The sine of
     * 10..150 degrees is above 2^28. */
    int64_t numerator =
        fxl_multiply_s64((int32_t)width * 32768, ((int64_t)1 << 31) + fxl_cos_q31(fov));
    lens->width = width;
    lens->height = height;
    lens->focal = fxl_divide_round(numerator, (uint32_t)fxl_sin_q31(fov));
    lens->near_z = near_z;
    lens->far_z = far_z;
    lens->inset = inset;
    lens->centre_x = (int32_t)width * 32768;
    lens->centre_y = (int32_t)height * 32768;
    lens->off_centre = NULL;
    return FXL_OK;
}

/* 1 / (2 tan(fov / 2)) of FXL_FOV_MAX and FXL_FOV_MIN is 0.13397 and 5.71503. Here each is moved
 * outward by less than 2/1000, in units of 2^-16, to a number that an instruction can hold. A width
 * is below 2^11, so the products are below 2^30. */
#define FOCAL_LEAST 0x2240
#define FOCAL_MOST  0x5B800

/* One comparison for both ends: a focal length below the least wraps to 2^31 - 2^24 or more, and
 * the span is below 2^29. */
static bool focal_in_range(fxl_q16_16 focal, uint16_t width)
{
    return fxl_bits_32(focal) - (uint32_t)width * FOCAL_LEAST <=
           (uint32_t)width * (FOCAL_MOST - FOCAL_LEAST);
}

/* Focal length and centre. */
/* SPEC 3.1 */
static bool centre_in_range(const fxl_lens *lens)
{
    return lens->off_centre != NULL ? lens->off_centre->is_valid(lens)
                                    : focal_in_range(lens->focal, lens->width) &&
                                          lens->centre_x == (int32_t)lens->width * 32768 &&
                                          lens->centre_y == (int32_t)lens->height * 32768;
}

bool fxl_lens_is_valid(const fxl_lens *lens)
{
    return lens != NULL && screen_in_range(lens->width, lens->height) &&
           depth_in_range(lens->near_z, lens->far_z, lens->inset) && centre_in_range(lens);
}

/* Offsets of the centre from the middle: at most three halves of an extent, and four focal lengths.
 * The extent is at most 2^10 and the focal length is below 2^29, so no product exceeds 2^31. */
static bool is_near(int64_t offset, uint16_t extent, fxl_q16_16 focal)
{
    return fxl_within(offset, extent * (int64_t)98304) && fxl_within(offset, 4 * (int64_t)focal);
}

FXL_COLD bool fxl_off_centre_is_valid(const fxl_lens *lens)
{
    return lens->inset == 0 && focal_in_range(lens->focal, lens->width) &&
           is_near(lens->centre_x - lens->width * (int64_t)32768, lens->width, lens->focal) &&
           is_near(lens->centre_y - lens->height * (int64_t)32768, lens->height, lens->focal);
}

/* *lens = *made with the centre (x, y), if that is a valid lens. An orthographic one stays so. */
/* orthographic 1.2 */
static FXL_COLD fxl_status set_if_valid(const fxl_lens *made, fxl_q16_16 x, fxl_q16_16 y,
                                        fxl_lens *lens)
{
    fxl_lens moved = *made;
    moved.centre_x = x;
    moved.centre_y = y;
    const bool is_middle = x == moved.width * 32768 && y == moved.height * 32768;
    if (fxl_orthographic_of(made) == NULL) {
        moved.off_centre = is_middle ? NULL : &fxl_off_centre;
    }
    if (!fxl_lens_is_valid(&moved)) {
        return FXL_E_RANGE;
    }
    *lens = moved;
    return FXL_OK;
}

fxl_status fxl_lens_set_centre(fxl_lens *lens, fxl_q16_16 x, fxl_q16_16 y)
{
    return lens == NULL ? FXL_E_ARGUMENT : set_if_valid(lens, x, y, lens);
}

/* A centre is below 2^28 units, and a part begins at less than 2^31: the differences are below
 * 2^32. */
fxl_status fxl_lens_of_part(const fxl_lens *whole, int16_t x, int16_t y, uint16_t width,
                            uint16_t height, fxl_lens *part)
{
    if (whole == NULL || part == NULL) {
        return FXL_E_ARGUMENT;
    }
    const int64_t centre_x = whole->centre_x - x * (int64_t)65536;
    const int64_t centre_y = whole->centre_y - y * (int64_t)65536;
    if (!fxl_within(centre_x, INT32_MAX) || !fxl_within(centre_y, INT32_MAX)) {
        return FXL_E_RANGE;
    }
    fxl_lens cut = *whole;
    cut.width = width;
    cut.height = height;
    return set_if_valid(&cut, (fxl_q16_16)centre_x, (fxl_q16_16)centre_y, part);
}

/* side * width / across pixels in 16.16, rounded once. Requires a side that window_in_range has
 * accepted: below 2^31, so the product is below 2^57, and a quotient of at most 8192 pixels. */
static fxl_q16_16 in_pixels(int64_t side, uint16_t width, uint32_t across)
{
    return fxl_divide_round(side * width * 65536, across);
}

/* A rectangle of the plane z = near_z, as fxl_lens_from_window takes it. */
typedef struct {
    int64_t left, right, bottom, top;
} window;

/* Whether the sides are in their range and order, and no quotient of in_pixels overflows. No valid
 * lens is refused: its focal length is below 6 widths, and its centre is at most 2 widths right of
 * the left border and 2 heights, so 2048 pixels, below the upper border. */
static bool window_in_range(const window *in, uint16_t width, fxl_q16_16 near_z)
{
    const int64_t limit = FXL_COORDINATE_MAX, across = in->right - in->left;
    return in->left >= -limit && in->right <= limit && in->bottom >= -limit && in->top <= limit &&
           across > 0 && in->bottom < in->top && fxl_within(in->left, 2 * across) &&
           fxl_within(in->top * width, 2048 * across) && near_z > 0 && near_z <= 8 * across;
}

fxl_status fxl_lens_from_window(uint16_t width, fxl_q16_16 left, fxl_q16_16 right,
                                fxl_q16_16 bottom, fxl_q16_16 top, fxl_q16_16 near_z,
                                fxl_q16_16 far_z, fxl_lens *lens)
{
    if (lens == NULL) {
        return FXL_E_ARGUMENT;
    }
    const window in = {left, right, bottom, top};
    if (width < 1 || width > FXL_SCREEN_MAX || !window_in_range(&in, width, near_z)) {
        return FXL_E_RANGE;
    }
    /* Products are below 2^42; of more than a row too many the quotient may not fit. */
    const int64_t length = in.right - in.left, height = (in.top - in.bottom) * width;
    if (height > length * (FXL_SCREEN_MAX + 1)) {
        return FXL_E_RANGE;
    }
    const uint32_t across = (uint32_t)length;
    uint32_t residue;
    const uint32_t rows = fxl_divide_u64(fxl_bits_64(height + length / 2), across, &residue);
    if (rows > FXL_SCREEN_MAX) {
        return FXL_E_RANGE;
    }
    const fxl_lens made = {
        width, (uint16_t)rows, in_pixels(near_z, width, across), near_z, far_z, 0, 0, 0, NULL};
    return set_if_valid(&made, in_pixels(-in.left, width, across), in_pixels(in.top, width, across),
                        lens);
}
