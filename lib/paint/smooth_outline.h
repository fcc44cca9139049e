/* SPDX-License-Identifier: MIT */
/* An outline whose depth codes are linear on the screen, in a depth buffer of 16 bits, near to
 * far: of one colour and with light that is linear too, or with such colours at its corners; and
 * with texels and light that are linear, in any order.
 * Survey, edges, depth test and pixels are one call of a kernel, which only Armv7-M has, as depth_outline.h
 * says. Other cores have texels and light in C. Internal. */
#ifndef FXL_SMOOTH_OUTLINE_H
#define FXL_SMOOTH_OUTLINE_H

#include "../raster/scan.h"
#include "corner_colours.h"
#include "depth_outline.h"
#include "light_row.h"
#include "rgb565_colour.h"
#include "segments.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place light: RGB565: the part of a colour that light leaves of a lit surface */
/* The lower words of the planes of code and light: in row 0, column 0, what a row adds, and what a column
 * adds. */
typedef struct {
    uint32_t code_along, code, code_down, light_down, light, light_along;
} fxl_smooth_words;

/* What the kernel needs of a polygon. For pixels of 16 bits light is less the half level, and has half
 * a part of 256 more; between -1 part and 0 it is not held, since no part of it is left. */
typedef struct {
    uint32_t limit;         /* light from here on is not of the ramp; 0: codes have a border */
    fxl_smooth_words words; /* the kernel's own once it draws */
    union {
        const uint8_t *ramp;    /* pixels of 8 bits: the entry of the face's colour in level 0 */
        uint32_t part_of_level; /* of 16 */
    } by;
    fxl_mixture_565 mixture; /* of 16 bits */
    uint16_t *cells;         /* of the band */
    uintptr_t pixels; /* as of fxl_depth_outline; of 16 bits: of the cell after the pixel's */
    uint32_t last;    /* pixels of 8 bits: the last level; of 16: the most light of the ramp */
    uint32_t border;  /* as of fxl_depth_border */
    uint32_t small_rows; /* fxl_smooth_small_rows; of triangles alone */
} fxl_smooth_outline;

/* What words of depth depend on beside the corners. near_high: near_z, moved up to the highest bit, by its
 * leading zeros. octaves: 0 where the lens has a single one, and codes of 15 bits; then
 * its leading zeros mean nothing. */
typedef struct {
    uint32_t near_high, near_zeros, octaves, octaves_zeros;
    const fxl_lens *lens;
} fxl_words_lens;

