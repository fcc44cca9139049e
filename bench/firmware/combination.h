/* SPDX-License-Identifier: MIT */
/* Which clipper and which method a program of make clippers draws with. */
#ifndef BENCH_COMBINATION_H
#define BENCH_COMBINATION_H

#include "draw.h"

typedef struct {
    const fxl_clipper *clipper;
    const fxl_hidden *hidden;
    uint32_t room; /* bytes for what hides what, where it wants some */
} combination;

extern const combination combination_chosen;

/* After draw_open: what draws. */
fxl_renderer *draw_renderer(void);

#endif
