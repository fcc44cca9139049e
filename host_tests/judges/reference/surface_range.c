/* SPDX-License-Identifier: MIT */
/* How far the library's values at a pixel may be from the exact ones: SPEC.md, section 9, and
 * docs/accuracy.md, sections 4.2.1 and 5. */
#include "reference/surface.h"

#include <math.h>

enum {
    POSITION_COLUMNS_MIN = 16 /* of textures whose positions have 16 bits */
};

/* Texels of the level for one of level 0, of a texture coordinate. */
static double scale_of(const ref_surface_view *view, int value)
{
    return view->texture && value < REF_BRIGHTNESS ? view->scales[value] : 1;
}

/* --- small faces (SPEC.md, section 9.1.1) --------------------------------------------------- */

/* The sides of the box of the corners on the screen. */
static void find_box(const ref_screen_point points[3], double sides[2])
{
    sides[0] = fmax(points[0].x, fmax(points[1].x, points[2].x)) -
               fmin(points[0].x, fmin(points[1].x, points[2].x));
    sides[1] = fmax(points[0].y, fmax(points[1].y, points[2].y)) -
               fmin(points[0].y, fmin(points[1].y, points[2].y));
}

/* Whether the light of a triangle may be taken for linear more often. */
static bool has_coarse_light(const ref_surface_view *view)
{
    return view->is_light_coarse && view->light && !view->texture;
}

/* The same of texels and their light: of opaque ones in 16 bits that repeat and have no key. */
static bool has_coarse_texels(const ref_surface_view *view)
{
    const ref_surface *surface = view->surface;
    return view->is_light_coarse && view->rgb565 && view->texture && !view->texture->clamps &&
           !view->texture->is_keyed && surface->opacity == REF_OPAQUE &&
           !ref_surface_mixes(surface) && surface->division != REF_DIVIDE_8 && !view->is_affine;
}

/* By the largest box that a small face may have. */
static bool may_be_small(const ref_surface_view *view)
{
    double sides[2];
    if (!view->is_in_front || view->surface->division == REF_DIVIDE_1) {
        return false;
    }
    find_box(view->points, sides);
    const double most = view->surface->has_colours ? 1023.01
                        : has_coarse_light(view)   ? 127.26
                        : has_coarse_texels(view)  ? 64.26
                                                   : 64.01;
    return fmax(sides[0], sides[1]) < most;
}

/* By how much the function of the screen may be off that takes the place of the exact value. */
static double linear_error(const ref_surface_view *view, int value, double scale)
{
    if (view->texture && value < REF_BRIGHTNESS) {
        return has_coarse_texels(view) ? 0.3 * scale : scale / 64;
    }
    if (has_coarse_texels(view)) {
        return 0.25;
    }
    const bool is_exact = view->surface->division == REF_DIVIDE_8 || view->is_affine;
    if (view->surface->has_colours && !is_exact) {
        return 0.3;
    }
    return has_coarse_light(view) ? 3.0 / 16 : 1.0 / 8;
}

/* The range of a value over the corners. */
static double range_of(const ref_surface_view *view, int value)
{
    const double a = view->steps[0][value], b = view->steps[1][value];
    return fmax(fmax(fabs(a), fabs(b)), fabs(a - b));
}

/* What a function of the screen rounds (docs/accuracy.md, section 5.1.1): its coefficients, and the
 * corners by 0.52/65536 pixel along each axis. */
static double screen_rounding(const ref_surface_view *view, int value, double scale)
{
    const ref_screen_point *p = view->points;
    const double area = fabs((p[1].x - p[0].x) * (p[2].y - p[0].y) -
                             (p[2].x - p[0].x) * (p[1].y - p[0].y));
    const double range = range_of(view, value) * scale;
    double sides[2];
    find_box(p, sides);
    if (!(area > 0)) {
        return scale;
    }
    const double change = range * 2 * (sides[0] + sides[1]) / area; /* a pixel */
    const double box = fmax(sides[0], sides[1]) / fmin(sides[0], sides[1]);
    const double filled = fmin(2 * sides[0] * sides[1] / area, 1024);
    return change * 0.52 / 65536 + (0x1p-29 + 0x1p-28 * filled * (1 + box)) * range;
}

/* --- segments (SPEC.md, section 9.2) ---------------------------------------------------------- */

