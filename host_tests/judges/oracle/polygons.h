/* SPDX-License-Identifier: MIT */
/* Random and adversarial polygons of the world. They are convex and flat except for the rounding
 * to 16.16, and the view cuts most of them. */
#ifndef ORACLE_POLYGONS_H
#define ORACLE_POLYGONS_H

#include "oracle/setup.h"

#define ORACLE_POLYGON_KINDS \
    "round, cut", "slivers", "triangles and quads, huge", "ground just under the eye", \
        "collinear and repeated vertices", "vertices on planes", "vertices at the range's ends", \
        "around and behind the eye", "nearly parallel to a plane", "edges through centres"

/* The number of the kind "nearly parallel to a plane". */
#define ORACLE_NEAR_PARALLEL 8

/* Sets the kind of the input, and appends a setup, the count of vertices and their x y z; at
 * most count_max vertices. */
void oracle_polygon_generate(oracle_random *random, int side_max, int count_max,
                             oracle_input *input);

/* Reads what the above wrote; 0 where it is not such an input. rest is how many
 * numbers follow. */
int oracle_polygon_read(const oracle_input *input, int rest, oracle_setup *setup,
                        fxl_polygon *polygon);

#endif
