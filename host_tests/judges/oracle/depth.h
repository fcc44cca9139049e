/* SPDX-License-Identifier: MIT */
/* Two triangles that are seen through one pixel: as numbers of an input, drawn by the library with
 * a depth buffer, and their exact distances. */
#ifndef ORACLE_DEPTH_H
#define ORACLE_DEPTH_H

#include "oracle/triangle.h"

enum {
    DEPTH_FACES = 2,
    DEPTH_CORNERS = ORACLE_SETUP_NUMBERS + 2,
    DEPTH_NUMBERS = DEPTH_CORNERS + 3 * 3 * DEPTH_FACES
};

#define DEPTH_TEXT ORACLE_SETUP_TEXT ", column row, six corners x y z"

/* Each face is a model and an instance of its own, of colours 1 and 2. */
typedef struct {
    oracle_setup setup;
    fxl_lens lens;    /* whose view that is */
    int64_t pixel[2]; /* column, row */
    fxl_point corners[3 * DEPTH_FACES];
    uint16_t indices[3 * DEPTH_FACES];
    fxl_face faces[DEPTH_FACES];
    fxl_model models[DEPTH_FACES];
    fxl_instance instances[DEPTH_FACES];
    fxl_scene scene;
} depth_sample;

/* Appends a pixel of the setup and two triangles about its points at the depths z[0] and z[1].
 * Edges are at most `most` times as long as that. Returns whether all corners are in range. */
int depth_sample_put(oracle_random *random, const double z[DEPTH_FACES], double most,
                     oracle_input *input);

/* Reads the numbers. Returns 0 where the library refuses them. */
int depth_sample_read(const oracle_input *input, depth_sample *sample);

/* The face that the pixel shows with 16 bits or, where `wide`, 32 bits a pixel; -1 for neither. */
int depth_sample_drawn(const depth_sample *sample, int wide);

/* Whether a face alone covers the pixel. */
int depth_sample_covers(const depth_sample *sample, int face);

/* How much farther the second face is, relative to the first's distance: exact but for the last
 * division. *slack: what SPEC.md, sections 10.1 and 10.2, allow for both faces together. Returns 0
 * where the ray is in the plane of one. */
int depth_sample_gap(const depth_sample *sample, double *gap, double *slack);

#endif
