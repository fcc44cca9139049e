/* SPDX-License-Identifier: MIT */
/* What the targets with a span buffer share. Internal. */
#ifndef FXL_TARGET_SPANS_H
#define FXL_TARGET_SPANS_H

#include "span_buffer.h"
#include "../draw/submit.h"
#include "targets.h"

/* fxl_target.memory_size: the span buffer fills all the memory of the target. */
uint32_t fxl_spans_workspace_size(const fxl_lens *lens);

/* Begins a band of which nothing was drawn. */
typedef void fxl_band_begin(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band);

/* Draws a band. Where the workspace is full the band is drawn again in halves, and so on; counted
 * in split_bands. Each part is begun first. Requires a workspace for any one row. Returns FXL_OK.
 */
fxl_status fxl_band_split_draw(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band, fxl_band_begin *begin);

/* fxl_target.draw_band: fxl_band_split_draw with a span buffer. */
fxl_status fxl_spans_draw_band(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band);

static inline fxl_span_buffer *fxl_spans_of(const fxl_workspace *workspace)
{
    return (fxl_span_buffer *)workspace->target_memory;
}

/* A target of a span buffer that paints a flat face by a function. */
#define FXL_TARGET_OF_SPANS(paints) \
    { \
        .pixel_bits = 8, .near_first = true, .fill = fxl_fill_band, \
        .choose = fxl_choose_with_memory, .memory_size = fxl_spans_workspace_size, \
        .draw_band = fxl_spans_draw_band, .flat = (paints) \
    }

#endif