static inline fxl_words_lens fxl_words_lens_of(const fxl_lens *lens)
{
    const uint32_t octaves = fxl_depth_scale_of(lens).octaves;
    const uint32_t near_z = (uint32_t)lens->near_z, zeros = fxl_leading_zeros(near_z);
    const fxl_words_lens of = {near_z << zeros, zeros, octaves == 1 ? 0 : octaves,
                               fxl_leading_zeros(octaves), lens};
    return of;
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* Those that fxl_find_smooth_planes finds. Returns fxl_depth_plane.one, with FXL_WORDS_HAVE_MEAN where the
 * mean of the error is taken off light; 0 where it finds none: *words is undefined then. Requires a triangle. */
int32_t fxl_find_smooth_words(const fxl_screen_corners *corners, const fxl_words_lens *lens,
                              const int32_t light[3], fxl_smooth_words *words);

#define FXL_WORDS_HAVE_MEAN (1 << 30)

/* The most rows of a triangle all of whose light is of the ramp, so that fxl_draw_smooth_triangle_16 need not
 * hold it; one: of fxl_find_smooth_words. Light at its corners is of the ramp, and the half part is
 * 2^15 for each level above 0: with so few rows and columns rounding changes light in the triangle by less than
 * 2^13 for each (corner_planes.h: k is below 2^-12 there). */
static inline uint32_t fxl_smooth_small_rows(int32_t one)
{
    return one == FXL_DEPTH_IS_LINEAR ? 6 : 0;
}

/* Draws an outline of count points. Requires fxl_smooth_outline_begin and what fxl_scan_begin
 * requires of outline and band. By the number of a pixel's bits; both write what
 * fxl_depth_paint_row and fxl_paint_pixels, or fxl_paint_pixels_565, write. */
fxl_depth_drawn fxl_draw_smooth_outline_8(const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band, fxl_smooth_outline *smooth);
fxl_depth_drawn fxl_draw_smooth_outline_16(const fxl_screen_point *points, uint32_t count,
                                           const fxl_band *band, fxl_smooth_outline *smooth);

/* fxl_draw_smooth_outline_16 of the corners of a triangle, which are in the columns of the band. Requires
 * small_rows too. */
fxl_depth_drawn fxl_draw_smooth_triangle_16(const fxl_inside_corners *corners, const fxl_band *band,
                                            fxl_smooth_outline *smooth);

#endif

/* fxl_draw_smooth_words: what a renderer with lit surfaces links, where FXL_DRAWS_SMOOTH_WORDS.
 *
 * Draws a polygon in words, near to far, into a band whose depth buffer `memory` has, and whose cells are
 * cleared. paint: of the face: gradients whose light is fxl_corner_planes_linear's, colour, ramp, levels_less_1, and of pixels of 2
 * bytes of_565 but for its key and what is mixed; scan: of the outline, not read yet. It writes what
 * fxl_depth_paint_row and fxl_paint_pixels, or fxl_paint_pixels_565, write. */
typedef void fxl_smooth_drawer(const fxl_paint *paint, const fxl_depth_plane *depth,
                               const void *memory, uint32_t pixel_bytes, const fxl_band *band,
                               fxl_scan *scan);
fxl_smooth_drawer fxl_draw_smooth_words;

/* Sets what all polygons of a band and a ramp share whose pixels have `pixel_bytes` bytes. Requires
 * fxl_depth_outline_can_draw. */
static inline void fxl_smooth_outline_of_band(const fxl_depth_head *head, const fxl_paint *paint,
                                              const fxl_band *band, uint32_t pixel_bytes,
                                              fxl_smooth_outline *smooth)
{
    smooth->cells = (uint16_t *)(uintptr_t)(head + 1);
    smooth->pixels = fxl_depth_outline_pixels(head, band, pixel_bytes);
    smooth->last = paint->levels_less_1;
    if (pixel_bytes != 1) {
        smooth->last = (smooth->last << 24) + fxl_half_part_565(paint->levels_less_1);
        smooth->pixels -= pixel_bytes;
        smooth->by.part_of_level = paint->of_565.part_of_level;
    }
}

/* Sets what follows from the colour of a polygon. */
static inline void fxl_smooth_outline_of_colour(const fxl_paint *paint, uint8_t colour,
                                                uint32_t pixel_bytes, fxl_smooth_outline *smooth)
{
    if (pixel_bytes == 1) {
        smooth->by.ramp = paint->ramp + colour;
    } else {
        smooth->mixture = fxl_mixture_of_565(paint->of_565.palette[colour], paint->of_565.dark);
    }
}

/* What the light of a polygon has more than its plane: the half part, less the half level. */
static inline uint32_t fxl_smooth_light_more(uint32_t pixel_bytes, const fxl_smooth_outline *smooth)
{
    return pixel_bytes == 1 ? 0 : (smooth->last & 0xFFFFFFu) - (1u << 23);
}

/* Sets what follows from its depth plane. one: of that. */
static inline __attribute__((always_inline)) void
fxl_smooth_outline_of_one(const fxl_depth_head *head, int32_t one, uint32_t pixel_bytes,
                          fxl_smooth_outline *smooth)
{
    const uint32_t border = fxl_depth_border_of(head->scale, one);
    const uint32_t end = (smooth->last + 1u) << (pixel_bytes == 1 ? 24 : 0);
    smooth->border = border;
    smooth->limit = border != 0 ? 0 : end;
}

static inline fxl_smooth_words fxl_smooth_words_of(const fxl_depth_plane *plane,
                                                   const fxl_gradients *gradients)
{
    const fxl_light_plane light = fxl_light_plane_of(gradients);
    const fxl_smooth_words words = {fxl_low_32(fxl_bits_64(plane->gradient.along)),
                                    fxl_low_32(fxl_bits_64(plane->gradient.at)),
                                    fxl_low_32(fxl_bits_64(plane->gradient.down)),
                                    light.down,
                                    light.at,
                                    light.along};
    return words;
}

/* Prepares a polygon. Requires planes in words, and fxl_depth_outline_can_draw. */
static inline void fxl_smooth_outline_set(const fxl_depth_head *head, const fxl_depth_plane *plane,
                                          const fxl_paint *paint, const fxl_band *band,
                                          uint32_t pixel_bytes, fxl_smooth_outline *smooth)
{
    fxl_smooth_outline_of_band(head, paint, band, pixel_bytes, smooth);
    fxl_smooth_outline_of_colour(paint, paint->colour, pixel_bytes, smooth);
    smooth->words = fxl_smooth_words_of(plane, paint->gradients);
    smooth->words.light += fxl_smooth_light_more(pixel_bytes, smooth);
    fxl_smooth_outline_of_one(head, plane->one, pixel_bytes, smooth);
}

/* The same for any polygon. Returns false if the kernel cannot draw it: *smooth is undefined then.
 * Requires paint->is_light_linear. */
static inline bool fxl_smooth_outline_begin(const void *memory, const fxl_depth_plane *plane,
                                            const fxl_paint *paint, const fxl_band *band,
                                            uint32_t pixel_bytes, fxl_smooth_outline *smooth)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    if (!fxl_depth_is_in_words(plane) || !fxl_depth_outline_can_draw(head, band, pixel_bytes)) {
        return false;
    }
    fxl_smooth_outline_set(head, plane, paint, band, pixel_bytes, smooth);
    return true;
}

