/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_EDGES_H
#define EQUALITY_EDGES_H

#include <stdint.h>

void test_edge_divide(uint32_t rounds);

#endif
