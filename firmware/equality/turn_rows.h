/* SPDX-License-Identifier: MIT */
#ifndef TURN_ROWS_H
#define TURN_ROWS_H

#include <stdint.h>

/* fxl_placement_rows. */
void test_turn_rows(uint32_t rounds);

#endif
