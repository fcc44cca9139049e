/* SPDX-License-Identifier: MIT */
/* Scanning by brute force: every pixel of a polygon's bounding box is tested. The same
 * pixels as fxl_scan_next gives, without a list of edges. Source: notes on
 * homogeneous view volumes (D6). */
#ifndef FXL_SCAN_BOX_H
#define FXL_SCAN_BOX_H

#include "fixel/stage/scan.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A polygon being scanned. The caller owns it; all members belong to scan_box.c. */
typedef struct {
    const fxl_screen_point *points;
    uint32_t count;
    int32_t left, right, bottom; /* pixels of the box that the band shows */
    int32_t row, column;         /* to be tested next */
} fxl_scan_box;

/* Begins to scan an outline of count points into a band. It must stay until the last
 * span. Requires what fxl_scan_begin requires, unchecked. */
void fxl_scan_box_begin(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                        fxl_scan_box *scan);

/* The next span; the order and the pixels are those of fxl_scan_next, exactly. */
bool fxl_scan_box_next(fxl_scan_box *scan, fxl_span *span);

#ifdef __cplusplus
}
#endif

#endif
