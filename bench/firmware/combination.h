/* SPDX-License-Identifier: MIT */
/* The clipper, the order and the target of a program of `make clippers`. */
#ifndef BENCH_COMBINATION_H
#define BENCH_COMBINATION_H

#include "draw.h"

typedef struct {
    const fxl_clipper *clipper;
    const fxl_order *order;
    const fxl_target *target;
    uint32_t room; /* bytes for the target, where it needs memory */
} combination;

extern const combination combination_chosen;

/* What some method wants beside its room, before the first frame; and after each frame the
 * bytes of it that were in use at most so far. */
void combination_prepare(fxl_renderer *renderer);
uint32_t combination_memory(const fxl_renderer *renderer);

#endif
