/* SPDX-License-Identifier: MIT */
/* Scan conversion by testing every pixel of a polygon's bounding box. It gives the same pixels
 * as fxl_scan_next, without a list of edges. Source: notes on homogeneous view volumes (D6). */
#ifndef FXL_SCAN_BOX_H
#define FXL_SCAN_BOX_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The state of a scan. The caller owns it; only scan_box.c uses its members. */
typedef struct {
    const fxl_screen_point *points;
    uint32_t count;
    int32_t left, right, bottom; /* the part of the box that lies in the band, in pixels */
    int32_t row, column;         /* the pixel to be tested next */
} fxl_scan_box;

/* Begins to scan an outline of count points into a band. The caller must keep the points until
 * the last span. The requirements are those of fxl_scan_begin; they are not checked. */
void fxl_scan_box_begin(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                        fxl_scan_box *scan);

/* Gives the next span; false when there are no more. The order and the pixels are exactly those
 * of fxl_scan_next. */
bool fxl_scan_box_next(fxl_scan_box *scan, fxl_span *span);

#ifdef __cplusplus
}
#endif

#endif
