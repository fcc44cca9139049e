/* SPDX-License-Identifier: MIT */
/* Whether two polygons that share an edge leave a gap or draw a pixel twice. */
#ifndef WATERTIGHT_H
#define WATERTIGHT_H

#include "study/clippers.h"
#include "unit.h"

enum {
    WATERTIGHT_WIDTH = 24,
    WATERTIGHT_HEIGHT = 20,
    WATERTIGHT_PIECES = 48 /* of two triangles together, at most */
};

/* Fails where they do. Each of the two is one polygon or several: the first so many
 * belong to the one, the others to the other. */
void watertight_expect(const fxl_screen_polygon *polygons, int first, int count);

/* The same for random pairs of triangles of the world, by a clipper whose room is
 * cleared. few: how many of the pairs must be cut, both. screens has room for so many. */
void watertight_expect_through(const fxl_clipper *clipper, fxl_clipper_workspace *workspace,
                               int few, fxl_screen_polygon *screens, int workspace_for);

/* The same for random pairs of triangles of an instance that is turned and scaled. */
void watertight_expect_turned(const fxl_clipper *clipper, int few, fxl_screen_polygon *screens,
                              int workspace_for);

/* Twice the area in units of 2^-32, positive clockwise. */
int64_t watertight_area(const fxl_screen_polygon *polygon);

#endif
