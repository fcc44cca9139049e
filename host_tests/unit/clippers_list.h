/* SPDX-License-Identifier: MIT */
/* The family's clippers, one after the other; the first two have integers of their own. */
#ifndef CLIPPERS_LIST_H
#define CLIPPERS_LIST_H

#include "fixel/records.h"
#include "study/clippers.h"

enum {
    CLIPPERS = 6
};

/* place clipper: the list of the unit tests and of the fuzzer */
static const fxl_clipper *const clippers[CLIPPERS] = {
    &fxl_clipper_normalised, &fxl_clipper_once, &fxl_clipper_half_spaces,
    &fxl_clipper_triangles,  &fxl_clipper_near, &fxl_clipper_left};

/* The family's clippers, then the two of the first chapter. */
static inline const fxl_clipper *clipper_number(int which)
{
    return which < CLIPPERS    ? clippers[which]
           : which == CLIPPERS ? &fxl_clipper_view
                               : &fxl_clipper_world;
}

#endif
