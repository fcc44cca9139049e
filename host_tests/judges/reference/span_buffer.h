/* SPDX-License-Identifier: MIT */
/* The covered pixels of a band, a mark for each pixel (docs/extras/spans.md). */
#ifndef REF_SPAN_BUFFER_H
#define REF_SPAN_BUFFER_H

#include "reference/record.h"

/* The caller provides rows * width marks. */
typedef struct {
    bool *covered;
    int width, first_row, rows;
} ref_span_buffer;

/* Begins a band: nothing of it is covered. */
void ref_span_buffer_begin(ref_span_buffer *cover, bool *covered, const ref_band *band);

/* Returns the number of maximal intervals of covered pixels, over all rows. */
long ref_span_buffer_intervals(const ref_span_buffer *cover);

/* Colours the uncovered pixels of a span, and marks them covered. Returns false, and changes
 * nothing, where there would then be more than `runs` intervals. */
bool ref_span_buffer_draw(ref_span_buffer *cover, const ref_span *span, uint8_t colour,
                          const ref_band *band, long runs);

#endif
