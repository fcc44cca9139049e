/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_PROJECT_H
#define EQUALITY_PROJECT_H

#include <stdint.h>

void test_project(uint32_t rounds);

#endif
