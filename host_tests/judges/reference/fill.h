/* SPDX-License-Identifier: MIT */
/* Fills spans and bands with a colour. */
#ifndef REF_FILL_H
#define REF_FILL_H

#include "reference/record.h"

void ref_fill_span(const ref_band *band, const ref_span *span, uint8_t colour);
void ref_fill_band(const ref_band *band, uint8_t colour);

#endif
