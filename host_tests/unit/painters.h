/* SPDX-License-Identifier: MIT */
/* Targets of tests, one of each kind at a time; among them the library's span buffer with its
 * pixels counted as they are written. */
#ifndef PAINTERS_H
#define PAINTERS_H

#include "choices.h"
#include "draw/stages.h"
#include "fixel/all.h"
#include "study/span_buffer.h"

/* Near to far, what comes first keeps its pixels: only pixels of the background's colour are
 * painted. */
const fxl_target *painter_under(uint8_t background);

/* Paints nothing. Counts how often each pixel of a frame, of so many bytes a row, is painted with
 * colours up to colour_max. */
const fxl_target *painter_counting(uint8_t *times, uint32_t width, uint8_t colour_max);

/* span_buffer.c, but that each span that it fills is counted. */
fxl_span_buffer *counted_span_buffer_make(void *memory, uint32_t size, uint16_t height);
void counted_span_buffer_begin(fxl_span_buffer *buffer, const fxl_band *band);
bool counted_span_buffer_draw(fxl_span_buffer *buffer, const fxl_trapezoid *trapezoid,
                              uint8_t colour, const fxl_band *band);

/* From now on writes[], all 0 at first, says how often each of so many pixels was written.
 * Answers choice_spans with the span buffer counted. */
const choice *counted_begin(uint8_t *writes, const uint8_t *pixels, uint32_t count);

#endif
