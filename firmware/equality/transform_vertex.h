/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_LOOK_AT_H
#define EQUALITY_LOOK_AT_H

#include <stdint.h>

void test_look_at(uint32_t rounds);

#endif
