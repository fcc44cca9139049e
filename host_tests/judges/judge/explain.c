/* SPDX-License-Identifier: MIT */
#include "judge/explain.h"

#include <math.h>
#include <stdlib.h>

#include "frames/input.h"
#include "reference/horizon.h"
#include "reference/wire.h"
#include "judge/beneath.h"
#include "reference/scan.h"

/* How far from a polygon's box, in pixels, its outline may be. */
#define OUTLINE_REACH 2.0

/* Whether a line along an edge of a polygon may cover a pixel, if it is moved by at most a pixel:
 * as far as outlines move a vertex, and as far as rounding does. */
static bool is_on_outline(const ref_screen_polygon *polygon, int x, int y)
{
    for (int k = 0; k < polygon->count; k++) {
        const ref_screen_line line = {polygon->points[k], polygon->points[(k + 1) % polygon->count],
                                      polygon->colour};
        if (ref_wire_is_near(&line, x, y, 1)) {
            return true;
        }
    }
    return false;
}

static judge_box box_of(const ref_screen_polygon *polygon)
{
    judge_box box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int i = 0; i < polygon->count; i++) {
        box.left = fmin(box.left, polygon->points[i].x);
        box.right = fmax(box.right, polygon->points[i].x);
        box.top = fmin(box.top, polygon->points[i].y);
        box.bottom = fmax(box.bottom, polygon->points[i].y);
    }
    return box;
}

static bool box_holds(const judge_box *box, double x, double y)
{
    return box->left <= x && x <= box->right && box->top <= y && y <= box->bottom;
}

/* Tells whether the box is at least this far away along x or y; then the outline is, too. */
static bool box_is_beyond(const judge_box *box, double x, double y, double distance)
{
    return box->left - x >= distance || x - box->right >= distance || box->top - y >= distance ||
           y - box->bottom >= distance;
}

static double segment_distance(const ref_screen_point *a, const ref_screen_point *b, double x,
                               double y)
{
    double dx = b->x - a->x, dy = b->y - a->y;
    double length_squared = dx * dx + dy * dy;
    double t = length_squared > 0 ? ((x - a->x) * dx + (y - a->y) * dy) / length_squared : 0;
    t = fmax(0, fmin(1, t));
    return hypot(a->x + t * dx - x, a->y + t * dy - y);
}

/* Returns the distance in pixels from a point to the nearest edge of an outline. */
static double edge_distance(const ref_screen_polygon *polygon, double x, double y)
{
    double nearest = INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        int next = i + 1 < polygon->count ? i + 1 : 0;
        nearest =
            fmin(nearest, segment_distance(&polygon->points[i], &polygon->points[next], x, y));
    }
    return nearest;
}

static const ref_screen_polygon *least_of(const ref_drawn *drawn, bool doubt)
{
    return doubt && drawn->in_doubt ? &drawn->least : &drawn->polygon;
}

static const ref_screen_polygon *most_of(const ref_drawn *drawn, bool doubt)
{
    return doubt && drawn->in_doubt ? &drawn->most : &drawn->polygon;
}

/* Returns the bounds of all that may be drawn of a polygon. */
static judge_box box_of_drawn(const ref_drawn *drawn)
{
    return box_of(most_of(drawn, true));
}

static int64_t down(double value)
{
    return (int64_t)floor(value);
}

/* What a face may have at a pixel: values from low to high. */
typedef struct {
    ref_place low, high;
} span;

/* place sampling: add_texels: each texel that a place may be in, rounded down by itself */
/* One texel at every level of light. */
static void add_texel(const ref_surface_view *look, const span *values, int texel,
                      judge_showing *found)
{
    if (texel == REF_CLEAR) {
        found->clear = true;
    } else if (look->rgb565) {
        judge_showing_add(found, ref_surface_full(look, texel)); /* find_parts has the light */
    } else {
        const int64_t last = down(values->high.values[REF_BRIGHTNESS]);
        for (int64_t i = down(values->low.values[REF_BRIGHTNESS]); i <= last; i++) {
            judge_showing_add(found, ref_surface_lit(look, i, (uint8_t)texel));
        }
    }
}

/* Every texel that a place may be in. */
static void add_texels(const ref_surface_view *look, const span *values, judge_showing *found)
{
    const double *low = values->low.values, *high = values->high.values;
    for (int64_t row = down(low[REF_V]); row <= down(high[REF_V]); row++) {
        for (int64_t column = down(low[REF_U]); column <= down(high[REF_U]); column++) {
            add_texel(look, values, ref_surface_texel(look, column, row), found);
        }
    }
}

