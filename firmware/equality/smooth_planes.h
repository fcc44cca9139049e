/* SPDX-License-Identifier: MIT */
#ifndef SMOOTH_PLANES_H
#define SMOOTH_PLANES_H

#include <stdint.h>

/* fxl_find_smooth_planes. */
void test_smooth_planes(uint32_t rounds);

#endif
