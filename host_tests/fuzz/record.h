/* SPDX-License-Identifier: MIT */
/* What the library answers to an input, as a hash. A demand says what must hold of an answer; the
 * record says which answer it was, so that a replay sees where one has changed. */
#ifndef RECORD_H
#define RECORD_H

#include "draw/stages.h"
#include "fixel/all.h"

/* Adds to the hash. The bytes have no padding between them. */
void record_bytes(const void *bytes, size_t size);
void record_number(int64_t number);
void record_text(const char *text); /* may be null */
/* The pixels, not what lies between width and stride. */
void record_band(const fxl_band *band);
void record_points(const fxl_screen_polygon *polygon);
/* An answer that is null records 0. */
void record_varying(const fxl_varying_polygon *polygon);

/* The hash of what was recorded since the last call. */
uint64_t record_end(void);

#endif