/* What is to be explained at the centre of a pixel. */
typedef struct {
    int x, y;
    uint16_t colour;          /* an entry of the palette, or of RGB565 */
    const ref_rgb565 *rgb565; /* of the frame; null: it is one of a palette */
    const uint8_t *backgrounds; /* what may be seen where no polygon is */
    int background_count;
    int line;    /* the colour of outlines, as `colour`; below 0: none are drawn */
    bool doubt;  /* near and far may leave more or less of a polygon; see below */
    bool texels; /* a face may show another texel within the bound of its coordinates */
} judge_question;

/* The values of a look at a pixel: the exact ones, or, with texels, all within their bounds. False:
 * there are none. */
static bool find_values(const ref_surface_view *look, const ref_lens *lens,
                        const judge_question *question, span *values)
{
    ref_place place;
    if (!ref_surface_place(look, lens, question->x + 0.5, question->y + 0.5, &place)) {
        return false;
    }
    values->low = values->high = place;
    if (question->texels) {
        ref_surface_find_range(look, lens, question->x, question->y, &place, &values->low,
                               &values->high);
    }
    return true;
}

/* The same of the other level that the library may choose. */
static void add_other_texels(const ref_surface_view *look, const ref_lens *lens,
                             const judge_question *question, judge_showing *found)
{
    const ref_surface_view other = ref_surface_with_level(look, look->other);
    span values;
    if (find_values(&other, lens, question, &values)) {
        add_texels(&other, &values, found);
    }
}

/* The parts of its colour that light may leave at a place of an RGB565 frame. */
static void find_parts(const ref_surface_view *look, const span *values, double part,
                       judge_showing *found)
{
    const double bound = part * ref_rgb565_part_bound(look->light);
    found->part[0] =
        fmax(ref_rgb565_part(look->light, values->low.values[REF_BRIGHTNESS]) - bound, 0);
    found->part[1] =
        fmin(ref_rgb565_part(look->light, values->high.values[REF_BRIGHTNESS]) + bound, 1);
}

/* The colours between those of corners that a pixel may have. */
static void find_colours(const span *values, judge_showing *found)
{
    found->is_range = true;
    found->range.cost = 0;
    ref_surface_channels(values->low.values, found->range.low);
    ref_surface_channels(values->high.values, found->range.high);
    judge_showing_add(found, 0); /* stands for all of them */
}

static void find_showing(const ref_lens *lens, const ref_drawn *drawn,
                         const judge_question *question, judge_showing *found)
{
    const ref_surface_view *look = &drawn->look;
    span values;
    judge_showing_begin(found);
    if (!look->surface) {
        const double brightness = 1 - drawn->shade;
        judge_showing_add(found, question->rgb565 ? question->rgb565->palette[drawn->polygon.colour]
                                                  : drawn->polygon.colour);
        found->part[0] = ref_rgb565_flat_part(fmax(brightness - REF_BRIGHTNESS_BOUND, 0));
        found->part[1] = ref_rgb565_flat_part(fmin(brightness + REF_BRIGHTNESS_BOUND, 1));
    } else if (!ref_stipple_draws(look->surface->opacity, question->x, question->y) ||
               !find_values(look, lens, question, &values)) {
        found->clear = true;
    } else if (look->surface->has_colours) {
        find_colours(&values, found);
    } else {
        add_texels(look, &values, found);
        if (question->texels && look->other) {
            add_other_texels(look, lens, question, found);
        }
        if (look->rgb565 && look->light) {
            find_parts(look, &values, question->texels ? 1 : 0, found);
        }
    }
}

/* Goes on to what is beneath a polygon. Returns what it costs that the polygon itself explains the
 * pixel. */
static double add_polygon(const ref_surface_view *look, const judge_showing *found,
                          judge_choice made, judge_beneath *beneath)
{
    if (look->surface && ref_surface_mixes(look->surface)) {
        judge_beneath_blend(beneath, look, found, made);
        return INFINITY;
    }
    const double shown = fmax(judge_beneath_shown(beneath, found), made.in);
    judge_beneath_leave_out(beneath, made.out);
    return shown;
}

/* What it costs that the outline of a polygon explains the pixel. beneath: what must be below all
 * that is drawn after it. */
static double outline_shown(const ref_drawn *drawn, const judge_question *question,
                            const judge_beneath *beneath)
{
    judge_showing line;
    if (question->line < 0 || !is_on_outline(&drawn->polygon, question->x, question->y)) {
        return INFINITY;
    }
    judge_showing_begin(&line);
    judge_showing_add(&line, (uint16_t)question->line);
    return judge_beneath_shown(beneath, &line);
}

/* What it costs that one of the backgrounds explains the pixel. */
static double background_shown(const judge_question *question, const judge_beneath *beneath)
{
    double least = INFINITY;
    for (int i = 0; i < question->background_count; i++) {
        least = fmin(least, judge_beneath_background(beneath, question->backgrounds[i]));
    }
    return least;
}

