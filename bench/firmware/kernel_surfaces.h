/* SPDX-License-Identifier: MIT */
#ifndef BENCH_KERNEL_SURFACES_H
#define BENCH_KERNEL_SURFACES_H

#include "kernels.h"

#define SURFACE_WIDTH  320u
#define SURFACE_HEIGHT 240u

/* What kernels with frames draw into, one after another. */
extern uint8_t kernel_screen[SURFACE_WIDTH * SURFACE_HEIGHT];

/* Before the list is run. False: the library refused the workload. */
bool kernel_surfaces_prepare(void);

extern const bench_kernel surface_list[]; /* ends with a name that is null */

#endif
