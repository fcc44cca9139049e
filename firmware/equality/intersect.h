/* SPDX-License-Identifier: MIT */
#ifndef INTERSECT_H
#define INTERSECT_H

#include <stdint.h>

/* fxl_intersect_edge. */
void test_intersect(uint32_t rounds);

#endif