/* accuracy 4.2 */
/* Returns the smallest distance d that explains a colour at a pixel's centre. Every polygon of the
 * reference renderer that has an edge within d of the centre may be put in or out there. d
 * explains the colour if some choice makes the last polygon that is in show that colour. Returns
 * infinity where no choice does. boxes holds each polygon's bounds.
 *
 * A choice that shows polygon i puts i in: this costs 0 if it is in already, else the distance
 * of its edge. It puts every later polygon that is in out: each costs the distance of its edge.
 * The cost of the choice is the largest of these. Earlier polygons do not matter, and later ones
 * that are out stay out. The background counts as a polygon before the first, and is always in.
 *
 * doubt: near and far may leave anything of a polygon from its least to its most
 * (docs/accuracy.md, section 4). Putting it in then costs 0 where its most is in, else the
 * distance of an edge of its most. Putting it out costs 0 where its least is out, else the
 * distance of an edge of its least.
 *
 * A polygon with a surface shows the colour of its texel there at its level of light, or with
 * texels: of any texel and any level within their bounds (reference/surface.h). Where its texel is
 * clear, putting it out costs 0. Where it is blended, it shows what the table makes of its colour
 * and of the one beneath; so the cost is found for each colour that may be beneath
 * (judge/beneath.h).
 *
 * Where outlines are drawn, that of a polygon comes right after it. At a pixel that it may cover,
 * to show the line costs 0, and so does leaving it out. */
static double explain_by_order(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                     size_t count, const judge_question *question)
{
    const double cx = question->x + 0.5, cy = question->y + 0.5;
    double best = INFINITY, least_cost = 0;
    judge_beneath beneath;
    judge_beneath_begin(&beneath, question->rgb565, question->colour);
    for (size_t i = count; i-- > 0 && least_cost < best;) {
        const ref_screen_polygon *least = least_of(&drawn[i], question->doubt);
        const ref_screen_polygon *most = most_of(&drawn[i], question->doubt);
        bool near = box_holds(&boxes[i], cx, cy);
        const double reach = question->line < 0 ? best : fmax(best, OUTLINE_REACH);
        if (!near && box_is_beyond(&boxes[i], cx, cy, reach)) {
            continue;
        }
        best = fmin(best, outline_shown(&drawn[i], question, &beneath));
        judge_showing found;
        find_showing(lens, &drawn[i], question, &found);
        const bool is_in = near && ref_scan_covers(most, cx, cy);
        const bool is_out = found.clear || !near || !ref_scan_covers(least, cx, cy);
        const judge_choice made = {is_in ? 0 : edge_distance(most, cx, cy),
                             is_out ? 0 : edge_distance(least, cx, cy)};
        best = fmin(best, add_polygon(&drawn[i].look, &found, made, &beneath));
        least_cost =
            made.out > 0 || drawn[i].look.surface ? judge_beneath_least(&beneath) : least_cost;
    }
    return fmin(best, background_shown(question, &beneath));
}

/* --- by depth ------------------------------------------------------------------------------- */

/* A polygon about the pixel. */
typedef struct {
    const ref_drawn *drawn;
    double nearness, most, slack; /* most: where what is shown may be no nearer than it */
    judge_choice made;
    judge_showing found;
} candidate;

static candidate candidate_of(const ref_lens *lens, const ref_drawn *drawn, const judge_box *box,
                              const judge_question *question)
{
    const double cx = question->x + 0.5, cy = question->y + 0.5;
    const ref_screen_polygon *least = least_of(drawn, question->doubt);
    const ref_screen_polygon *most = most_of(drawn, question->doubt);
    const bool near = box_holds(box, cx, cy);
    candidate one = {.drawn = drawn, .nearness = ref_drawn_nearness(drawn, lens, cx, cy),
                     .most = ref_drawn_nearness_most(drawn, lens, cx, cy),
                     .slack = ref_drawn_slack(drawn, lens, cx, cy)};
    find_showing(lens, drawn, question, &one.found);
    const bool is_in = near && ref_scan_covers(most, cx, cy);
    const bool is_out = one.found.clear || !near || !ref_scan_covers(least, cx, cy);
    one.made.in = is_in ? 0 : edge_distance(most, cx, cy);
    one.made.out = is_out ? 0 : edge_distance(least, cx, cy);
    return one;
}

