/* SPDX-License-Identifier: MIT */
/* Gradients of a small face, from its corners on the screen.
 *
 * With corners i = 0, 1, 2 at (x, y) on the screen, and edges X, Y from corner 0 to the others, the
 * value v that has the given values at the corners changes a pixel by
 *
 *   along = ((v1 - v0) Y2 - (v2 - v0) Y1) / area,   down = ((v2 - v0) X1 - (v1 - v0) X2) / area,
 *   area = X1 Y2 - X2 Y1.
 *
 * The four coefficients, such as Y2 / area, are the same for all values of a face. A weight that is
 * proportional to 1/z is the product of the depths of the other two corners.
 *
 * Which faces are small is a rule about the whole face: it does not depend on what clips it, splits
 * it or draws it. Internal. */
#ifndef FXL_CORNER_PLANES_H
#define FXL_CORNER_PLANES_H

#include "../math/arith.h"
#include "../math/product.h"
#include "depth_code.h"
#include "gradients.h"
#include "light_row.h"
#include "texture_level.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Three corners of a face on the screen, and the box of all of its vertices. */
typedef struct {
    fxl_screen_point points[3];
    fxl_q18_46 depths[3];
    int32_t width, height; /* of the box, in 1/65536 pixel */
    bool is_triangle;      /* the face has no other vertices */
} fxl_screen_corners;

/* The corners of a triangle, but for is_triangle. */
typedef struct {
    fxl_screen_corners corners;
    fxl_screen_point least; /* the least x and the least y */
} fxl_inside_corners;

/* The sides of the box of a small face: from 1/4 pixel to 64 pixels. */
#define FXL_SMALL_SIDE_MIN   (1 << 14)
#define FXL_SMALL_SIDE_MAX   (64 << 16)
#define FXL_TEXELS_SIDE_MAX  ((64 << 16) + (1 << 14))  /* of a triangle whose texels may be words */
#define FXL_WORDS_SIDE_MAX   ((127 << 16) + (1 << 14)) /* of a face whose planes may be words */
#define FXL_COLOURS_SIDE_MAX (1023 << 16)              /* of one whose colours may be words */
#define FXL_SMALL_SLOPES     16

/* What all values of a small face share. */
typedef struct {
    int32_t x, y; /* of corner 0, less those of the centre of pixel (0, 0) */
    /* A pixel along, values grow by (v1 - v0) along[0] + (v2 - v0) along[1], times 2^-exponent; a
     * pixel down likewise. The coefficients are at most 2^30. */
    int32_t along[2], down[2];
    int exponent; /* 20..36; of a thin face from 14 on, of one with longer sides up to 40 */
    const fxl_screen_corners *corners;
    const fxl_lens *lens;
    uint64_t area;         /* twice the triangle's, in units of 2^-32 pixel */
    uint32_t depths[3];    /* proportional to z: from 2^30 to 2^32 */
    int32_t weights[3];    /* near_z / z 2^weight_exponent: from 2^26 to 2^30 */
    uint32_t weight_range; /* from the least to the largest */
    uint32_t weight_most;
    int weight_exponent;
    bool is_triangle;
    bool may_be_steep;      /* thin, or its 1/z differ much */
    bool is_for_words;      /* thin, or with a longer side: it is not small */
    bool is_located;        /* the next two are found */
    uint32_t columns, rows; /* how far corner 0 is from the ends of the screen, at most */
    bool has_weight;        /* the next three are found */
    int gradient_exponent;  /* the gradient's 64 bits are a weight times 2^gradient_exponent */
    int32_t weight_slope;   /* what a weight changes a pixel along, times 2^(exponent - 32) */
    fxl_gradient weight;
} fxl_corner_planes;

/* From the least of three values to the largest. */
static inline uint32_t fxl_range_of(const int32_t values[3])
{
    int32_t least = values[0], most = values[0];
    for (uint32_t i = 1; i < 3; i++) {
        least = values[i] < least ? values[i] : least;
        most = values[i] > most ? values[i] : most;
    }
    return fxl_bits_32(most) - fxl_bits_32(least);
}

/* Sets *planes. side_max: FXL_SMALL_SIDE_MAX, or one of the three below. False where the face is
 * neither small nor what side_max takes beside: *planes is undefined then. A face is small if
 * - its box has sides of FXL_SMALL_SIDE_MIN to FXL_SMALL_SIDE_MAX,
 * - the triangle of the three corners fills at least 1/16 of the box,
 * - no corner's depth is below 2^(k - 1), where 2^k is the power of two at or below the largest,
 * - with s pixels the shorter side, the corners' 1/z differ by at most s / FXL_SMALL_SLOPES of the
 *   largest one. So what the corners' rounding changes a depth by is below its resolution in 16
 * bits. Requires a box that reaches the screen of the lens.
 *
 * FXL_WORDS_SIDE_MAX: a thin face, whose triangle fills 1/1024 to 1/16 of the box, one whose 1/z
 * differ by more, and one with sides up to that, are for words: only fxl_corner_planes_linear takes
 * them, the first two if 1/z changes by less than the largest one a pixel.
 *
 * FXL_TEXELS_SIDE_MAX: the same with sides up to that, where the triangle fills 1/32 of the box; only
 * fxl_find_texels takes them.
 *
 * FXL_COLOURS_SIDE_MAX: one with sides up to that is for colours: only corner_colours.h takes it,
 * and fxl_corner_planes_depth_words where sides are up to FXL_WORDS_SIDE_MAX. So is one that fills
 * 1/128 of the box, and one whose 1/z differ by more.
 *
 * In the triangle the rounding of the coefficients moves a plane by less than k = 2^-29 + 2^-28 n
 * (1 + b) of the range of its values at the corners, where the triangle fills 1/n of the box and b
 * is the ratio of the longer side of the box to the shorter one. */
