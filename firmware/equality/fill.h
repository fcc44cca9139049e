/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_FILL_H
#define EQUALITY_FILL_H

#include <stdint.h>

void test_fill(uint32_t rounds);
void test_fill_rgb565(uint32_t rounds);
void test_draw_outline(uint32_t rounds);
void test_draw_outline_rgb565(uint32_t rounds);

#endif
