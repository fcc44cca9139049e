/* SPDX-License-Identifier: MIT */
/* Clippers and hidden-surface methods by their names in the comparison. */
#ifndef FRAMES_METHODS_H
#define FRAMES_METHODS_H

#include "fixel/all.h"

typedef struct {
    const char *name;
    const fxl_clipper *clipper;
    const fxl_raster_backend *painter; /* its own; null: the method's */
} named_clipper;

typedef struct {
    const char *name;
    const fxl_visibility *hidden;
} named_hidden;

/* Null where there is none of that name. */
const named_clipper *find_clipper(const char *name);
const named_hidden *find_hidden(const char *name);

#endif
