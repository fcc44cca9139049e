/* SPDX-License-Identifier: MIT */
#ifndef BENCH_KERNEL_DEPTH_H
#define BENCH_KERNEL_DEPTH_H

#include "kernels.h"

/* Before the list is run. False: the library refused the workload. */
bool kernel_depth_prepare(void);

extern const bench_kernel depth_list[]; /* ends with a name that is null */

#endif
