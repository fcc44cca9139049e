/* SPDX-License-Identifier: MIT */
#ifndef PLACEMENT_ROWS_H
#define PLACEMENT_ROWS_H

#include <stdint.h>

/* fxl_placement_rows. */
void test_placement_rows(uint32_t rounds);

#endif
