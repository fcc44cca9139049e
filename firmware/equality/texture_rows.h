/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_TEXTURE_ROWS_H
#define EQUALITY_TEXTURE_ROWS_H

#include <stdint.h>

void test_texture_rows(uint32_t rounds);

#endif
