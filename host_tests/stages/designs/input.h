/* SPDX-License-Identifier: MIT */
/* What every design and the exact value are given, and how one input is written
 * on a command line: integers only, so that it comes back bit for bit. */
#ifndef DESIGNS_INPUT_H
#define DESIGNS_INPUT_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "oracle/claim.h"

enum designs_stage {
    DESIGNS_MATRIX,
    DESIGNS_VERTEX,
    DESIGNS_CLIP,
    DESIGNS_FILL,
    DESIGNS_TEXEL, /* divided at each pixel */
    DESIGNS_TEXEL_16,
    DESIGNS_TEXEL_8,
    DESIGNS_TEXEL_AFFINE,
    DESIGNS_LIGHT,
    DESIGNS_DEPTH_16,
    DESIGNS_DEPTH_32,
    DESIGNS_STAGES
};

enum {
    DESIGNS_TEXT_MAX = 1024
};

/* One input of a stage; what its stage does not use is 0.
 *   matrix: pose's angles. vertex: camera, lens, points[0].
 *   clip: camera, lens, plane, points[0] inside of it and points[1] outside.
 *   fill: lens (the screen's size), outline. From texel on: face, the numbers of a surface_sample
 *   or, of depth, of a depth_sample. */
typedef struct {
    fxl_pose pose;
    fxl_camera camera;
    fxl_lens lens;
    int plane;
    fxl_point points[2];
    fxl_screen_polygon outline;
    oracle_input face;
} designs_input;

/* The input as text without quotes, and back; false where the text is not one
 * of this stage or leaves the library's ranges. */
void designs_write_input(enum designs_stage stage, const designs_input *input,
                         char text[DESIGNS_TEXT_MAX]);
bool designs_read_input(enum designs_stage stage, const char *text, designs_input *input);

#endif