/* The longest segment of a division; 0: each pixel has the exact value. */
static int longest_segment(const ref_surface_view *view)
{
    const int division = view->surface->division;
    return division == REF_DIVIDE_1 || view->is_affine ? 0 : division == REF_DIVIDE_8 ? 8 : 16;
}

/* The exact values at both ends of the segment of so many columns about a pixel. False: the plane
 * is not in front of the eye in both. */
static bool find_ends(const ref_surface_view *view, const ref_lens *lens, int length, int x, int y,
                      ref_place ends[2])
{
    const int first = x / length * length;
    return ref_surface_place(view, lens, first + 0.5, y + 0.5, &ends[0]) &&
           ref_surface_place(view, lens, first + length + 0.5, y + 0.5, &ends[1]);
}

/* How far the values of segments may be below and above the exact ones. A value is a quotient of
 * linear functions, whose curve bends to one side: the line of a shorter segment lies between it
 * and the line of the longest one. */
static void find_bends(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                       const ref_place *place, ref_place *below, ref_place *above)
{
    const int length = longest_segment(view);
    ref_place ends[2];
    const bool has_ends = length > 0 && find_ends(view, lens, length, x, y, ends);
    for (int k = 0; k < REF_VALUES; k++) {
        const double promised = (length == 8 ? 0.075 : length == 16 ? 0.3 : 0) * scale_of(view, k);
        double bends[2] = {-promised, promised};
        if (has_ends) {
            const double a = ends[0].values[k], b = ends[1].values[k];
            bends[0] = bends[1] = a + (b - a) * (x % length) / length - place->values[k];
        }
        below->values[k] = fmin(fmax(-bends[0], 0), promised);
        above->values[k] = fmin(fmax(bends[1], 0), promised);
    }
}

/* --- rounding ------------------------------------------------------------------------------- */

/* How often v repeats in 16 columns, at least once. */
static double repeats_of(const ref_surface_view *view, const ref_lens *lens, int x, int y)
{
    ref_place ends[2];
    if (view->texture->clamps) {
        return 0;
    }
    if (!find_ends(view, lens, 16, x, y, ends)) {
        return 1;
    }
    return 1 + floor(fabs(ends[1].values[REF_V] - ends[0].values[REF_V]) / view->level->height);
}

/* What the steps between two divisions round, and what a position of 16 bits cuts off
 * (docs/accuracy.md, section 5.2). */
static double steps_rounding(const ref_surface_view *view, const ref_lens *lens, int value, int x,
                             int y)
{
    const ref_texture_level *level = view->level;
    const bool has_positions =
        view->texture && level->width >= POSITION_COLUMNS_MIN && !ref_surface_mixes(view->surface);
    if (view->surface->has_colours) {
        return 65.0 / 2048; /* SPEC.md, section 9.8 */
    }
    if (!has_positions) {
        return 0x1p-12;
    }
    if (value == REF_BRIGHTNESS) {
        return view->rgb565 || view->surface->division == REF_DIVIDE_1 ? 0x1p-12 : 1.0 / 16;
    }
    const double unit = (level->width > level->height ? level->width : level->height) / 65536.0;
    return 0x1p-12 + unit * (view->surface->division == REF_DIVIDE_1
                                 ? 1
                                 : 9 + repeats_of(view, lens, x, y));
}

static double rounding_of(const ref_surface_view *view, const ref_lens *lens, int value, int x,
                          int y)
{
    const double scale = scale_of(view, value);
    if (view->is_billboard) {
        return view->rounding[value];
    }
    const double rounding = 1.0 / 256 + steps_rounding(view, lens, value, x, y);
    return may_be_small(view) || view->is_affine ? rounding + screen_rounding(view, value, scale)
                                                 : rounding;
}

/* accuracy 4.2.1 */
void ref_surface_find_range(const ref_surface_view *view, const ref_lens *lens, int x, int y,
                            const ref_place *place, ref_place *low, ref_place *high)
{
    ref_place below, above;
    const bool is_small = !view->is_billboard && may_be_small(view);
    find_bends(view, lens, x, y, place, &below, &above);
    for (int k = 0; k < REF_VALUES; k++) {
        const double linear = is_small ? linear_error(view, k, scale_of(view, k)) : 0;
        const double rounding = rounding_of(view, lens, k, x, y);
        low->values[k] = place->values[k] - fmax(below.values[k], linear) - rounding;
        high->values[k] = place->values[k] + fmax(above.values[k], linear) + rounding;
    }
}
