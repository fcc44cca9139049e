/* SPDX-License-Identifier: MIT */
/* What the designs are tried on: samples that are the same on every machine, by integers and the four
 * operations of IEEE double only, and square roots. */
#ifndef DESIGNS_SAMPLE_H
#define DESIGNS_SAMPLE_H

#include "designs/input.h"
#include "oracle/random.h"

/* The stream of one shard of one kind of samples. */
oracle_random designs_random_start(uint64_t seed, const char *kind, uint64_t point, uint64_t shard);

/* Evenly by magnitude: each octave of low..high is equally likely, and so is
 * every part of an octave. 0 < low <= high. */
double designs_random_spread(oracle_random *random, double low, double high);

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
