/* SPDX-License-Identifier: MIT */
/* The measured region: everything between these two calls. The counting plugin finds them by
 * name. Without the plugin they do nothing. */
#ifndef BENCH_REGION_H
#define BENCH_REGION_H

void bench_begin(void);
void bench_end(void);

#endif
