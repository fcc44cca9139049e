/* SPDX-License-Identifier: MIT */
/* Gradients: how the depth and the attributes of a face vary over the screen.
 *
 * What is linear over a face is, divided by the depth z, linear on the screen. So a face has a
 * weight w, which is 1/z in a unit of its own, and for each attribute a (texture coordinates,
 * light) a / z in a unit of its own. At a pixel's centre a = a_value / w_value * 2^a_shift.
 *
 * They come from three corners of the whole face, before anything clips it, so they depend on
 * the face and the view alone. Internal. */
#ifndef FXL_GRADIENTS_H
#define FXL_GRADIENTS_H

#include "fixel/records.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A number that is linear on the screen. Its value is the upper word: at the centre of the pixel in
 * column x of row y that of at + x * along + y * down. Values of the pixels of the screen, and of
 * the first column that is a multiple of 16 to its right, are below 2^30. */
typedef struct {
    int64_t at, along, down;
} fxl_gradient;

/* A vector (x, y, z) * 2^exponent. The components are at most 2^30; one is at least 2^29, or all
 * are 0. */
typedef struct {
    int32_t x, y, z;
    int exponent;
} fxl_block_vector;

/* Requires components of at most 2^62. Error: half a unit of each component, at most 2^-30 of the
 * largest. */
fxl_block_vector fxl_block(int64_t x, int64_t y, int64_t z, int exponent);

/* The gradient of vector . D, where D = (x - centre, centre - y, focal) is the direction of a
 * pixel's centre in 16.16. It is scaled so that its largest value on the screen is from 2^61 to
 * 2^62; returns the exponent: vector . D is the 64 bits * 2^exponent. Exact. */
int fxl_gradient_of_plane(fxl_block_vector vector, const fxl_view *view, fxl_gradient *gradient);

/* The attributes of a face: u and v, where it has a texture, and then light, where it is lit. So
 * light is the last. */
enum {
    FXL_ATTRIBUTE_U,
    FXL_ATTRIBUTE_V,
    FXL_ATTRIBUTES = 3
};

/* The corners of a face, and the values of its attributes at its three corners: 16.16, each below
 * 2^30. */
typedef struct {
    fxl_view_point corners[3];
    int32_t values[FXL_ATTRIBUTES][3];
    uint32_t count; /* of attributes: the first so many are used */
} fxl_gradient_corners;

/* number * 2^exponent, not negative. */
typedef struct {
    int64_t number;
    int32_t exponent;
} fxl_scaled_number;

/* The largest shift but of attributes in words (corner_colours.h, smooth_outline.h): 62, and the 8
 * that fxl_texture_level_choose takes off. */
#define FXL_SHIFT_MOST 70

/* The gradients of a face. */
typedef struct {
    fxl_gradient weight; /* above 0 where the face is */
    fxl_gradient attributes[FXL_ATTRIBUTES];
    int8_t shifts[FXL_ATTRIBUTES];
    uint8_t count; /* of attributes */
    /* Six times the volume between eye and corners, in the cube of their unit. Not in the display
     * list. */
    fxl_scaled_number volume;
    uint32_t weight_min[2]; /* the least weight, at both ends, of a segment of 16, of 4 pixels that
                               is divided at its ends alone: then all attributes are within 0.3 of
                               their unit (65536) of the exact ones. At least 1, at most
                               2^31. */
} fxl_gradients;

/* Finds the gradients of a face on the screen of a view.
 * Requires corners whose coordinates are below 2^61, not on one line.
 * Error: docs/accuracy.md, section 5. */
void fxl_gradients_find(const fxl_gradient_corners *face, const fxl_view *view,
                        fxl_gradients *gradients);

/* How a row of a face is divided: each aligned segment of 16 columns of the screen is one, or two
 * of 8 columns, or four of 4, or else each pixel is divided. That depends on the weights at the
 * ends of the 16 columns alone, so no clipping and no band changes it.
 *
 * Finds the least weights, at both ends of the 16 columns, for 16, 8 and 4 columns of a surface
 * with this division. FXL_DIVIDE_8 takes half of the columns that FXL_DIVIDE_16 takes, and so is
 * within 0.075 of a unit. UINT32_MAX: no weight suffices. */
void fxl_find_least_weights(const fxl_gradients *gradients, uint32_t division, uint32_t least[3]);

/* The logarithm of the columns of the segments within 16 columns, by the weights at their ends; 0:
 * each pixel is divided. */
static inline uint32_t fxl_segment_log(const uint32_t least[3], uint32_t weight_0,
                                       uint32_t weight_1)
{
    const uint32_t weight = weight_0 < weight_1 ? weight_0 : weight_1;
    return weight >= least[0] ? 4 : weight >= least[1] ? 3 : weight >= least[2] ? 2 : 0;
}
/* Where all three corners are on the screen, puts them into the plane of the screen, so that their
 * weight is constant and their attributes are linear on the screen. Corners that are on one line
 * there stay as they are. A corner is on the screen if it can be projected, with
 * 0 <= x <= width and 0 <= y <= height. Exact, given the projected corners. Returns whether it has
 * put them there. */
bool fxl_corners_make_affine(fxl_gradient_corners *face, const fxl_view *view);

#ifdef __cplusplus
}
#endif

#endif
