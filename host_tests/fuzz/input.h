/* SPDX-License-Identifier: MIT */
/* Numbers from a fuzzer's bytes. Past their end everything is 0, so that every
 * input means something and a shorter one means less. */
#ifndef INPUT_H
#define INPUT_H

#include "draw/stages.h"
#include "fixel/all.h"

typedef struct {
    const uint8_t *at;
    size_t left;
} fuzz_input;

/* The next 0..8 bytes, little-endian. */
uint64_t fuzz_bits(fuzz_input *in, unsigned bytes);

/* A number of 0 .. count - 1, from one byte where that suffices. */
uint32_t fuzz_below(fuzz_input *in, uint32_t count);

/* A number of low..high. */
int32_t fuzz_between(fuzz_input *in, int32_t low, int32_t high);

/* Any 32 bits, or a number near one of the edges where bugs live. */
int32_t fuzz_any(fuzz_input *in);

/* A world coordinate within limit: often small, often at the range's end. */
fxl_q16_16 fuzz_coordinate(fuzz_input *in, fxl_q16_16 limit);

fxl_point fuzz_point(fuzz_input *in, fxl_q16_16 limit);

/* A pose in range; angles at the quarter turns are as likely as others. */
fxl_pose fuzz_pose(fuzz_input *in);

/* A lens made by its function: any field of view, any depths, and a screen of
 * at most pixels pixels. */
fxl_lens fuzz_lens(fuzz_input *in, uint32_t pixels);

#endif