/* What the kernel of colours needs of a polygon, in the order in which it loads it. The words are those of row 0
 * of the screen, and what a row adds: the code in column 0, the channels in the face's column
 * (corner_colours.h). */
struct fxl_colour_outline {
    uint32_t code, code_down, green, green_down;
    uint32_t red, red_down, blue, blue_down;
    uint32_t column;     /* the face's */
    uint32_t code_along; /* what a column adds */
    uintptr_t pixels;    /* as of fxl_depth_outline: of the cell after the pixel's */
    uint32_t step, green_step; /* what a column adds: fxl_colour_words */
    uint32_t border;           /* as of fxl_depth_border */
    uint16_t *cells;           /* of the band */
};

#if FXL_DRAWS_SMOOTH_OUTLINES

/* A face with colours at its corners, and what the kernel of its planes begins with. */
typedef struct {
    fxl_colour_outline outline;
    uint32_t is_lit;
    int32_t limit;        /* FXL_BEND_NONE, FXL_BEND_FINE or FXL_BEND_ANY */
    int32_t values[3][3]; /* red, green and blue at the corners of a face that is lit; then the kernel's own */
} fxl_colour_face;

/* fxl_corner_planes_begin with FXL_COLOURS_SIDE_MAX, fxl_corner_colours_linear,
 * fxl_corner_planes_depth_words, fxl_colour_outline_of_words and fxl_colour_outline_of_plane at once, of
 * a face with sides up to FXL_WORDS_SIDE_MAX; if it is not lit, fxl_corner_colours of its corners too. Returns
 * false where one of the first three does: what they set of the outline is undefined then. The values are
 * always. */
bool fxl_find_colour_planes(const fxl_screen_corners *corners, const fxl_words_lens *lens,
                            const fxl_corner *const of[3], fxl_colour_face *face);

/* Draws an outline of count points, as fxl_draw_smooth_outline_16 does. Writes what
 * fxl_depth_paint_row and fxl_paint_colours_565 write of opaque pixels. Requires points whose
 * columns are within 128 of the face's. */