/* The polygons about a pixel, which the caller frees, and how many there are. */
static candidate *candidates_of(const ref_lens *lens, const ref_drawn *drawn,
                                const judge_box *boxes, size_t count,
                                const judge_question *question, size_t *found)
{
    size_t near_count = 0;
    for (size_t i = 0; i < count; i++) {
        near_count += !box_is_beyond(&boxes[i], question->x + 0.5, question->y + 0.5, 1);
    }
    candidate *near = malloc((near_count + 1) * sizeof *near);
    if (!near) {
        give_up("there is not enough memory");
    }
    for (size_t i = 0; i < count && *found < near_count; i++) {
        if (!box_is_beyond(&boxes[i], question->x + 0.5, question->y + 0.5, 1)) {
            near[(*found)++] = candidate_of(lens, &drawn[i], &boxes[i], question);
        }
    }
    return near;
}

/* Whether one is nearer than another, which may be null: the background, for sure. */
static bool is_nearer(const candidate *one, const candidate *other, double resolution)
{
    return !other || one->nearness > other->most * (1 + resolution + one->slack + other->slack);
}

/* What it costs that an opaque polygon, or the background, explains the pixel. */
static double explain_by(const candidate *near, size_t count, const candidate *shown,
                         const judge_question *question, double resolution)
{
    double cost = shown ? shown->made.in : 0;
    judge_beneath beneath;
    judge_beneath_begin(&beneath, question->rgb565, question->colour);
    for (size_t i = count; i-- > 0;) {
        const candidate *one = &near[i];
        if (!ref_is_blended(one->drawn)) {
            /* A line is as near as its face, and drawn over it. */
            if (one != shown && (is_nearer(one, shown, resolution) ||
                                 (shown && ref_lies_on(one->drawn, shown->drawn)))) {
                cost = fmax(cost, one->made.out);
            }
        } else if (!shown || !is_nearer(shown, one, resolution)) {
            judge_choice made = one->made;
            made.out = is_nearer(one, shown, resolution) ? made.out : 0;
            judge_beneath_blend(&beneath, &one->drawn->look, &one->found, made);
        }
    }
    return fmax(shown ? judge_beneath_shown(&beneath, &shown->found)
                      : background_shown(question, &beneath),
                cost);
}

/* accuracy 4.2 */
/* The same of a frame that was drawn by a depth buffer. A choice that shows opaque polygon i puts
 * out every opaque one that is nearer by more than the resolution and the slack of both. Blended
 * polygons are drawn over it in their order, those that are farther by more are not, and the others
 * may be in or out. Looks at polygons within a pixel of the centre alone. */
static double explain_by_depth(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                              size_t count, const judge_question *question, double resolution)
{
    size_t found = 0;
    candidate *near = candidates_of(lens, drawn, boxes, count, question, &found);
    double best = explain_by(near, found, NULL, question, resolution);
    for (size_t i = 0; i < found; i++) {
        if (!ref_is_blended(near[i].drawn)) {
            best = fmin(best, explain_by(near, found, &near[i], question, resolution));
        }
    }
    free(near);
    return best;
}

judge_box *judge_boxes_of(const ref_display_list *list)
{
    judge_box *boxes = malloc((list->count + 1) * sizeof *boxes);
    for (size_t i = 0; boxes && i < list->count; i++) {
        boxes[i] = box_of_drawn(&list->drawn[i]);
    }
    return boxes;
}

judge_reason judge_pixel(const ref_renderer *renderer, const judge_box *boxes, uint8_t background,
                         int line, int x, int y, uint16_t colour, double limit)
{
    const ref_display_list *list = &renderer->display_list;
    const double resolution = ref_depth_resolution(&renderer->lens, renderer->method.depth_bits);
    const int ways = renderer->scene->surfaces ? 4 : 2;
    judge_question question = {.x = x,
                               .y = y,
                               .colour = colour,
                               .rgb565 = renderer->rgb565,
                               .backgrounds = &background,
                               .background_count = 1,
                               .line = line < 0 ? line : ref_pixel_of(renderer, (uint8_t)line)};
    judge_reason reason = {0};
    if (renderer->scene->horizon.count > 0) {
        int low, high;
        (void)ref_horizon_level(renderer, x, y, &low, &high);
        question.backgrounds = &renderer->scene->horizon.colours[low];
        question.background_count = high - low + 1;
    }
    for (int way = 0; way < ways; way++) {
        question.doubt = way & 1;
        question.texels = way & 2;
        const double distance =
            renderer->method.depth_bits != 0
                ? explain_by_depth(&renderer->lens, list->drawn, boxes, list->count,
                                         &question, resolution)
                : explain_by_order(&renderer->lens, list->drawn, boxes, list->count, &question);
        if (distance <= limit) {
            return (judge_reason){distance, question.doubt, question.texels};
        }
        if (way == 0) {
            reason.distance = distance;
        }
    }
    return reason;
}
