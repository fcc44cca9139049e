/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_DEPTH_PLANES_H
#define EQUALITY_DEPTH_PLANES_H

#include <stdint.h>

/* fxl_find_depth_plane. */
void test_depth_planes(uint32_t rounds);

#endif
