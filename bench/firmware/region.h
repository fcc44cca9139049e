/* SPDX-License-Identifier: MIT */
/* What is measured: everything between these two calls. The counting plugin
 * knows them by name. Without it they do nothing. */
#ifndef BENCH_REGION_H
#define BENCH_REGION_H

void bench_begin(void);
void bench_end(void);

#endif
