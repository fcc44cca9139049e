/* SPDX-License-Identifier: MIT */
#include "judge/explain.h"

#include <math.h>
#include <string.h>

#include "reference/scan.h"

judge_box judge_box_of(const ref_screen_polygon *polygon)
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

double judge_edge_distance(const ref_screen_polygon *polygon, double x, double y)
{
    double nearest = INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        int next = i + 1 < polygon->count ? i + 1 : 0;
        nearest =
            fmin(nearest, segment_distance(&polygon->points[i], &polygon->points[next], x, y));
    }
    return nearest;
}

static const ref_screen_polygon *judge_least(const ref_drawn *drawn, bool doubt)
{
    return doubt && drawn->in_doubt ? &drawn->least : &drawn->polygon;
}

static const ref_screen_polygon *judge_most(const ref_drawn *drawn, bool doubt)
{
    return doubt && drawn->in_doubt ? &drawn->most : &drawn->polygon;
}

judge_box judge_box_of_drawn(const ref_drawn *drawn)
{
    return judge_box_of(judge_most(drawn, true));
}

/* The colours that a polygon may show at a pixel that it covers, and whether it may be clear there.
 */
typedef struct {
    bool colours[256], clear;
} showing;

static int64_t down(double value)
{
    return (int64_t)floor(value);
}

/* One texel at every level of light within the slack. part: of the slack, 0 or 1. */
static void add_texel(const ref_surface_view *look, const ref_place *place, double part, int texel,
                      showing *found)
{
    const double level = place->values[REF_BRIGHTNESS], slack = part * place->slack[REF_BRIGHTNESS];
    if (texel == REF_CLEAR) {
        found->clear = true;
        return;
    }
    for (int64_t i = down(level - slack); i <= down(level + slack); i++) {
        found->colours[ref_surface_lit(look, i, (uint8_t)texel)] = true;
    }
}

/* Every texel that the place may be in. */
static void add_texels(const ref_surface_view *look, const ref_place *place, double part,
                       showing *found)
{
    const double u = place->values[REF_U], v = place->values[REF_V];
    const double u_slack = part * place->slack[REF_U], v_slack = part * place->slack[REF_V];
    for (int64_t row = down(v - v_slack); row <= down(v + v_slack); row++) {
        for (int64_t column = down(u - u_slack); column <= down(u + u_slack); column++) {
            add_texel(look, place, part, ref_surface_texel(look, column, row), found);
        }
    }
}

static void find_showing(const ref_lens *lens, const ref_drawn *drawn,
                         const judge_question *question, showing *found)
{
    const ref_surface_view *look = &drawn->look;
    ref_place place;
    *found = (showing){.clear = false};
    if (!look->surface) {
        found->colours[drawn->polygon.colour] = true;
    } else if (!ref_stipple_draws(look->surface->opacity, question->x, question->y) ||
               !ref_surface_place(look, lens, question->x + 0.5, question->y + 0.5, &place)) {
        found->clear = true;
    } else {
        add_texels(look, &place, question->texels ? 1 : 0, found);
    }
}

/* What a choice costs: to show a polygon, to leave it out. */
typedef struct {
    double in, out;
} choice;

/* Leaving a polygon out costs so much, whatever is beneath it. */
static void add_left_out(double out, double costs[256])
{
    for (int c = 0; c < 256 && out > 0; c++) {
        costs[c] = fmax(costs[c], out);
    }
}

/* The colours beneath a polygon that blends which make one that costs little. */
static void add_blended(const ref_surface_view *look, const showing *found, choice made,
                        double costs[256])
{
    double before[256];
    memcpy(before, costs, sizeof before);
    add_left_out(made.out, costs);
    for (int c = 0; c < 256 && isfinite(made.in); c++) {
        for (int beneath = 0; beneath < 256 && found->colours[c]; beneath++) {
            const uint8_t mixed = ref_surface_over(look, (uint8_t)c, (uint8_t)beneath);
            costs[beneath] = fmin(costs[beneath], fmax(before[mixed], made.in));
        }
    }
}

/* costs[c]: what it costs that the colour c, beneath the polygons after this one, explains the
 * pixel. Makes them those beneath this polygon too. Returns what it costs that the polygon itself
 * explains the pixel. */
static double add_polygon(const ref_surface_view *look, const showing *found, choice made,
                          double costs[256])
{
    double shown = INFINITY;
    if (look->surface && look->surface->blends) {
        add_blended(look, found, made, costs);
        return shown;
    }
    for (int c = 0; c < 256 && isfinite(made.in); c++) {
        if (found->colours[c]) {
            shown = fmin(shown, fmax(costs[c], made.in));
        }
    }
    add_left_out(made.out, costs);
    return shown;
}

static double least_of(const double costs[256])
{
    double least = INFINITY;
    for (int c = 0; c < 256; c++) {
        least = fmin(least, costs[c]);
    }
    return least;
}

