/* SPDX-License-Identifier: MIT */
/* The visibility methods with a span buffer, or with a scan by bounding boxes. */
#ifndef FXL_STUDY_METHODS_H
#define FXL_STUDY_METHODS_H

#include "fixel/order.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The order of fxl_visibility_sorted; every pixel of a polygon's bounding box is tested (lib/study/scan_box.h). It
 * gives the same pixels without setting up edges. */
extern const fxl_target fxl_palette_box;
extern const fxl_visibility fxl_visibility_box;

/* Front to back into a span buffer (lib/study/span_buffer.h). Each pixel is drawn once, by the
 * first polygon that covers it, so the frame is that of the reverse order.
 * The memory has at least FXL_SPAN_BUFFER_BYTES_LEAST of the screen. If a band has more
 * intervals than the workspace holds, the band is drawn again in halves, and these in halves if
 * need be; each time counts in split_bands. The least workspace holds any one row, so the frame
 * never depends on its size. */
extern const fxl_target fxl_palette_spans;
extern const fxl_visibility fxl_visibility_spans;

/* The span buffer, with every pixel of a polygon's bounding box tested (lib/study/scan_box.h). */
extern const fxl_target fxl_palette_spans_box;
extern const fxl_visibility fxl_visibility_spans_box;

/* Draws what fxl_visibility_bsp draws, near to far into a span buffer. */
extern const fxl_visibility fxl_visibility_bsp_spans;

#ifdef __cplusplus
}
#endif

#endif
