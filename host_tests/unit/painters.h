/* SPDX-License-Identifier: MIT */
/* Targets of tests. One of each kind at a time. */
#ifndef PAINTERS_H
#define PAINTERS_H

#include "unit.h"

/* Near to far, what comes first keeps its pixels: only pixels of the background's colour are
 * painted. */
const fxl_target *painter_under(uint8_t background);

/* Paints nothing. Counts how often each pixel of a frame, of so many bytes a row, is painted with
 * colours up to colour_max. */
const fxl_target *painter_counting(uint8_t *times, uint32_t width, uint8_t colour_max);

#endif
