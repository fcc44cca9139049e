/* SPDX-License-Identifier: MIT */
/* Fills spans and bands with a colour. */
#ifndef REF_FILL_H
#define REF_FILL_H

#include "reference/record.h"

uint16_t ref_pixel(const ref_band *band, int x, int y);
void ref_fill_span(const ref_band *band, const ref_span *span, uint16_t colour);
void ref_fill_band(const ref_band *band, uint16_t colour);

#endif
