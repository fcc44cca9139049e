/* SPDX-License-Identifier: MIT */
#include "draw_outline.h"
#include "fill.h"
#include "scan.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M

bool fxl_draw_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan)
{
    if (FXL_IS_SMALL) {
        return fxl_draw_by_active_edges(points, count, band, scan);
    }
    fxl_scan_outline(points, count, band, scan);
    const fxl_trapezoid *trapezoid = fxl_scan_next_trapezoid(scan);
    while (trapezoid != NULL) {
        fxl_fill_trapezoid(band, trapezoid, scan->colour);
        trapezoid = fxl_scan_is_over(scan) ? NULL : fxl_scan_next_trapezoid(scan);
    }
    return fxl_scan_reaches(scan, band);
}

#endif
