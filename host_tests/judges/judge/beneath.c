/* SPDX-License-Identifier: MIT */
#include "judge/beneath.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "frames/input.h"

/* --- what a polygon shows ------------------------------------------------------------------- */

void judge_showing_begin(judge_showing *found)
{
    found->clear = found->is_range = false;
    found->part[0] = found->part[1] = 1;
    found->count = 0;
}

void judge_showing_add(judge_showing *found, uint16_t colour)
{
    for (int i = 0; i < found->count; i++) {
        if (found->colours[i] == colour) {
            return;
        }
    }
    if (found->count == JUDGE_COLOURS_MAX) {
        give_up("a surface may show so many colours at one pixel that the judge has no room");
    }
    found->colours[found->count++] = colour;
}

/* --- ranges of RGB565 ----------------------------------------------------------------------- */

static judge_range range_of_colour(uint16_t colour)
{
    judge_range range = {.cost = 0};
    for (int i = 0; i < REF_CHANNELS; i++) {
        range.low[i] = range.high[i] = ref_channel(colour, i);
    }
    return range;
}

/* What a texel, or a face's own colour, becomes in light that leaves from one part to another. */
static judge_range range_in_light(const judge_beneath *of, uint16_t colour, double least,
                                  double most)
{
    judge_range range = {.cost = 0};
    for (int i = 0; i < REF_CHANNELS; i++) {
        const double one = ref_rgb565_lit(of->rgb565, colour, i, least);
        const double other = ref_rgb565_lit(of->rgb565, colour, i, most);
        range.low[i] = (int)floor(fmin(one, other) + 0.5);
        range.high[i] = (int)floor(fmax(one, other) + 0.5);
    }
    return range;
}

/* The same of all light that was found. */
static judge_range range_shown(const judge_beneath *of, const judge_showing *found, uint16_t colour)
{
    return found->is_range ? found->range
                           : range_in_light(of, colour, found->part[0], found->part[1]);
}

static bool overlap(const judge_range *a, const judge_range *b)
{
    for (int i = 0; i < REF_CHANNELS; i++) {
        if (a->low[i] > b->high[i] || b->low[i] > a->high[i]) {
            return false;
        }
    }
    return true;
}

/* What is beneath a colour where floor((own colour + (16 - own) beneath) / 16) is within a range.
 * False: nothing. */
static bool find_beneath(const judge_range *mixed, const judge_range *colour, int own,
                         judge_range *beneath)
{
    bool found = true;
    for (int i = 0; i < REF_CHANNELS; i++) {
        const double low = 16 * mixed->low[i] - own * colour->high[i];
        const double high = 16 * mixed->high[i] + 15 - own * colour->low[i];
        const int most = ref_channel_most(i);
        if (own == 16) {
            beneath->low[i] = 0;
            beneath->high[i] = most;
            found = found && low <= 0 && high >= 0;
            continue;
        }
        beneath->low[i] = (int)fmax(ceil(low / (16 - own)), 0);
        beneath->high[i] = (int)fmin(floor(high / (16 - own)), most);
        found = found && beneath->low[i] <= beneath->high[i];
    }
    return found;
}

/* What is beneath a colour where the sum of both, at most the most of a channel, is within a range.
 * False: nothing. */
static bool find_added_to(const judge_range *sum, const judge_range *colour, judge_range *beneath)
{
    bool found = true;
    for (int i = 0; i < REF_CHANNELS; i++) {
        const int most = ref_channel_most(i);
        const int low = sum->low[i] - colour->high[i];
        const int high = sum->high[i] >= most ? most : sum->high[i] - colour->low[i];
        beneath->low[i] = low > 0 ? low : 0;
        beneath->high[i] = high;
        found = found && beneath->low[i] <= high;
    }
    return found;
}

/* Adds a range; a range that is there already keeps the smaller cost. */
static void add_range(judge_beneath *to, const judge_range *range)
{
    for (int i = 0; i < to->count; i++) {
        judge_range *there = &to->ranges[i];
        if (memcmp(there->low, range->low, sizeof range->low) == 0 &&
            memcmp(there->high, range->high, sizeof range->high) == 0) {
            there->cost = fmin(there->cost, range->cost);
            return;
        }
    }
    if (to->count == JUDGE_RANGES_MAX) {
        give_up("so many surfaces are blended at one pixel that the judge has no room");
    }
    to->ranges[to->count++] = *range;
}

