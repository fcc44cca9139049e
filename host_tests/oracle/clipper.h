/* SPDX-License-Identifier: MIT */
/* The clipper that is judged. */
#ifndef ORACLE_CLIPPER_H
#define ORACLE_CLIPPER_H

#include "oracle/space.h"

/* fxl_clipper_view until another is chosen by its name in the comparison; 0 where there
 * is none of that name. */
int oracle_clipper_choose(const char *name);

/* From now on what is exact takes the chosen clipper's own matrix, planes and rounded vertices as
 * given, not the view's: what is left is its clipping alone. */
void oracle_clipper_own_integers(void);

/* What exact clipping takes as given. */
oracle_space oracle_clipper_space(const fxl_view *view);

/* A polygon of the world onto the screen: what the clipper answers, and how many
 * polygons it gives, into screens with room for so many. */
fxl_clip_result oracle_clipper_take(fxl_view *view, const fxl_polygon *polygon,
                                    fxl_screen_polygon *screens, int workspace_for, int *count);

/* How far the chosen one's outlines may be off, in 1/65536 pixel (docs/extras/clippers.md). */
double oracle_clipper_bound(const fxl_lens *lens);

/* Whether that holds for triangles alone: of a face that is not quite flat it makes others. */
int oracle_clipper_wants_triangles(void);

#endif
