/* SPDX-License-Identifier: MIT */
#ifndef EQUALITY_FACES_H
#define EQUALITY_FACES_H

#include <stdint.h>

void test_front_faces(uint32_t rounds);
void test_clip_by_view(uint32_t rounds);

#endif
