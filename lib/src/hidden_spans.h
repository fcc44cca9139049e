/* SPDX-License-Identifier: MIT */
/* What painters with a span buffer share. Internal. */
#ifndef FXL_HIDDEN_SPANS_H
#define FXL_HIDDEN_SPANS_H

#include "fixel/span_buffer.h"
#include "walk.h"

/* fxl_painter.room and .begin: the span buffer is all of the painter's room. */
uint32_t fxl_spans_room(const fxl_lens *lens);
void fxl_spans_begin(fxl_renderer *renderer, const fxl_band *band);

static inline fxl_span_buffer *fxl_spans_of(const fxl_renderer *renderer)
{
    return renderer->paint_room;
}

#endif
