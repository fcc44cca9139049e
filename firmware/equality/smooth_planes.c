/* SPDX-License-Identifier: MIT */
/* Compares the planes of depth and of light, of colours, or of texels, that a small face has in words:
 * which faces have them, and the words. */

#include "equality.h"
#include "paint/smooth_outline.h"
#include "sides.h"

#include <string.h>

/* From 0 to below `end`. */
static uint32_t any_below(uint32_t end)
{
    return (any_32() >> 4) % end;
}

/* Below 2^bits, and shifted to the right by any number of bits, in one of two cases. */
static uint32_t any_size(uint32_t bits)
{
    const uint32_t value = any_32() >> (32u - bits);
    return any_below(2) != 0 ? value : value >> any_below(bits);
}

static void any_lens(fxl_lens *lens)
{
    const uint32_t octaves = any_below(20);
    lens->near_z = (int32_t)(1u + any_size(18) + (1u << any_below(10)));
    const uint64_t far_z = ((uint64_t)(uint32_t)lens->near_z << octaves) + any_size(18);
    lens->far_z = far_z > INT32_MAX ? INT32_MAX : (int32_t)far_z + 1;
}

/* Three points in a box of some pixels, at depths near one another, from a quarter of the near
 * plane to beyond the far plane. */
static void any_corners(const fxl_lens *lens, fxl_screen_corners *corners)
{
    const uint32_t wide = any_size(23) + 1u, high = any_below(4) != 0 ? wide : any_size(23) + 1u;
    const int32_t left = (int32_t)any_below(2048u << 16), top = (int32_t)any_below(2048u << 16);
    const uint64_t depth = (uint64_t)(uint32_t)lens->near_z << (28u + any_below(14));
    const uint64_t first = depth + (depth >> 16) * any_below(65536);
    const uint32_t drop = 16u + any_below(12);
    int32_t least_x = INT32_MAX, most_x = 0, least_y = INT32_MAX, most_y = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const int32_t x = left + (int32_t)any_below(wide), y = top + (int32_t)any_below(high);
        corners->points[i].x = x;
        corners->points[i].y = y;
        corners->depths[i] = (fxl_q18_46)(first + (first >> drop) * any_below(65536));
        least_x = x < least_x ? x : least_x;
        most_x = x > most_x ? x : most_x;
        least_y = y < least_y ? y : least_y;
        most_y = y > most_y ? y : most_y;
    }
    corners->width = most_x - least_x + (int32_t)(any_below(16) == 0 ? any_size(20) : 0);
    corners->height = most_y - least_y + (int32_t)(any_below(16) == 0 ? any_size(20) : 0);
    corners->is_triangle = any_below(64) != 0;
}

static void any_light(int32_t light[3])
{
    const uint32_t range = any_below(2) != 0 ? 63u << 16 : 4u << 16;
    const uint32_t first = 32768u + any_below((63u << 16) - range + 1u);
    for (uint32_t i = 0; i < 3; i++) {
        light[i] = (int32_t)(first + any_below(range));
    }
}

/* A value near the first one, or of one of so many bits. */
static int32_t value_near(int32_t first, uint32_t bits)
{
    const int32_t change = (int32_t)any_size(bits);
    return first + (any_below(2) != 0 ? change : -change);
}

/* u and v of three corners, mostly within 128 texels. */
static void any_texels(fxl_corner corners[3])
{
    const uint32_t bits = any_below(8) != 0 ? 23u : 30u;
    const int32_t u = (int32_t)any_32() >> 2, v = (int32_t)any_32() >> 2;
    for (uint32_t i = 0; i < 3; i++) {
        corners[i].texel.u = value_near(u, bits);
        corners[i].texel.v = value_near(v, bits);
    }
}

static bool has_same_texels(const fxl_screen_corners *corners, const fxl_words_lens *lens)
{
    fxl_texel_planes core = {{0}, {0}, {0}}, portable = core;
    fxl_corner with[3];
    int32_t values[3];
    const fxl_corner *const of[3] = {&with[0], &with[1], &with[2]};
    const int32_t *const light_of = any_below(2) != 0 ? values : NULL;
    const bool is_affine = any_below(4) == 0;
    const uint32_t v_drop = any_below(17);
    any_texels(with);
    any_light(values);
    const int32_t one =
        fxl_find_texel_planes(corners, lens, of, &core, light_of, is_affine, v_drop);
    return one == portable_find_texel_planes(corners, lens, of, &portable, light_of, is_affine,
                                             v_drop) &&
           (one == 0 || equality_same_words(&core, &portable, sizeof core));
}

static bool is_gradient(const fxl_gradient *a, const fxl_gradient *b)
{
    return a->at == b->at && a->along == b->along && a->down == b->down;
}

static bool is_same(const fxl_gradients *a, const fxl_gradients *b)
{
    return is_gradient(&a->weight, &b->weight) &&
           is_gradient(&a->attributes[0], &b->attributes[0]) && a->shifts[0] == b->shifts[0] &&
           a->count == b->count && a->weight_min[0] == b->weight_min[0] &&
           a->weight_min[1] == b->weight_min[1];
}

