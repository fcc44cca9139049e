/* SPDX-License-Identifier: MIT */
/* What the designs are tried on. */
#ifndef DESIGNS_SAMPLE_H
#define DESIGNS_SAMPLE_H

#include "designs/input.h"
#include "designs/random.h"

typedef struct {
    double low, high;
} designs_range;

/* From where samples come. World units, degrees. */
typedef struct {
    designs_range near;  /* the near plane */
    designs_range depth; /* of a visible vertex, or of a crossing; never nearer than near */
    designs_range fov;
    double eye;          /* the eye lies within +-eye */
    double reach;        /* and every vertex within +-reach */
    designs_range edge;  /* from a crossing to either end */
    designs_range angle; /* between edge and plane; any where low is 0 */
    /* of surfaces and depth */
    double far;           /* the far plane */
    double face;          /* a face's longest edge, in depths of its pixel */
    designs_range texels; /* the largest texture coordinate */
} designs_plan;

/* The whole of what the library's contract allows on a usual screen. */
extern const designs_plan designs_whole;

/* One input of a stage. The same state gives the same input. */
void designs_sample(enum designs_stage stage, const designs_plan *plan, oracle_random *random,
                    designs_input *input);

#endif
