/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_SMALL_STAGES_H
#define EQUALITY_SMALL_STAGES_H

#include <stdint.h>

void test_sines(uint32_t rounds);
void test_camera(uint32_t rounds);
void test_sphere(uint32_t rounds);
void test_clip(uint32_t rounds);
void test_order(uint32_t rounds);
void test_outlines(uint32_t rounds);

#endif
