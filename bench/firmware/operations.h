/* SPDX-License-Identifier: MIT */
/* A program that counts operations counts those between these two calls. */
#ifndef BENCH_OPERATIONS_H
#define BENCH_OPERATIONS_H

void operations_begin(void);
void operations_end(void);

#endif
