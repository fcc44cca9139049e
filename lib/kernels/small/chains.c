/* SPDX-License-Identifier: MIT */
#include "chains.h"

/* No outline is scanned by chains: scan.c. */
const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan)
{
    return fxl_scan_next_of_crossings(scan);
}
