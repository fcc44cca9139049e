/* SPDX-License-Identifier: MIT */
/* A stage of the comparison: its name, its unit, and a design's error in it. */
#ifndef DESIGNS_STAGE_H
#define DESIGNS_STAGE_H

#include "designs/design.h"
#include "designs/sample.h"

enum {
    DESIGNS_COUNT = 3
};

extern const designs_design *const designs_all[DESIGNS_COUNT];

extern const char *const designs_stage_names[DESIGNS_STAGES];
extern const char *const designs_stage_units[DESIGNS_STAGES];
extern const char *const designs_stage_measures[DESIGNS_STAGES];

/* Each design's error for one input. */
void designs_errors(enum designs_stage stage, const designs_input *input,
                    double errors[DESIGNS_COUNT]);

/* One input in words: what is given, what is exact, what each design makes of
 * it. */
void designs_explain(enum designs_stage stage, const designs_input *input);

/* A stage measured over one parameter. */
typedef struct {
    const char *name, *label;
    enum designs_stage stage;
    int count;
    double values[16];
    void (*set)(designs_plan *plan, double value);
} designs_sweep;

enum {
    DESIGNS_SWEEPS = 12
};

extern const designs_sweep designs_sweeps[DESIGNS_SWEEPS];

/* --- surfaces and depth ------------------------------------------------------- */

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
