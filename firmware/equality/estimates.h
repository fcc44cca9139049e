/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_ESTIMATES_H
#define EQUALITY_ESTIMATES_H

#include <stdint.h>

void test_facing(uint32_t rounds);
void test_sphere(uint32_t rounds);

#endif
