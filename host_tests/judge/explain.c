/* SPDX-License-Identifier: MIT */
#include "judge/explain.h"

#include <math.h>

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

/* Whether a polygon may show a colour, and whether it may be clear, at a pixel that it covers. */
typedef struct {
    bool shown, clear;
} showing;

static void add_texel(showing *found, int texel, uint8_t colour)
{
    found->shown = found->shown || texel == colour;
    found->clear = found->clear || texel == REF_CLEAR;
}

/* Every texel that the place may be in. */
static showing texels_about(const ref_texture *texture, const ref_place *place, double slack,
                            uint8_t colour)
{
    showing found = {false, false};
    for (double v = floor(place->v - slack); v <= place->v + slack; v++) {
        for (double u = floor(place->u - slack); u <= place->u + slack; u++) {
            add_texel(&found, ref_texture_colour(texture, (int64_t)u, (int64_t)v), colour);
        }
    }
    return found;
}

static showing shows(const ref_lens *lens, const ref_drawn *drawn, const judge_question *question)
{
    const ref_surface_view *look = &drawn->look;
    ref_place place;
    if (!look->surface) {
        return (showing){drawn->polygon.colour == question->colour, false};
    }
    if (!ref_stipple_draws(look->surface->opacity, question->x, question->y)) {
        return (showing){false, true};
    }
    if (!look->texture) {
        return (showing){drawn->polygon.colour == question->colour, false};
    }
    if (!ref_surface_place(look, lens, question->x + 0.5, question->y + 0.5, &place)) {
        return (showing){false, true};
    }
    return texels_about(look->texture, &place, question->texels ? place.slack : 0,
                        question->colour);
}

double judge_explain(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                     size_t count, const judge_question *question)
{
    const double cx = question->x + 0.5, cy = question->y + 0.5;
    double best = INFINITY;
    double uncovered = 0; /* the cost of putting every later polygon out */
    for (size_t i = count; i-- > 0 && uncovered < best;) {
        const ref_screen_polygon *least = judge_least(&drawn[i], question->doubt);
        const ref_screen_polygon *most = judge_most(&drawn[i], question->doubt);
        bool near = box_holds(&boxes[i], cx, cy);
        if (!near && box_is_beyond(&boxes[i], cx, cy, best)) {
            continue;
        }
        const showing found = shows(lens, &drawn[i], question);
        if (found.shown) {
            bool in = near && ref_scan_covers(most, cx, cy);
            double cost = in ? 0 : judge_edge_distance(most, cx, cy);
            best = fmin(best, fmax(uncovered, cost));
        }
        if (near && !found.clear && ref_scan_covers(least, cx, cy)) {
            uncovered = fmax(uncovered, judge_edge_distance(least, cx, cy));
        }
    }
    return question->background == question->colour ? fmin(best, uncovered) : best;
}
