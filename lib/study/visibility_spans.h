/* SPDX-License-Identifier: MIT */
/* What the raster backends with a span buffer share. Internal. */
#ifndef FXL_VISIBILITY_SPANS_H
#define FXL_VISIBILITY_SPANS_H

#include "fixel/study/span_buffer.h"
#include "../draw/submit.h"

/* fxl_raster_backend.workspace_size and .begin_band: the span buffer fills the whole workspace
 * of the backend. */
uint32_t fxl_spans_workspace_size(const fxl_lens *lens);
void fxl_spans_begin(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band);

static inline fxl_span_buffer *fxl_spans_of(const fxl_workspace *workspace)
{
    return (fxl_span_buffer *)workspace->raster_workspace;
}

#endif
