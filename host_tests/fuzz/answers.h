/* SPDX-License-Identifier: MIT */
/* What must hold of the library's answers whatever it is fed, and which answers they were, as a hash:
 * so a replay sees where one has changed. */
#ifndef ANSWERS_H
#define ANSWERS_H

#include <stdio.h>
#include <stdlib.h>

#include "draw/stages.h"
#include "fixel/all.h"

/* Ends the program with a sentence where a promise does not hold. */
#define DEMAND(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
            abort(); \
        } \
    } while (0)

/* --- which they were ---------------------------------------------------------- */

/* Adds to the hash. The bytes have no padding between them. */
void record_bytes(const void *bytes, size_t size);
void record_number(int64_t number);
void record_text(const char *text); /* may be null */
/* The pixels, not what lies between width and stride. */
void record_band(const fxl_band *band);
void record_points(const fxl_screen_polygon *polygon);
/* An answer that is null records 0. */
void record_varying(const fxl_varying_polygon *polygon);

/* The hash of what was recorded since the last call. */
uint64_t record_end(void);

/* --- single stages, checked in wider arithmetic ------------------------------- */

/* A polygon clipped in the view lies inside every plane but for the clipper's
 * error, and projects onto the screen. */
void judge_view_clip(fxl_clip_result cut, const fxl_view_polygon *result, const fxl_view *view);

/* On which side of the planes a point lies, all planes and some of them; answers
 * those that it is outside of. */
fxl_planes judge_outcode(const fxl_view_frustum *frustum, const fxl_view_point *point,
                         uint32_t some);

/* What a clipper put on the screen has a legal count and is in range. */
void judge_screen(fxl_clip_result cut, const fxl_screen_polygon *screen);

/* A projected point, or a refusal, against the exact quotient. */
void judge_projection(const fxl_lens *lens, const fxl_view_point *view, fxl_status status,
                      const fxl_screen_point *screen);

/* A transformed point against sums in 128 bits. */
void judge_transform(const fxl_camera *camera, const fxl_point *point, const fxl_view_point *view);

/* A plane's distance of a point against sums in 128 bits. */
void judge_plane_distance(const fxl_plane *plane, const fxl_point *point, fxl_q18_46 distance);

/* place fill-rule: definition: edge_winding */
/* Every pixel of the band against the winding number of the outline about its
 * centre; pixels hold 1 where a span was, 0 elsewhere. */
void judge_coverage(const fxl_screen_polygon *polygon, const fxl_band *band);

#endif
