/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_ROWS_H
#define EQUALITY_ROWS_H

#include <stdint.h>

void test_row_to_16(uint32_t rounds);

#endif
