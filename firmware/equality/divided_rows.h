/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_DIVIDED_ROWS_H
#define EQUALITY_DIVIDED_ROWS_H

#include <stdint.h>

void test_divided_rows(uint32_t rounds);

#endif
