/* SPDX-License-Identifier: MIT */
/* Targets with a span buffer, or with a scan by bounding boxes: palette indices without a depth
 * buffer. */
#ifndef FXL_STUDY_TARGETS_H
#define FXL_STUDY_TARGETS_H

#include "../draw/submit.h"
#include "fixel/target.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Every pixel of a polygon's bounding box is tested (lib/study/scan_box.h). It gives the pixels of
 * fxl_palette without setting up edges. */
extern const fxl_target fxl_palette_box;

/* Near to far into a span buffer (lib/study/span_buffer.h). Each pixel is drawn once, by the first
 * polygon that covers it, so the frame is that of fxl_palette. `depth` of a configuration has at
 * least FXL_SPAN_BUFFER_BYTES_LEAST of the screen. If a band has more intervals than it holds, the
 * band is drawn again in halves, and these in halves if need be; each time counts in split_bands.
 * The least memory holds any one row, so the frame never depends on its size. */
extern const fxl_target fxl_palette_spans;

/* The span buffer, with every pixel of a polygon's bounding box tested (lib/study/scan_box.h). */
extern const fxl_target fxl_palette_spans_box;

/* Internal: begins a band of which nothing was drawn. */
typedef void fxl_band_begin(const fxl_renderer *renderer, fxl_workspace *workspace,
                            const fxl_band *band);

/* Internal: draws a band. Where the workspace is full the band is drawn again in halves, and so on;
 * counted in split_bands. Each part is begun first. Requires a workspace for any one row. Returns
 * FXL_OK.
 */
fxl_status fxl_band_split_draw(const fxl_renderer *renderer, fxl_workspace *workspace,
                               const fxl_band *band, fxl_band_begin *begin);

#ifdef __cplusplus
}
#endif

#endif