bool fxl_corner_planes_begin(const fxl_screen_corners *corners, const fxl_lens *lens,
                             int32_t side_max, fxl_corner_planes *planes);

/* The depth of the face on the screen. Error in the triangle, given the corners on the screen: k
 * (above) of the range of depths, 2^-25 of the largest one, and 1/16 unit of the upper word.
 * Corners are off by 0.52/65536 pixel, which moves the plane by so much times its slope. */
void fxl_corner_planes_depth(fxl_corner_planes *planes, fxl_depth_plane *plane);

/* The depth of a triangle of one octave or two in words: fxl_depth_plane that
 * FXL_DEPTH_IS_LINEAR, or FXL_DEPTH_IS_BENT. Returns false where the face is not a triangle, or has
 * more octaves, or may be steep and its depth changes much; or where the lens has a single octave.
 * Error in the triangle, given the corners: that of fxl_corner_planes_depth, and 2048 2^-16 code,
 * or 4096 2^-16 beyond the end of an octave. */
bool fxl_corner_planes_depth_words(const fxl_corner_planes *planes, fxl_depth_plane *depth);

/* The mean of what a constant weight takes off a value in the triangle, of which corners 1 and 2
 * have d1 and d2 more than corner 0. With a and b the same differences of weights, and s the sum of
 * the three weights, it is (d1 (2 a - b) + d2 (2 b - a)) / 4 s. Any two weights differ by less than
 * 2^30, so factors are below 2^31; values differ by less than 2^22, so products are below 2^53.
 * Here s is that of weights whose middle one is midway. It costs at most 1/4 of the mean. */
static inline int32_t fxl_corner_planes_mean(const fxl_corner_planes *planes, int32_t d1,
                                             int32_t d2)
{
    const int32_t *weights = planes->weights;
    const int32_t a = weights[1] - weights[0], b = weights[2] - weights[0];
    const int64_t sum = fxl_product(d1, 2 * a - b) + fxl_product(d2, 2 * b - a);
    const uint32_t twice = 2u * planes->weight_most - planes->weight_range;
    return fxl_signed_32(fxl_lower_of_shifted(sum, 24)) / (int32_t)((twice + twice / 2u) >> 22);
}

/* The depth of a triangle of one octave, and its light, in words: fxl_depth_plane that
 * FXL_DEPTH_IS_LINEAR, and gradients of a constant weight with light alone, whose lower words are
 * those of light_row.h: for what fxl_paint.has_light_rows alone. Returns false where the face is
 * not a triangle, or not in one octave, or a constant weight changes its light by more than
 * FXL_WORDS_ERROR_LIGHT, or light changes by 128 levels a pixel or more, or it may be steep and its
 * depth changes much; or where the lens has a single octave. From FXL_AFFINE_ERROR_LIGHT on the
 * mean of the error is taken off light, which is then off by at most 3/4 of that. light: at the
 * corners, of levels and a half. Error in the triangle, beyond that: as above, and 2048 2^-16 code,
 * 2048 2^-24 level.
 */
bool fxl_corner_planes_linear(const fxl_corner_planes *planes, const int32_t light[3],
                              fxl_gradients *gradients, fxl_depth_plane *depth);

/* Both at once: fxl_corner_planes_begin, then fxl_corner_planes_linear. */
bool fxl_find_smooth_planes(const fxl_screen_corners *corners, const fxl_lens *lens,
                            const int32_t light[3], fxl_gradients *gradients,
                            fxl_depth_plane *depth);

/* The weight and the attributes of values, which it changes. Where is_affine, the weight is
 * constant. It is constant too where that changes no attribute by more than FXL_AFFINE_ERROR_TEXEL
 * or FXL_AFFINE_ERROR_LIGHT: with attributes that differ by D over the corners, and weights by E
 * from the least weight w on, attributes are off by at most D E / (4 w) in the triangle. Error,
 * beyond that, given the corners: of a constant weight, k of the range and 1/16 unit of the upper
 * word; of any other, what docs/accuracy.md, section 5.1.1, says. */
void fxl_corner_planes_find(fxl_corner_planes *planes, int32_t (*values)[3], uint32_t count,
                            bool is_affine, fxl_gradients *gradients);

/* What a texture's level depends on, but for texels. is_affine as above: then the face is as if all
 * of it were at one depth. Else nearest is the least depth of the face, above 0. */
void fxl_corner_planes_density(const fxl_corner_planes *planes, bool is_affine, fxl_q18_46 nearest,
                               fxl_texel_density *density);

/* What a constant weight may change an attribute by, in 1/65536: 1/64 of a texel, and 1/8 of a
 * level of light. Of a face with more than three vertices 1/8 of that: the fourth corner of a
 * parallelogram is off by up to 8 times the bound of the triangle. */
#define FXL_AFFINE_ERROR_TEXEL 1024u
#define FXL_AFFINE_ERROR_LIGHT 8192u
#define FXL_WORDS_ERROR_LIGHT  16384u /* of fxl_corner_planes_linear and fxl_find_texels: 1/4 */
#define FXL_WORDS_ERROR_TEXEL  19660u /* of fxl_find_texels: below 0.3 */

#ifdef __cplusplus
}
#endif

#endif