fxl_depth_drawn fxl_draw_colour_outline(const fxl_screen_point *points, uint32_t count,
                                        const fxl_band *band, const fxl_colour_outline *outline);

#endif

/* Sets what all polygons of a band share. Requires fxl_depth_outline_can_draw. */
static inline void fxl_colour_outline_of_band(const fxl_depth_head *head, const fxl_band *band,
                                              fxl_colour_outline *outline)
{
    outline->cells = (uint16_t *)(uintptr_t)(head + 1);
    outline->pixels = fxl_depth_outline_pixels(head, band, 2) - 2u;
}

/* Sets what follows from the colours of a polygon, which are in words. */
static inline void fxl_colour_outline_of_words(const fxl_gradients *gradients,
                                               fxl_colour_outline *outline)
{
    const fxl_gradient *of = gradients->attributes;
    outline->red = fxl_low_32(fxl_bits_64(of[0].at));
    outline->green = fxl_low_32(fxl_bits_64(of[1].at));
    outline->blue = (uint32_t)(fxl_bits_64(of[1].at) >> 32);
    outline->red_down = fxl_low_32(fxl_bits_64(of[0].down));
    outline->green_down = (uint32_t)(fxl_bits_64(of[0].down) >> 32);
    outline->blue_down = fxl_low_32(fxl_bits_64(of[1].down));
    outline->column = (uint32_t)(fxl_bits_64(of[0].at) >> 32);
    outline->step = fxl_low_32(fxl_bits_64(of[0].along));
    outline->green_step = (uint32_t)(fxl_bits_64(of[0].along) >> 32);
}

/* Sets what follows from its plane, which is in words. */
static inline void fxl_colour_outline_of_plane(fxl_depth_scale scale, const fxl_depth_plane *plane,
                                               fxl_colour_outline *outline)
{
    outline->code = fxl_low_32(fxl_bits_64(plane->gradient.at));
    outline->code_down = fxl_low_32(fxl_bits_64(plane->gradient.down));
    outline->code_along = fxl_low_32(fxl_bits_64(plane->gradient.along));
    outline->border = fxl_depth_border(scale, plane);
}

/* Prepares a polygon with colours at its corners. Requires fxl_depth_outline_can_draw. */
static inline void fxl_colour_outline_set(const fxl_depth_head *head, const fxl_depth_plane *plane,
                                          const fxl_gradients *gradients, const fxl_band *band,
                                          fxl_colour_outline *outline)
{
    fxl_colour_outline_of_band(head, band, outline);
    fxl_colour_outline_of_words(gradients, outline);
    fxl_colour_outline_of_plane(head->scale, plane, outline);
}

/* --- texels, in pixels of 16 bits; in C for all cores ------------------------------------------ */

/* fxl_find_texels: what a painter of such pixels links.
 *
 * The gradients of a triangle with a constant weight, in words, and its depth. values: u, v and, if
 * count is 3, light at the corners. planes: of a small
 * face, or with FXL_TEXELS_SIDE_MAX. Where is_affine, that weight is asked
 * for; false otherwise if it changes u or v by more than FXL_WORDS_ERROR_TEXEL, or light by more
 * than FXL_WORDS_ERROR_LIGHT. Also false where the depth is not in words
 * (fxl_corner_planes_depth_words), or where a value changes by 128 or more a pixel: *gradients and
 * *depth are undefined then. Error in the triangle, beyond that, given the corners: k of the range
 * (corner_planes.h), and 2048 2^-24. */
typedef bool fxl_texels_finder(const fxl_corner_planes *planes, int32_t (*values)[3],
                               uint32_t count, bool is_affine, fxl_gradients *gradients,
                               fxl_depth_plane *depth);
fxl_texels_finder fxl_find_texels;

/* Such gradients: attributes are words in 8.24, modulo 2^32, in column 0 of row 0, and the changes.
 * A texture has at most 256 texels along a side, so coordinates wrap by themselves. Light is that of
 * light_row.h. shifts: of u and v less by the bits that a level of the texture leaves out. */
