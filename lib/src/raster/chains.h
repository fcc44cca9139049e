/* SPDX-License-Identifier: MIT */
/* What scan and its kernel, fxl_scan_next_trapezoid, have between them. Internal. */
#ifndef FXL_CHAINS_H
#define FXL_CHAINS_H

#include "fixel/stage/scan.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The next span as a trapezoid of one row, of a scan by crossings. The kernel
 * goes there where a scan that has no more rows is not by chains. */
const fxl_trapezoid *fxl_scan_next_of_active_edges(fxl_scan *scan);

#ifdef __cplusplus
}
#endif

#endif
