/* SPDX-License-Identifier: MIT */
/* Adversarial outlines on the screen, for the claim coverage. */
#ifndef ORACLE_OUTLINES_H
#define ORACLE_OUTLINES_H

#include "oracle/claim.h"

#define ORACLE_OUTLINE_KINDS \
    "anywhere in range", "on half pixels", "within a unit of centres", "about the screen", \
        "round, rounded to slightly concave", "edges through centres", \
        "horizontals and verticals", "slivers", "at the ends of the range"

/* Sets the kind of the input, and appends the count of points and their x y. */
void oracle_outline_generate(oracle_random *random, int width, int height, oracle_input *input);

#endif
