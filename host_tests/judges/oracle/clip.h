/* SPDX-License-Identifier: MIT */
/* The clipper under test, and exact clipping with the integers that it is given. */
#ifndef ORACLE_CLIP_H
#define ORACLE_CLIP_H

#include "oracle/setup.h"
#include "oracle/cover.h"

/* The integers that exact clipping takes as given: a matrix, six planes and the scales of the
 * projection. Some clippers have other integers than the view. */

/* A point (x', y', z') / w, in units of 2^-46, is inside where x x' + y y' + z z' + offset 2^up
 * w >= 0. up gives the offset the unit of the products. */
typedef struct {
    int64_t x, y, z, offset;
    unsigned up;
} oracle_plane;

typedef struct {
    fxl_camera camera; /* a row is 2^-shift times its direction, then rounded to 2^-46 */
    unsigned x_shift, y_shift, z_shift;
    oracle_plane planes[FXL_PLANE_COUNT];
    int64_t centre_x, centre_y; /* of the screen, 1/65536 pixel */
    int64_t x_scale, y_scale;   /* pixels of 1/65536 for side / depth = 1 */
} oracle_space;

/* The integers of the view: SPEC.md, sections 4.6 to 4.8. */
oracle_space oracle_space_of_view(const fxl_view *view);

/* Clipping and projection in exact rational arithmetic (SPEC.md, sections 4.7 and 4.8):
 * Sutherland-Hodgman in the view on homogeneous big integers, with the planes that the integers
 * of the space define. Nothing is rounded until the result is written at 2^-48 pixel. */

enum {
    ORACLE_OUTLINE_MAX = 64,
    ORACLE_SPOT_BITS = 32 /* below 1/65536 pixel */
};

typedef struct {
    int count;                             /* 0 where fewer than three vertices are left */
    oracle_spot spots[ORACLE_OUTLINE_MAX]; /* in units of 2^-48 pixel, rounded down */
    int origins[ORACLE_OUTLINE_MAX]; /* the edge from each spot: the number of the polygon's edge,
                                        or -1 - plane for one that a plane made */
} oracle_outline;

void oracle_clip(const oracle_space *space, const fxl_polygon *polygon, oracle_outline *outline);

/* The clipper under test. */

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
