/* SPDX-License-Identifier: MIT */
/* What is covered of a band, pixel by pixel (docs/extras/spans.md). */
#ifndef REF_SPAN_BUFFER_H
#define REF_SPAN_BUFFER_H

#include "reference/record.h"

/* The caller gives the pixels, rows * width, and owns it all. */
typedef struct {
    bool *covered;
    int width, first_row, rows;
} ref_span_buffer;

/* Nothing of the band is covered. */
void ref_span_buffer_begin(ref_span_buffer *cover, bool *covered, const ref_band *band);

/* Runs of covered pixels, of all rows, as long as can be. */
long ref_span_buffer_intervals(const ref_span_buffer *cover);

/* Colours what is not covered of a span, and covers it. False where there would then be more
 * than so many runs: then all is as it was. */
bool ref_span_buffer_draw(ref_span_buffer *cover, const ref_span *span, uint8_t colour,
                          const ref_band *band, long runs);

#endif