/* place stipple: a blend: what a pixel may show over what is beneath it */
static void blend_ranges(judge_beneath *of, const ref_surface_view *look,
                         const judge_showing *found, judge_choice made)
{
    const int count = of->count;
    const size_t size = (size_t)count * sizeof(judge_range);
    judge_range *before = malloc(size > 0 ? size : 1);
    if (!before) {
        give_up("there is not enough memory");
    }
    memcpy(before, of->ranges, size);
    judge_beneath_leave_out(of, made.out);
    for (int c = 0; c < found->count && made.in <= 1; c++) {
        const judge_range colour = range_shown(of, found, found->colours[c]);
        for (int i = 0; i < count; i++) {
            judge_range beneath = {.cost = fmax(before[i].cost, made.in)};
            if (look->surface->adds
                    ? find_added_to(&before[i], &colour, &beneath)
                    : find_beneath(&before[i], &colour, look->surface->sixteenths, &beneath)) {
                add_range(of, &beneath);
            }
        }
    }
    free(before);
}

/* The least cost of a range that overlaps this one. */
static double least_within(const judge_beneath *of, const judge_range *range)
{
    double least = INFINITY;
    for (int i = 0; i < of->count; i++) {
        if (of->ranges[i].cost < least && overlap(&of->ranges[i], range)) {
            least = of->ranges[i].cost;
        }
    }
    return least;
}

/* The least cost that a texel, or a face's own colour, explains the pixel in light that was found.
 * Light is rounded to 256 parts, so all channels have the same one. */
static double least_in_light(const judge_beneath *of, const judge_showing *found, uint16_t colour)
{
    judge_range range = range_shown(of, found, colour);
    double least = INFINITY;
    if (found->is_range || !(found->part[0] < found->part[1])) {
        return least_within(of, &range);
    }
    const int last = (int)floor(256 * found->part[1]);
    for (int part = (int)ceil(256 * found->part[0]); part <= last; part++) {
        range = range_in_light(of, colour, part / 256.0, part / 256.0);
        least = fmin(least, least_within(of, &range));
    }
    return least;
}

/* --- colours of a palette ------------------------------------------------------------------- */

/* The colours beneath a polygon that blends which make one that costs little. */
static void blend_colours(judge_beneath *of, const ref_surface_view *look,
                          const judge_showing *found, judge_choice made)
{
    double before[256];
    memcpy(before, of->costs, sizeof before);
    judge_beneath_leave_out(of, made.out);
    for (int c = 0; c < found->count && isfinite(made.in); c++) {
        for (int beneath = 0; beneath < 256; beneath++) {
            const uint8_t mixed =
                ref_surface_over(look, (uint8_t)found->colours[c], (uint8_t)beneath);
            of->costs[beneath] = fmin(of->costs[beneath], fmax(before[mixed], made.in));
        }
    }
}

/* --- both ----------------------------------------------------------------------------------- */

void judge_beneath_begin(judge_beneath *of, const ref_rgb565 *rgb565, uint16_t colour)
{
    of->rgb565 = rgb565;
    of->count = 0;
    if (rgb565) {
        of->ranges[of->count++] = range_of_colour(colour);
        return;
    }
    for (int c = 0; c < 256; c++) {
        of->costs[c] = c == colour ? 0 : INFINITY;
    }
}

void judge_beneath_leave_out(judge_beneath *of, double out)
{
    for (int i = 0; i < of->count && out > 0; i++) {
        of->ranges[i].cost = fmax(of->ranges[i].cost, out);
    }
    for (int c = 0; c < 256 && out > 0 && !of->rgb565; c++) {
        of->costs[c] = fmax(of->costs[c], out);
    }
}

void judge_beneath_blend(judge_beneath *of, const ref_surface_view *look,
                         const judge_showing *found, judge_choice made)
{
    if (of->rgb565) {
        blend_ranges(of, look, found, made);
    } else {
        blend_colours(of, look, found, made);
    }
}

double judge_beneath_shown(const judge_beneath *of, const judge_showing *found)
{
    double least = INFINITY;
    for (int c = 0; c < found->count; c++) {
        if (of->rgb565) {
            least = fmin(least, least_in_light(of, found, found->colours[c]));
        } else {
            least = fmin(least, of->costs[found->colours[c]]);
        }
    }
    return least;
}

double judge_beneath_background(const judge_beneath *of, uint8_t background)
{
    if (of->rgb565) {
        const judge_range range = range_of_colour(of->rgb565->palette[background]);
        return least_within(of, &range);
    }
    return of->costs[background];
}

double judge_beneath_least(const judge_beneath *of)
{
    double least = INFINITY;
    for (int i = 0; i < of->count; i++) {
        least = fmin(least, of->ranges[i].cost);
    }
    for (int c = 0; c < 256 && !of->rgb565; c++) {
        least = fmin(least, of->costs[c]);
    }
    return least;
}
