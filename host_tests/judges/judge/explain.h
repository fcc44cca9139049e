/* SPDX-License-Identifier: MIT */
/* Whether a pixel that differs from the reference's is explained: by outlines, by bounds, by what a
 * frame may show. */
#ifndef JUDGE_EXPLAIN_H
#define JUDGE_EXPLAIN_H

#include "reference/render.h"

/* Frames with outlines. */

/* How far from a polygon's box, in pixels, its outline may be. */
#define JUDGE_OUTLINE_REACH 2.0

/* Whether a line along an edge of a polygon may cover a pixel, if it is moved by at most a pixel:
 * as far as outlines move a vertex, and as far as rounding does. */
bool judge_is_on_outline(const ref_screen_polygon *polygon, int x, int y);

/* Explains why a pixel may differ from that of the reference renderer (docs/accuracy.md, section
 * 4). */

/* The bounds of a polygon's outline, in pixels. */
typedef struct {
    double left, right, top, bottom;
} judge_box;

judge_box judge_box_of(const ref_screen_polygon *polygon);

/* Returns the bounds of all that may be drawn of a polygon. */
judge_box judge_box_of_drawn(const ref_drawn *drawn);

/* Returns the distance in pixels from a point to the nearest edge of an outline. */
double judge_edge_distance(const ref_screen_polygon *polygon, double x, double y);

/* place pixel-format: which colours a pixel may have */
/* What is to be explained at the centre of a pixel. */
typedef struct {
    int x, y;
    uint16_t colour;          /* an entry of the palette, or of RGB565 */
    const ref_rgb565 *rgb565; /* of the frame; null: it is one of a palette */
    uint8_t background;
    int line;    /* the colour of outlines, as `colour`; below 0: none are drawn */
    bool doubt;  /* near and far may leave more or less of a polygon; see below */
    bool texels; /* a face may show another texel within the bound of its coordinates */
} judge_question;

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
double judge_explain(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                     size_t count, const judge_question *question);

/* The same of a frame that was drawn by a depth buffer. A choice that shows opaque polygon i puts
 * out every opaque one that is nearer by more than the resolution and the slack of both. Blended
 * polygons are drawn over it in their order, those that are farther by more are not, and the others
 * may be in or out. Looks at polygons within a pixel of the centre alone. */
double judge_explain_by_depth(const ref_lens *lens, const ref_drawn *drawn, const judge_box *boxes,
                              size_t count, const judge_question *question, double resolution);

/* Judges one pixel of a frame against the reference renderer's frame. */

/* The distance in pixels within which an edge explains a difference, unless the caller asks for
 * another one (docs/accuracy.md, section 4). */
#define JUDGE_DISTANCE (1.0 / 8192)

/* Why a pixel may have its colour. */
typedef struct {
    double distance; /* in pixels, as judge_explain returns it */
    bool near_far;   /* it needs near and far moved by the bound on depths */
    bool texels;     /* it needs another texel within the bound */
} judge_reason;

/* Returns the bounds of a frame's polygons, for the caller to free; null where memory is short. */
judge_box *judge_boxes_of(const ref_display_list *list);

/* Explains a colour at pixel (x, y) of the renderer's frame, which was begun with keeps_doubt. The
 * reason is within the bound if its distance is at most `limit`. line: the palette index of the
 * outlines that were drawn; below 0: none. */
judge_reason judge_pixel(const ref_renderer *renderer, const judge_box *boxes, uint8_t background,
                         int line, int x, int y, uint16_t colour, double limit);

#endif
