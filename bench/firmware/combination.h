/* SPDX-License-Identifier: MIT */
/* The clipper and the visibility method of a program of `make clippers`. */
#ifndef BENCH_COMBINATION_H
#define BENCH_COMBINATION_H

#include "draw.h"

typedef struct {
    const fxl_clipper *clipper;
    const fxl_visibility *hidden;
    uint32_t room; /* bytes for the visibility method, where it needs a workspace */
} combination;

extern const combination combination_chosen;

/* What some method wants beside its room, before the first frame; and after each frame the
 * bytes of it that were in use at most so far. */
void combination_prepare(fxl_renderer *renderer);
uint32_t combination_memory(const fxl_renderer *renderer);

/* After draw_open: what draws. */
fxl_renderer *draw_renderer(void);

#endif
