/* SPDX-License-Identifier: MIT */
/* The list of kernels: a new one is a function and a line. */
#ifndef BENCH_KERNELS_H
#define BENCH_KERNELS_H

#include "kernel_inputs.h"

typedef struct {
    const char *name;
    void (*run)(const kernel_inputs *inputs);
    uint32_t units; /* units of one run: the figure is divided by it */
} bench_kernel;

/* Both end with a name that is null. */
extern const bench_kernel kernel_list[]; /* of the library */
extern const bench_kernel limit_list[];  /* bare work, to compare with */

#endif
