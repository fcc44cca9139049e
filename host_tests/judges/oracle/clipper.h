/* SPDX-License-Identifier: MIT */
/* The clipper under test. */
#ifndef ORACLE_CLIPPER_H
#define ORACLE_CLIPPER_H

#include "oracle/space.h"

/* Chooses the clipper by its name in the comparison; until then it is fxl_clipper_view. Returns
 * 0 where there is none of that name. */
int oracle_clipper_choose(const char *name);

/* From now on the exact side takes the matrix, planes and rounded vertices of the chosen
 * clipper, not of the view, as given. This tests its clipping alone. */
void oracle_clipper_own_integers(void);

/* Returns the integers that exact clipping takes as given. */
oracle_space oracle_clipper_space(const fxl_view *view);

/* A polygon of the world onto the screen: what the clipper answers, and how many
 * polygons it gives, into screens with room for so many. */
fxl_clip_result oracle_clipper_take(fxl_view *view, const fxl_polygon *polygon,
                                    fxl_screen_polygon *screens, int workspace_for, int *count);

/* Returns how far the outlines of the chosen clipper may be off, in 1/65536 pixel
 * (docs/extras/clippers.md). */
double oracle_clipper_bound(const fxl_lens *lens);

/* Tells whether that bound holds for triangles alone. The clipper changes the outline of a face
 * that is not quite flat. */
int oracle_clipper_wants_triangles(void);

#endif
