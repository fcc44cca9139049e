/* SPDX-License-Identifier: MIT */
/* What is covered of a band, pixel by pixel (docs/extras/spans.md). */
#ifndef REF_COVER_H
#define REF_COVER_H

#include "reference/record.h"

/* The caller gives the pixels, rows * width, and owns it all. */
typedef struct {
    bool *covered;
    int width, first_row, rows;
} ref_cover;

/* Nothing of the band is covered. */
void ref_cover_begin(ref_cover *cover, bool *covered, const ref_band *band);

/* Runs of covered pixels, of all rows, as long as can be. */
long ref_cover_runs(const ref_cover *cover);

/* Colours what is not covered of a span, and covers it. False where there would then be more
 * than so many runs: then all is as it was. */
bool ref_cover_span(ref_cover *cover, const ref_span *span, uint8_t colour, const ref_band *band,
                    long runs);

#endif