#define FXL_SHIFT_OF_TEXELS 120
FXL_STATIC_ASSERT(FXL_SHIFT_OF_TEXELS - 8 > FXL_SHIFT_MOST, "also less the bits of a level");

/* Of a face with a texture: without any attribute, the shifts are undefined. */
static inline bool fxl_has_texel_words(const fxl_gradients *gradients)
{
    return gradients->shifts[0] > FXL_SHIFT_MOST;
}

/* What is linear over the pixels: the code of depth_code.h, u, v, and light. Light is less the half
 * level, and has half a part of 256 more, as of fxl_smooth_outline: in the triangle it is not below
 * 0, and not above a part of 256, as the half part is 2^15 for each level above 0, and rounding changes
 * it by less than 2^14 for each. v is such that its row is from bit 16 + log on in a texture of 2^log
 * columns. */
typedef struct {
    uint32_t code, u, v, light;
} fxl_texel_words;

/* The words of a triangle: in column 0 of row 0, what a row adds, and what a column adds. */
typedef struct {
    fxl_texel_words at, down, along;
} fxl_texel_planes;

/* Those of such gradients, v in 8.24. */
static inline void fxl_texel_words_of(const fxl_gradients *gradients, const fxl_depth_plane *depth,
                                      fxl_texel_planes *planes)
{
    const fxl_gradient *u = &gradients->attributes[FXL_ATTRIBUTE_U];
    const fxl_gradient *v = &gradients->attributes[FXL_ATTRIBUTE_V];
    planes->at.code = fxl_low_32(fxl_bits_64(depth->gradient.at));
    planes->down.code = fxl_low_32(fxl_bits_64(depth->gradient.down));
    planes->along.code = fxl_low_32(fxl_bits_64(depth->gradient.along));
    planes->at.u = fxl_low_32(fxl_bits_64(u->at));
    planes->down.u = fxl_low_32(fxl_bits_64(u->down));
    planes->along.u = fxl_low_32(fxl_bits_64(u->along));
    planes->at.v = fxl_low_32(fxl_bits_64(v->at));
    planes->down.v = fxl_low_32(fxl_bits_64(v->down));
    planes->along.v = fxl_low_32(fxl_bits_64(v->along));
    planes->at.light = planes->down.light = planes->along.light = 0;
    if (gradients->count > FXL_SEGMENT_LIGHT) {
        const fxl_gradient *light = &gradients->attributes[FXL_SEGMENT_LIGHT];
        planes->at.light = fxl_low_32(fxl_bits_64(light->at));
        planes->down.light = fxl_low_32(fxl_bits_64(light->down));
        planes->along.light = fxl_low_32(fxl_bits_64(light->along));
    }
}

/* Whether u and v differ by less than 128 texels from those of corner 0. Coordinates are within
 * FXL_TEXEL_MAX, so differences are below 2^31. */
static inline bool fxl_has_few_texels(int32_t (*values)[3])
{
    int32_t bits = 0;
    for (uint32_t i = FXL_ATTRIBUTE_U; i <= FXL_ATTRIBUTE_V; i++) {
        const int32_t d1 = values[i][1] - values[i][0], d2 = values[i][2] - values[i][0];
        bits |= (d1 ^ (d1 >> 31)) | (d2 ^ (d2 >> 31));
    }
    return bits >> 23 == 0;
}

/* The words of a triangle, which fxl_corner_planes_begin with FXL_TEXELS_SIDE_MAX and fxl_find_texels find, from
 * the texels of its corners and light at these; light: null: it is none, and its words are undefined; v_drop: that
 * of fxl_texel_planes_scale, at most 16. Returns
 * fxl_depth_plane.one; 0 where the face is not such a triangle, or u or v differ by 128 texels or more
 * from those of corner 0: *planes is undefined then. It is a kernel: Armv7-M has its own. */
int32_t fxl_find_texel_planes(const fxl_screen_corners *corners, const fxl_words_lens *lens,
                              const fxl_corner *const of[3], fxl_texel_planes *planes,
                              const int32_t *light, bool is_affine, uint32_t v_drop);

