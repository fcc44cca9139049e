/* SPDX-License-Identifier: MIT */
/* What must be beneath some polygons so that a pixel shows what it shows, and what it costs to explain the
 * pixel so (judge/explain.h). In frames of a palette a cost for each colour; in RGB565 ranges of
 * colours, each with a cost. */
#ifndef JUDGE_BENEATH_H
#define JUDGE_BENEATH_H

#include "reference/render.h"

enum {
    JUDGE_RANGES_MAX = 4096,
    JUDGE_COLOURS_MAX = 256 /* that one polygon may show at a pixel */
};

/* Colours from low to high in each channel. */
typedef struct {
    int low[REF_CHANNELS], high[REF_CHANNELS];
    double cost;
} judge_range;

/* The colours that a polygon may show at a pixel that it covers, and whether it may be clear there.
 * In a palette they are entries, and lit; in RGB565 they are those of texels, and light leaves a
 * part of them from part[0] to part[1], or, with is_range, they are all of a range. */
typedef struct {
    bool clear, is_range;
    judge_range range;
    double part[2];
    int count;
    uint16_t colours[JUDGE_COLOURS_MAX];
} judge_showing;

/* No colour, and all of it is left. */
void judge_showing_begin(judge_showing *found);

/* Adds a colour, once. */
void judge_showing_add(judge_showing *found, uint16_t colour);

/* What a choice costs: to show a polygon, to leave it out. */
typedef struct {
    double in, out;
} judge_choice;

typedef struct {
    const ref_rgb565 *rgb565; /* null: frames of a palette */
    double costs[256];        /* of each colour of a palette */
    int count;
    judge_range ranges[JUDGE_RANGES_MAX];
} judge_beneath;

/* Nothing is above: the pixel itself has the colour. */
void judge_beneath_begin(judge_beneath *of, const ref_rgb565 *rgb565, uint16_t colour);

/* A polygon above what is now beneath is left out, which costs so much. */
void judge_beneath_leave_out(judge_beneath *of, double out);

/* A polygon that is blended is put in, or left out. In RGB565 it is put in from a pixel's distance
 * at most. */
void judge_beneath_blend(judge_beneath *of, const ref_surface_view *look,
                         const judge_showing *found, judge_choice made);

/* The least cost that what a polygon shows explains the pixel; or the background, or anything. */
double judge_beneath_shown(const judge_beneath *of, const judge_showing *found);
double judge_beneath_background(const judge_beneath *of, uint8_t background);
double judge_beneath_least(const judge_beneath *of);

#endif
