/* SPDX-License-Identifier: MIT */
/* What is counted of a program that counts operations: everything between these two calls. */
#ifndef BENCH_OPERATIONS_H
#define BENCH_OPERATIONS_H

void operations_begin(void);
void operations_end(void);

#endif