/* What pixels there are. */
#define FXL_TEXELS_WIDE  1u /* of texels of 16 bits */
#define FXL_TEXELS_LIT   2u
#define FXL_TEXELS_BENT  4u /* codes have a border */
#define FXL_TEXELS_BLACK 8u /* lit, and the dark colour is 0: for the kernel */

/* What the pixels of a polygon depend on, and what the kernel keeps from row to row. */
typedef struct {
    fxl_texel_planes planes;
    uint16_t *cells;         /* of the band */
    uintptr_t pixels;        /* as of fxl_depth_outline: of the cell after the pixel's */
    const uint8_t *texels;
    uint32_t part_of_level;           /* 0: unlit */
    const uint16_t *palette;          /* of texels of 8 bits */
    uint32_t columns_mask, rows_mask; /* of u / 2^24, and of v / 2^16 */
    uint32_t kind;                    /* FXL_TEXELS_WIDE, _LIT, _BENT, _BLACK */
    fxl_mixture_565 mixture;          /* of the colour 0 */
    uint32_t end;                     /* the kernel's own */
    uint32_t border;                  /* fxl_depth_border */
    bool or_equal;
} fxl_texel_outline;

/* The words of a level, from those of fxl_texel_words_of: coordinates are shifted by the bits that the
 * level leaves out, v by at most 16 with those that its columns leave out. What wraps wraps by a
 * whole number of textures. */
static inline void fxl_texel_planes_scale(fxl_texel_planes *of, uint32_t u_drop, uint32_t v_drop)
{
    of->at.u = fxl_bits_32(fxl_signed_32(of->at.u) >> u_drop);
    of->down.u = fxl_bits_32(fxl_signed_32(of->down.u) >> u_drop);
    of->along.u = fxl_bits_32(fxl_signed_32(of->along.u) >> u_drop);
    of->at.v = fxl_bits_32(fxl_signed_32(of->at.v) >> v_drop);
    of->down.v = fxl_bits_32(fxl_signed_32(of->down.v) >> v_drop);
    of->along.v = fxl_bits_32(fxl_signed_32(of->along.v) >> v_drop);
}

/* What all triangles of a surface share: all but the planes, and what depends on them. paint: as of
 * fxl_draw_texels, but for the gradients and the light of the face. */
void fxl_texel_outline_of_surface(const fxl_depth_head *head, const fxl_paint *paint,
                                  fxl_texel_outline *of);

/* What the light of a lit triangle has more than that of fxl_texel_words_of: half a part, less the
 * half level. */
static inline uint32_t fxl_texel_light_more(uint32_t levels_less_1)
{
    return fxl_half_part_565(levels_less_1) - (1u << 23);
}

/* The rest, of a triangle: the kind of its pixels, and its light. one: of the depth plane. */
void fxl_texel_outline_of_face(const fxl_depth_head *head, const fxl_paint *paint, int32_t one,
                               fxl_texel_outline *of);

#if FXL_DRAWS_SMOOTH_OUTLINES

/* Draws an outline of count points, near to far. Requires what
 * fxl_draw_smooth_outline_16 does, and cleared cells. */
fxl_depth_drawn fxl_draw_texel_outline(const fxl_screen_point *points, uint32_t count,
                                       const fxl_band *band, fxl_texel_outline *outline);

#endif

/* Draws a polygon of such a face into a band whose depth buffer `memory` has, and whose cells are
 * cleared. paint: of the face: gradients, level, is_evenly_lit, light, of what is lit levels_less_1, and of_565 but for its key
 * and what is mixed; scan: workspace. Returns whether it reaches a row of the band. Safe
 * for any gradients: no texel is read that is not of the level. */
bool fxl_draw_texels(const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
                     const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                     fxl_scan *scan);

/* The same of an outline with all that it draws. */
bool fxl_draw_texel_words(fxl_texel_outline *outline, const void *memory,
                          const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                          fxl_scan *scan);

#ifdef __cplusplus
}
#endif

#endif
