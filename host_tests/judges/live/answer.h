/* SPDX-License-Identifier: MIT */
/* What the reference renderer draws of a pose, and its verdict on a board's frame: the parts of an answer of live/main.c. */
#ifndef LIVE_ANSWER_H
#define LIVE_ANSWER_H

#include "frames/moving_reference.h"
#include "reference/render.h"
#include "reference/scene.h"

enum {
    LIVE_REQUEST_SIZE = 36,
    LIVE_PARTS = 4,
    LIVE_WANT_VERDICT = 8
};

/* place pixel-format: the record of the reference by which a frame is judged; the bytes of a pixel */
typedef struct {
    ref_scene_image image;
    moving_reference moving;
    ref_renderer renderer;
    ref_rgb565 rgb565;
    size_t area;     /* pixels of a frame */
    uint16_t *frame; /* the reference renderer's */
    uint8_t *bytes_of_frame;
    uint8_t *board;     /* the bytes of the board's frame */
    size_t frame_bytes; /* how many those are */
    uint8_t *verdict;   /* of each pixel */
    uint8_t *faces;
    uint32_t *shown; /* ref_renderer.shown, while faces are wanted */
    uint8_t *outlines;
    size_t outlines_capacity;
} live_session;

/* The parts that were wanted, and 0 bytes of each other one. */
typedef struct {
    const uint8_t *bytes[LIVE_PARTS];
    size_t sizes[LIVE_PARTS];
} live_answer;

/* Opens an image of so many bytes, aligned to four, which outlive the session. Returns null, or a clause that says what is
 * wrong. live_close is due in each case. */
const char *live_open(live_session *run, const uint8_t *bytes, size_t size, ref_method method);
void live_close(live_session *run);

/* Answers a request; with LIVE_WANT_VERDICT run->board is the board's frame. Returns null, or a clause that says what is
 * wrong. The answer is there until the next call. */
const char *live_ask(live_session *run, const uint8_t *request, live_answer *answer);

/* Little-endian, as in docs/formats.md, section 1. */
void live_put_u32(uint8_t *to, uint32_t value);

#endif
