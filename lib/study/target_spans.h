/* SPDX-License-Identifier: MIT */
/* What the raster backends with a span buffer share. Internal. */
#ifndef FXL_TARGET_SPANS_H
#define FXL_TARGET_SPANS_H

#include "span_buffer.h"
#include "../draw/submit.h"
#include "targets.h"

/* fxl_target.workspace_size and .begin_band: the span buffer fills the whole workspace
 * of the backend. */
uint32_t fxl_spans_workspace_size(const fxl_lens *lens);
void fxl_spans_begin(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band);

/* fxl_target.draw_band: where the workspace is full the band is drawn again in halves,
 * and so on; counted in split_bands. Requires a workspace for any one row. Returns FXL_OK. */
fxl_status fxl_band_split_draw(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band);

static inline fxl_span_buffer *fxl_spans_of(const fxl_workspace *workspace)
{
    return (fxl_span_buffer *)workspace->target_memory;
}

#endif
