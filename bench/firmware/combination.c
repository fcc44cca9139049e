/* SPDX-License-Identifier: MIT */
/* Compiled once for each combination: bench/clippers.mk says which. */
#include "combination.h"
#include "draw/stages.h"
#include "fixel/all.h"
#include "study/study.h"

const combination combination_chosen = {&COMBINATION_CLIPPER, &COMBINATION_ORDER,
                                        &COMBINATION_TARGET, COMBINATION_ROOM};
