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

typedef struct {
    const char *name;
    const fxl_visibility *visibility;
    bool draws_surfaces;
} named_visibility;

/* Null if no clipper or method has the name. */
const named_clipper *find_clipper(const char *name);
const named_visibility *find_visibility(const char *name);

#endif