double judge_explain(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                     size_t count, const judge_question *question)
{
    const double cx = question->x + 0.5, cy = question->y + 0.5;
    double best = INFINITY, least_cost = 0, costs[256];
    for (int c = 0; c < 256; c++) {
        costs[c] = c == question->colour ? 0 : INFINITY;
    }
    for (size_t i = count; i-- > 0 && least_cost < best;) {
        const ref_screen_polygon *least = judge_least(&drawn[i], question->doubt);
        const ref_screen_polygon *most = judge_most(&drawn[i], question->doubt);
        bool near = box_holds(&boxes[i], cx, cy);
        if (!near && box_is_beyond(&boxes[i], cx, cy, best)) {
            continue;
        }
        showing found;
        find_showing(lens, &drawn[i], question, &found);
        const bool is_in = near && ref_scan_covers(most, cx, cy);
        const bool is_out = found.clear || !near || !ref_scan_covers(least, cx, cy);
        const choice made = {is_in ? 0 : judge_edge_distance(most, cx, cy),
                             is_out ? 0 : judge_edge_distance(least, cx, cy)};
        best = fmin(best, add_polygon(&drawn[i].look, &found, made, costs));
        least_cost = made.out > 0 || drawn[i].look.surface ? least_of(costs) : least_cost;
    }
    return fmin(best, costs[question->background]);
}

/* --- by depth ------------------------------------------------------------------------------- */

enum {
    NEAR_MAX = 1024 /* polygons about one pixel */
};

/* A polygon about the pixel. */
typedef struct {
    const ref_drawn *drawn;
    double nearness;
    choice made;
    showing found;
} candidate;

static candidate candidate_of(const ref_lens *lens, const ref_drawn *drawn, const judge_box *box,
                              const judge_question *question)
{
    const double cx = question->x + 0.5, cy = question->y + 0.5;
    const ref_screen_polygon *least = judge_least(drawn, question->doubt);
    const ref_screen_polygon *most = judge_most(drawn, question->doubt);
    const bool near = box_holds(box, cx, cy);
    candidate one = {.drawn = drawn, .nearness = ref_nearness(&drawn->depth, lens, cx, cy)};
    find_showing(lens, drawn, question, &one.found);
    const bool is_in = near && ref_scan_covers(most, cx, cy);
    const bool is_out = one.found.clear || !near || !ref_scan_covers(least, cx, cy);
    one.made.in = is_in ? 0 : judge_edge_distance(most, cx, cy);
    one.made.out = is_out ? 0 : judge_edge_distance(least, cx, cy);
    return one;
}

/* Whether one is nearer than another, which may be null: the background, for sure. */
static bool is_nearer(const candidate *one, const candidate *other, double resolution)
{
    return !other || one->nearness > other->nearness * (1 + resolution + one->drawn->depth.slack +
                                                        other->drawn->depth.slack);
}

/* What it costs that an opaque polygon, or the background, explains the pixel. */
static double explain_by(const candidate *near, size_t count, const candidate *shown,
                         const judge_question *question, double resolution)
{
    double costs[256], cost = shown ? shown->made.in : 0, best = INFINITY;
    for (int c = 0; c < 256; c++) {
        costs[c] = c == question->colour ? 0 : INFINITY;
    }
    for (size_t i = count; i-- > 0;) {
        const candidate *one = &near[i];
        if (!ref_is_blended(one->drawn)) {
            if (one != shown && is_nearer(one, shown, resolution)) {
                cost = fmax(cost, one->made.out);
            }
        } else if (!shown || !is_nearer(shown, one, resolution)) {
            choice made = one->made;
            made.out = is_nearer(one, shown, resolution) ? made.out : 0;
            add_polygon(&one->drawn->look, &one->found, made, costs);
        }
    }
    for (int c = 0; c < 256; c++) {
        if (shown ? shown->found.colours[c] : c == question->background) {
            best = fmin(best, costs[c]);
        }
    }
    return fmax(best, cost);
}

double judge_explain_by_depth(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                              size_t count, const judge_question *question, double resolution)
{
    candidate near[NEAR_MAX];
    size_t found = 0;
    for (size_t i = 0; i < count && found < NEAR_MAX; i++) {
        if (!box_is_beyond(&boxes[i], question->x + 0.5, question->y + 0.5, 1)) {
            near[found++] = candidate_of(lens, &drawn[i], &boxes[i], question);
        }
    }
    double best = found == 0 ? (question->colour == question->background ? 0 : INFINITY)
                             : explain_by(near, found, NULL, question, resolution);
    for (size_t i = 0; i < found; i++) {
        if (!ref_is_blended(near[i].drawn)) {
            best = fmin(best, explain_by(near, found, &near[i], question, resolution));
        }
    }
    return best;
}
