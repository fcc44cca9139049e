/* SPDX-License-Identifier: MIT */
/* Surfaces and depth by the designs: their samples, and their errors. */
#ifndef DESIGNS_SURFACE_H
#define DESIGNS_SURFACE_H

#include "designs/sample.h"
#include "designs/stage.h"

/* place sampling: the texel of a pixel in other arithmetic */
int naive_texel(designs_surface *face, uint8_t division);
int naive_level(designs_surface *face);
int naive_nearer(const depth_sample *faces, bool wide);
int float32_texel(designs_surface *face, uint8_t division);
int float32_level(designs_surface *face);
int float32_nearer(const depth_sample *faces, bool wide);

/* Makes a sample of a stage from DESIGNS_TEXEL on. All corners are in front of the near plane, so
 * no design needs to clip; without perspective they are on the screen. */
void designs_sample_surface(enum designs_stage stage, const designs_plan *plan,
                            oracle_random *random, designs_input *input);

/* Each design's error for one input of such a stage. Requires one that designs_is_surface takes. */
void designs_surface_errors(enum designs_stage stage, const designs_input *input,
                            double errors[DESIGNS_COUNT]);

/* Whether the numbers are an input of such a stage. */
bool designs_is_surface(enum designs_stage stage, const oracle_input *face);

#endif
