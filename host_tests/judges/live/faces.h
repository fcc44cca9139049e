/* SPDX-License-Identifier: MIT */
/* What each pixel of a frame shows: the part "faces" of an answer (main.c). */
#ifndef LIVE_FACES_H
#define LIVE_FACES_H

#include "reference/render.h"

enum {
    FACE_SIZE = 16 /* bytes of a pixel's face */
};

void put_u16(uint8_t *to, uint32_t value);
void put_u32(uint8_t *to, uint32_t value);
void put_f32(uint8_t *to, double value);

/* Of the frame that was drawn, whose renderer->shown is set. to: FACE_SIZE bytes a pixel. */
void collect_faces(const ref_renderer *renderer, uint8_t *to);

#endif
