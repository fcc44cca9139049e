/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_DEPTH_ROWS_H
#define EQUALITY_DEPTH_ROWS_H

#include <stdint.h>

void test_depth_rows(uint32_t rounds);

#endif
