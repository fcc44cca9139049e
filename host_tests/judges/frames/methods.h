/* SPDX-License-Identifier: MIT */
/* Clippers and visibility methods by the names that options of programs give them. */
#ifndef FRAMES_METHODS_H
#define FRAMES_METHODS_H

#include "draw/stages.h"
#include "fixel/all.h"

typedef struct {
    const char *name;
    const fxl_clipper *clipper;
    const fxl_target *target; /* its own; null: that of the visibility method */
} named_clipper;

/* An order and a target, by a name that VISIBILITY= takes. */
typedef struct {
    const char *name;
    const fxl_order *order;
    const fxl_target *target; /* where the pixels are a palette's */
    bool draws_surfaces;      /* else faces are drawn in their own colours */
} named_visibility;

/* Null if no clipper or method has the name. */
const named_clipper *find_clipper(const char *name);
const named_visibility *find_visibility(const char *name);

#endif