/* Whether the kernel says rightly that the mean of the error is taken off light. Requires planes that are words. */
static bool says_mean(const fxl_screen_corners *corners, const fxl_lens *lens,
                      const int32_t light[3])
{
#if FXL_DRAWS_SMOOTH_OUTLINES
    fxl_corner_planes planes;
    fxl_smooth_words words;
    const fxl_words_lens words_lens = fxl_words_lens_of(lens);
    const int32_t one = fxl_find_smooth_words(corners, &words_lens, light, &words);
    (void)fxl_corner_planes_begin(corners, lens, FXL_WORDS_SIDE_MAX, &planes);
    const uint64_t least = planes.weight_most - planes.weight_range;
    const uint64_t error = (uint64_t)fxl_range_of(light) * planes.weight_range;
    return ((one & FXL_WORDS_HAVE_MEAN) != 0) == (error > least * 4u * FXL_AFFINE_ERROR_LIGHT);
#else
    (void)corners;
    (void)lens;
    (void)light;
    return true;
#endif
}

void test_smooth_planes(uint32_t rounds)
{
    static fxl_lens lens;
    fxl_screen_corners corners;
    fxl_gradients by_core, by_portable;
    fxl_depth_plane core, portable;
    int32_t light[3];
    for (uint32_t i = 0; i < rounds; i++) {
        any_lens(&lens);
        any_corners(&lens, &corners);
        any_light(light);
        const fxl_words_lens words_lens = fxl_words_lens_of(&lens);
        const bool found = fxl_find_smooth_planes(&corners, &lens, light, &by_core, &core);
        const bool expected =
            portable_find_smooth_planes(&corners, &lens, light, &by_portable, &portable);
        equality_case(found == expected &&
                      (!found || (is_gradient(&core.gradient, &portable.gradient) &&
                                  core.one == portable.one && is_same(&by_core, &by_portable) &&
                                  says_mean(&corners, &lens, light))));
        equality_case(!corners.is_triangle || has_same_texels(&corners, &words_lens));
    }
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* A value of a channel below `end`: mostly near `first`. */
static int32_t any_value(uint32_t first, uint32_t range, uint32_t end)
{
    const uint32_t value = first + any_below(range);
    return (int32_t)(4096u + value % (end - 2u * 4096u + 1u));
}

static void any_values(int32_t (*values)[3])
{
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t end = (k == 1 ? 64u : 32u) << 16, range = any_size(21) + 1u;
        const uint32_t first = any_below(4) != 0 ? any_below(end) : 0;
        for (uint32_t i = 0; i < 3; i++) {
            values[k][i] = any_value(first, range, end);
        }
        if (first == 0) { /* a corner is near an end */
            const bool is_upper = any_below(2) != 0;
            values[k][any_below(3)] = 4096 + (int32_t)any_below(1u << 14);
            for (uint32_t i = 0; i < 3 && is_upper; i++) {
                values[k][i] = (int32_t)end - values[k][i];
            }
        }
    }
}

/* Values of a face that is lit, or colours of one that is not, whose values are *values then. */
static void any_colours(fxl_corner corners[3], int32_t (*values)[3], fxl_colour_face *face)
{
    static const int32_t limits[4] = {FXL_BEND_NONE, FXL_BEND_NONE, FXL_BEND_FINE, FXL_BEND_ANY};
    const fxl_corner *const of[3] = {&corners[0], &corners[1], &corners[2]};
    face->limit = limits[any_below(4)];
    face->is_lit = any_below(2);
    any_values(values);
    for (uint32_t i = 0; i < 3; i++) { /* the upper byte means nothing */
        corners[i].texel.u = (int32_t)(any_below(256) << 24 | (uint32_t)values[0][i] >> 13 << 16 |
                                       (uint32_t)values[1][i] >> 14 << 8 | (uint32_t)values[2][i] >> 13);
    }
    if (face->is_lit) {
        memcpy(face->values, values, sizeof face->values);
    } else {
        fxl_corner_colours(of, values);
    }
}

/* What a kernel sets of an outline, whose other words are the same in both. */
static bool has_same_words(const fxl_colour_outline *a, const fxl_colour_outline *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

void test_colour_planes(uint32_t rounds)
{
    static fxl_lens lens;
    fxl_screen_corners corners;
    fxl_colour_outline by_portable;
    fxl_colour_face by_core;
    fxl_corner of[3];
    const fxl_corner *const at[3] = {&of[0], &of[1], &of[2]};
    fxl_gradients gradients;
    fxl_depth_plane portable;
    fxl_corner_planes planes;
    memset(&by_core, 0, sizeof by_core);
    memset(&by_portable, 0, sizeof by_portable);
    for (uint32_t i = 0; i < rounds; i++) {
        int32_t values[3][3];
        any_lens(&lens);
        any_corners(&lens, &corners);
        corners.is_triangle = true;
        any_colours(of, values, &by_core);
        const fxl_words_lens words_lens = fxl_words_lens_of(&lens);
        const bool found = fxl_find_colour_planes(&corners, &words_lens, at, &by_core);
        const bool expected =
            corners.width <= FXL_WORDS_SIDE_MAX && corners.height <= FXL_WORDS_SIDE_MAX &&
            fxl_corner_planes_begin(&corners, &lens, FXL_COLOURS_SIDE_MAX, &planes) &&
            fxl_corner_colours_linear(&planes, values, by_core.limit == FXL_BEND_ANY,
                                      by_core.limit == FXL_BEND_NONE, &gradients) &&
            fxl_corner_planes_depth_words(&planes, &portable);
        if (expected) {
            fxl_colour_outline_of_words(&gradients, &by_portable);
            fxl_colour_outline_of_plane(fxl_depth_scale_of(&lens), &portable, &by_portable);
        }
        equality_case(found == expected && (!found || has_same_words(&by_core.outline, &by_portable)));
    }
}

#endif
